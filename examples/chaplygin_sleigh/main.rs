//! Chaplygin's sleigh: a body on ice with one blade. No force acts and no energy is lost, and yet it ends up gliding straight,
//! with its mass centre ahead. One run against the closed form, with the force on the blade.
//!
//! ```text
//! cargo run --release --example chaplygin_sleigh
//! ```

#[path = "../common/mod.rs"]
mod common;
mod exact;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use exact::Exact;
use holonomy::prelude::*;
use models::{Sleigh, SleighState};
use std::path::Path;
use std::process::ExitCode;

const END: f64 = 8.0;
const SAMPLES: usize = 800;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let (m, i, a) = (2.5, 0.3, 0.4);
    let sleigh = Sleigh { m, i, a }.prepare()?;
    // It starts backwards, and turns.
    let start = SleighState { x: 0.1, y: -0.2, phi: 0.3, u: -1.2, o: 0.9 };
    let exact = Exact::new([m, i, a], start.u, start.o);
    let run = sleigh.simulate(start).tolerance(1e-12, 1e-12).until(END)?;

    println!("Chaplygin's sleigh, {END} s in {} steps\n", run.statistics().accepted);
    println!("      t      forward    turning    heading/°    force on the blade / N");
    let mut checks = Checks::default();
    let (mut motion, mut force, mut energy) = (0.0f64, 0.0f64, 0.0f64);
    let (mut path, mut ahead, mut forces) = (Vec::new(), Vec::new(), Vec::new());
    let (mut speeds, mut turning) = (Vec::new(), Vec::new());
    for step in 0..=SAMPLES {
        let t = END * step as f64 / SAMPLES as f64;
        let s = run.at(t)?;
        let blade = sleigh.multipliers(t, &s, &[]).blade;
        let (u, o) = (exact.forward(t), exact.turning(t));
        motion = motion.max((s.u - u).abs()).max((s.o - o).abs()).max((s.phi - start.phi - exact.turned(t)).abs());
        force = force.max((blade - exact.force(t)).abs());
        energy = energy.max((sleigh.energy(t, &s) / sleigh.energy(0.0, &start) - 1.0).abs());
        path.push((s.x, s.y));
        ahead.push((s.x + a * s.phi.cos(), s.y + a * s.phi.sin()));
        speeds.push((t, s.u));
        turning.push((t, s.o));
        forces.push((t, blade));
        if step % 100 == 0 {
            println!("  {t:5.1} {:12.6} {:10.6} {:12.4} {blade:20.6}", s.u, s.o, s.phi.to_degrees());
        }
    }
    println!();
    checks.below("speeds and heading against the closed form", motion, 1e-9);
    checks.below("force on the blade against the closed form / N", force, 1e-8);
    checks.below("energy (relative)", energy, 1e-10);
    // Where it ends was computed elsewhere, with 24 digits.
    let end = run.last().1;
    checks.below("where it ends / m", (end.x + 6.72871229645976).hypot(end.y + 6.1049043429903636), 1e-9);
    checks.hold("it glides forward in the end", end.u > 0.0 && end.o.abs() < 1e-4);

    let svg = Path::new("target/chaplygin_sleigh/chaplygin_sleigh.svg");
    let panel = |title, labels, curves| Panel { title, labels, equal: false, curves };
    draw(
        svg,
        &[
            &[Panel {
                title: "path on the ice",
                labels: ["x / m", "y / m"],
                equal: true,
                curves: vec![("blade", path), ("mass centre", ahead)],
            }],
            &[
                panel("speeds", ["t / s", "m/s, rad/s"], vec![("forward", speeds), ("turning", turning)]),
                panel("force of the ice on the blade", ["t / s", "λ / N"], vec![("", forces)]),
            ],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
