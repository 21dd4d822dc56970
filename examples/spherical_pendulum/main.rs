//! The spherical pendulum in x, y, z, its rod a constraint: one choice of independent speeds breaks down on the level, and the run
//! leaves it in time, comes back, and loses nothing on the way.
//!
//! ```text
//! cargo run --release --example spherical_pendulum
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;
mod motion;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::Error;
use holonomy::prelude::*;
use holonomy::simulate::{Chart, Charts};
use models::{InAngles, InAnglesState, OneChart, OneChartState, ThreeCharts, ThreeChartsState};
use motion::{Drift, G, L, M, drift, place};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let one = OneChart { m: M, l: L, g: G }.prepare()?;
    let three = ThreeCharts { m: M, l: L, g: G }.prepare()?;
    let angles = InAngles { m: M, l: L, g: G }.prepare()?;

    println!("Through the level with one chart, independent dx/dt and dy/dt, 20 s");
    let start = OneChartState { x: 0.0, y: 0.0, z: -L, dot_x: 7.5, dot_y: 0.0 };
    let stopped = one.simulate(start).charts(Charts::Stay).until(20.0).unwrap_err();
    println!("  told to stay in it: {stopped}");
    checks.hold("it stops on the level", matches!(stopped.error, Error::ChartSingularity { guard: "z", .. }));
    let run = one.simulate(start).tolerance(1e-12, 1e-12).until(20.0)?;
    told(run.charts(), run.statistics().chart_changes);
    let loss: Drift = drift(&one, &run);
    checks.below("energy (relative)", loss.energy, 1e-9);
    checks.below("length of the rod (relative)", loss.rod, 1e-14);

    println!("\nA thousand changes between three charts, against the same motion in angles");
    let [theta, phi, theta_rate, phi_rate] = [1.35, 0.2, 0.4, 9.0];
    let (x, v) = place([theta, phi, theta_rate, phi_rate]);
    let start = ThreeChartsState { x: x[0], y: x[1], z: x[2], dot_x: v[0], dot_y: v[1] };
    let around = three.simulate(start).tolerance(1e-14, 1e-14).dense(false).until(185.0)?;
    told(around.charts(), around.statistics().chart_changes);
    let start = InAnglesState { theta, phi, dot_theta: theta_rate, dot_phi: phi_rate };
    let exact = angles.simulate(start).tolerance(1e-14, 1e-14).until(185.0)?;
    checks.hold("at least 1,000 changes", around.statistics().chart_changes >= 1000);
    let loss = drift(&three, &around);
    checks.below("energy (relative)", loss.energy, 1e-10);
    checks.below("length of the rod (relative)", loss.rod, 1e-14);
    let (_, end) = exact.last();
    let (there, _) = place([end.theta, end.phi, end.dot_theta, end.dot_phi]);
    let (_, here) = around.last();
    let apart = [here.x - there[0], here.y - there[1], here.z - there[2]].iter().map(|d| d * d).sum::<f64>().sqrt();
    checks.below("distance from the motion in angles after 265 turns / m", apart, 1e-7);

    println!("\nUndriven for 1,000 s at a relative tolerance of 1e-10");
    let start = ThreeChartsState { x: 0.48, y: 0.0, z: -0.64, dot_x: 0.0, dot_y: 1.2 };
    let long = three.simulate(start).tolerance(1e-10, 1e-10).dense(false).until(1000.0)?;
    checks.below("residual of the rod at the end of any step (relative)", long.largest_residuals().position, 1e-10);
    checks.below("energy (relative)", drift(&three, &long).energy, 1e-7);

    let svg = PathBuf::from("target/spherical_pendulum/spherical_pendulum.svg");
    let times: Vec<f64> = (0..=2000).map(|i| 0.002 * f64::from(i)).collect();
    let along = |f: &dyn Fn(f64) -> Result<f64, Error>| -> Result<Vec<(f64, f64)>, Error> {
        times.iter().map(|t| Ok((*t, f(*t)?))).collect()
    };
    let path = around.iter().take(1500).map(|(_, s)| (s.x, s.y)).collect();
    let height = along(&|t| Ok(run.at(t)?.z))?;
    let speed = along(&|t| Ok(run.velocities_at(t)?.dot_z))?;
    // λ times the length of the gradient: what the rod pulls.
    let tension = along(&|t| Ok(-run.multipliers_at(t, &[])?.rod * L))?;
    let panel =
        |title, label, curve| Panel { title, labels: ["t / s", label], equal: false, curves: vec![("", curve)] };
    draw(
        &svg,
        &[
            &[Panel {
                title: "around the level, from above",
                labels: ["x / m", "y / m"],
                equal: true,
                curves: vec![("", path)],
            }],
            &[
                panel("through the level: height", "z / m", height),
                panel("the speed that the state does not hold", "dz/dt / (m/s)", speed),
                panel("pull of the rod", "N", tension),
            ],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}

/// In which charts a run took its steps.
fn told(charts: &[(Chart, usize)], changes: usize) {
    let list: Vec<String> = charts
        .iter()
        .map(|(chart, steps)| match chart {
            Chart::Emitted(chart) => format!("{steps} steps in chart {chart}"),
            Chart::General => format!("{steps} in the general chart"),
        })
        .collect();
    println!("  {}; {changes} changes", list.join(", "));
}
