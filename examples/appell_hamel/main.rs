//! A particle whose velocity keeps its angle with the vertical (Appell 1911, Hamel): a constraint that is quadratic in the
//! velocities, with two branches, run on both, checked against the closed form and drawn.
//!
//! ```text
//! cargo run --release --example appell_hamel
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::{ConstrainedSystem, Error, Prepared};
use models::{SteadySlope, SteadySlopeState};
use std::path::Path;
use std::process::ExitCode;

const M: f64 = 0.9;
const G: f64 = 9.81;
const A: f64 = 1.3;

/// One run: the time, the way along the ground, the height, λ.
struct Branch {
    rows: Vec<[f64; 4]>,
    motion: f64,
    reaction: f64,
    residual: f64,
    energy: f64,
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let model = SteadySlope { m: M, g: G, a: A }.prepare()?;
    let mut checks = Checks::default();
    println!("A velocity that keeps its angle with the vertical\n");
    for note in SteadySlope::MODEL.notes {
        println!("  note: {note}");
    }
    for guard in SteadySlope::MODEL.guards {
        println!("  guard of {:?}: {}", guard.rows, guard.name);
    }

    // x' and y' are given; the vertical speed follows, on the branch of the guess.
    let guess = SteadySlopeState { dot_x: 6.0, dot_y: -4.0, ..Default::default() };
    let up = model.solve_velocities(0.0, &SteadySlopeState { dot_z: 5.0, ..guess }, &["dot_x", "dot_y"])?;
    let down = model.solve_velocities(0.0, &SteadySlopeState { dot_z: -5.0, ..guess }, &["dot_x", "dot_y"])?;
    checks.below("vertical speeds of the two branches: sum / (m/s)", (up.dot_z + down.dot_z).abs(), 1e-14);

    // Upwards the speed is lost at t = (1 + a²) z'/g, where the constraint loses its direction.
    let end = (1.0 + A * A) * up.dot_z / G;
    let mut drawn = Vec::new();
    for (name, start, until) in [("upwards", up, 0.95 * end), ("downwards", down, 0.95 * end)] {
        println!("\n{name}, {until:.3} s from z' = {:.4} m/s", start.dot_z);
        let branch = run(&model, start, until)?;
        checks.below("motion against the closed form / m, m/s", branch.motion, 1e-7);
        checks.below("λ against -m g/((1 + a²) z') (relative)", branch.reaction, 1e-7);
        checks.below("residual of the constraint / (m/s)²", branch.residual, 1e-6);
        checks.below("energy (relative)", branch.energy, 1e-8);
        drawn.push((name, branch));
    }

    println!("\nat rest the constraint binds nothing");
    let error = model.check_rank(0.0, &SteadySlopeState::default()).err();
    if let Some(error) = &error {
        println!("  {error}");
    }
    let named = matches!(&error, Some(Error::Dependent { rows, .. }) if *rows == ["angle"]);
    checks.hold("the loss of rank is an error that names the constraint", named);

    let curve = |across: usize, along: usize| {
        drawn.iter().map(|(name, b)| (*name, b.rows.iter().map(|row| (row[across], row[along])).collect())).collect()
    };
    let path = Path::new("target/appell_hamel/appell_hamel.svg");
    let labels = |across, along| [across, along];
    let panels = [
        Panel { title: "path", labels: labels("way along the ground / m", "z / m"), equal: true, curves: curve(1, 2) },
        Panel { title: "multiplier", labels: labels("t / s", "λ / (N s/m)"), equal: false, curves: curve(0, 3) },
    ];
    draw(path, &[&panels])?;
    println!("\nwritten: {}", path.display());
    Ok(checks.verdict())
}

/// The motion is along a straight line with z'' = -g/(1 + a²): the constraint takes a part of the weight.
fn run(model: &Prepared<SteadySlope>, start: SteadySlopeState, until: f64) -> Result<Branch, Error> {
    let run = model.simulate(start).tolerance(1e-12, 1e-12).every(until / 200.0).until(until)?;
    let fall = -G / (1.0 + A * A);
    let mut branch = Branch { rows: Vec::new(), motion: 0.0, reaction: 0.0, residual: 0.0, energy: 0.0 };
    let energy = model.energy(0.0, &start);
    for (t, s) in run.iter() {
        let (risen, rate) = (start.dot_z * t + fall * t * t / 2.0, start.dot_z + fall * t);
        let exact = [
            (s.x, start.dot_x / start.dot_z * risen),
            (s.y, start.dot_y / start.dot_z * risen),
            (s.z, risen),
            (s.dot_x, start.dot_x / start.dot_z * rate),
            (s.dot_y, start.dot_y / start.dot_z * rate),
            (s.dot_z, rate),
        ];
        branch.motion = exact.iter().fold(branch.motion, |worst, (found, exact)| worst.max((found - exact).abs()));
        let lambda = model.multipliers(t, s, &[]).angle;
        let expected = -M * G / ((1.0 + A * A) * rate);
        branch.reaction = branch.reaction.max((lambda / expected - 1.0).abs());
        branch.residual = branch.residual.max(model.velocity_residual_at(t, s)[0].abs());
        branch.energy = branch.energy.max((model.energy(t, s) / energy - 1.0).abs());
        branch.rows.push([t, s.x.hypot(s.y), s.z, lambda]);
    }
    Ok(branch)
}
