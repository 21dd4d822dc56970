//! What kinds of systems a model belongs to, measured on its declaration at a state, not read off how it was written.

use super::declaration::Level;
use super::kkt::conditioned_rank;
use super::linear::{fixed, unit};
use super::number::{Dual, Number};
use super::system::System;
use nalgebra::DMatrix;
use std::collections::BTreeSet;

/// The classes that are counted.
pub const CLASSES: [&str; 23] = [
    "nonlinear φ",
    "acceleration rows",
    "two kinds mixed",
    "∂A/∂t",
    "∂a0/∂t",
    "∂M/∂t",
    "∂f/∂t",
    "∂η/∂t",
    "A ≠ I",
    "dense M",
    "no constant pivot",
    "k = 0",
    "m = 0",
    "m = n − 1",
    "redundant rows",
    "M from T",
    "T with b or T0",
    "V beside T",
    "families",
    "functions of the user's",
    "cases",
    "combined speeds",
    "several charts",
];

/// A derivative below this is none.
const NOTHING: f64 = 1e-10;

/// The classes of the model at a state that leaves k accelerations free.
pub fn classes(system: &System<'_>, t: f64, x: &[f64], v: &[f64], k: usize) -> BTreeSet<&'static str> {
    let (model, n) = (system.model, system.model.n());
    let rows = system.rows(t, x, v);
    let dynamics = system.dynamics(t, x, v);
    let c = rows.c.map(|e| e.value);
    let rank = conditioned_rank(&c).0;
    let bound = |i: &usize| rows.levels[*i] == Level::Velocity;
    let nonlinear = (0..c.nrows()).filter(bound).any(|i| !rows.linear[i]);
    let kinds: BTreeSet<(u8, bool)> = (0..c.nrows()).map(|i| (rows.levels[i] as u8, rows.linear[i])).collect();
    let elsewhere = |values: &[f64]| values.iter().map(|x| 0.83 * x + 0.19).collect::<Vec<_>>();
    let other = system.rows(t + 0.31, &elsewhere(x), &elsewhere(v)).c.map(|e| e.value);
    let constant = |(a, b): (&f64, &f64)| a.abs() > NOTHING && (a - b).abs() <= NOTHING;
    let of = |level| model.constraints.iter().enumerate().filter(move |(_, c)| c.level == level).map(|(i, _)| i);
    let moving = Dual::moving(t, 1.0);
    let still = vec![Dual::zero(); n];
    let x_still = fixed(x);
    let changes = |e: Dual<f64>| e.rate.abs() > NOTHING;
    let a_changes = || {
        let column = |j| system.rates(Dual::fixed(moving), &fixed(&x_still), &unit(n, j));
        (0..n).flat_map(column).any(|e| changes(e.rate))
    };
    let identity = DMatrix::identity(n, n);
    let lower = || {
        let momentum = |j| system.kinetic(Dual::constant(t), &x_still, &unit(n, j));
        n > 0 && (0..n).map(momentum).any(|kinetic| changes(kinetic) || kinetic.value.abs() > NOTHING)
    };
    let holds = |class: &str| match class {
        "nonlinear φ" => nonlinear,
        "acceleration rows" => rows.levels.contains(&Level::Acceleration),
        "two kinds mixed" => kinds.len() > 1,
        "∂A/∂t" => a_changes(),
        "∂a0/∂t" => system.rates(moving, &x_still, &still).into_iter().any(changes),
        "∂M/∂t" => system.inertia_rate(t, x).iter().any(|rate| rate.abs() > NOTHING),
        "∂f/∂t" => of(Level::Position).any(|row| changes(system.position(row, moving, &x_still))),
        "∂η/∂t" => of(Level::Velocity).any(|row| changes(system.velocity(row, moving, &x_still, &still))),
        "A ≠ I" => dynamics.a.map(|e| e.value) != identity,
        "dense M" => n > 1 && dynamics.m.iter().all(|e| e.value.abs() > NOTHING),
        "no constant pivot" => !c.is_empty() && !c.iter().zip(other.iter()).any(constant),
        "k = 0" => k == 0,
        "m = 0" => c.nrows() == 0 && model.configuration.is_none(),
        "m = n − 1" => n > 1 && rank == n - 1,
        "redundant rows" => rank < c.nrows() && model.constraints.iter().any(|c| c.redundant),
        "M from T" => model.kinetic_energy.is_some(),
        "T with b or T0" => model.kinetic_energy.is_some() && lower(),
        "V beside T" => model.kinetic_energy.is_some() && model.potential_energy.is_some(),
        "families" => !model.sizes.is_empty(),
        "functions of the user's" => !model.functions.is_empty(),
        "cases" => !model.conditions().is_empty(),
        "combined speeds" => model.charts.iter().flatten().any(|chosen| chosen.name.is_some()),
        "several charts" => model.charts.len() > 1,
        other => panic!("{other} is no class"),
    };
    CLASSES.into_iter().filter(|class| holds(class)).collect()
}
