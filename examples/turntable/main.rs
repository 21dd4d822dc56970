//! A ball on a turntable: it goes round circles, at two sevenths of the table's rate, wherever it is put. The rows of the
//! constraint have a part of their own, η, so the reactions do work and no energy is kept.
//!
//! ```text
//! cargo run --release --example turntable
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{Turntable, TurntableState};
use std::path::Path;
use std::process::ExitCode;

const M: f64 = 0.4;
const R: f64 = 0.05;
const W: f64 = 3.5;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let table = Turntable { m: M, r: R, w: W, a: 0.0, b: 0.0 }.prepare()?;
    println!("A ball on a table that turns at {W} rad/s\n");
    for equation in Turntable::MODEL.equations.iter().filter(|e| ["M_d", "h_u*", "lambda(along_x)"].contains(&e.symbol))
    {
        println!("  {} = {}  {}", equation.symbol, equation.text, equation.source);
    }

    // Pushed at (0.2, 0): the centre of its circle and its radius follow from the rate 2/7 W alone.
    let start = TurntableState { x: 0.2, vx: -0.05, vy: 0.12, oz: 1.0, ..Default::default() };
    let around = 2.0 / 7.0 * W;
    let (cx, cy) = (start.x - start.vy / around, start.vx / around);
    let period = std::f64::consts::TAU / around;
    let run = table.simulate(start).tolerance(1e-12, 1e-12).until(5.0 * period)?;
    let (mut path, mut force) = (Vec::new(), Vec::new());
    let (mut apart, mut pull, mut work) = (0.0f64, 0.0f64, 0.0f64);
    let kinetic = |t: f64, s: &TurntableState| table.energy(t, s);
    let first = kinetic(0.0, &start);
    let mut done = 0.0;
    let steps = 2000;
    let dt = 5.0 * period / f64::from(steps);
    let power = |t: f64| -> Result<f64, Error> {
        let s = run.at(t)?;
        // -λᵀ η: what the table gives to the ball.
        let lambda = table.multipliers(t, &s, &[]);
        Ok(-(lambda.along_x * W * s.y - lambda.along_y * W * s.x))
    };
    for i in 0..=steps {
        let t = (dt * f64::from(i)).min(5.0 * period);
        let s = run.at(t)?;
        let (sin, cos) = (around * t).sin_cos();
        let exact =
            [cx + (start.x - cx) * cos - (start.y - cy) * sin, cy + (start.x - cx) * sin + (start.y - cy) * cos];
        apart = apart.max((s.x - exact[0]).hypot(s.y - exact[1]));
        // The friction is what bends the path: m v² / radius.
        let lambda = table.multipliers(t, &s, &[]);
        let size = lambda.along_x.hypot(lambda.along_y);
        pull = pull.max((size - M * around * start.vx.hypot(start.vy)).abs());
        if i > 0 {
            // Simpson's rule over the interval.
            done += dt / 6.0 * (power(t - dt)? + 4.0 * power(t - 0.5 * dt)? + power(t)?);
        }
        work = work.max((kinetic(t, &s) - first - done).abs());
        path.push((s.x, s.y));
        force.push((t, lambda.along_x));
    }
    checks.below("five turns: distance from the circle / m", apart, 1e-10);
    checks.below("friction against m v 2/7 W / N", pull, 1e-11);
    checks.below("kinetic energy against the work of the reactions -λᵀη / J", work, 1e-10);

    // A table whose rate swings: the horizontal motion is (2/7)(rate r)' turned by a quarter, so with the momentum about the
    // contact v - (2/7) rate × r is kept.
    let swinging = Turntable { m: M, r: R, w: W, a: 0.6, b: 2.0 }.prepare()?;
    let swung = swinging.simulate(start).tolerance(1e-12, 1e-12).until(10.0)?;
    let kept = |t: f64, s: &TurntableState| {
        let rate = 2.0 / 7.0 * W * (1.0 + 0.6 * (2.0 * t).sin());
        [s.vx + rate * s.y, s.vy - rate * s.x]
    };
    let before = kept(0.0, &start);
    let drift = swung.iter().map(|(t, s)| {
        let now = kept(t, s);
        (now[0] - before[0]).abs().max((now[1] - before[1]).abs())
    });
    checks.below("a swinging rate: v - (2/7) rate × r / (m/s)", drift.fold(0.0, f64::max), 1e-10);

    let svg = Path::new("target/turntable/turntable.svg");
    let swung = (0..=2000).map(|i| swung.at(0.005 * f64::from(i)).map(|s| (s.x, s.y))).collect::<Result<_, _>>()?;
    let plane = |title, curve| Panel { title, labels: ["x / m", "y / m"], equal: true, curves: vec![("", curve)] };
    draw(
        svg,
        &[
            &[plane("the table's rate is constant", path), plane("the rate swings", swung)],
            &[Panel {
                title: "friction along x", labels: ["t / s", "λ / N"], equal: false, curves: vec![("", force)]
            }],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
