//! A bicycle from its frames, points and bodies: the speeds between which it rides by itself, against the published ones, and two
//! rides, one that comes upright and one that falls.
//!
//! ```text
//! cargo run --release --example bicycle
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{Bicycle, BicycleState};
use std::path::Path;
use std::process::ExitCode;

/// Meijaard, Papadopoulos, Ruina and Schwab 2007, section 6: speeds in m/s, and the eigenvalues at 5 m/s in 1/s.
const WEAVE: f64 = 4.292_382_536_341_11;
const CAPSIZE: f64 = 6.024_262_015_388_37;
const AT_FIVE: [(f64, f64); 4] = [
    (-0.322_866_429_004_09, 0.0),
    (-0.775_341_882_195_85, 4.464_867_713_788_23),
    (-0.775_341_882_195_85, -4.464_867_713_788_23),
    (-14.078_389_692_798_22, 0.0),
];

fn upright(speed: f64) -> BicycleState {
    BicycleState { dot_rear: -speed / Bicycle::BENCHMARK.r_rear, ..Default::default() }
}

/// What leaning and steering do about riding straight on: real and imaginary parts, the fastest growing first.
fn eigenvalues(bicycle: &Prepared<Bicycle>, speed: f64) -> Result<Vec<(f64, f64)>, Error> {
    let all = bicycle.linearize(0.0, &upright(speed), &[])?.eigenvalues()?;
    // Where it is, where it heads, how far the wheels have turned and how fast it rides give zeros, exactly.
    Ok(all.iter().filter(|value| value.re != 0.0 || value.im != 0.0).map(|value| (value.re, value.im)).collect())
}

/// The speed between two others where the largest real part of the chosen eigenvalues changes its sign.
fn threshold(bicycle: &Prepared<Bicycle>, (mut from, mut to): (f64, f64), swings: bool) -> Result<f64, Error> {
    let growth = |speed: f64| -> Result<f64, Error> {
        let chosen = eigenvalues(bicycle, speed)?.into_iter().filter(|(_, im)| (*im != 0.0) == swings);
        Ok(chosen.map(|(re, _)| re).fold(f64::NEG_INFINITY, f64::max))
    };
    let before = growth(from)? > 0.0;
    for _ in 0..60 {
        let middle = (from + to) / 2.0;
        *(if (growth(middle)? > 0.0) == before { &mut from } else { &mut to }) = middle;
    }
    Ok((from + to) / 2.0)
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let bicycle = Bicycle::BENCHMARK.prepare()?;
    let cost = Bicycle::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("A bicycle of four bodies, from geometry: {operations} operations and {} sincos a step", cost.sincos);

    let found = eigenvalues(&bicycle, 5.0)?;
    let off = found.iter().zip(AT_FIVE).map(|((re, im), (a, b))| (re - a).hypot(im - b)).fold(0.0, f64::max);
    checks.hold("four eigenvalues", found.len() == 4);
    checks.below("eigenvalues at 5 m/s against the published ones", off, 1e-11);
    let weave = threshold(&bicycle, (3.0, 5.0), true)?;
    let capsize = threshold(&bicycle, (5.0, 7.0), false)?;
    println!("it rides by itself between {weave:.4} and {capsize:.4} m/s");
    checks.below("the speed where weaving ends", (weave - WEAVE).abs(), 1e-10);
    checks.below("the speed where it begins to capsize", (capsize - CAPSIZE).abs(), 1e-10);

    // A push to the right, at a speed between these and at one below.
    let mut curves = Vec::new();
    for (speed, end) in [(4.6, 12.0), (3.9, 12.0)] {
        let start = BicycleState { dot_lean: 0.1, ..upright(speed) };
        let run = bicycle.simulate(start).tolerance(1e-11, 1e-11).until(end)?;
        let energy = |t: f64, s: &BicycleState| bicycle.energy(t, s);
        let (first, (t, last)) = (energy(0.0, &start), run.last());
        println!("pushed at {speed} m/s: after {end} s it leans {:.4}, steers {:.4}", last.lean, last.steer);
        checks.below("energy lost (relative)", ((energy(t, last) - first) / first).abs(), 1e-9);
        checks.below("height of the front contact", run.largest_residuals().position, 1e-12);
        let largest = |from: f64, to: f64| -> Result<f64, Error> {
            (0..=200).try_fold(0.0_f64, |most, i| {
                Ok(most.max(run.at(from + (to - from) * f64::from(i) / 200.0)?.lean.abs()))
            })
        };
        let (early, late) = (largest(0.0, end / 3.0)?, largest(2.0 * end / 3.0, end)?);
        println!("  largest lean in the first third {early:.4}, in the last {late:.4}");
        match speed > WEAVE {
            true => checks.hold("it comes upright", late < early / 4.0),
            false => checks.hold("it sways more and more", late > early),
        }
        let times = (0..=800).map(|i| (end * f64::from(i) / 800.0).min(end));
        let lean = times.map(|t| Ok((t, run.at(t)?.lean))).collect::<Result<Vec<_>, Error>>()?;
        curves.push((if speed > WEAVE { "4.6 m/s" } else { "3.9 m/s" }, lean));
    }

    let speeds: Vec<f64> = (0..=400).map(|i| f64::from(i) / 40.0).collect();
    let (mut growth, mut swing) = (Vec::new(), Vec::new());
    for speed in speeds {
        for (re, im) in eigenvalues(&bicycle, speed)? {
            if re > -12.0 {
                growth.push((speed, re));
            }
            if im > 0.0 {
                swing.push((speed, im));
            }
        }
    }
    // One curve for each branch: points in the order of their values, which do not cross within a kind.
    let branches = branches(growth);
    let svg = Path::new("target/bicycle/bicycle.svg");
    let titles = ["growing fastest", "second", "third", "fourth"];
    let growth = titles.into_iter().zip(branches).collect();
    draw(
        svg,
        &[
            &[
                Panel {
                    title: "eigenvalues, real parts",
                    labels: ["speed / (m/s)", "1/s"],
                    equal: false,
                    curves: growth,
                },
                Panel {
                    title: "the pair's imaginary part",
                    labels: ["speed / (m/s)", "1/s"],
                    equal: false,
                    curves: vec![("", swing)],
                },
            ],
            &[Panel { title: "lean after a push", labels: ["t / s", "lean / rad"], equal: false, curves }],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}

/// Points of equal speed as one point of each of four curves, the largest first.
fn branches(points: Vec<(f64, f64)>) -> [Vec<(f64, f64)>; 4] {
    let mut branches: [Vec<(f64, f64)>; 4] = Default::default();
    for (speed, value) in points {
        let free = branches.iter_mut().find(|branch| branch.last().is_none_or(|(last, _)| *last != speed));
        if let Some(branch) = free {
            branch.push((speed, value));
        }
    }
    branches
}
