//! Andrews' squeezing mechanism, seven bodies in three loops, from geometry: the published figures, and a second under its motor, in which
//! the crank turns thousands of times.
//!
//! ```text
//! cargo run --release --example andrews
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{Squeezer, SqueezerState};
use std::path::Path;
use std::process::ExitCode;

/// The start and the end of the test set (Test Set for IVP Solvers, problem Andrews): β, Θ, γ, Φ, δ, Ω, ε at t = 0 and at t = 0.03 s, where
/// the rates, accelerations and multipliers are given as well, to as many digits as an integrator of the time had.
const START: [f64; 7] = [
    -0.06171389001427645,
    0.0,
    0.45527981916307037,
    0.22266839016588588,
    0.48736497954384256,
    -0.22266839016588588,
    1.2305474445498212,
];
const END: f64 = 0.03;
/// β'' and Θ'' at the start, where all others are zero, and the first two multipliers.
const FIRST: [f64; 4] = [14222.443919954114, -10666.832939965585, 98.56687039624109, -6.122688344255662];
const ANGLES: [f64; 7] = [
    15.81077119629904,
    -15.75637105984298,
    0.04082224013073101,
    -0.5347301163226948,
    0.5244099658805303,
    0.5347301163226948,
    1.048080741042263,
];
const RATES: [f64; 7] = [
    1139.920302151208,
    -1424.379294994111,
    11.03291221937134,
    19.29337464421385,
    0.5735699284790808,
    -19.29337464421385,
    0.3231791658026955,
];
const ACCELERATIONS: [f64; 7] = [
    -24631.76316945196,
    51850.37701610329,
    324102.5686413781,
    566749.3645176213,
    16743.62929479361,
    -566749.3645176222,
    9826.520791458423,
];
const MULTIPLIERS: [f64; 6] =
    [199.175333373191, -29.75531228015052, 23.06654119098399, 31.45271365475927, 22.64249232082739, 11.61740700019673];

/// The largest difference, in units of the largest expected figure.
fn off(found: &[f64], expected: &[f64]) -> f64 {
    let largest = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
    largest(&mut found.iter().zip(expected).map(|(a, b)| a - b)) / largest(&mut expected.iter().copied())
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let squeezer = Squeezer::PUBLISHED.prepare()?;
    let cost = Squeezer::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("Andrews' squeezing mechanism: {operations} operations and {} sincos a step", cost.sincos);

    println!("\nThe published run");
    let start = SqueezerState::from_fn(|i| if i < 7 { START[i] } else { 0.0 });
    let rates: [f64; 7] = squeezer.velocity_rates(0.0, &start, &[]).into();
    // The test set counts its multipliers the other way round.
    let lambda = <[f64; 6]>::from(squeezer.multipliers(0.0, &start, &[])).map(|l| -l);
    checks.below("accelerations at its start (relative)", off(&rates[..2], &FIRST[..2]), 1e-12);
    checks.below("multipliers at its start (relative)", off(&lambda[..2], &FIRST[2..]), 1e-12);
    let run = squeezer.simulate(start).tolerance(1e-13, 1e-13).until(END)?;
    let (t, s) = run.last();
    checks.below("angles at its end (relative)", off(&squeezer.coordinates(t, s), &ANGLES), 1e-9);
    let v: [f64; 7] = squeezer.velocities(t, s).into();
    // A change of the torque by 1e-12 changes the rates by 4e-9.
    checks.below("rates there (relative)", off(&v, &RATES), 1e-8);
    let there = SqueezerState::from_fn(|i| if i < 7 { ANGLES[i] } else { RATES[0] });
    let rates: [f64; 7] = squeezer.velocity_rates(t, &there, &[]).into();
    checks.below("accelerations at the published end (relative)", off(&rates, &ACCELERATIONS), 1e-6);
    let lambda = <[f64; 6]>::from(squeezer.multipliers(t, &there, &[])).map(|l| -l);
    checks.below("multipliers at the published end (relative)", off(&lambda, &MULTIPLIERS), 1e-6);

    println!("\nA second under the motor");
    let long = squeezer.simulate(start).tolerance(1e-10, 1e-10).dense(false).until(1.0)?;
    let residuals = long.largest_residuals();
    let turns = long.last().1.beta / std::f64::consts::TAU;
    println!("  {} steps, {turns:.1} turns", long.statistics().accepted);
    checks.below("residuals at the end of any step (relative)", residuals.position.max(residuals.velocity), 1e-10);
    // The torque's work is what it turns the crank by.
    let (motor, first) = (Squeezer::PUBLISHED.mom, squeezer.energy(0.0, &start));
    let (mut lost, mut given) = (0.0f64, 0.0f64);
    for (t, s) in long.iter() {
        let work = motor * (s.beta - start.beta);
        lost = lost.max((squeezer.energy(t, s) - first - work).abs());
        given = given.max(work);
    }
    checks.below("energy against the work of the motor (of all of it)", lost / given, 1e-7);

    let svg = Path::new("target/andrews/andrews.svg");
    let (mut pins, mut ends, mut forces) = (Vec::new(), Vec::new(), [const { Vec::new() }; 2]);
    let mut small = [const { Vec::new() }; 4];
    for i in 0..=3000 {
        let t = END * f64::from(i) / 3000.0;
        let s = run.at(t.min(END))?;
        let (told, lambda) = (squeezer.outputs(t, &s, &[]), squeezer.multipliers(t, &s, &[]));
        pins.push((told.pin_x, told.pin_y));
        ends.push((told.end_x, told.end_y));
        forces[0].push((t, lambda.b_x));
        forces[1].push((t, lambda.b_y));
        small.iter_mut().zip([s.gamma, s.phi, s.delta, s.epsilon]).for_each(|(curve, angle)| curve.push((t, angle)));
    }
    let ([across, along], [gamma, phi, delta, epsilon]) = (forces, small);
    let in_time = |title, label, curves| Panel { title, labels: ["t / s", label], equal: false, curves };
    let paths = vec![("the common pin", pins), ("the spring's end", ends)];
    let angles = vec![("gamma", gamma), ("phi", phi), ("delta", delta), ("epsilon", epsilon)];
    draw(
        svg,
        &[
            &[Panel { title: "paths", labels: ["x / m", "y / m"], equal: true, curves: paths }],
            &[
                in_time("angles", "rad", angles),
                in_time("force of the first loop on the pin", "N", vec![("x", across), ("y", along)]),
            ],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
