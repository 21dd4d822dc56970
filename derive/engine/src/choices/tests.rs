//! What is chosen, and why.

use super::*;
use crate::analyse_by;
use crate::syntax;

/// The first speed's inertia runs. With it dependent every entry of M_d does; with another one dependent a single one.
const RUNNING: &str = "
    #[coordinates(x, y, z)]
    #[inertia(diag(m*(2 + cos(x)), m, m))]
    #[forces(0, 0, -m*g)]
    #[constraint(sum: dot(x) + dot(y) + dot(z) == 0)]";

/// A point on a sphere: each speed may be dependent, and each such chart breaks down somewhere else.
const SPHERE: &str = "
    #[coordinates(x, y, z)]
    #[inertia(diag(m, m, m))]
    #[forces(0, 0, -m*g)]
    #[constraint(sphere: powi(x, 2) + powi(y, 2) + powi(z, 2) == 1)]";

fn model(statements: &str) -> proc_macro2::TokenStream {
    format!("#[derive(ConstrainedSystem)] {statements} pub struct Model {{ pub m: f64, pub g: f64 }}")
        .parse()
        .expect("tokens")
}

/// The speeds of the state, and what is told about them.
fn told(statements: &str, search: Search) -> (String, String) {
    let equations = analyse_by(model(statements), search).unwrap_or_else(|_| panic!("{statements}")).equations;
    let names: Vec<&str> = equations.state_speeds.iter().map(|s| equations.graph.name(*s)).collect();
    (names.join(" "), equations.notes.first().cloned().unwrap_or_default())
}

fn system(statements: &str) -> InitialSystem {
    let declarations = syntax::read(model(statements)).0.expect("a struct");
    crate::model::build(&declarations).unwrap_or_else(|_| panic!("{statements}"))
}

#[test]
fn an_exchange_wins_that_makes_the_motion_cheaper() {
    let (speeds, note) = told(RUNNING, Search::Off);
    assert_eq!(speeds, "dot_x dot_z");
    let weighs = "independent speeds dot_x, dot_z, chosen by cost: as derived its motion weighs ";
    assert!(note.starts_with(weighs) && note.contains("as with dot_y instead of dot_z"), "{note}");
    let alternatives = Alternatives::of(&system(RUNNING)).expect("a choice");
    let [first, other] = [None, Some([false, true, false])]
        .map(|d| weighed(&alternatives, d.as_ref().map(|d| &d[..]), None).expect("a chart"));
    assert_eq!(first.found.dependent, [true, false, false]);
    assert!(other.weight < first.weight, "{} {}", other.weight, first.weight);
}

/// The same motion, where the other speeds would be divided by what may vanish.
#[test]
fn a_cheaper_motion_is_not_worth_a_new_guard() {
    let guarded = RUNNING.replace("dot(x) + dot(y) + dot(z)", "dot(x) + x*dot(y) + x*dot(z)");
    let (speeds, note) = told(&guarded, Search::Off);
    assert_eq!(speeds, "dot_y dot_z");
    assert!(note.contains("dot_z, chosen by the cheapest pivots; dependent"), "{note}");
    let alternatives = Alternatives::of(&system(&guarded)).expect("a choice");
    let first = weighed(&alternatives, None, None).expect("a chart");
    assert!(!first.found.quality.may_break_down());
    let exchanged = Some([false, true, false]);
    let exchanged = exchanged.as_ref().map(|d| &d[..]);
    let other = weighed(&alternatives, exchanged, None).expect("a chart");
    assert!(other.found.quality.may_break_down() && !other.found.quality.no_worse_than(&first.found.quality));
    assert!(weighed(&alternatives, exchanged, Some(&first.found.quality)).is_none());
}

#[test]
fn a_little_is_not_worth_a_chart_that_breaks_down_elsewhere() {
    let (speeds, note) = told(SPHERE, Search::Off);
    assert_eq!(speeds, "dot_y dot_z");
    assert!(
        note.contains("chosen by the cheapest pivots: as derived its motion weighs 42 operations, 41 with dot_x"),
        "{note}"
    );
    assert!(note.contains("instead of dot_z, too little less for another chart"), "{note}");
}

/// The names of the state depend on neither the numbers for judging nor the level of search nor the order of rows.
#[test]
fn the_declarations_alone_choose() {
    let plain = told(RUNNING, Search::Off);
    assert_eq!(told(RUNNING, Search::Full), plain);
    assert_eq!(told(&format!("#[holonomy(simplify = off)] {RUNNING}"), Search::Full), plain);
    let started = format!("{RUNNING} #[start(x = 3.1, y = 0.2, z = 0.3)]");
    assert_eq!(told(&started, Search::Off).0, plain.0);
    let rows = ["#[constraint(sum: dot(x) + dot(y) + dot(z) == 0)]", "#[constraint(tie: dot(w) - dot(y) == 0)]"];
    let wider = |rows: [&str; 2]| {
        format!(
            "#[coordinates(x, y, z, w)] #[inertia(diag(m*(2 + cos(x)), m, m, m))] #[forces(0, 0, -m*g, 0)] {}",
            rows.concat()
        )
    };
    let [forth, back] = [wider(rows), wider([rows[1], rows[0]])].map(|model| told(&model, Search::Off).0);
    assert_eq!(forth, back);
}

#[test]
fn who_names_speeds_is_asked_nothing() {
    assert!(Alternatives::of(&system(&format!("{RUNNING} #[independent(dot(y), dot(z))]"))).is_none());
    assert!(Alternatives::of(&system("#[coordinates(x)] #[inertia(diag(m))] #[forces(-m*g)]")).is_none());
}
