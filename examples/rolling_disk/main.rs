//! The rolling disk of Blajer (1992), section 6: derived by the compiler in the paper's three formulations, compared with
//! the paper, run, checked and drawn.
//!
//! ```text
//! cargo run --release --example rolling_disk
//! ```

#[path = "../common/mod.rs"]
mod common;
mod expansion;
mod geometry;
mod models;
mod motion;
mod picture;
mod printed;
mod stability;

use common::checks::Checks;
use holonomy::{ConstrainedSystem, Description};
use motion::{Disks, Posture};
use std::path::PathBuf;
use std::process::ExitCode;

const M: f64 = 2.0;
const R: f64 = 0.5;
const J: f64 = 0.125;
const G: f64 = 9.81;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let disks = Disks::new(M, R, J, G)?;
    let posture = Posture { x: 0.0, y: 0.0, phi: 0.6, theta: 0.35, psi: 0.0, rates: [1.1, -0.4, -5.2] };
    let mut checks = Checks::default();

    println!("The rolling disk of Blajer (1992), section 6\n");
    derived(
        "six quasi-velocities, (6.2)-(6.13)",
        models::RollingDisk::MODEL,
        &["D", "M_d", "h_u*", "lambda(no_slip_along)", "lambda(no_slip_across)", "lambda(contact)"],
    );
    derived("five generalised coordinates, (6.14)-(6.20)", models::FloorDisk::MODEL, &["M_d"]);
    derived("two stages down to three rates, (6.21)-(6.29)", models::StagedDisk::MODEL, &["M_d", "h_u*"]);

    derived("and from geometry alone", geometry::Disk::MODEL, &["M_d", "h_u*"]);
    let geometric = geometry::Disk { m: M, r: R, j: J, g: G }.prepare()?;
    let state = posture.quasi();
    let bodies = geometry::DiskState::from(<[f64; 9]>::from(state));
    let (a, b) = (disks.quasi.accelerations(0.0, &state, &[]), geometric.accelerations(0.0, &bodies, &[]));
    let (force, contact) = (disks.quasi.multipliers(0.0, &state, &[]), geometric.multipliers(0.0, &bodies, &[]));
    let apart = |a: f64, b: f64| (a - b).abs() / (M * G);
    checks.below(
        "accelerations and reactions, by equations and by geometry (relative)",
        a.iter().zip(b).map(|(a, b)| apart(*a, b)).fold(apart(force.contact, contact.no_slip_z), f64::max),
        1e-13,
    );
    println!();

    println!("The printed formulas at φ = 0.6, θ = 0.35, rates 1.1, -0.4, -5.2 (derived | printed)\n");
    let lines = printed::lines(&disks, &posture, [M, R, J, G]);
    for line in &lines {
        let verdict = if line.holds() { "" } else { "  the print is wrong" };
        println!("  {:7} {:16} {:>12.6} | {:>12.6}{verdict}", line.equation, line.quantity, line.derived, line.printed);
    }
    let wrong = lines.iter().filter(|line| !line.holds()).count();
    println!("\n  {} of {} compared entries do not hold as printed\n", wrong, lines.len());
    // The list of errors is known: two entries of A, (6.11) row 3, three signs of λ, (6.18), (6.19), (6.27), (6.28).
    checks.hold("entries that do not hold as printed: 12", wrong == 12);

    println!("One motion through all three formulations, 10 s");
    let run = motion::compare(&disks, &posture, 10.0)?;
    checks.below("largest difference in a coordinate or a rate", run.disagreement, 1e-8);
    checks.below("largest difference in a reaction / N", run.force, 1e-6);
    checks.below("energy, six quasi-velocities (relative)", run.energy[0], 1e-10);
    checks.below("energy, five coordinates with friction as input", run.energy[1], 1e-9);
    checks.below("energy, three rates", run.energy[2], 1e-10);
    checks.below("height of the contact point / m", run.drift[0], 1e-12);
    checks.below("slip under the computed friction / (m/s)", run.drift[1], 1e-8);
    println!("  the coefficient of friction must be at least {:.4}", run.friction);
    checks.below("its difference from the third formulation", run.friction_error, 1e-6);
    println!("\n      t      lean/°    reactions of the floor on the disk: x, y, z / N");
    for (t, p, force) in run.samples.iter().step_by(100) {
        println!("  {t:5.1} {:10.4}    {:10.5} {:10.5} {:10.5}", p.theta.to_degrees(), force[0], force[1], force[2]);
    }

    println!("\nStability of straight rolling");
    let exact = (M * G * R / (2.0 * (M * R * R + 2.0 * J))).sqrt();
    let found = stability::threshold(&disks, 0.5 * exact, 2.0 * exact, 0.001)?;
    println!("  threshold of |dψ/dt|: {found:.4} rad/s by bisection, {exact:.4} analytic");
    checks.below("relative difference", (found / exact - 1.0).abs(), 0.005);

    let folder = PathBuf::from("target/rolling_disk");
    std::fs::create_dir_all(&folder)?;
    let (svg, code) = (folder.join("rolling_disk.svg"), folder.join("rolling_disk.expanded.rs"));
    picture::draw(&run.samples, &svg)?;
    expansion::write(include_str!("models.rs"), &code)?;
    println!("\nwritten: {} and {}", svg.display(), code.display());
    Ok(checks.verdict())
}

/// Equations of a model as the derive describes them.
fn derived(title: &str, model: &Description, symbols: &[&str]) {
    println!("{title}");
    for equation in model.equations.iter().filter(|e| symbols.contains(&e.symbol)) {
        // One row of a matrix a line.
        let text = equation.text.replace("], [", &format!("],\n{:33}[", ""));
        println!("  {:22} {:7} {text}", equation.symbol, equation.source);
    }
    for note in model.notes {
        println!("  note: {note}");
    }
    let cost = model.operations.iter().find(|cost| cost.function == "derivative");
    if let Some(cost) = cost {
        let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
        println!("  the whole derivative takes {operations} operations and {} sincos", cost.sincos);
    }
    println!();
}
