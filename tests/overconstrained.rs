//! Loops with more rows than they need run as if they had only those that they need, and share their reactions.

mod support;

use holonomy::simulate::Charts;
use holonomy::{ConstrainedSystem, Error, Prepared};
use support::running::entries;

/// A coupler on three bars of one length: two of them hold all that the three do, and only where they are parallel.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b, c, d)]
#[frame(A = rotate(N, z, a), B = rotate(N, z, b), C = rotate(N, z, c), D = rotate(N, z, d))]
#[point(P = O + l*A.x, Q = O + w*N.x + l*B.x, R = O + w/2*N.x + l*C.x)]
#[body(
    first = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) },
    second = { frame: B, center: O + w*N.x + l/2*B.x, mass: m, inertia: rod(m, l, x) },
    third = { frame: C, center: O + w/2*N.x + l/2*C.x, mass: m, inertia: rod(m, l, x) },
    coupler = { frame: D, center: P + w/2*D.x, mass: m, inertia: rod(m, w, x) },
)]
#[gravity(-g*N.y)]
#[constraint(outer: P + w*D.x == Q)]
#[constraint(inner: P + w/2*D.x == R, redundant)]
#[independent(dot(a))]
#[start(a = -0.7, b = -0.7, c = -0.7, d = 0)]
struct ParallelBars {
    #[nominal(1.2)]
    l: f64,
    #[nominal(2.5)]
    w: f64,
    #[nominal(0.7)]
    m: f64,
    #[nominal(9.81)]
    g: f64,
}

/// Bennett's linkage by its angles, the last hinge as five rows of which three say nothing new where it is closed.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b, c)]
#[frame(A = rotate(N, z, a), TA = rotate(A, x, beta), B = rotate(TA, z, b), TB = rotate(B, x, alpha))]
#[frame(C = rotate(TB, z, c), TC = rotate(C, x, beta), Ground = rotate(N, x, -alpha))]
#[point(P = O + l*sin(beta)/sin(alpha)*A.x, Q = P + l*B.x, R = Q + l*sin(beta)/sin(alpha)*C.x)]
#[body(
    first = { frame: A, center: O + l/2*A.x, mass: m, inertia: cuboid(m, l, l/5, l/5) },
    second = { frame: B, center: P + l/2*B.x, mass: m, inertia: cuboid(m, l, l/5, l/5) },
    third = { frame: C, center: Q + l/2*C.x, mass: m, inertia: cuboid(m, l, l/5, l/5) },
)]
#[gravity(-g*N.y)]
#[constraint(hinge: revolute(R, O - l*N.x, TC.z, Ground.z), redundant)]
#[independent(dot(a))]
#[start(a = 1, b = 2, c = -1)]
struct Bennett {
    #[nominal(1)]
    l: f64,
    #[nominal(1.4)]
    alpha: f64,
    #[nominal(0.5)]
    beta: f64,
    #[nominal(0.8)]
    m: f64,
    #[nominal(9.81)]
    g: f64,
}

/// The largest f, and the largest change of the energy relative to its kinetic part's largest, over a run.
fn drift<M: ConstrainedSystem>(model: &Prepared<M>, start: M::State<f64>, until: f64) -> (f64, f64) {
    let run = model.simulate(start).tolerance(1e-10, 1e-12).until(until).expect("it runs");
    let (mut worst, mut change, mut kinetic) = (0.0_f64, 0.0_f64, 0.0_f64);
    let energy = model.energy(0.0, &start);
    for (t, s) in run.iter() {
        let f = entries(&model.position_residual_at(t, s));
        worst = f.iter().fold(worst, |worst, f| worst.max(f.abs()));
        change = change.max((model.energy(t, s) - energy).abs());
        kinetic = kinetic.max(model.kinetic_energy(t, &model.coordinates(t, s), &model.velocities(t, s)));
        model.check_rank(t, s).expect("the other rows are independent");
    }
    (worst, change / kinetic)
}

/// Three bars and the coupler swing as one pendulum, and no bar pushes another: the coupler's share is on each of them.
#[test]
fn three_parallel_bars_swing_as_a_pendulum() {
    let (l, w, m, g) = (1.2, 2.5, 0.7, 9.81);
    let model = ParallelBars { l, w, m, g }.prepare().expect("good parameters");
    let start = ParallelBarsState { a: -0.7, b: -0.7, c: -0.7, d: 0.0, dot_a: 0.4 };
    // 3 m l²/3 + m l² against m g l cos a (3/2 + 1)
    let pull = |a: f64| -2.5 * g * a.cos() / (2.0 * l);
    let rate = entries(&model.derivative(0.0, &start, &[]).0);
    assert!((rate[4] - pull(-0.7)).abs() < 1e-13 && rate[..3].iter().all(|rate| (rate - 0.4).abs() < 1e-14));
    let (residual, energy) = drift(&model, start, 20.0);
    assert!(residual < 1e-12 && energy < 1e-8, "{residual:e} {energy:e}");
    // by Runge-Kutta's method in a alone
    let (mut a, mut u, h) = (-0.7_f64, 0.4_f64, 1e-4);
    for _ in 0..50_000 {
        let (k1, j1) = (u, pull(a));
        let (k2, j2) = (u + h / 2.0 * j1, pull(a + h / 2.0 * k1));
        let (k3, j3) = (u + h / 2.0 * j2, pull(a + h / 2.0 * k2));
        let (k4, j4) = (u + h * j3, pull(a + h * k3));
        a += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        u += h / 6.0 * (j1 + 2.0 * j2 + 2.0 * j3 + j4);
    }
    let run = model.simulate(start).tolerance(1e-11, 1e-13).until(5.0).expect("it runs");
    let (_, end) = run.last();
    assert!((end.a - a).abs() < 1e-9 && (end.dot_a - u).abs() < 1e-9, "{} {a}", end.a);
    assert!((end.b - a).abs() < 1e-9 && (end.c - a).abs() < 1e-9 && end.d.abs() < 1e-12);
}

#[test]
fn bennetts_linkage_runs() {
    let model = Bennett { l: 1.0, alpha: 1.4, beta: 0.5, m: 0.8, g: 9.81 }.prepare().expect("good parameters");
    let rows = Bennett::MODEL.rows;
    assert_eq!((rows.len(), rows.iter().filter(|row| row.redundant).count()), (5, 3));
    let guess = BennettState { a: 1.0, b: 2.0, c: -1.0, dot_a: 0.5 };
    let found = model.assemble(guess).hold("a").solve().expect("it closes");
    let (a, b, c) = (found.a, found.b, found.c);
    // the opposite angles are alike, and the others follow by Bennett's ratio
    assert!((a + c).abs() < 1e-12, "{a} {c}");
    let ratio = ((1.4_f64 + 0.5) / 2.0).sin() / ((1.4_f64 - 0.5) / 2.0).sin();
    let product = (a / 2.0).tan() * (b / 2.0).tan();
    assert!([product, 1.0 / product].iter().any(|p| (p.abs() - ratio).abs() < 1e-11), "{product} {ratio}");
    // until shortly before all links lie on one line, where the rows that are left lose their rank
    let (residual, energy) = drift(&model, found, 0.5);
    assert!(residual < 1e-10 && energy < 1e-7, "{residual:e} {energy:e}");
}

/// With a third bar of another length, or in another direction, the three still close where they start, and hold each other fast.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b, c, d)]
#[frame(A = rotate(N, z, a), B = rotate(N, z, b), C = rotate(N, z, c), D = rotate(N, z, d))]
#[point(P = O + l*A.x, Q = O + w*N.x + l*B.x, R = O + w/2*N.x + l*(cos(-0.7)*N.x + sin(-0.7)*N.y))]
#[point(S = R + (l - s)*(C.x - cos(c0)*N.x - sin(c0)*N.y))]
#[body(
    first = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) },
    second = { frame: B, center: O + w*N.x + l/2*B.x, mass: m, inertia: rod(m, l, x) },
    third = { frame: C, center: S - l/2*C.x, mass: m, inertia: rod(m, l, x) },
    coupler = { frame: D, center: P + w/2*D.x, mass: m, inertia: rod(m, w, x) },
)]
#[gravity(-g*N.y)]
#[constraint(outer: P + w*D.x == Q)]
#[constraint(inner: P + w/2*D.x == S, redundant)]
#[independent(dot(a))]
#[start(a = -0.7, b = -0.7, c = -0.7, d = 0)]
struct ShiftedBars {
    #[nominal(1.2)]
    l: f64,
    #[nominal(2.5)]
    w: f64,
    /// By how much the third bar is shorter.
    #[nominal(0)]
    s: f64,
    /// Where it points when the others point to -0.7.
    #[nominal(-0.7)]
    c0: f64,
    #[nominal(0.7)]
    m: f64,
    #[nominal(9.81)]
    g: f64,
}

/// What the nominal parameters leave free, others hold: a run says so at its start, at rest as well, where nothing else would. Where
/// only the accelerations contradict each other, the bars being parallel still, it says so before it has moved by a part in ten thousand.
#[test]
fn rows_that_are_redundant_with_other_parameters_only_are_refused() {
    let good = ShiftedBars { l: 1.2, w: 2.5, s: 0.0, c0: -0.7, m: 0.7, g: 9.81 };
    for charts in [Charts::Change, Charts::General] {
        let start = |c: f64| ShiftedBarsState { a: -0.7, b: -0.7, c, d: 0.0, dot_a: 0.0 };
        let model = good.clone().prepare().expect("good parameters");
        model.simulate(start(-0.7)).charts(charts).until(0.5).expect("nominal parameters run");
        for (c0, s) in [(-0.5, 0.0), (-0.5, 0.3), (-0.7, 0.3), (-0.7, 0.01)] {
            let model = ShiftedBars { s, c0, ..good.clone() }.prepare().expect("good parameters");
            let interrupted = model.simulate(start(c0)).charts(charts).until(0.5).expect_err("it is rigid");
            let moved = (interrupted.trajectory.last().1.a + 0.7).abs();
            assert!(moved < 1e-4 && interrupted.trajectory.last().0 < 0.2, "{interrupted:?}");
            match &interrupted.error {
                Error::NotRedundant { rows, value, time } => {
                    assert!(!rows.is_empty() && rows.iter().all(|row| row.starts_with("inner")), "{rows:?}");
                    assert!(interrupted.error.to_string().contains("do not follow from the others"));
                    assert!(c0 == -0.7 || *time == 0.0 && *value > 0.01, "{time} {value:e}");
                }
                // Newton's method does not get onto an isolated point where the rows touch.
                Error::Projection { constraint, .. } => assert!(c0 == -0.7 && constraint.starts_with("inner")),
                other => panic!("{other:?}"),
            }
        }
    }
}

/// A bead on a rail that is held twice, until the second guide leaves the first.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(rail: y == 0)]
#[constraint(guide: if x < l { y } else { y - b*powi(x - l, 2) } == 0, redundant)]
#[independent(dot(x))]
#[start(x = 0, y = 0)]
struct TwoGuides {
    #[nominal(1)]
    m: f64,
    #[nominal(1)]
    l: f64,
    #[nominal(0.3)]
    b: f64,
    #[nominal(9.81)]
    g: f64,
}

#[test]
fn rows_that_become_independent_during_a_run_end_it() {
    let model = TwoGuides { m: 1.0, l: 1.0, b: 0.3, g: 9.81 }.prepare().expect("good parameters");
    let start = TwoGuidesState { x: 0.0, y: 0.0, dot_x: 1.0 };
    model.simulate(start).max_step(0.05).until(0.9).expect("both guides say the same");
    let interrupted = model.simulate(start).max_step(0.05).until(2.0).expect_err("the guides part");
    match &interrupted.error {
        Error::NotRedundant { rows, time, .. } => assert!(rows == &["guide"] && (1.0..1.1).contains(time), "{time}"),
        Error::Projection { time, .. } => assert!((1.0..1.1).contains(time), "{time}"),
        other => panic!("{other:?}"),
    }
    assert!((interrupted.trajectory.last().1.x - 1.0).abs() < 0.1);
}

/// Velocities that are given may satisfy nothing: that is told, and not that rows are no longer redundant.
#[test]
fn given_velocities_are_judged_first() {
    let model = ParallelBars { l: 1.2, w: 2.5, m: 0.7, g: 9.81 }.prepare().expect("good parameters");
    let start = ParallelBarsState { a: -0.7, b: -0.7, c: -0.7, d: 0.0, dot_a: 0.0 };
    let v = ParallelBarsVelocities { dot_a: 1.0, dot_b: 0.2, dot_c: -0.4, dot_d: 0.3 };
    let error = model.simulate(start).velocities(v).until(1.0).expect_err("the bars would come apart").error;
    assert!(matches!(error, Error::Unmet { .. }), "{error:?}");
    let v = ParallelBarsVelocities { dot_a: 0.4, dot_b: 0.4, dot_c: 0.4, dot_d: 0.0 };
    model.simulate(start).velocities(v).until(1.0).expect("they move as one");
}
