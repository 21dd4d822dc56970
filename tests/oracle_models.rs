//! Every model of the repository against the oracle, at random states and random parameters.

mod claims;
mod registry;
mod support;

use claims::compiled::{claim, other_claim};
use claims::states::{Point, random_state};
use holonomy::{ConstrainedSystem, Dual, Error, Prepared, Vector};
use oracle::{Claim, Declaration, Report, System, check, read_models};
use registry::every_model;
use std::collections::BTreeSet;
use std::path::Path;
use support::fields::Field;
use support::parallel;
use support::splitmix::SplitMix;

/// States of each model, ...
const STATES: usize = 25;
/// ... and of one with more speeds than this: the full system is dense, and chains of many links need not be shown so often.
const MANY: usize = 12;
const STATES_OF_MANY: usize = 2;

/// What a file of the repository declares.
fn declared(file: &str) -> Vec<Declaration> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    read_models(&std::fs::read_to_string(path).expect("the file is there"))
}

/// A model with parameters near the nominal ones, at a random state of it.
fn drawn<'a, M: ConstrainedSystem>(
    declared: &'a Declaration,
    build: &impl Fn(&[f64]) -> M,
    random: &mut SplitMix,
) -> (System<'a>, Prepared<M>, Point) {
    let mut spread = 0.35;
    for _ in 0..40 {
        let nominal = declared.parameters.iter().map(|(_, value)| value.unwrap_or(1.0));
        let parameters: Vec<f64> = nominal.map(|p| p * random.between(1.0 - spread, 1.0 + spread)).collect();
        let inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let system = System { model: declared, parameters: parameters.clone(), inputs };
        let model = build(&parameters).prepare().expect("the parameters are good");
        if let Some(state) = random_state(&model, &system, random, [0.2, 1.2]) {
            return (system, model, state);
        }
        // a mechanism that does not close with these lengths
        spread *= 0.7;
    }
    panic!("{}: no state was reached", declared.name)
}

/// How long a conservative model runs.
const RUN: f64 = 20.0;

/// The rate of the energy along the motion, as a part of the power of the forces; `None` without a potential.
fn energy_rate<M: ConstrainedSystem>(model: &Prepared<M>, claim: &Claim) -> Option<f64> {
    claim.potential_energy?;
    let dual = model.system().clone().prepare_as::<Dual<f64>>().expect("the parameters are good");
    let y: Vec<f64> = claim.state_coordinates.iter().chain(&claim.speeds).copied().collect();
    let rate: Vec<f64> = claim.coordinate_rates.iter().chain(&claim.accelerations).copied().collect();
    let state = M::State::<Dual<f64>>::from_fn(|i| Dual::new(y[i], rate[i]));
    let power = claim.forces.iter().zip(&claim.velocities).fold(0.0, |sum, (h, v)| sum + (h * v).abs());
    Some(dual.energy(Dual::variable(claim.t), &state).derivative.abs() / (power + claim.kinetic_energy + f64::EPSILON))
}

/// The largest change of the energy in a run, as a part of the energies that are exchanged; one that a loss of rank ends counts so far.
fn energy_drift<M: ConstrainedSystem>(model: &Prepared<M>, (t, q, u): &Point) -> f64 {
    let y: Vec<f64> = q.iter().chain(u).copied().collect();
    let start = M::State::<f64>::from_fn(|i| y[i]);
    let simulation = model.simulate(start).starting_at(*t).tolerance(1e-10, 1e-12).max_steps(20_000).every(0.25);
    let run = simulation.until(t + RUN).unwrap_or_else(|stop| {
        // A bicycle that has fallen flat: its wheels touch the ground all around, and the steps become tiny next to that.
        let near = matches!(stop.error, Error::TooManySteps { .. });
        let of_mechanism = matches!(stop.error, Error::Dependent { .. } | Error::ChartSingularity { .. });
        assert!(of_mechanism || near, "{}: {}", M::MODEL.name, stop.error);
        println!("{:24} {}", M::MODEL.name, stop.error);
        stop.trajectory
    });
    let energies: Vec<f64> = run.iter().map(|(t, s)| model.energy(t, s)).collect();
    let kinetic =
        |(t, s): (f64, &M::State<f64>)| model.kinetic_energy(t, &model.coordinates(t, s), &model.velocities(t, s));
    let exchanged = run.iter().map(kinetic).fold(energies[0].abs(), f64::max);
    energies.iter().fold(0.0_f64, |worst, e| worst.max((e - energies[0]).abs())) / exchanged
}

/// Holds the emitted code of a model against its declaration.
fn agrees<M: ConstrainedSystem>(file: &str, build: impl Fn(&[f64]) -> M) {
    // Draws of its own, whatever other models there are.
    let seed = file.bytes().chain(M::MODEL.name.bytes()).fold(4_u64, |seed, b| seed.wrapping_mul(31) + u64::from(b));
    let random = &mut SplitMix::new(seed);
    let all = declared(file);
    let declared = all.iter().find(|d| d.name == M::MODEL.name).expect("the model is declared in its file");
    let mut total = Report::default();
    let mut runs = Vec::new();
    let mut steady = true;
    let many = declared.n() > MANY;
    for _ in 0..if many { STATES_OF_MANY } else { STATES } {
        let (system, model, point) = drawn(declared, &build, random);
        let (t, q, u) = point.clone();
        let inputs = &system.inputs;
        for claim in [claim(&model, t, &q, &u, inputs), other_claim(&model, t, &q, &u, inputs)] {
            let report = check(&system, &claim);
            let parameters = &system.parameters;
            steady &= inputs.is_empty() && energy_rate(&model, &claim).is_some_and(|rate| rate < 1e-9);
            report.assert(&format!("{} at t = {t}, q = {q:?}, u = {u:?}, parameters {parameters:?}", declared.name));
            total.add(report);
        }
        runs.push((model, point));
    }
    // where the energy does not change at any state, it must not change in a run
    let mut drift = String::new();
    if steady && !many {
        let drifts: Vec<f64> = runs.iter().take(2).map(|(model, point)| energy_drift(model, point)).collect();
        assert!(drifts.iter().all(|d| *d < 1e-7), "{}: the energy drifts by {drifts:?}", declared.name);
        drift = format!(", energy kept to {:.0e}", drifts.iter().fold(0.0_f64, |worst, d| worst.max(*d)));
    }
    let Report { compared, worst, worst_in, .. } = total;
    println!(
        "{:24} {compared:6} numbers compared, largest error {worst:.1e} of its bound, in {worst_in}{drift}",
        declared.name
    );
}

macro_rules! check_all {
    ($($file:literal $module:ident: $($model:ident($($field:ident),*))*;)*) => {{
        let checks: &[fn()] = &[$($(|| agrees($file, |p| {
            let mut p = p.iter().copied();
            registry::$module::$model { $($field: Field::take(&mut p)),* }
        })),*),*];
        parallel::each(checks.len(), |number| checks[number]());
    }};
}

#[test]
fn every_model_agrees_with_the_oracle() {
    every_model!(check_all);
}

/// The check of charts can fail: every number of a chart, off by a part in a million, is found.
#[test]
fn wrong_charts_are_found() {
    let all = declared("tests/models/combined.rs");
    let declared = all.iter().find(|d| d.name == "SphericalByTurning").expect("the model is there");
    let build = |p: &[f64]| registry::combined::SphericalByTurning { m: p[0], l: p[1], g: p[2] };
    let (system, model, (t, q, u)) = drawn(declared, &build, &mut SplitMix::new(12));
    let right = claim(&model, t, &q, &u, &[]);
    assert!(check(&system, &right).failures.is_empty());
    let off = |value: &mut f64| *value += 1e-6 * value.abs().max(1.0);
    for chart in 0..2 {
        for part in 0..4 {
            let mut wrong = right.clone();
            let chart = &mut wrong.charts[chart];
            let values =
                [&mut chart.speeds, &mut chart.velocities, &mut chart.coordinate_rates, &mut chart.accelerations];
            off(&mut values.into_iter().nth(part).expect("four parts")[0]);
            assert!(!check(&system, &wrong).failures.is_empty(), "part {part}");
        }
    }
}

macro_rules! names {
    ($($file:literal $module:ident: $($model:ident($($field:ident),*))*;)*) => {
        BTreeSet::from([$($(($file.to_string(), stringify!($model).to_string())),*),*])
    };
}

/// The files under a folder, as the registry names them.
fn rust_files(folder: &str) -> Vec<String> {
    let mut open = vec![folder.to_string()];
    let mut files = Vec::new();
    while let Some(folder) = open.pop() {
        let entries = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(&folder)).expect("a folder");
        for entry in entries.map(|entry| entry.expect("an entry")) {
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.file_type().expect("a type").is_dir() {
                open.push(path);
            } else if path.ends_with(".rs") {
                files.push(path);
            }
        }
    }
    files
}

#[test]
fn every_model_is_registered() {
    let registered: BTreeSet<(String, String)> = every_model!(names);
    let files = rust_files("tests/models").into_iter().chain(rust_files("examples"));
    let found: BTreeSet<(String, String)> =
        files.flat_map(|file| declared(&file).into_iter().map(move |model| (file.clone(), model.name))).collect();
    let missing: Vec<_> = found.symmetric_difference(&registered).collect();
    assert!(missing.is_empty(), "not in tests/registry, or not in the repository: {missing:?}");
}
