//! Loops closed on top of a tree, against M_d as a whole: the same v̇, u̇ and λ at every state, in every chart.
//!
//! Neither form asks whether the position rows hold, so that any configuration is a state to compare at; where rows are dependent only
//! where the others hold, the oracle's tests compare.

use holonomy_engine::analyse;
use holonomy_engine::projection::{Equations, GuardKind};
use holonomy_engine::symbolic::{Expr, Symbol};
use proc_macro2::TokenStream;
use std::collections::HashMap;

/// The largest difference over the largest number of a kind.
const AGREE: f64 = 1e-11;
/// Draws, and how many of them are compared at least: not those where the pivots of a chart, which are of the order of one, are small,
/// and M_d as a whole loses digits.
const DRAWS: usize = 60;
const COMPARED: usize = 8;
const PIVOT: f64 = 0.3;

const BY: [&str; 2] = ["recursive", "matrix"];

fn derived(text: &str, by: &str) -> Equations {
    let tokens: TokenStream =
        text.replace("struct", &format!("#[holonomy(elimination = {by})] struct")).parse().expect("tokens");
    match analyse(tokens) {
        Ok(analysis) => analysis.equations,
        Err(errors) => panic!("{:?}", errors.iter().map(|error| &error.message).collect::<Vec<_>>()),
    }
}

/// A number for every symbol that follows from its name and from the number of the draw; quaternions of unit length.
fn number(equations: &Equations, draw: usize) -> impl Fn(Symbol) -> f64 {
    let graph = &equations.graph;
    let value = |name: &str| {
        let sum = name.bytes().fold(7_u64, |sum, byte| sum.wrapping_mul(31).wrapping_add(byte.into()));
        0.9 + 0.6 * (sum as f64 * 0.37 + 1.7 * draw as f64).sin()
    };
    // Angles all around.
    let spread = |s: Symbol| if equations.coordinates.contains(&s) { 9.0 } else { 1.0 };
    let mut known: HashMap<Symbol, f64> = graph.symbols().map(|s| (s, spread(s) * value(graph.name(s)))).collect();
    for i in 0.. {
        let of = |letter: &str| graph.symbols().find(|s| graph.name(*s) == format!("{letter}_{i}"));
        let Some(parts) = ["qa", "qb", "qc", "qd"].map(of).into_iter().collect::<Option<Vec<Symbol>>>() else { break };
        let length = parts.iter().map(|s| known[s] * known[s]).sum::<f64>().sqrt();
        parts.iter().for_each(|s| *known.get_mut(s).expect("it is known") /= length);
    }
    known.insert(graph.pi_symbol(), std::f64::consts::PI);
    move |symbol| known[&symbol]
}

/// Everything about the motion of both at several states, chart by chart; the equations joint by joint.
#[track_caller]
fn agree(text: &str) -> Equations {
    let [a, b] = BY.map(|by| derived(text, by));
    assert!(a.is_recursive() && !b.is_recursive());
    let names = |e: &Equations| (e.multiplier_names.clone(), e.row_names());
    assert_eq!(names(&a), names(&b));
    let kinds = |e: &Equations| -> Vec<Vec<Expr>> {
        let mut all =
            vec![e.velocities.clone(), e.velocity_rates.clone(), e.accelerations.clone(), e.multipliers.clone()];
        all.extend([e.coordinate_rates.clone(), e.outputs.values.clone(), vec![e.kinetic_energy]]);
        all.extend(e.charts.iter().map(|chart| chart.accelerations.clone()));
        all
    };
    let mut compared = 0;
    for draw in 0..DRAWS {
        let guards = b.guards.iter().chain(b.charts.iter().flat_map(|chart| &chart.guards));
        let pivots: Vec<Expr> = guards.filter(|guard| guard.kind == GuardKind::Pivot).map(|guard| guard.expr).collect();
        if b.graph.evaluate(&pivots, &number(&b, draw)).iter().any(|pivot| pivot.abs() < PIVOT) {
            continue;
        }
        compared += 1;
        let values = |e: &Equations| -> Vec<Vec<f64>> {
            kinds(e).iter().map(|roots| e.graph.evaluate(roots, &number(e, draw))).collect()
        };
        for (kind, (a, b)) in values(&a).iter().zip(&values(&b)).enumerate() {
            assert_eq!(a.len(), b.len());
            let largest = b.iter().fold(0.0_f64, |most, b| most.max(b.abs()));
            for (a, b) in a.iter().zip(b) {
                assert!((a - b).abs() <= AGREE * largest, "draw {draw}, kind {kind}: {a} {b} of {largest}");
            }
        }
    }
    assert!(compared >= COMPARED, "{compared} compared");
    a
}

/// Rods in a row, the end of the last one pinned; by absolute angles.
fn pinned(n: usize, further: &str) -> String {
    format!(
        "#[size(n = {n}, ends = {n} + 1)] #[coordinates(q[n])] #[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
        #[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..ends)]
        #[body(rod[i] = {{ frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) }} for i in 0..n)]
        #[gravity(g*N.x)] #[constraint(pin: P[n] == O + d*N.y)] {further} struct Rods {{ m: f64, l: f64, d: f64, g: f64 }}"
    )
}

#[test]
fn pinned_rods_agree() {
    for n in [3, 5, 8] {
        let equations = agree(&pinned(n, ""));
        assert_eq!((equations.state_speeds.len(), equations.velocity_rates.len()), (n - 2, n));
    }
}

#[test]
fn charts_pick_other_speeds_of_the_same_motion() {
    let charts = "#[independent(dot(q[0]), dot(q[1]), dot(q[2]))] #[independent(dot(q[1]), dot(q[3]), dot(q[4]))]
        #[independent(bend = dot(q[1]) - dot(q[0]), turn = cos(q[2])*dot(q[2]) + q[0]*dot(q[3]), dot(q[4]))]";
    let equations = agree(&pinned(5, charts));
    assert_eq!(equations.charts.len(), 2);
    // As those that the state names.
    let combined =
        "#[independent(bend = dot(q[1]) - dot(q[0]), turn = cos(q[2])*dot(q[2]) + q[0]*dot(q[3]), dot(q[4]))]";
    assert!(agree(&pinned(5, combined)).combined);
}

#[test]
fn rods_in_space_agree() {
    let of = |n: usize| {
        format!(
            "#[size(n = {n}, ends = {n} + 1)] #[coordinates(a[n], b[n])]
            #[frame(L[0] = rotate(rotate(N, x, a[0]), y, b[0]), L[i] = rotate(rotate(L[i - 1], x, a[i]), y, b[i]) for i in 1..n)]
            #[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].z for i in 1..ends)]
            #[body(rod[i] = {{ frame: L[i], center: P[i] + l/2*L[i].z, mass: m, inertia: cylinder(m, r, l, z) }} for i in 0..n)]
            #[gravity(-g*N.z)] #[constraint(pin: P[n] == O + d*N.x)] struct Rods {{ m: f64, l: f64, r: f64, d: f64, g: f64 }}"
        )
    };
    for n in [2, 3] {
        agree(&of(n));
    }
}

/// Norms of quaternions need no force: their rows are not among those that close loops.
#[test]
fn rods_on_balls_agree() {
    let balls = |pin: &str| {
        format!(
            "#[size(n = 2)] #[coordinates(qa[n], qb[n], qc[n], qd[n])]
            #[frame(L[0] = quaternion(N, qa[0], qb[0], qc[0], qd[0]), L[1] = quaternion(L[0], qa[1], qb[1], qc[1], qd[1]))]
            #[point(P = O + l*L[0].z, Q = P + l*L[1].z)]
            #[body(upper = {{ frame: L[0], center: O + l/2*L[0].z, mass: m, inertia: diag(j, 2*j, j/2) }})]
            #[body(lower = {{ frame: L[1], center: P + l/2*L[1].z, mass: m, inertia: diag(j, j/3, j/2) }})]
            #[gravity(-g*N.z)] {pin} struct Balls {{ m: f64, l: f64, j: f64, d: f64, g: f64 }}"
        )
    };
    let free = agree(&balls(""));
    assert_eq!((free.state_speeds.len(), free.speeds.len(), free.norms), (6, 8, 2));
    agree(&balls("#[constraint(pin: Q == O + d*N.x)]"));
}

/// Two loops that share the first two joints on their ways to the ground, a torque, a spring, a damper and an armature, and outputs
/// with a reaction of a row and one of a joint.
fn branched(row: &str) -> String {
    format!(
        "#[size(n = 6)] #[coordinates(q[n])] #[inputs(tau)]
        #[frame(A = rotate(N, z, q[0]), B = rotate(A, z, q[1]), C = rotate(B, z, q[2]), D = rotate(C, z, q[3]))]
        #[frame(E = rotate(B, z, q[4]), F = rotate(E, z, q[5]))]
        #[point(P = O + l*A.x, Q = P + l*B.x, R = Q + l*C.x, S = R + l*D.x, T = Q + l*E.x, U = T + l*F.x)]
        #[body(rod_a = {{ frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) }})]
        #[body(rod_b = {{ frame: B, center: P + l/2*B.x, mass: m, inertia: rod(m, l, x) }})]
        #[body(rod_c = {{ frame: C, center: Q + l/2*C.x, mass: m, inertia: rod(m, l, x) }})]
        #[body(rod_d = {{ frame: D, center: R + l/2*D.x, mass: m, inertia: rod(m, l, x) }})]
        #[body(rod_e = {{ frame: E, center: Q + l/2*E.x, mass: m, inertia: rod(m, l, x) }})]
        #[body(rod_f = {{ frame: F, center: T + l/2*F.x, mass: m, inertia: rod(m, l, x) }})]
        #[gravity(-g*N.y)] #[torque(drive = {{ on: A, value: tau*N.z }})]
        #[spring(between = {{ from: P, to: T, stiffness: g, length: l }})]
        #[damper(joint = {{ of: q[3], coefficient: m }})] #[armature(gear = {{ of: q[4], inertia: m }})]
        #[release(hinge = {{ point: P, along: A.y }})]
        #[constraint(one: S == O + d*N.x)] #[constraint(two: dot(U, N.y) == d)] {row}
        #[output(sum = reaction(hinge) + reaction(two) + ddot(q[5]))]
        struct Tree {{ m: f64, l: f64, d: f64, g: f64 }}"
    )
}

#[test]
fn loops_that_share_a_path_agree() {
    let equations = agree(&branched(""));
    assert_eq!((equations.rows.len(), equations.state_speeds.len()), (3, 3));
}

#[test]
fn redundant_rows_share_the_reaction_alike() {
    let equations = agree(&branched("#[constraint(three: dot(U, N.y) + dot(S, N.x) == 2*d, redundant)]"));
    assert_eq!((equations.multipliers.len(), equations.state_speeds.len()), (4, 3));
    assert!(equations.rows[3].redundant);
}

/// A knife edge at the end of a row of rods: a row of velocities, and one with a speed that time gives.
#[test]
fn rows_of_velocities_agree() {
    let rows = "#[constraint(edge: dot(velocity(P[n]), L[n - 1].y) == 0)] #[constraint(led: dot(q[0]) == sin(t))]";
    let text = pinned(5, rows).replace("#[constraint(pin: P[n] == O + d*N.y)]", "");
    agree(&text);
}

#[test]
fn what_is_no_tree_with_linear_rows_is_refused() {
    let refused = |text: String| {
        let tokens: TokenStream =
            text.replace("struct", "#[holonomy(elimination = recursive)] struct").parse().expect("tokens");
        let errors = analyse(tokens).expect_err("it cannot be");
        errors.iter().map(|error| error.message.clone()).collect::<Vec<_>>().join("; ")
    };
    let nonlinear = pinned(4, "#[constraint(pace: powi(dot(q[0]), 2) + powi(dot(q[1]), 2) == 1)]");
    let rates = pinned(4, "#[constraint(pace: ddot(q[0]) == 1)]");
    for text in [nonlinear, rates] {
        let message = refused(text);
        assert!(
            message.contains("cannot be eliminated joint by joint") && message.contains("linear in velocities"),
            "{message}"
        );
    }
}
