//! 3,000 random systems through the engine, evaluated and held against the oracle; 1,000 of them as emitted, with what they cost.

mod claims;
mod random;
mod support;

use claims::agreement::agrees;
use claims::evaluated::{plain, projected, simplified};
use holonomy_engine::program::programs;
use holonomy_engine::projection::Equations;
use oracle::{CLASSES, Report};
use random::{MODELS, counted, first};
use std::sync::Mutex;
use support::parallel;
use support::splitmix::SplitMix;

const STATES: usize = 2;
/// How many go through the engine's simplification as well.
const EMITTED: usize = 1000;

/// The first models of the series in one form, each with draws of its own; the failures are told together. The table of classes.
fn all_agree(count: usize, form: impl Fn(&str) -> Result<Equations, String> + Sync) -> Vec<&'static str> {
    let models = first(count, 7);
    let results = parallel::each(count, |number| {
        agrees(&models[number].source, form(&models[number].source), STATES, &mut SplitMix::new(500 + number as u64))
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
