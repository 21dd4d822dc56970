//! 500 random systems through the engine, evaluated and held against the oracle.

mod claims;
mod oracle;
mod random;
mod support;

use claims::evaluated::{Evaluated, equations};
use oracle::{System, check, closed, read_models};
use random::{counted, generate};
use support::splitmix::SplitMix;

const MODELS: usize = 500;
const STATES: usize = 3;

#[test]
fn random_systems_agree_with_the_oracle() {
    let mut random = SplitMix::new(500);
    let models: Vec<_> = (0..MODELS).map(|number| generate(7, number)).collect();
    let mut failures = Vec::new();
    let (mut worst, mut compared) = (0.0_f64, 0);
    for model in &models {
        let declared = read_models(&model.source).remove(0);
        let equations = match equations(&model.source) {
            Ok(equations) => equations,
            Err(refusal) => {
                failures.push(format!("{} was refused: {refusal}\n{}", model.name, model.source));
                continue;
            }
        };
        let mut system = System::nominal(&declared);
        for _ in 0..STATES {
            system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
            let t = random.between(0.0, 2.0);
            let q =
                (0..20).find_map(|_| closed(&system, t, &random.vector(declared.state_coordinates().len(), -1.0, 1.0)));
            let q = q.expect("the manifold is reached");
            let u = random.vector(equations.state_speeds.len(), -1.0, 1.0);
            let evaluated = Evaluated { equations: &equations, system: &system };
            let report = check(&system, &evaluated.claim(t, &q, &u));
            worst = worst.max(report.worst);
            compared += report.compared;
            if !report.failures.is_empty() {
                let state = format!("t = {t}, q = {q:?}, u = {u:?}, inputs = {:?}", system.inputs);
                failures.push(format!(
                    "{} at {state}\n  {}\n{}",
                    model.name,
                    report.failures.join("\n  "),
                    model.source
                ));
                break;
            }
        }
    }
    println!("{}{compared} numbers compared, largest error {worst:.1e} of its bound", counted(&models));
    assert!(failures.is_empty(), "{} of {MODELS} systems\n{}", failures.len(), failures.join("\n"));
}
