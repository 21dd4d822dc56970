//! A rattleback: spun the one way it goes on for long, spun the other way it begins to rattle, stops and turns back. Nothing is lost:
//! the energy goes from the spin to the rattling and back. How fast the rattling grows either way, the linearised equations tell.
//!
//! ```text
//! cargo run --release --example rattleback
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{Rattleback, RattlebackState};
use std::path::Path;
use std::process::ExitCode;

/// Figures of the size of those in Kane and Levinson 1982.
const STONE: Rattleback =
    Rattleback { m: 1.0, a: 0.2, b: 0.03, c: 0.02, h: 0.01, ixx: 2e-4, iyy: 1.6e-3, izz: 1.7e-3, ixy: -2e-5, g: 9.81 };

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let stone = STONE.prepare()?;
    let cost = Rattleback::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("A rattleback: {operations} operations and {} sincos a step", cost.sincos);
    let lying = stone.assemble(RattlebackState { z: 0.02, ..Default::default() }).hold("roll").hold("pitch").solve()?;
    checks.below(
        "at rest it carries its weight / N",
        (stone.outputs(0.0, &lying, &[]).normal - STONE.m * STONE.g).abs(),
        1e-12,
    );

    // Small oscillations at rest: none of them grows by itself.
    let all = stone.linearize(0.0, &lying, &[])?.eigenvalues()?;
    let growth = all.iter().map(|value| value.re.abs()).fold(0.0, f64::max);
    checks.below("growth of the oscillations at rest / (1/s)", growth, 1e-9);
    // Spun, one of them does, one way and not the other: what the trick is made of.
    let fastest = |spin: f64| -> Result<f64, Error> {
        let spinning = RattlebackState { dot_spin: spin, ..lying };
        let modes = stone.linearize(0.0, &spinning, &[])?.eigenvalues()?;
        // Of those that swing fast.
        Ok(modes.iter().filter(|value| value.im > 1.0).map(|value| value.re).fold(f64::NEG_INFINITY, f64::max))
    };
    let (left, right) = (fastest(5.0)?, fastest(-5.0)?);
    println!("  at 5 rad/s the rattling grows by {left:.3} 1/s to the left, by {right:.3} to the right");
    checks.hold("it grows faster one way", right > 5.0 * left);

    let end = 20.0;
    let mut curves = Vec::new();
    let mut turns = Vec::new();
    for (label, spin) in [("to the right", -5.0), ("to the left", 5.0)] {
        let guess = RattlebackState { dot_spin: spin, roll: 0.01, pitch: 0.005, ..lying };
        let start = stone.assemble(guess).hold("roll").hold("pitch").solve()?;
        let run = stone.simulate(start).tolerance(1e-11, 1e-11).until(end)?;
        let first = stone.energy(0.0, &start);
        let lost = run.iter().map(|(t, s)| (stone.energy(t, s) / first - 1.0).abs()).fold(0.0, f64::max);
        checks.below("energy lost (relative)", lost, 1e-8);
        checks.below("height of the contact / m", run.largest_residuals().position, 1e-12);
        let mut spins = Vec::new();
        let mut least = f64::INFINITY;
        for i in 0..=2000 {
            let t = (end * f64::from(i) / 2000.0).min(end);
            let told = stone.outputs(t, &run.at(t)?, &[]);
            least = least.min(told.normal);
            spins.push((t, told.turning));
        }
        println!("  spun {label}: it presses with at least {least:.2} N");
        let back = spins.iter().find(|(_, turning)| turning * spin < 0.0).map_or(f64::INFINITY, |(t, _)| *t);
        println!("  and turns back after {back:.2} s");
        turns.push(back);
        curves.push((label, spins));
    }
    checks.hold("to the right it turns back much sooner", turns[0] < 0.5 * turns[1]);

    let svg = Path::new("target/rattleback/rattleback.svg");
    draw(svg, &[&[Panel { title: "spin about the vertical", labels: ["t / s", "rad/s"], equal: false, curves }]])?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
