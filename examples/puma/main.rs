//! The Puma 560: the published torques that hold it and that its rates call for, and a motion from one pose to another whose torques
//! are found by inverse dynamics and then driven through the arm itself.
//!
//! ```text
//! cargo run --release --example puma
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{PumaArm, PumaArmInputs, PumaArmState};
use std::f64::consts::{FRAC_PI_4, PI};
use std::path::Path;
use std::process::ExitCode;

/// The pose at which figures were published, and those figures: torques in N m that hold the arm there, and that its rates call for.
const READY: [f64; 6] = [0.0, FRAC_PI_4, PI, 0.0, FRAC_PI_4, 0.0];
const RATES: [f64; 6] = [1.0, 2.0, 3.0, 1.0, 2.0, 3.0];
const HOLDING: [f64; 6] = [0.0, 31.6399, 6.0351, 0.0, 0.0283, 0.0];
const OF_RATES: [f64; 6] = [-4.6346, 8.7258, -1.9267, 0.0021, 0.0190, 0.0001];

/// Where the motion ends, and how long it takes.
const THERE: [f64; 6] = [1.2, -0.4, 2.2, 0.8, -0.6, 1.5];
const TIME: f64 = 1.5;

fn off(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Angles, rates and accelerations on the way, at rest at both ends: the polynomial of fifth degree in t / TIME.
fn wanted(t: f64) -> (PumaArmState, [f64; 6]) {
    let s = t / TIME;
    let way = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * s * s * (1.0 - s).powi(2) / TIME;
    let second = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / TIME.powi(2);
    let along = |i: usize| THERE[i] - READY[i];
    let state = |i: usize| if i < 6 { READY[i] + way * along(i) } else { rate * along(i - 6) };
    (PumaArmState::from_fn(state), std::array::from_fn(|i| second * along(i)))
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let arm = PumaArm::UNIMATE.prepare()?;
    let cost = |function: &str| {
        let found = PumaArm::MODEL.operations.iter().find(|cost| cost.function == function);
        found.map_or(0, |cost| cost.additions + cost.multiplications + cost.divisions + cost.roots)
    };
    println!("The Puma 560: {} operations for its motion,", cost("derivative"));
    println!("{} for the torques that a motion needs\n", cost("inverse_dynamics"));
    let none = PumaArmInputs::default();

    let at_rest = PumaArmState::from_fn(|i| if i < 6 { READY[i] } else { 0.0 });
    let moving = PumaArmState::from_fn(|i| if i < 6 { READY[i] } else { RATES[i - 6] });
    let holding = arm.inverse_dynamics(0.0, &at_rest, &[0.0; 6], &none);
    let bias = arm.inverse_dynamics(0.0, &moving, &[0.0; 6], &none);
    let of_rates: Vec<f64> = bias.iter().zip(&holding).map(|(all, weight)| all - weight).collect();
    checks.below("holding torques against the published ones / N m", off(&holding, &HOLDING), 5.1e-5);
    // The published matrix has four decimals and is multiplied by the rates.
    checks.below("torques of the rates against the published ones / N m", off(&of_rates, &OF_RATES), 3.1e-4);

    // What the motion needs, driven through the arm.
    let needed = |t: f64| {
        let (state, rates) = wanted(t);
        PumaArmInputs::from(arm.inverse_dynamics(t, &state, &rates, &none))
    };
    let run = arm.simulate(at_rest).inputs(|t, _| needed(t)).tolerance(1e-12, 1e-12).until(TIME)?;
    let (_, end) = run.last();
    let end: [f64; 12] = (*end).into();
    checks.below("where it arrives / rad", off(&end[..6], &THERE), 1e-8);
    checks.below("how it stands there / (rad/s)", off(&end[6..], &[0.0; 6]), 1e-8);

    // The motors' work is the energy that the arm has gained.
    let steps = 600;
    let dt = TIME / f64::from(steps);
    let power = |t: f64| -> Result<f64, Error> { arm.power(t, &run.at(t)?, &needed(t)) };
    let (mut work, mut torques, mut powers) = (0.0, [const { Vec::new() }; 6], Vec::new());
    for i in 0..=steps {
        let t = (dt * f64::from(i)).min(TIME);
        if i > 0 {
            work += dt / 6.0 * (power(t - dt)? + 4.0 * power(t - 0.5 * dt)? + power(t)?);
        }
        let tau: [f64; 6] = needed(t).into();
        torques.iter_mut().zip(tau).for_each(|(curve, tau)| curve.push((t, tau)));
        powers.push((t, power(t)?));
    }
    let (t, last) = run.last();
    let gained = arm.energy(t, last) - arm.energy(0.0, &at_rest);
    println!("  the motors do {work:.4} J");
    checks.below("their work against the energy gained / J", (work - gained).abs(), 1e-7);

    let svg = Path::new("target/puma/puma.svg");
    let [waist, shoulder, elbow, wrist, bend, flange] = torques;
    let arm_curves = vec![("waist", waist), ("shoulder", shoulder), ("elbow", elbow)];
    let wrist_curves = vec![("forearm", wrist), ("wrist", bend), ("flange", flange)];
    let torque = |title, curves| Panel { title, labels: ["t / s", "N m"], equal: false, curves };
    draw(
        svg,
        &[
            &[torque("torques of the arm", arm_curves), torque("torques of the wrist", wrist_curves)],
            &[Panel { title: "power of the motors", labels: ["t / s", "W"], equal: false, curves: vec![("", powers)] }],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
