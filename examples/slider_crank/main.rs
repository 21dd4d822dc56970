//! A slider-crank from geometry: the piston's motion in closed form, the force of its guide by balances, a thousand seconds undriven,
//! and the period that an integral knows.
//!
//! ```text
//! cargo run --release --example slider_crank
//! ```

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/drift.rs"]
mod drift;
mod exact;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use drift::drift;
use exact::{moment, period, rod, stroke};
use holonomy::prelude::*;
use holonomy::simulate::Event;
use models::{SliderCrank, SliderCrankInputs, SliderCrankState};
use std::path::Path;
use std::process::ExitCode;

const CRANK: SliderCrank = SliderCrank { r: 0.3, l: 0.9, m1: 1.0, m2: 1.0, m3: 2.0, g: 9.81 };

/// The torque of the driven run in N m, and its end in s.
const TORQUE: f64 = 4.0;
const END: f64 = 1.0;

/// The crank's speed in rad/s with which the turning run begins.
const SPEED: f64 = 15.0;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let crank = CRANK.prepare()?;
    let cost =
        SliderCrank::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("A slider-crank: {operations} operations and {} sincos a step", cost.sincos);
    let begin = |alpha: f64, dot_alpha: f64| {
        let guess = SliderCrankState { alpha, beta: 0.0, x: CRANK.l, dot_alpha };
        crank.assemble(guess).hold("alpha").solve()
    };
    let (driven, free) = (SliderCrankInputs { tau: TORQUE }, SliderCrankInputs { tau: 0.0 });

    println!("\nA second under a torque of {TORQUE} N m");
    let start = begin(0.0, 0.0)?;
    let run = crank.simulate(start).inputs(|_, _| driven).tolerance(1e-12, 1e-12).until(END)?;
    let (mut placed, mut moved, mut carried, mut work) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
    for (t, s) in run.iter() {
        let (beta, slope) = rod(&CRANK, s.alpha);
        let [x, first, second] = stroke(&CRANK, s.alpha);
        placed = placed.max((s.x - x).abs()).max((s.beta - beta).abs());
        let v = crank.velocities(t, s);
        moved = moved.max((v.dot_x - first * s.dot_alpha).abs()).max((v.dot_beta - slope * s.dot_alpha).abs());
        // Of the piston alone: the rod pulls it with the opposite of λ.
        let (rates, told) = (crank.velocity_rates(t, s, &driven), crank.outputs(t, s, &driven));
        let (push, weight) = (crank.multipliers(t, s, &driven), CRANK.m3 * CRANK.g);
        let inertia = CRANK.m3 * (first * rates.dot_alpha + second * s.dot_alpha * s.dot_alpha);
        carried = carried.max((inertia + push.closure_x).abs()).max((told.guide - push.closure_y - weight).abs());
        work = work.max((crank.energy(t, s) - crank.energy(0.0, &start) - TORQUE * (s.alpha - start.alpha)).abs());
    }
    checks.below("piston and rod against the closed form / m, rad", placed, 1e-13);
    checks.below("their rates against it / (m/s), (rad/s)", moved, 1e-12);
    checks.below("forces on the piston, rod and guide against its inertia and weight / N", carried, 1e-9);
    checks.below("energy against the work of the torque / J", work, 1e-9);

    // All forces from outside, the guide's among them, turn the whole about the bearing.
    let steps = 4000;
    let dt = END / f64::from(steps);
    let state = |t: f64| run.at(t.min(END));
    let turning = |t: f64| -> Result<f64, Error> {
        let s = state(t)?;
        Ok(moment(&CRANK, TORQUE, [s.alpha, s.beta, s.x], crank.outputs(t, &s, &driven).guide))
    };
    let (mut impulse, mut balance, mut biggest) = (0.0, 0.0f64, 0.0f64);
    let (mut guides, mut strokes, mut accelerations) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..=steps {
        let t = dt * f64::from(i);
        if i > 0 {
            impulse += dt / 6.0 * (turning(t - dt)? + 4.0 * turning(t - 0.5 * dt)? + turning(t)?);
        }
        let s = state(t)?;
        let told = crank.outputs(t, &s, &driven);
        balance = balance.max((told.momentum - impulse).abs());
        biggest = biggest.max(told.momentum.abs());
        guides.push((t, told.guide));
        strokes.push((t, s.x));
        accelerations.push((t, told.acceleration));
    }
    checks.below("angular momentum against the moments of weights and guide (relative)", balance / biggest, 1e-7);

    println!("\nUndriven for 1,000 s at a relative tolerance of 1e-10");
    for (label, alpha, speed) in [("swinging", 0.3, 0.0), ("turning", 0.0, SPEED)] {
        let run = crank.simulate(begin(alpha, speed)?).inputs(|_, _| free).tolerance(1e-10, 1e-10).dense(false);
        let run = run.event(Event::<SliderCrank>::new("turn", |_, s| (0.5 * s.alpha).sin())).until(1000.0)?;
        let lost = drift(&crank, &run);
        println!("  {label}: {} steps, crank at {:.1} rad", run.statistics().accepted, run.last().1.alpha);
        checks.below("  residuals at the end of any step (relative)", lost.residual, 1e-10);
        checks.below("  energy (of the largest kinetic one)", lost.energy, 1e-7);
        if speed > 0.0 {
            let turn = period(&CRANK, speed);
            let passages = run.events().iter().enumerate();
            let late = passages.map(|(i, event)| (event.time - turn * (i + 1) as f64).abs()).fold(0.0, f64::max);
            checks.hold("every turn is found", run.events().len() == (1000.0 / turn) as usize);
            checks.below("  times of its turns against the integral / s", late, 1e-5);
        }
    }

    let svg = Path::new("target/slider_crank/slider_crank.svg");
    let panel =
        |title, label, curve| Panel { title, labels: ["t / s", label], equal: false, curves: vec![("", curve)] };
    draw(
        svg,
        &[
            &[panel("the piston", "x / m", strokes), panel("its acceleration", "m/s²", accelerations)],
            &[panel("what the guide holds", "N", guides)],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
