//! A heavy top by angles and by a unit quaternion: both have the same motion, until the axis hangs, where angles fail and the quaternion
//! does not notice; and the spin above which the top sleeps upright.
//!
//! ```text
//! cargo run --release --example heavy_top
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{AngledTop, AngledTopState, FreeTop, FreeTopState};
use std::path::Path;
use std::process::ExitCode;

/// The fast top of Brüls and Cardona 2010: let go with its axis level.
const M: f64 = 15.0;
const G: f64 = 9.81;
const L: f64 = 1.0;
const AXIAL: f64 = 0.46875;
const ACROSS: f64 = 0.234375;
const SPIN: f64 = 150.0;
const SWEEP: f64 = -4.61538;

/// The lowest height of the mass centre: the cubic u̇² = f(u) of the heavy top (Goldstein, Classical Mechanics, section 5.7), u the
/// height over l, for a start with a level axis and no nutation. With I = ACROSS + m l², a = AXIAL·spin/I, b = vertical momentum/I
/// and β = 2 m g l/I it is f(u) = (1 - u²)(b² - β u) - (b - a u)², one of whose zeros is the start, u = 0.
fn lowest() -> f64 {
    let i = ACROSS + M * L * L;
    // The momentum about the vertical is that of the sweep alone, whose rate is that about T.z, which points up.
    let (a, b, beta) = (AXIAL * SPIN / i, SWEEP, 2.0 * M * G * L / i);
    let cubic = |u: f64| (1.0 - u * u) * (b * b - beta * u) - (b - a * u).powi(2);
    let (mut from, mut to) = (-1.0, -1e-3);
    for _ in 0..200 {
        let middle = 0.5 * (from + to);
        *(if (cubic(middle) > 0.0) == (cubic(from) > 0.0) { &mut from } else { &mut to }) = middle;
    }
    0.5 * (from + to) * L
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let angled = AngledTop { m: M, g: G, l: L, axial: AXIAL, across: ACROSS }.prepare()?;
    let free = FreeTop { m: M, g: G, l: L, axial: AXIAL, across: ACROSS }.prepare()?;
    let operations = |cost: &[holonomy::FunctionCost]| {
        let found = cost.iter().find(|cost| cost.function == "derivative");
        found.map_or((0, 0), |cost| (cost.additions + cost.multiplications + cost.divisions + cost.roots, cost.sincos))
    };
    let (by_angles, by_quaternion) = (operations(AngledTop::MODEL.operations), operations(FreeTop::MODEL.operations));
    println!(
        "A heavy top: by angles {} operations and {} sincos, by a quaternion {} and {}",
        by_angles.0, by_angles.1, by_quaternion.0, by_quaternion.1
    );

    // A gentle start: the same motion.
    let end = 2.0;
    let turning = AngledTopState { dot_heading: 0.4, dot_rise: 0.1, dot_spin: 60.0, ..Default::default() };
    let turned = FreeTopState { e0: 1.0, omega_T_x: 0.1, omega_T_y: 60.0, omega_T_z: 0.4, ..Default::default() };
    let by_angles = angled.simulate(turning).tolerance(1e-12, 1e-12).until(end)?;
    let by_quaternion = free.simulate(turned).tolerance(1e-12, 1e-12).until(end)?;
    let mut apart = 0.0f64;
    for i in 0..=400 {
        let t = (end * f64::from(i) / 400.0).min(end);
        let (a, b) = (angled.outputs(t, &by_angles.at(t)?, &[]), free.outputs(t, &by_quaternion.at(t)?, &[]));
        apart = apart.max((a.height - b.height).abs()).max((a.hold - b.hold).abs() / (M * G));
    }
    checks.below("height and what the point holds, both ways", apart, 1e-9);

    // The fast top falls until its axis nearly hangs.
    let fast = FreeTopState { e0: 1.0, omega_T_y: SPIN, omega_T_z: SWEEP, ..Default::default() };
    let run = free.simulate(fast).tolerance(1e-12, 1e-12).until(end)?;
    let (mut low, mut swung, mut energy, mut norm) = (f64::INFINITY, 0.0f64, 0.0f64, 0.0f64);
    let first = (free.energy(0.0, &fast), free.outputs(0.0, &fast, &[]).swing);
    for (t, s) in run.iter() {
        energy = energy.max((free.energy(t, s) / first.0 - 1.0).abs());
        swung = swung.max((free.outputs(t, s, &[]).swing / first.1 - 1.0).abs());
        norm = norm.max((s.e0 * s.e0 + s.e1 * s.e1 + s.e2 * s.e2 + s.e3 * s.e3 - 1.0).abs());
    }
    checks.below("energy of the fast top (relative)", energy, 1e-9);
    checks.below("its momentum about the vertical (relative)", swung, 1e-9);
    checks.below("norm of its quaternion", norm, 1e-12);
    let (mut path, mut heights) = (Vec::new(), Vec::new());
    for i in 0..=20_000 {
        let t = (end * f64::from(i) / 20_000.0).min(end);
        let told = free.outputs(t, &run.at(t)?, &[]);
        low = low.min(told.height);
        if i % 10 == 0 {
            path.push((told.x, told.y));
            heights.push((t, told.height));
        }
    }
    let exact = lowest();
    println!("  it comes down to {low:.9} m");
    checks.below("its lowest height against the root of the cubic / m", (low - exact).abs(), 1e-5);

    // Without spin it is a pendulum, and its axis hangs on the way: there the angles have no rates.
    let stopped = angled.simulate(AngledTopState::default()).until(end).err().map(|stopped| stopped.error);
    checks.hold("by angles the run ends where the axis hangs", matches!(stopped, Some(Error::ChartSingularity { .. })));
    println!("  by angles: {}", stopped.map_or(String::new(), |error| error.to_string()));
    // A quarter of the period from the level: K(1/√2) √(I/(m g l)).
    const K: f64 = 1.854_074_677_301_371_9;
    let quarter = K * ((ACROSS + M * L * L) / (M * G * L)).sqrt();
    let level = FreeTopState { e0: 1.0, ..Default::default() };
    let swing = free.simulate(level).tolerance(1e-12, 1e-12).until(4.0 * quarter)?;
    let hanging = free.outputs(quarter, &swing.at(quarter)?, &[]).height;
    let across = free.outputs(2.0 * quarter, &swing.at(2.0 * quarter)?, &[]).y;
    checks.below("by the quaternion it hangs after a quarter of the period / m", (hanging + L).abs(), 1e-12);
    checks.below("and is level on the other side after a half / m", (across + L).abs(), 1e-12);

    // Upright it sleeps where (J ω)² > 4 m g l I; below, a lean grows at the rate √(4 m g l I - (J ω)²) / (2 I).
    let i = ACROSS + M * L * L;
    let least = 2.0 * (M * G * L * i).sqrt() / AXIAL;
    let lean = |spin: f64| -> Result<[f64; 2], Error> {
        let half = std::f64::consts::FRAC_PI_4 + 5e-7;
        let leaning = FreeTopState { e0: half.cos(), e1: half.sin(), omega_T_y: spin, ..Default::default() };
        let run = free.simulate(leaning).tolerance(1e-12, 1e-12).until(6.0)?;
        let at = |t: f64| -> Result<f64, Error> {
            let told = free.outputs(t, &run.at(t)?, &[]);
            Ok(told.x.hypot(told.y))
        };
        Ok([at(4.0)?, at(6.0)?])
    };
    let [early, late] = lean(0.9 * least)?;
    let rate = (4.0 * M * G * L * i - (AXIAL * 0.9 * least).powi(2)).sqrt() / (2.0 * i);
    println!("  it sleeps above {least:.3} rad/s; at a tenth less a lean grows {:.1} times in 2 s", late / early);
    checks.below("that growth against the known rate (relative)", ((late / early).ln() / 2.0 / rate - 1.0).abs(), 1e-3);
    let asleep = lean(1.02 * least)?;
    checks.below("a lean of 1e-6 rad somewhat above that spin / m", asleep[0].max(asleep[1]), 1e-5);

    let svg = Path::new("target/heavy_top/heavy_top.svg");
    draw(
        svg,
        &[
            &[Panel {
                title: "the fast top from above",
                labels: ["x / m", "y / m"],
                equal: true,
                curves: vec![("", path)],
            }],
            &[Panel { title: "its height", labels: ["t / s", "m"], equal: false, curves: vec![("", heights)] }],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
