//! A particle in a vertical plane whose path is steered to a curvature: a constraint stated for accelerations, which binds
//! no velocity. Run through full turns, checked against the circle that the path must be, and drawn.
//!
//! ```text
//! cargo run --release --example curvature
//! ```

#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::{ConstrainedSystem, Error, Level, Prepared};
use models::{SteeredParticle, SteeredParticleState};
use std::path::Path;
use std::process::ExitCode;

const M: f64 = 0.8;
const G: f64 = 9.81;
const KAPPA: f64 = 2.5;

/// What a run shows: its samples (t, x, y, v, force across the path) and the largest errors.
#[derive(Default)]
struct Run {
    samples: Vec<[f64; 5]>,
    radius: f64,
    energy: f64,
    force: f64,
    full: f64,
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let model = SteeredParticle { m: M, g: G, kappa: KAPPA }.prepare()?;
    let mut checks = Checks::default();
    println!("A path of prescribed curvature\n");
    for note in SteeredParticle::MODEL.notes {
        println!("  note: {note}");
    }
    for equation in SteeredParticle::MODEL.equations.iter().filter(|e| ["C", "c0*", "lambda(path)"].contains(&e.symbol))
    {
        println!("  {} = {}", equation.symbol, equation.text);
    }
    checks.hold("the row binds accelerations", SteeredParticle::MODEL.rows[0].level == Level::Acceleration);

    // Fast enough for full turns: every direction of motion occurs, and every component of the velocity vanishes.
    println!("\n3 s from (4.5, 0) m/s");
    let run = simulate(&model, SteeredParticleState { dot_x: 4.5, ..Default::default() }, 3.0)?;
    checks.below("distance from the circle of radius 1/κ (relative)", run.radius, 1e-8);
    checks.below("energy (relative)", run.energy, 1e-9);
    checks.below("force across the path against m (κ v² + g cos ψ) (relative)", run.force, 1e-12);
    checks.below("accelerations and λ against the full equations (2.8) (relative)", run.full, 1e-12);
    let level = |sample: &[f64; 5]| sample[1].abs() > 0.99 / KAPPA;
    checks.hold("it came to both sides of the circle", run.samples.iter().filter(|s| level(s)).count() > 4);

    let curve = |across: usize, along: usize| run.samples.iter().map(|s| (s[across], s[along])).collect::<Vec<_>>();
    let path = Path::new("target/curvature/curvature.svg");
    let panel = |title, labels, equal, points| Panel { title, labels, equal, curves: vec![("", points)] };
    let way = panel("path", ["x / m", "y / m"], true, curve(1, 2));
    let speed = panel("speed", ["t / s", "v / (m/s)"], false, curve(0, 3));
    let force = panel("force across the path", ["t / s", "N / N"], false, curve(0, 4));
    draw(path, &[&[way], &[speed, force]])?;
    println!("\nwritten: {}", path.display());
    Ok(checks.verdict())
}

fn simulate(model: &Prepared<SteeredParticle>, start: SteeredParticleState, until: f64) -> Result<Run, Error> {
    let trajectory = model.simulate(start).tolerance(1e-12, 1e-12).every(until / 1500.0).until(until)?;
    let mut run = Run::default();
    let energy = model.energy(0.0, &start);
    for (t, s) in trajectory.iter() {
        let v = s.dot_x.hypot(s.dot_y);
        // C has the length v, so the force across the path is λ v.
        let lambda = model.multipliers(t, s, &[]).path;
        let expected = M * (KAPPA * v * v + G * s.dot_x / v);
        run.force = run.force.max((lambda * v - expected).abs() / (M * KAPPA * v * v));
        run.radius = run.radius.max((s.x.hypot(s.y - 1.0 / KAPPA) * KAPPA - 1.0).abs());
        run.energy = run.energy.max((model.energy(t, s) / energy - 1.0).abs());
        let (rates, multipliers) = model.initial_equations_at(t, s, &[]).solve()?;
        let found = model.velocity_rates(t, s, &[]);
        let scale = rates.amax();
        let errors =
            [(found.dot_x - rates[0]) / scale, (found.dot_y - rates[1]) / scale, lambda / multipliers[0] - 1.0];
        run.full = errors.iter().fold(run.full, |worst, error| worst.max(error.abs()));
        run.samples.push([t, s.x, s.y, v, lambda * v]);
    }
    Ok(run)
}
