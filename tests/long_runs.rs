//! Closed loops that turn for long: angles of many turns are no reason for other steps or other charts.

#[path = "../examples/four_bar/models.rs"]
#[allow(dead_code, reason = "the other one is the example's")]
mod four_bar;

use four_bar::{ByRocker, ByRockerState};
use holonomy::prelude::*;
use holonomy::{State, Trajectory};
use std::f64::consts::TAU;

/// Three turns of the crank, which begin after so many others.
fn three_turns(after: f64) -> Trajectory<ByRocker> {
    let bar = ByRocker { a: 0.3, b: 1.2, c: 1.0, d: 1.4, m1: 0.5, m2: 1.0, m3: 10.0, load: 2.0, g: 9.81 };
    let bar = bar.prepare().expect("the parameters are good");
    let guess = ByRockerState { crank: after * TAU, coupler: 0.8, rocker: 2.0, dot_rocker: -5.0 };
    let start = bar.assemble(guess).hold("crank").set("dot_crank", 12.0).solve().expect("it closes");
    let end = move |_: f64, s: &State<ByRocker>| s.crank - (after + 3.0) * TAU;
    bar.simulate(start).tolerance(1e-10, 1e-10).stop_at("three turns", end).until(10.0).expect("it runs")
}

/// The size of a pivot is judged by how large it becomes on the way, and not by how far the angle has come in it.
#[test]
fn angles_of_many_turns() {
    let (fresh, late) = (three_turns(0.0), three_turns(10_000.0));
    let (first, second) = (fresh.statistics(), late.statistics());
    assert!(first.chart_changes >= 12, "{first:?}");
    assert!(second.chart_changes <= first.chart_changes + 3, "{second:?} instead of {first:?}");
    assert!((second.accepted as f64) < 1.3 * first.accepted as f64, "{second:?} instead of {first:?}");
    assert!((fresh.last().0 - late.last().0).abs() < 1e-8);
}
