//! 3,000 random systems through the engine, evaluated and held against the oracle; 1,000 of them as emitted, with what they cost.

mod claims;
mod random;
mod support;

use claims::evaluated::{Evaluated, plain, projected, simplified};
use holonomy_engine::program::programs;
use holonomy_engine::projection::Equations;
use oracle::{CLASSES, Report, System, check, classes, closed, onto_nonlinear_rows, read_models};
use random::{MODELS, RandomModel, counted, first};
use std::collections::BTreeSet;
use std::sync::Mutex;
use support::parallel;
use support::splitmix::SplitMix;

const STATES: usize = 2;
/// How many go through the engine's simplification as well.
const EMITTED: usize = 1000;

/// States are this far from where a model changes between its cases.
const BETWEEN_CASES: f64 = 1e-9;

/// What the states of a model have shown.
#[derive(Default)]
struct Shown {
    report: Report,
    classes: BTreeSet<&'static str>,
}

/// One model in one form, at a few states.
fn agrees(model: &RandomModel, equations: Result<Equations, String>, random: &mut SplitMix) -> Result<Shown, String> {
    let equations = equations.map_err(|refusal| format!("was refused: {refusal}"))?;
    let declared = read_models(&model.source).remove(0);
    let mut system = System::nominal(&declared);
    let mut shown = Shown::default();
    for number in 0..STATES {
        system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let evaluated = Evaluated { equations: &equations, system: &system };
        let state = |random: &mut SplitMix| {
            let t = random.between(0.0, 2.0);
            let q = closed(&system, t, &random.vector(declared.state_coordinates().len(), -1.0, 1.0))?;
            let u = random.vector(equations.state_speeds.len(), -1.0, 1.0);
            let x = system.coordinates(t, &q);
            let u = onto_nonlinear_rows(&system, t, &x, &u, |u| evaluated.velocities(t, &q, u))?;
            let v = evaluated.velocities(t, &q, &u);
            (system.to_next_case(t, &q, &x, &v) > BETWEEN_CASES).then_some((t, q, u))
        };
        let (t, q, u) = (0..20).find_map(|_| state(random)).ok_or("the manifold is not reached")?;
        let claim = evaluated.claim(t, &q, &u);
        let report = check(&system, &claim);
        if !report.failures.is_empty() {
            let state = format!("t = {t}, q = {q:?}, u = {u:?}, inputs = {:?}", system.inputs);
            return Err(format!("at {state}\n  {}", report.failures.join("\n  ")));
        }
        shown.report.add(report);
        let k = claim.complement.nrows();
        if number == 0 {
            shown.classes.extend(classes(&system, t, &claim.coordinates, &claim.velocities, k));
        }
    }
    Ok(shown)
}

/// The first models of the series in one form, each with draws of its own; the failures are told together. The table of classes.
fn all_agree(count: usize, form: impl Fn(&str) -> Result<Equations, String> + Sync) -> Vec<&'static str> {
    let models = first(count, 7);
    let results = parallel::each(count, |number| {
        agrees(&models[number], form(&models[number].source), &mut SplitMix::new(500 + number as u64))
    });
    let (mut failures, mut found, mut total) = (Vec::new(), Vec::new(), Report::default());
    for (model, result) in models.iter().zip(results) {
        match result {
            Ok(mut shown) => {
                shown.report.worst_in = format!("{} of {}", shown.report.worst_in, model.name);
                total.add(shown.report);
                found.extend(shown.classes.iter().copied());
            }
            Err(failure) => failures.push(format!("{} {failure}\n{}", model.name, model.source)),
        }
    }
    println!("{}{} numbers compared", counted(found.iter().copied()), total.compared);
    println!("largest error {:.1e} of its bound, in {}", total.worst, total.worst_in);
    assert!(failures.is_empty(), "{} of {count} systems\n{}", failures.len(), failures.join("\n"));
    found
}

#[test]
fn random_systems_as_projected_agree_with_the_oracle() {
    let found = all_agree(MODELS, projected);
    for class in CLASSES {
        assert!(found.iter().filter(|c| **c == class).count() >= 100, "fewer than 100 of {class}");
    }
}

#[test]
fn random_systems_as_emitted_agree_with_the_oracle() {
    let costs = Mutex::new(Vec::new());
    let weight = |equations: &Equations| {
        let programs = programs(equations).expect("every symbol is known");
        programs.function("derivative").expect("every model has one").count.weight()
    };
    let found = |source: &str| {
        let equations = simplified(source)?;
        let cost = (weight(&equations), weight(&plain(source)?));
        costs.lock().expect("nobody has panicked").push(cost);
        Ok(equations)
    };
    all_agree(EMITTED, found);
    let costs = costs.into_inner().expect("nobody has panicked");
    assert_eq!(costs.len(), EMITTED);
    let mut gains: Vec<f64> = costs.iter().map(|(found, plain)| 1.0 - *found as f64 / (*plain).max(1) as f64).collect();
    gains.sort_by(f64::total_cmp);
    println!("what a derivative costs less than without a search, in tenths of the models:");
    println!(
        "{}",
        (0..=10).map(|i| format!(" {:.0} %", 100.0 * gains[i * (gains.len() - 1) / 10])).collect::<String>()
    );
    let total = |of: fn(&(usize, usize)) -> usize| costs.iter().map(of).sum::<usize>();
    let dearer = costs.iter().filter(|(found, plain)| found > plain).count();
    println!("{dearer} are dearer; all together {} instead of {}", total(|c| c.0), total(|c| c.1));
    assert!(total(|c| c.0) < total(|c| c.1) && dearer == 0, "{dearer} are dearer, one by {:.0} %", -100.0 * gains[0]);
}
