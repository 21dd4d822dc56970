//! A car's axle on two springs, one of which the road moves: position constraints that depend on time, light masses, and
//! reactions. One run against the end that the test set for initial value problems publishes.
//!
//! ```text
//! cargo run --release --example car_axis
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{CarAxle, CarAxleState, CarAxleVelocities};
use std::path::Path;
use std::process::ExitCode;

const END: f64 = 3.0;

/// Test Set for IVP Solvers, problem caraxis, at t = 3: coordinates, velocities, multipliers. A computation with 26 digits confirms
/// twelve of the first four, nine of the next four and seven of the last two.
const PUBLISHED: [f64; 10] = [
    0.04934557842755629,
    0.4969894602303324,
    1.0417425248854,
    0.3739110272652214,
    -0.07705836840321485,
    0.007446866596327776,
    0.01755681574942899,
    0.770341043779403,
    -0.00473688675078463,
    -0.00110468041134573,
];

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let axle = CarAxle { eps: 0.01, m: 10.0, l: 1.0, l0: 0.5, r: 0.1, w: 10.0, g: 1.0 }.prepare()?;
    let mut checks = Checks::default();
    let start = CarAxleState { xl: 0.0, yl: 0.5, xr: 1.0, yr: 0.5, dot_yl: 0.0, dot_yr: 0.0 };
    // The road's rate sets the horizontal speeds: they follow from the constraints.
    let v = axle.velocities(0.0, &start);
    println!("A car's axle, {END} s; at the start the constraints ask for dx/dt = {} and {}", v.dot_xl, v.dot_xr);
    checks.below("these speeds against -1/2", (v.dot_xl + 0.5).abs().max((v.dot_xr + 0.5).abs()), 1e-14);

    let run = axle.simulate(start).tolerance(1e-12, 1e-12).until(END)?;
    let (t, end) = run.last();
    let (x, v): ([f64; 4], CarAxleVelocities) = (axle.coordinates(t, end), axle.velocities(t, end));
    let (v, lambda): ([f64; 4], [f64; 2]) = (v.into(), axle.multipliers(t, end, &[]).into());
    let apart = |found: &[f64], published: &[f64]| {
        found.iter().zip(published).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
    };
    println!("{} steps, {} changes of the chart", run.statistics().accepted, run.statistics().chart_changes);
    checks.below("coordinates against the published ones (relative)", apart(&x, &PUBLISHED[..4]), 1e-9);
    checks.below("velocities (relative)", apart(&v, &PUBLISHED[4..8]), 3e-9);
    checks.below("multipliers (relative)", apart(&lambda, &PUBLISHED[8..]), 2e-7);
    checks.below("residual of f at the end of any step (relative)", run.largest_residuals().position, 1e-13);

    let sample = |f: &dyn Fn(f64, &CarAxleState) -> f64| -> Result<Vec<(f64, f64)>, Error> {
        (0..=1500).map(|i| END * f64::from(i) / 1500.0).map(|t| Ok((t, f(t, &run.at(t)?)))).collect()
    };
    let panel = |title, label, curves| Panel { title, labels: ["t / s", label], equal: false, curves };
    let left = sample(&|_, s| s.yl)?;
    let right = sample(&|_, s| s.yr)?;
    let road = sample(&|t, _| 0.1 * (10.0 * t).sin())?;
    let across = sample(&|_, s| s.xl)?;
    let foot = sample(&|t, s| axle.multipliers(t, s, &[]).foot)?;
    let bar = sample(&|t, s| axle.multipliers(t, s, &[]).axle)?;
    let svg = Path::new("target/car_axis/car_axis.svg");
    draw(
        svg,
        &[
            &[
                panel("heights", "y", vec![("left", left), ("right", right), ("road", road)]),
                panel("the left end to and fro", "x", vec![("", across)]),
            ],
            &[panel("multipliers", "λ", vec![("foot", foot), ("axle", bar)])],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
