//! A Stewart platform from geometry, five closed loops in space: assembled from a rough guess and by the lengths of its legs, held at
//! rest by the forces that statics know, led along a motion by inverse dynamics, and left to itself.
//!
//! ```text
//! cargo run --release --example stewart
//! ```

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/drift.rs"]
mod drift;
mod models;
mod statics;

use common::checks::Checks;
use common::picture::{Panel, draw};
use drift::drift;
use holonomy::prelude::*;
use models::{Stewart, StewartInputs, StewartState};
use nalgebra::{Matrix6, Vector6};
use statics::{Pose, holding, legs, state};
use std::path::Path;
use std::process::ExitCode;

/// Where the platform rests, and where it is led.
const HOME: Pose = [0.0, 0.0, 0.9, 0.0, 0.0, 0.0];
const THERE: Pose = [0.15, -0.1, 1.05, 0.3, 0.2, -0.15];
/// How long that takes.
const TIME: f64 = 1.5;

/// Feet in pairs about three directions, 30 degrees apart in each, and the platform's joints in pairs between these.
fn platform() -> Stewart {
    let at = |radius: f64, degrees: [f64; 6]| {
        let angles = degrees.map(f64::to_radians);
        (angles.map(|angle| radius * angle.cos()), angles.map(|angle| radius * angle.sin()))
    };
    let (bx, by) = at(1.0, [15.0, 105.0, 135.0, 225.0, 255.0, 345.0]);
    let (px, py) = at(0.5, [45.0, 75.0, 165.0, 195.0, 285.0, 315.0]);
    Stewart { bx, by, px, py, m: 20.0, r: 0.6, mc: 2.0, mr: 1.0, l: 0.7, k: 4000.0, s0: 1.1, g: 9.81 }
}

fn off(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Pose, rates and accelerations on the way, at rest at both ends: the polynomial of fifth degree in t / TIME.
fn wanted(t: f64) -> (Pose, Pose, Pose) {
    let s = t / TIME;
    let way = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * s * s * (1.0 - s).powi(2) / TIME;
    let second = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / TIME.powi(2);
    let along = |part: f64| std::array::from_fn(|i| part * (THERE[i] - HOME[i]));
    let gone: Pose = along(way);
    (std::array::from_fn(|i| HOME[i] + gone[i]), along(rate), along(second))
}

/// The forces in the legs for a state and its accelerations: what inverse dynamics ask for along the pose, by the legs' rates J u that
/// stand in D, Jᵀ f.
fn needed(model: &Prepared<Stewart>, s: &StewartState, accelerations: &Pose) -> StewartInputs {
    let along = model.inverse_dynamics(0.0, s, accelerations, &StewartInputs::default());
    let complement = model.complement(0.0, s);
    let lengths = Matrix6::from_fn(|i, j| complement.entry(i, 18 + j));
    let forces = lengths.lu().solve(&Vector6::from(along)).unwrap_or(Vector6::repeat(f64::NAN));
    StewartInputs::from(<[f64; 6]>::from(forces))
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let design = platform();
    let stewart = design.clone().prepare()?;
    let cost = Stewart::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("A Stewart platform: {operations} operations and {} sincos a step", cost.sincos);
    let at_rest = |pose: &Pose| state(&design, pose, &[0.0; 6]);

    // The pose is given, the legs are anywhere near: upright and a metre long.
    let rough = |pose: &Pose| {
        let at = |i: usize| if i < 6 { pose[i] } else { f64::from(u8::from((18..24).contains(&i))) };
        StewartState::from_fn(at)
    };
    let names = ["x", "y", "z", "yaw", "pitch", "roll"];
    let placed = names.iter().fold(stewart.assemble(rough(&THERE)), |assembly, name| assembly.hold(name)).solve()?;
    let exact: [f64; 30] = at_rest(&THERE).into();
    checks.below("legs of a pose against the closed form / rad, m", off(&<[f64; 30]>::from(placed), &exact), 1e-13);

    // The other way: six lengths are given, and the pose is found from another one.
    let reached = legs(&design, &THERE)
        .iter()
        .enumerate()
        .fold(stewart.assemble(rough(&HOME)), |assembly, (i, leg)| assembly.set(&format!("s_{i}"), leg.length));
    let found: [f64; 30] = reached.solve()?.into();
    checks.below("pose by the lengths of the legs / m, rad", off(&found[..6], &THERE), 1e-12);

    // At rest: the forces in the legs and those on the platform's joints by statics.
    let standing = at_rest(&THERE);
    let held = needed(&stewart, &standing, &[0.0; 6]);
    let (forces, exerted) = holding(&design, &THERE).ok_or("a singular pose")?;
    checks.below("forces that hold it against statics / N", off(&<[f64; 6]>::from(held), &forces), 1e-9);
    let joints: [f64; 18] = stewart.multipliers(0.0, &standing, &held).into();
    let known: Vec<f64> = exerted.iter().flat_map(|force| force.iter().copied()).collect();
    checks.below("forces on its joints against statics / N", off(&joints, &known), 1e-9);
    let rates: [f64; 24] = stewart.velocity_rates(0.0, &standing, &held).into();
    checks.below("accelerations then / (m/s², rad/s²)", off(&rates, &[0.0; 24]), 1e-10);

    println!("\nLed from one pose to another in {TIME} s");
    let forces = |t: f64| {
        let (pose, rates, accelerations) = wanted(t);
        needed(&stewart, &state(&design, &pose, &rates), &accelerations)
    };
    let run = stewart.simulate(at_rest(&HOME)).inputs(|t, _| forces(t)).tolerance(1e-11, 1e-11).until(TIME)?;
    let end: [f64; 30] = (*run.last().1).into();
    checks.below("where it arrives / m, rad", off(&end[..6], &THERE), 1e-8);
    checks.below("how it stands there / (m/s, rad/s)", off(&end[24..], &[0.0; 6]), 1e-8);

    println!("\nLet go from there without forces, on its springs");
    let free =
        stewart.simulate(standing).inputs(|_, _| StewartInputs::default()).tolerance(1e-10, 1e-10).until(20.0)?;
    let lost = drift(&stewart, &free);
    println!("  {} steps in 20 s", free.statistics().accepted);
    checks.below("residuals at the end of any step (relative)", lost.residual, 1e-10);
    checks.below("energy (of the largest kinetic one)", lost.energy, 1e-7);

    let svg = Path::new("target/stewart/stewart.svg");
    let (mut leading, mut heights, mut lengths) = ([const { Vec::new() }; 6], Vec::new(), [const { Vec::new() }; 6]);
    for i in 0..=600 {
        let part = f64::from(i) / 600.0;
        let t = (TIME * part).min(TIME);
        leading.iter_mut().zip(<[f64; 6]>::from(forces(t))).for_each(|(curve, force)| curve.push((t, force)));
        let s = free.at(2.0 * part)?;
        let all: [f64; 30] = s.into();
        heights.push((2.0 * part, s.z));
        lengths.iter_mut().zip(&all[18..24]).for_each(|(curve, length)| curve.push((2.0 * part, *length)));
    }
    let panel = |title, label, curves| Panel { title, labels: ["t / s", label], equal: false, curves };
    let labelled =
        |curves: [Vec<(f64, f64)>; 6]| ["leg 1", "leg 2", "leg 3", "leg 4"].into_iter().zip(curves).collect();
    draw(
        svg,
        &[
            &[panel("forces in four legs that lead it", "N", labelled(leading))],
            &[
                panel("let go: height of the platform", "z / m", vec![("", heights)]),
                panel("lengths of four legs", "m", labelled(lengths)),
            ],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
