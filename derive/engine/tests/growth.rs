//! How the equations of open mechanisms grow with the number of their links.

use holonomy_engine::program::{Count, programs};
use holonomy_engine::projection::Equations;
use holonomy_engine::{analyse, expand};
use proc_macro2::{TokenStream, TokenTree};

const LINKS: [usize; 4] = [5, 10, 20, 40];

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("tokens")
}

/// Uniform rods in a row, by absolute angles as a family.
fn absolute(n: usize) -> TokenStream {
    rods(n, "#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]")
}

/// The same by the angles of their joints.
fn relative(n: usize) -> TokenStream {
    rods(n, "#[frame(L[0] = rotate(N, z, q[0]), L[i] = rotate(L[i - 1], z, q[i]) for i in 1..n)]")
}

fn rods(n: usize, frames: &str) -> TokenStream {
    tokens(&format!(
        "#[size(n = {n})] #[coordinates(q[n])] {frames}
        #[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
        #[body(rod[i] = {{ frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) }} for i in 0..n)]
        #[gravity(g*N.x)] #[holonomy(elimination = recursive)] struct Rods {{ m: f64, l: f64, g: f64 }}"
    ))
}

/// Rods in space on joints of two axes.
fn spatial(n: usize) -> TokenStream {
    tokens(&format!(
        "#[size(n = {n})] #[coordinates(a[n], b[n])]
        #[frame(L[0] = rotate(rotate(N, x, a[0]), y, b[0]), L[i] = rotate(rotate(L[i - 1], x, a[i]), y, b[i]) for i in 1..n)]
        #[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].z for i in 1..n)]
        #[body(rod[i] = {{ frame: L[i], center: P[i] + l/2*L[i].z, mass: m, inertia: cylinder(m, r, l, z) }} for i in 0..n)]
        #[gravity(-g*N.z)] #[holonomy(elimination = recursive)] struct Rods {{ m: f64, l: f64, r: f64, g: f64 }}"
    ))
}

fn derived(tokens: TokenStream) -> Equations {
    match analyse(tokens) {
        Ok(analysis) => analysis.equations,
        Err(errors) => panic!("{:?}", errors.iter().map(|error| &error.message).collect::<Vec<_>>()),
    }
}

fn count(equations: &Equations, function: &str) -> Count {
    programs(equations).expect("every symbol is known").function(function).expect("it is emitted").count
}

fn all(tokens: TokenStream) -> usize {
    let each = tokens.into_iter().map(|token| match token {
        TokenTree::Group(group) => 2 + all(group.stream()),
        _ => 1,
    });
    each.sum()
}

/// Operations of the motion, of M v and of M v̇ - h*, expressions in the arena, and tokens of what is emitted, per link.
fn grows(name: &str, chain: impl Fn(usize) -> TokenStream, most: usize) {
    grows_by(name, chain, most, [1.01, 1.01, 1.01, 1.01, 1.1]);
}

/// The same of closed chains: forms of the chart reach less far in long ones, and what leads to D is not all handed on whole.
fn closed_grows(name: &str, chain: impl Fn(usize) -> TokenStream, most: usize) {
    grows_by(name, chain, most, [1.05, 1.01, 1.01, 1.3, 1.1]);
}

fn grows_by(name: &str, chain: impl Fn(usize) -> TokenStream, most: usize, growth: [f64; 5]) {
    println!("{name:24} {:>10} {:>10} {:>10} {:>10} {:>10}", "motion", "M v", "M v' - h*", "arena", "tokens");
    let mut per_link = Vec::new();
    for n in LINKS {
        let equations = derived(chain(n));
        assert!(equations.is_recursive() && equations.inertia.entries().is_empty());
        let functions = ["derivative", "momenta", "inverse_dynamics"].map(|name| count(&equations, name).operations());
        let emitted = all(expand(chain(n)));
        let row = [functions[0], functions[1], functions[2], equations.graph.len(), emitted];
        println!("{n:24} {:10} {:10} {:10} {:10} {:10}", row[0], row[1], row[2], row[3], row[4]);
        per_link.push(row.map(|figure| figure as f64 / n as f64));
    }
    // A link more costs what the last one cost, and what blocks hand on is told in tokens as well.
    let added = |from: usize, to: usize, at: usize| {
        let (a, b) = (LINKS[from] as f64, LINKS[to] as f64);
        (per_link[to][at] * b - per_link[from][at] * a) / (b - a)
    };
    for (at, most) in growth.into_iter().enumerate() {
        let (earlier, later) = (added(1, 2, at), added(2, 3, at));
        assert!(later <= most * earlier, "{name}: figure {at} grows by {earlier} and then by {later} a link");
    }
    assert!(per_link[3][0] <= most as f64, "{} operations a link", per_link[3][0]);
}

#[test]
fn rods_in_absolute_angles_grow_linearly() {
    grows("rods, absolute angles", absolute, 90);
}

#[test]
fn rods_in_relative_angles_grow_linearly() {
    grows("rods, joint angles", relative, 75);
}

#[test]
fn rods_in_space_grow_linearly() {
    grows("rods in space", spatial, 350);
}

/// Left to itself the derive takes M_d as a whole where that is quicker, and joint by joint beyond.
#[test]
fn long_chains_are_eliminated_joint_by_joint() {
    let chosen = |n: usize| {
        let text = absolute(n).to_string().replace("# [holonomy (elimination = recursive)]", "");
        assert!(!text.contains("elimination"), "{text}");
        let equations = derived(tokens(&text));
        let told = equations.notes.iter().any(|note| note.starts_with("the motion is found joint by joint"));
        assert_eq!(told, equations.is_recursive(), "{:?}", equations.notes);
        told
    };
    assert_eq!([5, 10, 20, 40].map(chosen), [false, false, true, true]);
}

/// The rods of [`absolute`], the end of the last one pinned.
fn pinned(n: usize) -> TokenStream {
    let text = absolute(n).to_string().replace(
        "# [body",
        "# [point (Q = P [n - 1] + l * L [n - 1] . x)] # [constraint (pin : Q == O + d * N . y)] # [body",
    );
    assert!(text.contains("constraint"), "{text}");
    tokens(&text.replace("m : f64", "m : f64, d : f64"))
}

/// The rods of [`spatial`] likewise.
fn pinned_in_space(n: usize) -> TokenStream {
    let text = spatial(n).to_string().replace(
        "# [body",
        "# [point (Q = P [n - 1] + l * L [n - 1] . z)] # [constraint (pin : Q == O + d * N . x)] # [body",
    );
    assert!(text.contains("constraint"), "{text}");
    tokens(&text.replace("m : f64", "m : f64, d : f64"))
}

#[test]
fn pinned_rods_grow_linearly() {
    closed_grows("pinned rods", pinned, 145);
}

#[test]
fn pinned_rods_in_space_grow_linearly() {
    closed_grows("pinned rods in space", pinned_in_space, 750);
}

/// So are closed ones, where a row more on every speed costs less than the factorisation that it fills.
#[test]
fn long_closed_chains_are_eliminated_joint_by_joint() {
    let chosen = |n: usize| {
        let text = pinned(n).to_string().replace("# [holonomy (elimination = recursive)]", "");
        assert!(!text.contains("elimination"), "{text}");
        derived(tokens(&text)).is_recursive()
    };
    assert_eq!([5, 10, 20].map(chosen), [false, false, true]);
}

/// M and h* as a whole: n² entries that each cost the same.
#[test]
fn the_mass_matrix_grows_quadratically() {
    let entries = |n: usize| {
        let text = relative(n).to_string().replace("elimination = recursive", "elimination = matrix, simplify = off");
        let equations = derived(tokens(&text));
        let (inertia, forces) = (count(&equations, "inertia").operations(), count(&equations, "forces").operations());
        println!("{n} rods: M {inertia}, h* {forces}");
        (inertia as f64, forces as f64)
    };
    let [five, ten, twenty] = [5, 10, 20].map(entries);
    // a n² + b n
    assert!(twenty.0 - ten.0 <= 4.2 * (ten.0 - five.0), "M");
    assert!(twenty.1 - ten.1 <= 4.2 * (ten.1 - five.1), "h*");
}

/// Four-bars in a row: each window shares its right arm with the next one, one loop more with two bars more, one degree of freedom.
fn windows(n: usize) -> TokenStream {
    let arms = n + 1;
    tokens(&format!(
        "#[size(n = {n}, arms = {arms})] #[coordinates(arm[arms], bar[n])]
        #[frame(A[i] = rotate(N, z, arm[i]) for i in 0..arms, B[i] = rotate(N, z, bar[i]) for i in 0..n)]
        #[point(G[i] = O + i*d*N.x for i in 0..arms, P[i] = G[i] + l*A[i].x for i in 0..arms)]
        #[body(upright[i] = {{ frame: A[i], center: G[i] + l/2*A[i].x, mass: m, inertia: rod(m, l, x) }} for i in 0..arms)]
        #[body(level[i] = {{ frame: B[i], center: P[i] + b/2*B[i].x, mass: m, inertia: rod(m, b, x) }} for i in 0..n)]
        #[gravity(-g*N.y)] #[constraint(closure[i]: P[i] + b*B[i].x == P[i + 1] for i in 0..n)]
        #[independent(dot(arm[0]))]
        struct Windows {{ m: f64, l: f64, b: f64, d: f64, g: f64 }}"
    ))
}

/// Operations of the motion and of the reactions, expressions and tokens: D, a_u and λ are found window by window, C_d⁻¹ is never
/// written out.
#[test]
fn four_bars_in_a_row_grow_linearly() {
    const WINDOWS: [usize; 5] = [1, 5, 10, 20, 40];
    println!("windows: motion, reactions, arena, tokens; milliseconds");
    let mut figures = Vec::new();
    for n in WINDOWS {
        let start = std::time::Instant::now();
        let emitted = all(expand(windows(n)));
        let time = start.elapsed().as_millis();
        let equations = derived(windows(n));
        let [motion, reactions] = ["derivative", "multipliers"].map(|name| count(&equations, name).operations());
        let row = [motion, reactions, equations.graph.len(), emitted];
        println!("{n}: {row:?}; {time}");
        figures.push(row);
    }
    let added = |at: usize, figure: usize| {
        let difference = figures[at][figure] as f64 - figures[at - 1][figure] as f64;
        difference / (WINDOWS[at] - WINDOWS[at - 1]) as f64
    };
    for figure in 0..4 {
        let most = (1..4).map(|at| added(at, figure)).fold(0.0, f64::max);
        // The search for cheaper forms, which is bounded by counts, reaches less far in long rows.
        let growth = if figure < 2 { 1.1 } else { 1.3 };
        assert!(added(4, figure) <= growth * most, "figure {figure} grows faster in longer rows: {figures:?}");
    }
}
