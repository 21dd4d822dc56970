//! 50 random models as real Rust: derived by the macro, compiled, held against the oracle.

mod claims;
mod oracle;
mod support;

use claims::compiled::{claim, other_claim};
use claims::states::random_state;
use holonomy::ConstrainedSystem;
use oracle::{System, check, read_models};
use support::splitmix::SplitMix;

/// The models themselves, one struct each.
#[allow(dead_code, reason = "not every parameter occurs in an equation")]
mod models {
    include!("data/random_models.rs");
}

const SOURCE: &str = include_str!("data/random_models.rs");
/// Checked against the generator in tests/random_models.rs.
const MODELS: usize = 50;
const STATES: usize = 5;

/// Holds the emitted code of a model against its declaration.
fn agrees<M: ConstrainedSystem>(build: impl Fn(&[f64]) -> M) -> Result<f64, String> {
    let declared = read_models(SOURCE);
    let declared = declared.iter().find(|d| d.name == M::MODEL.name).expect("the model is declared");
    let mut random = SplitMix::new(M::MODEL.name.bytes().map(u64::from).sum());
    let mut system = System::nominal(declared);
    let model = build(&system.parameters).prepare().map_err(|e| format!("{}: {e}", declared.name))?;
    let mut worst = 0.0_f64;
    for _ in 0..STATES {
        system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let state = (0..20).find_map(|_| random_state(&model, &system, &mut random, [-1.0, 1.0]));
        let (t, q, u) = state.expect("the manifold is reached");
        for claim in [claim(&model, t, &q, &u, &system.inputs), other_claim(&model, t, &q, &u, &system.inputs)] {
            let report = check(&system, &claim);
            if !report.failures.is_empty() {
                let failures = report.failures.join("\n  ");
                return Err(format!("{} at t = {t}, q = {q:?}, u = {u:?}\n  {failures}", declared.name));
            }
            worst = worst.max(report.worst);
        }
    }
    Ok(worst)
}

macro_rules! check_all {
    ($($model:ident($($field:ident),*))*) => {
        vec![$(agrees(|p| {
            let mut p = p.iter().copied();
            models::$model { $($field: p.next().expect("a parameter")),* }
        })),*]
    };
}

#[test]
fn compiled_random_models_agree_with_the_oracle() {
    let results = models::every_random_model!(check_all);
    assert_eq!(results.len(), MODELS);
    let failures: Vec<String> = results.iter().filter_map(|result| result.clone().err()).collect();
    let worst = results.iter().flatten().fold(0.0_f64, |worst, w| worst.max(*w));
    println!("largest error {worst:.1e} of its bound");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
