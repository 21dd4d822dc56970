//! A chain of twenty links: it swings in the frequencies that the zeros of a Laguerre polynomial give, and is let go from a
//! horizontal line. The accelerations come joint by joint.
//!
//! ```text
//! cargo run --release --example chain
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use holonomy::prelude::*;
use models::{Chain, ChainState};
use std::path::Path;
use std::process::ExitCode;

const LINKS: usize = 20;
const M: f64 = 0.1;
const L: f64 = 0.05;
const G: f64 = 9.81;

/// The Laguerre polynomial of degree n: (k + 1) L_{k+1} = (2k + 1 - x) L_k - k L_{k-1}.
fn laguerre(n: usize, x: f64) -> f64 {
    let (mut before, mut last) = (1.0, 1.0 - x);
    for k in 1..n {
        let k = k as f64;
        (before, last) = (last, ((2.0 * k + 1.0 - x) * last - k * before) / (k + 1.0));
    }
    last
}

/// Its zeros in ascending order, all of which lie below 4 n.
fn zeros(n: usize) -> Vec<f64> {
    let grid: Vec<f64> = (0..=40_000).map(|i| 4.0 * n as f64 * (f64::from(i) / 40_000.0).powi(2)).collect();
    let sign = |x: f64| laguerre(n, x) > 0.0;
    let brackets = grid.windows(2).filter(|pair| sign(pair[0]) != sign(pair[1]));
    let refined = brackets.map(|pair| {
        let (mut from, mut to) = (pair[0], pair[1]);
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            *(if sign(middle) == sign(from) { &mut from } else { &mut to }) = middle;
        }
        0.5 * (from + to)
    });
    refined.collect()
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let chain = Chain { m: M, l: L, g: G }.prepare()?;
    let cost = Chain::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("A chain of {LINKS} links: {operations} operations and {} sincos a step", cost.sincos);
    Chain::MODEL.notes.iter().for_each(|note| println!("  {note}"));

    let hanging = ChainState::default();
    let tension = chain.outputs(0.0, &hanging, &[]).tension;
    checks.below("tension at rest: n m g / N", (tension - LINKS as f64 * M * G).abs(), 1e-12);

    // Small oscillations of n weights on a thread: ω² l/g are the zeros of L_n.
    let mut squares: Vec<f64> =
        chain.linearize(0.0, &hanging, &[])?.eigenvalues()?.iter().map(|e| e.im * e.im).collect();
    squares.sort_by(f64::total_cmp);
    let found: Vec<f64> = squares.iter().step_by(2).map(|square| square * L / G).collect();
    let known = zeros(LINKS);
    checks.hold("twenty frequencies", known.len() == LINKS && found.len() == LINKS);
    let apart = found.iter().zip(&known).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    checks.below("frequencies against the zeros of the Laguerre polynomial (relative)", apart, 1e-9);

    // Let go from a horizontal line.
    let start = ChainState::from_fn(|i| if i < LINKS { std::f64::consts::FRAC_PI_2 } else { 0.0 });
    let end = 1.2;
    let run = chain.simulate(start).tolerance(1e-11, 1e-11).until(end)?;
    let scale = M * G * L * (LINKS * (LINKS + 1) / 2) as f64;
    let lost = run.iter().map(|(t, s)| (chain.energy(t, s) - chain.energy(0.0, &start)).abs()).fold(0.0, f64::max);
    checks.below("energy lost while it falls (relative)", lost / scale, 1e-8);

    let mut shapes = Vec::new();
    for (label, t) in [("0 s", 0.0), ("0.3 s", 0.3), ("0.5 s", 0.5), ("0.7 s", 0.7)] {
        let y: [f64; 41] = chain.outputs(t, &run.at(t)?, &[]).into();
        let weights = (0..LINKS).map(|i| (y[1 + i], y[1 + LINKS + i]));
        shapes.push((label, std::iter::once((0.0, 0.0)).chain(weights).collect()));
    }
    let times = (0..=1200).map(|i| (end * f64::from(i) / 1200.0).min(end));
    let tension =
        times.map(|t| Ok((t, chain.outputs(t, &run.at(t)?, &[]).tension))).collect::<Result<Vec<_>, Error>>()?;
    let svg = Path::new("target/chain/chain.svg");
    draw(
        svg,
        &[
            &[Panel { title: "let go from a line", labels: ["x / m", "y / m"], equal: true, curves: shapes }],
            &[Panel {
                title: "what the hook holds",
                labels: ["t / s", "N"],
                equal: false,
                curves: vec![("", tension)],
            }],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
