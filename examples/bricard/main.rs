//! Bricard's mechanism: five rods and six hinges in space, which counting calls immovable. It swings to and fro between two dead
//! centres, and never leaves them as it should not: the period after ten of them, the closed form of its angles, published figures.
//!
//! ```text
//! cargo run --release --example bricard
//! ```

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/drift.rs"]
mod drift;
mod models;

use common::checks::Checks;
use common::picture::{Panel, draw};
use drift::drift;
use holonomy::prelude::*;
use holonomy::simulate::Event;
use models::{Bricard, BricardOutputs, BricardState};
use std::path::Path;
use std::process::ExitCode;

/// Problem A04 of the IFToMM benchmark library, computed with 20 digits: the period, a1'' at the start, the third hinge at 1 s and 10 s.
const PERIOD: f64 = 4.991711513688724;
const FIRST: f64 = 1.9580838323353293;
const THIRD: [(f64, [f64; 3]); 2] = [
    (1.0, [0.27448131926462305, -0.886707938734672, -0.46233000268737606]),
    (10.0, [0.9997309873038354, -0.9999999638258172, -0.00026897651224930486]),
];

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut checks = Checks::default();
    let loop_of_rods = Bricard { m: 1.0, l: 1.0, b: 0.1, g: 9.81 }.prepare()?;
    let cost = Bricard::MODEL.operations.iter().find(|cost| cost.function == "derivative").ok_or("no derivative")?;
    let operations = cost.additions + cost.multiplications + cost.divisions + cost.roots;
    println!("Bricard's mechanism: {operations} operations and {} sincos a derivative", cost.sincos);

    let start = BricardState::default();
    let rates: [f64; 5] = loop_of_rods.velocity_rates(0.0, &start, &[]).into();
    let off = rates.iter().zip([1.0, -1.0, 1.0, -1.0, 1.0]).map(|(rate, sign)| (rate - sign * FIRST).abs());
    checks.below("accelerations from rest against the published ones / s^-2", off.fold(0.0, f64::max), 1e-12);

    let turns = 10;
    let end = PERIOD * (f64::from(turns) + 0.1);
    let simulation = loop_of_rods.simulate(start).tolerance(1e-12, 1e-12);
    let run = simulation.event(Event::<Bricard>::new("dead centre", |_, s| s.dot_a1)).until(end)?;
    println!("{} steps, {} changes of the chart", run.statistics().accepted, run.statistics().chart_changes);
    // From rest at one dead centre to rest at the other takes half a period.
    let times: Vec<f64> = run.events().iter().map(|event| event.time).filter(|time| *time > 0.1).collect();
    checks.hold("every dead centre is found", times.len() == 2 * turns as usize);
    let late = times.iter().enumerate().map(|(i, time)| (time - 0.5 * PERIOD * (i + 1) as f64).abs());
    checks.below("times of the dead centres against the period / s", late.fold(0.0, f64::max), 1e-8);

    let energy = |t: f64, s: &BricardState| loop_of_rods.energy(t, s);
    let first = energy(0.0, &start);
    let (mut loss, mut apart, mut axis) = (0.0f64, 0.0f64, 0.0f64);
    for (t, s) in run.iter() {
        loss = loss.max((energy(t, s) - first).abs());
        // a1 = a3 = a5, a2 = a4, sin a2 = -sin a1/(1 + sin a1)
        let second = -(s.a1.sin() / (1.0 + s.a1.sin())).asin();
        let angles = [s.a3 - s.a1, s.a5 - s.a1, s.a2 - second, s.a4 - second];
        apart = angles.iter().fold(apart, |apart, angle| apart.max(angle.abs()));
        let y = loop_of_rods.outputs(t, s, &[]);
        axis = axis.max(y.axis_y.abs()).max(y.axis_z.abs());
    }
    // The kinetic energy reaches 24 J.
    checks.below("energy / J", loss, 1e-9);
    checks.below("angles against their closed form", apart, 1e-9);
    checks.below("the sixth hinge's axis, of which one row is not written", axis, 1e-9);
    checks.below("residual of f at the end of any step (relative)", run.largest_residuals().position, 1e-12);
    for (t, expected) in THIRD {
        let y = loop_of_rods.outputs(t, &run.at(t)?, &[]);
        let found = [y.x_2, y.y_2, y.z_2];
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        checks.below(&format!("the third hinge at {t} s against the published place / m"), off, 1e-9);
    }

    println!("\nUndriven for 1,000 s at a relative tolerance of 1e-10");
    let long = loop_of_rods.simulate(start).tolerance(1e-10, 1e-10).dense(false).until(1000.0)?;
    let lost = drift(&loop_of_rods, &long);
    println!("{} steps, {} changes of the chart", long.statistics().accepted, long.statistics().chart_changes);
    checks.below("residuals at the end of any step (relative)", lost.residual, 1e-10);
    checks.below("energy (of the largest kinetic one)", lost.energy, 1e-7);

    // From above and aside: z comes out of the paper, to the left and down.
    let seen = |x: f64, y: f64, z: f64| (x - 0.45 * z, y - 0.3 * z);
    let rods = |y: &BricardOutputs| -> Vec<(f64, f64)> {
        let joints = [
            (y.x_0, y.y_0, y.z_0),
            (y.x_1, y.y_1, y.z_1),
            (y.x_2, y.y_2, y.z_2),
            (y.x_3, y.y_3, y.z_3),
            (y.x_4, y.y_4, y.z_4),
            (y.x_5, y.y_5, y.z_5),
        ];
        joints.into_iter().map(|(x, y, z)| seen(x, y, z)).collect()
    };
    let at = |t: f64| -> Result<BricardOutputs, Error> { Ok(loop_of_rods.outputs(t, &run.at(t)?, &[])) };
    let times: Vec<f64> = (0..=1000).map(|i| 2.0 * PERIOD * f64::from(i) / 1000.0).collect();
    let curve = |f: &dyn Fn(&BricardState) -> f64| -> Result<Vec<(f64, f64)>, Error> {
        times.iter().map(|t| Ok((*t, f(&run.at(*t)?)))).collect()
    };
    let path = times.iter().map(|t| at(*t).map(|y| seen(y.x_2, y.y_2, y.z_2))).collect::<Result<Vec<_>, Error>>()?;
    let places =
        vec![("0 s", rods(&at(0.0)?)), ("0.8 s", rods(&at(0.8)?)), ("1.25 s", rods(&at(1.25)?)), ("third hinge", path)];
    let svg = Path::new("target/bricard/bricard.svg");
    draw(
        svg,
        &[
            &[Panel { title: "rods", labels: ["x, z / m", "y, z / m"], equal: true, curves: places }],
            &[
                Panel {
                    title: "angles",
                    labels: ["t / s", "rad"],
                    equal: false,
                    curves: vec![("a1, a3, a5", curve(&|s| s.a1)?), ("a2, a4", curve(&|s| s.a2)?)],
                },
                Panel {
                    title: "force of the sixth hinge along the third rod",
                    labels: ["t / s", "N"],
                    equal: false,
                    curves: vec![("", curve(&|s| loop_of_rods.multipliers(0.0, s, &[]).sixth_z)?)],
                },
            ],
        ],
    )?;
    println!("\nwritten: {}", svg.display());
    Ok(checks.verdict())
}
