//! 500 random systems through the engine, evaluated and held against the oracle.

mod claims;
mod oracle;
mod random;
mod support;

use claims::evaluated::{Evaluated, projected, simplified};
use holonomy_engine::projection::Equations;
use oracle::{Report, System, check, closed, read_models};
use random::{RandomModel, counted, generate};
use support::splitmix::SplitMix;

const STATES: usize = 3;

/// One model in one form, at a few states: the numbers compared and the largest error as a part of its bound.
fn agrees(model: &RandomModel, equations: Result<Equations, String>, random: &mut SplitMix) -> Result<Report, String> {
    let equations = equations.map_err(|refusal| format!("was refused: {refusal}"))?;
    let declared = read_models(&model.source).remove(0);
    let mut system = System::nominal(&declared);
    let mut total = Report::default();
    for _ in 0..STATES {
        system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let t = random.between(0.0, 2.0);
        let q = (0..20).find_map(|_| closed(&system, t, &random.vector(declared.state_coordinates().len(), -1.0, 1.0)));
        let q = q.expect("the manifold is reached");
        let u = random.vector(equations.state_speeds.len(), -1.0, 1.0);
        let evaluated = Evaluated { equations: &equations, system: &system };
        let report = check(&system, &evaluated.claim(t, &q, &u));
        if !report.failures.is_empty() {
            let state = format!("t = {t}, q = {q:?}, u = {u:?}, inputs = {:?}", system.inputs);
            return Err(format!("at {state}\n  {}", report.failures.join("\n  ")));
        }
        total.compared += report.compared;
        if report.worst > total.worst {
            (total.worst, total.worst_in) = (report.worst, report.worst_in);
        }
    }
    Ok(total)
}

/// The first models of the series in one form; the failures are told together.
fn all_agree(count: usize, form: impl Fn(&str) -> Result<Equations, String>) {
    let mut random = SplitMix::new(500);
    let models: Vec<_> = (0..count).map(|number| generate(7, number)).collect();
    let mut failures = Vec::new();
    let mut total = Report::default();
    for model in &models {
        match agrees(model, form(&model.source), &mut random) {
            Ok(report) => {
                total.compared += report.compared;
                if report.worst > total.worst {
                    (total.worst, total.worst_in) = (report.worst, format!("{} of {}", report.worst_in, model.name));
                }
            }
            Err(failure) => failures.push(format!("{} {failure}\n{}", model.name, model.source)),
        }
    }
    println!("{}{} numbers compared", counted(&models), total.compared);
    println!("largest error {:.1e} of its bound, in {}", total.worst, total.worst_in);
    assert!(failures.is_empty(), "{} of {count} systems\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn random_systems_as_projected_agree_with_the_oracle() {
    all_agree(500, projected);
}

#[test]
fn random_systems_as_emitted_agree_with_the_oracle() {
    all_agree(500, simplified);
}
