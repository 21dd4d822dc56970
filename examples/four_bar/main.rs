//! A four-bar from geometry: figures of 50-digit arithmetic, Freudenstein's closed form, a thousand seconds undriven, and ten thousand
//! turns through the dead points of the chosen speed, with the period that an integral knows.
//!
//! ```text
//! cargo run --release --example four_bar
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
use exact::{angles, period, ratios};
use holonomy::prelude::*;
use holonomy::simulate::Event;
use models::{ByRocker, ByRockerState, FourBar, FourBarInputs, FourBarState};
use std::path::Path;
use std::process::ExitCode;

const BAR: FourBar = FourBar { a: 0.5, b: 1.8, c: 1.2, d: 2.0, m1: 0.5, m2: 1.8, m3: 1.2, g: 9.81 };

/// A state under a torque of 2 N m, its accelerations and the force on the pin, from arithmetic of 50 digits.
const TORQUE: f64 = 2.0;
const STATE: [f64; 4] = [-2.6628225143311117, 0.5771314851460677, 2.464563621401967, -5.978195111091518];
const ACCELERATIONS: [f64; 3] = [46.83378772899098, 15.855504426681547, -9.519541179350036];
const PIN: [f64; 2] = [-9.691434964601558, -3.9588260543433725];

/// Turns with changes of the chart, and the crank's speed in rad/s with which they begin.
const TURNS: usize = 10_000;
const SPEED: f64 = 12.0;

/// The linkage that takes them: a short crank, a heavy rocker, and the load on its pin in kg.
const LOADED: FourBar = FourBar { a: 0.3, b: 1.2, c: 1.0, d: 1.4, m1: 0.5, m2: 1.0, m3: 10.0, g: 9.81 };
const LOAD: f64 = 2.0;

fn off(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let bar = BAR.prepare()?;
    let cost = FourBar::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("A four-bar: {operations} operations and {} sincos a step", cost.sincos);

    let (driven, free) = (FourBarInputs { tau: TORQUE }, FourBarInputs { tau: 0.0 });
    let state = FourBarState::from(STATE);
    let rates: [f64; 3] = bar.velocity_rates(0.0, &state, &driven).into();
    let pin: [f64; 2] = bar.multipliers(0.0, &state, &driven).into();
    checks.below("accelerations against 50 digits / (rad/s²)", off(&rates, &ACCELERATIONS), 1e-10);
    checks.below("force on the pin against 50 digits / N", off(&pin, &PIN), 1e-10);

    println!("\nTwo seconds under a torque of {TORQUE} N m");
    let guess = FourBarState { crank: 0.0, coupler: 0.6, rocker: 1.9, dot_crank: 0.0 };
    let start = bar.assemble(guess).hold("crank").solve()?;
    let run = bar.simulate(start).inputs(|_, _| driven).tolerance(1e-12, 1e-12).until(2.0)?;
    let (mut apart, mut rates_apart, mut work) = (0.0f64, 0.0f64, 0.0f64);
    for (t, s) in run.iter() {
        let (known, known_rates) = (angles(&BAR, s.crank), ratios(&BAR, s.crank));
        let v = bar.velocities(t, s);
        let rates = [v.dot_coupler - known_rates.0 * s.dot_crank, v.dot_rocker - known_rates.1 * s.dot_crank];
        apart = apart.max(off(&[s.coupler, s.rocker], &[known.0, known.1]));
        rates_apart = rates_apart.max(off(&rates, &[0.0; 2]));
        work = work.max((bar.energy(t, s) - bar.energy(0.0, &start) - TORQUE * (s.crank - start.crank)).abs());
    }
    checks.below("angles against Freudenstein's closed form / rad", apart, 1e-13);
    checks.below("rates against it / (rad/s)", rates_apart, 1e-12);
    checks.below("energy against the work of the torque / J", work, 1e-9);

    println!("\nUndriven for 1,000 s at a relative tolerance of 1e-10");
    for (label, crank, speed) in [("swinging", -0.5, 0.0), ("turning", 0.0, SPEED)] {
        let guess = FourBarState { crank, dot_crank: speed, ..start };
        let start = bar.assemble(guess).hold("crank").solve()?;
        let long = bar.simulate(start).inputs(|_, _| free).tolerance(1e-10, 1e-10).dense(false).until(1000.0)?;
        let lost = drift(&bar, &long);
        println!("  {label}: {:?} steps, crank at {:.1} rad", long.statistics().accepted, long.last().1.crank);
        checks.below("  residuals at the end of any step (relative)", lost.residual, 1e-10);
        checks.below("  energy (of the largest kinetic one)", lost.energy, 1e-7);
    }

    println!("\n{TURNS} turns by the speed of the rocker, which stands still twice a turn, or of the coupler");
    let FourBar { a, b, c, d, m1, m2, m3, g } = LOADED;
    let by_rocker = ByRocker { a, b, c, d, m1, m2, m3, load: LOAD, g }.prepare()?;
    let guess = ByRockerState { crank: 0.0, coupler: 0.8, rocker: 2.0, dot_rocker: -5.0 };
    let begin = by_rocker.assemble(guess).hold("crank").set("dot_crank", SPEED).solve()?;
    let turn = period(&LOADED, LOAD, SPEED);
    let around = by_rocker
        .simulate(begin)
        .tolerance(3e-12, 3e-12)
        .dense(false)
        .every(turn / 3.0)
        .event(Event::<ByRocker>::new("turn", |_, s| (0.5 * s.crank).sin()))
        .until(turn * (TURNS as f64 + 0.5))?;
    let changes = around.statistics().chart_changes;
    println!("  {} steps, {changes} changes of the chart, a turn takes {turn:.9} s", around.statistics().accepted);
    let times: Vec<f64> = around.events().iter().map(|event| event.time).collect();
    checks.hold("every turn is found", times.len() == TURNS);
    checks.hold("the chart changes in every turn", changes >= 4 * TURNS);
    let periods: Vec<f64> = std::iter::once(&0.0).chain(&times).zip(&times).map(|(from, to)| to - from).collect();
    let (low, high) = periods.iter().fold((f64::INFINITY, 0.0f64), |(low, high), p| (low.min(*p), high.max(*p)));
    checks.below("spread of the period over all turns (relative)", (high - low) / turn, 1e-8);
    checks.below("the last turn against the integral (relative)", off(&periods[TURNS - 1..], &[turn]) / turn, 1e-8);
    let lost = drift(&by_rocker, &around);
    checks.below("residuals at the end of any step (relative)", lost.residual, 1e-10);
    checks.below("energy (of the largest kinetic one)", lost.energy, 1e-7);

    let svg = Path::new("target/four_bar/four_bar.svg");
    let mut paths = [const { Vec::new() }; 3];
    let mut forces = [const { Vec::new() }; 2];
    for i in 0..=1500 {
        let t = 2.0 * f64::from(i) / 1500.0;
        let s = run.at(t)?;
        let middle = [s.coupler.cos(), s.coupler.sin()].map(|part| 0.5 * BAR.b * part);
        let crank = (BAR.a * s.crank.cos(), BAR.a * s.crank.sin());
        paths[0].push(crank);
        paths[1].push((crank.0 + middle[0], crank.1 + middle[1]));
        paths[2].push((BAR.d + BAR.c * s.rocker.cos(), BAR.c * s.rocker.sin()));
        let pin = bar.multipliers(t, &s, &driven);
        forces[0].push((t, pin.closure_x));
        forces[1].push((t, pin.closure_y));
    }
    let ([crank, middle, rocker], [across, along]) = (paths, forces);
    let errors = periods.iter().enumerate().map(|(i, p)| (i as f64, (p / turn - 1.0) * 1e9)).collect();
    let paths = vec![("crank's end", crank), ("coupler's middle", middle), ("rocker's end", rocker)];
    draw(
        svg,
        &[
            &[
                Panel { title: "paths", labels: ["x / m", "y / m"], equal: true, curves: paths },
                Panel {
                    title: "force on the pin of coupler and rocker",
                    labels: ["t / s", "N"],
                    equal: false,
                    curves: vec![("x", across), ("y", along)],
                },
            ],
            &[Panel {
                title: "each turn's period against the integral",
                labels: ["turn", "parts in 10⁹"],
                equal: false,
                curves: vec![("", errors)],
            }],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
