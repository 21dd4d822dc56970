//! Random closed mechanisms through the engine, against the oracle, which has every body in maximal coordinates and solves all rows
//! by dense algebra.

mod claims;
mod random;
mod support;

use claims::agreement::{NOT_REACHED, agrees};
use claims::evaluated::{joint_by_joint, projected, simplified};
use holonomy_engine::projection::Equations;
use oracle::Report;
use random::{RandomModel, closed_mechanism, counted};
use std::sync::atomic::{AtomicUsize, Ordering};
use support::parallel;
use support::splitmix::SplitMix;

/// How many are drawn as the equations come, ...
const PROJECTED: usize = 560;
/// ... how many of these are compared at least, ...
const COMPARED: usize = 500;
/// ... and how many are drawn in the forms in which they are emitted.
const EMITTED: usize = 32;

/// How many of those that are compared are eliminated joint by joint where that is asked, at least.
const RECURSIVE: usize = 300;

/// How often each class must occur among the equations as they come.
const CLASSES: [(&str, usize); 2] = [("platform", 20), ("slider in a loop", 40)];

/// The equations of a mechanism, with the line of independent speeds that the engine asks for where its own choice is a bad one
/// at the start; whether it asked.
fn derived(
    mechanism: &RandomModel,
    form: impl Fn(&str) -> Result<Equations, String>,
) -> (String, Result<Equations, String>, bool) {
    let refusal = match form(&mechanism.source) {
        Err(refusal) if refusal.contains("; write `") => refusal,
        found => return (mechanism.source.clone(), found, false),
    };
    let line = refusal.split('`').rev().nth(1).expect("a line between quotes");
    let source = mechanism.source.replacen("pub struct", &format!("{line}\npub struct"), 1);
    let found = form(&source);
    (source, found, true)
}

/// The first mechanisms of the series in one form, each with draws of its own; the disagreements are told together. The classes of
/// those that were compared, and how many these are.
///
/// Drawn without regard to whether they move: what has no degree of freedom, rows that repeat others without a mark, or a start from
/// which Newton's method does not get onto the loops is refused, and drawn in vain. They are counted.
fn all_agree(count: usize, form: impl Fn(&str) -> Result<Equations, String> + Sync) -> (Vec<String>, usize) {
    let results = parallel::each(count, |number| {
        let mut mechanism = closed_mechanism(23, number);
        let mut random = SplitMix::new(900 + number as u64);
        let (source, equations, asked) = derived(&mechanism, &form);
        if asked {
            mechanism.classes.push("independent speeds as the engine asked".to_owned());
        }
        let shown = agrees(&source, equations, 1, &mut random);
        (RandomModel { source, ..mechanism }, shown)
    });
    let (mut failures, mut found, mut in_vain, mut total) = (Vec::new(), Vec::new(), Vec::new(), Report::default());
    for (mechanism, shown) in results {
        match shown {
            Ok(mut shown) => {
                shown.report.worst_in = format!("{} of {}", shown.report.worst_in, mechanism.name);
                total.add(shown.report);
                found.extend(mechanism.classes);
            }
            Err(refusal) if refusal == NOT_REACHED || refusal.starts_with("was refused") => {
                in_vain.push(format!("{} {refusal}", mechanism.name));
            }
            Err(failure) => failures.push(format!("{} {failure}\n{}", mechanism.name, mechanism.source)),
        }
    }
    println!("{}{} numbers compared", counted(found.iter().map(String::as_str)), total.compared);
    println!("largest error {:.1e} of its bound, in {}", total.worst, total.worst_in);
    let short = in_vain.iter().map(|refusal| refusal.chars().take(120).collect::<String>());
    println!("{} drawn in vain:\n{}", in_vain.len(), short.collect::<Vec<_>>().join("\n"));
    assert!(failures.is_empty(), "{} of {count} mechanisms\n{}", failures.len(), failures.join("\n"));
    (found, count - in_vain.len())
}

#[test]
fn random_closed_mechanisms_as_projected_agree_with_the_oracle() {
    let (found, compared) = all_agree(PROJECTED, projected);
    assert!(compared >= COMPARED, "{compared} compared");
    let count = |class: &str| found.iter().filter(|found| *found == class).count();
    for place in ["planar", "spatial"] {
        for loops in 1..=4 {
            for with in ["with redundancy", "without"] {
                let class = format!("{place}, {loops} loops, {with}");
                assert!(count(&class) > 20, "{} of {class}", count(&class));
            }
        }
    }
    for (class, least) in CLASSES {
        assert!(count(class) >= least, "{} of {class}", count(class));
    }
}

#[test]
fn random_closed_mechanisms_joint_by_joint_agree_with_the_oracle() {
    let recursive = AtomicUsize::new(0);
    let (_, compared) = all_agree(PROJECTED, |source| {
        let equations = joint_by_joint(source)?;
        recursive.fetch_add(usize::from(equations.is_recursive()), Ordering::Relaxed);
        Ok(equations)
    });
    let recursive = recursive.into_inner();
    println!("{recursive} of {PROJECTED} mechanisms joint by joint");
    assert!(compared >= COMPARED && recursive >= RECURSIVE, "{compared} compared, {recursive} joint by joint");
}

#[test]
fn random_closed_mechanisms_as_emitted_agree_with_the_oracle() {
    let (_, compared) = all_agree(EMITTED, simplified);
    assert!(compared >= EMITTED - EMITTED / 8, "{compared} compared");
}
