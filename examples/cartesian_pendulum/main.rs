//! The pendulum in x and y, swung over the top: two choices of independent speeds take turns, the rod stays as long as it is,
//! and events find the top and the bottom. Its period against the elliptic integral.
//!
//! ```text
//! cargo run --release --example cartesian_pendulum
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use holonomy::simulate::Event;
use models::{CartesianPendulum, CartesianPendulumState};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;
use std::process::ExitCode;

const M: f64 = 1.5;
const L: f64 = 0.8;
const G: f64 = 9.81;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let pendulum = CartesianPendulum { m: M, l: L, g: G }.prepare()?;
    println!("A pendulum in x and y\n");
    for note in CartesianPendulum::MODEL.notes {
        println!("  note: {note}");
    }

    // Over the top: v² at the bottom is above 4 g l.
    let speed = (4.6 * G * L).sqrt();
    let start = CartesianPendulumState { x: 0.0, y: -L, dot_x: speed };
    let end = 60.0;
    let run = pendulum
        .simulate(start)
        .tolerance(1e-12, 1e-12)
        .event(Event::<CartesianPendulum>::new("bottom or top", |_, s| s.x))
        .until(end)?;
    let statistics = run.statistics();
    println!("\nOver the top: {} steps, {} changes of the chart", statistics.accepted, statistics.chart_changes);
    // A full turn takes 4 l/v K(k) with k² = 4 g l/v².
    let turn = 4.0 * L / speed * elliptic_k((4.0 * G * L).sqrt() / speed);
    let times: Vec<f64> = run.events().iter().map(|event| event.time).collect();
    let late = times.iter().enumerate().map(|(i, time)| (time - 0.5 * turn * (i + 1) as f64).abs());
    checks.hold("every half turn is found", times.len() == (2.0 * end / turn) as usize);
    checks.below("times of bottom and top against the elliptic integral / s", late.fold(0.0, f64::max), 1e-8);
    let energy = pendulum.energy(0.0, &start);
    let (mut loss, mut pull) = (0.0f64, 0.0f64);
    for ((t, s), v) in run.iter().zip(run.velocities()) {
        let (x, square) = (pendulum.coordinates(t, s), v.dot_x * v.dot_x + v.dot_y * v.dot_y);
        loss = loss.max(((0.5 * M * square + M * G * x[1]) / energy - 1.0).abs());
        pull = pull.max((run.outputs_at(t, &[])?.tension - M / L * (square - G * x[1])).abs());
    }
    checks.below("energy (relative)", loss, 1e-10);
    checks.below("tension against (m/l)(v² - g y) / N", pull, 1e-8);
    checks.below("length of the rod at the end of any step (relative)", run.largest_residuals().position, 1e-14);

    // Released level: a quarter of the period is √(l/g) K(sin 45°).
    let level = CartesianPendulumState { x: L, y: 0.0, dot_x: 0.0 };
    let fall = pendulum.simulate(level).velocities([0.0, 0.0].into()).tolerance(1e-12, 1e-12);
    let fall = fall.stop_at("bottom", |_, s| s.x).until(10.0)?;
    let quarter = (L / G).sqrt() * elliptic_k((TAU / 8.0).sin());
    checks.below("released level: time to the bottom / s", (fall.last().0 - quarter).abs(), 1e-9);

    let svg = Path::new("target/cartesian_pendulum/cartesian_pendulum.svg");
    let sample = |f: &dyn Fn(f64) -> Result<f64, Error>| -> Result<Vec<(f64, f64)>, Error> {
        (0..=1200).map(|i| 0.0025 * f64::from(i)).map(|t| Ok((t, f(t)?))).collect()
    };
    let panel = |title, label, curves| Panel { title, labels: ["t / s", label], equal: false, curves };
    let horizontal = sample(&|t| Ok(run.velocities_at(t)?.dot_x))?;
    let vertical = sample(&|t| Ok(run.velocities_at(t)?.dot_y))?;
    let height = sample(&|t| Ok(run.at(t)?.y))?;
    let tension = sample(&|t| Ok(run.outputs_at(t, &[])?.tension))?;
    draw(
        svg,
        &[
            &[
                panel("height", "y / m", vec![("", height)]),
                panel("speeds", "m/s", vec![("dx/dt", horizontal), ("dy/dt", vertical)]),
            ],
            &[panel("pull of the rod", "N", vec![("", tension)])],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}

/// K(k) by the arithmetic-geometric mean.
fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    while (a - b).abs() > 4.0 * f64::EPSILON * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    FRAC_PI_2 / a
}
