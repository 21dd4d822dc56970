//! A flyball governor whose links are springs, so stiff that an explicit method crawls: it runs by Radau5 of the crate
//! `differential-equations`, against published figures, with its angular momentum and the balance of its energy.
//!
//! ```text
//! cargo run --release --example flyball
//! ```

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use differential_equations::methods::ImplicitRungeKutta;
use holonomy::differential_equations::Equations;
use holonomy::prelude::*;
use models::{Governor, GovernorState};
use std::f64::consts::{FRAC_PI_3, TAU};
use std::path::Path;
use std::process::ExitCode;

const HEIGHT: f64 = 1.0;
const OFF: f64 = 0.05;

/// Problem A05 of the IFToMM benchmark library, computed with 19 digits: ph, s, a1, and their rates at these times.
const PUBLISHED: [(f64, [f64; 6]); 4] = [
    (
        0.25,
        [
            1.4953165461057047,
            0.6220927215961469,
            1.183402675449843,
            5.536672019829262,
            0.7471334957172857,
            0.8071086524725847,
        ],
    ),
    (
        0.5,
        [
            2.8076794883679015,
            0.7432494247863257,
            1.3113049452514836,
            5.103415421971535,
            0.052119780158373416,
            0.053905218498742476,
        ],
    ),
    (
        0.75,
        [
            4.1103642836753504,
            0.640396711609433,
            1.2030870376226246,
            5.455329625346692,
            -0.7338530664482362,
            -0.7865865812996674,
        ],
    ),
    (
        1.0,
        [
            5.586346965869005,
            0.5014209223795677,
            1.0489630251693505,
            6.2711257418765545,
            -0.12215149289772892,
            -0.14088557947952693,
        ],
    ),
];
const MOMENTUM: f64 = 53.868998658418434;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let governor = Governor {
        g: 9.81,
        k: 8e5,
        cd: 4e4,
        l0: 0.5,
        m_rod: 0.3,
        l_rod: HEIGHT,
        w_rod: 0.01,
        off: OFF,
        m_ball: 5.0,
        m_slider: 3.0,
        b_slider: 0.1,
    }
    .prepare()?;
    let start = GovernorState { s: 0.5, a1: FRAC_PI_3, a2: FRAC_PI_3, dot_ph: TAU, ..Default::default() };
    // By entries: Radau5 makes a single number coarser once for each of them.
    let method = || ImplicitRungeKutta::radau5().rtol([1e-13; 8]).atol([1e-13; 8]);

    // Radau5 has the ends of its runs to the tolerance, and what lies between by a cubic: one run to each time.
    let equations = Equations::new(&governor)?;
    let mut here = (0.0, start);
    let (mut steps, mut spun, mut balance) = (0, 0.0f64, 0.0f64);
    for (t, expected) in PUBLISHED {
        let states = equations.solve(method(), here.1, (here.0, t))?;
        steps += states.len() - 1;
        for (t, s) in &states {
            let y = governor.outputs(*t, s, &[]);
            spun = spun.max((y.turning / MOMENTUM - 1.0).abs());
            // the dampers alone take energy
            balance = balance.max((governor.power(*t, s, &[])? - y.damping).abs());
        }
        here = *states.last().ok_or("a run without an end")?;
        let s = here.1;
        let found = [s.ph, s.s, s.a1, s.dot_ph, s.dot_s, s.dot_a1];
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        checks.below(&format!("the state at {t} s against the published one"), off, 1e-9);
        checks.below("the rods against each other", (s.a1 - s.a2).abs().max((s.dot_a1 - s.dot_a2).abs()), 1e-9);
    }
    checks.below("angular momentum about the shaft (relative)", spun, 1e-9);
    checks.below("power against that of the dampers / W", balance, 1e-9);
    let explicit = governor.simulate(start).tolerance(1e-11, 1e-11).until(1.0)?;
    println!("{steps} steps of Radau5, {} of an explicit method of order 8", explicit.statistics().accepted);
    let end = explicit.last().1;
    let apart: [f64; 8] = (*end).into();
    let there: [f64; 8] = here.1.into();
    let apart = apart.iter().zip(there).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    checks.below("the two methods at the end against each other", apart, 1e-9);

    let long = equations.every(0.005).solve(method(), start, (0.0, 4.0))?;
    let curve = |f: &dyn Fn(&GovernorState) -> f64| long.iter().map(|(t, s)| (*t, f(s))).collect::<Vec<_>>();
    // In the plane of the rods, which turns: ball, hinges, the other ball, and by the links through the slider.
    let outline = |s: &GovernorState| -> Vec<(f64, f64)> {
        let rod = |a: f64, part: f64| (OFF + part * HEIGHT * a.sin(), HEIGHT * (1.0 - part * a.cos()));
        let ([m1, b1], [m2, b2]) = ([0.5, 1.0].map(|part| rod(s.a1, part)), [0.5, 1.0].map(|part| rod(s.a2, part)));
        let other = |(x, z): (f64, f64)| (-x, z);
        let links = [m1, (OFF, s.s), (-OFF, s.s), other(m2)];
        [vec![b1], links.to_vec(), vec![other(b2), (-OFF, HEIGHT), (OFF, HEIGHT), b1]].concat()
    };
    let at = |t: f64| long.iter().find(|(time, _)| *time >= t - 1e-9).map(|(_, s)| outline(s)).unwrap_or_default();
    let svg = Path::new("target/flyball/flyball.svg");
    let panel = |title, label, curves| Panel { title, labels: ["t / s", label], equal: false, curves };
    draw(
        svg,
        &[
            &[
                Panel {
                    title: "in the plane of the rods",
                    labels: ["m", "z / m"],
                    equal: true,
                    curves: vec![("0 s", at(0.0)), ("0.25 s", at(0.25)), ("0.5 s", at(0.5))],
                },
                panel("the slider", "s / m", vec![("", curve(&|s| s.s))]),
            ],
            &[
                panel("the shaft", "rad/s", vec![("", curve(&|s| s.dot_ph))]),
                panel("pull of a link", "N", vec![("", curve(&|s| governor.outputs(0.0, s, &[]).tension1))]),
            ],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
