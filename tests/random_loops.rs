//! Random closed mechanisms through the engine, against the oracle, which has every body in maximal coordinates and solves all rows
//! by dense algebra.

mod claims;
mod random;
mod support;

use claims::agreement::agrees;
use claims::evaluated::{joint_by_joint, projected, simplified};
use holonomy_engine::projection::Equations;
use oracle::Report;
use random::{RandomModel, closed_mechanism, counted};
use std::sync::atomic::{AtomicUsize, Ordering};
use support::parallel;
use support::splitmix::SplitMix;

/// How many are drawn as the equations come, ...
const PROJECTED: usize = 560;
/// ... how many are drawn to be eliminated joint by joint, and how many of these are, at least, ...
const JOINT_BY_JOINT: (usize, usize) = (280, 150);
/// ... and how many are drawn in the forms in which they are emitted.
const EMITTED: usize = 32;

/// What is drawn although it is no mechanism, by what the engine says of it, and how much of that there is at most.
const REFUSED: [(&str, usize); 3] = [
    ("depends on the other rows", 7),
    ("depends on the others wherever these hold", 1),
    ("binds no coordinate and no speed", 1),
];

/// How often each class must occur among the equations as they come.
const CLASSES: [(&str, usize); 2] = [("platform", 20), ("slider in a loop", 40)];

/// The equations of a mechanism, with the line of independent speeds that the engine asks for where its own choice is a bad one
/// at the start; whether it asked.
fn derived(
    mechanism: &RandomModel,
    form: impl Fn(&str) -> Result<Equations, String>,
) -> (String, Result<Equations, String>, bool) {
    let refusal = match form(&mechanism.source) {
        Err(refusal) if refusal.contains("; write `#[independent(") => refusal,
        found => return (mechanism.source.clone(), found, false),
    };
    let line = refusal.split('`').rev().nth(1).expect("a line between quotes");
    let source = mechanism.source.replacen("pub struct", &format!("{line}\npub struct"), 1);
    let found = form(&source);
    (source, found, true)
}

/// The first mechanisms of the series in one form, each with draws of its own; the disagreements are told together. The classes of
/// those that were compared.
///
/// Drawn without regard to whether they move: rows that bind nothing, or repeat others without a mark, are refused, and drawn in
/// vain. They are counted by what is said of them; nothing else may be refused, least of all the line that a refusal offers.
fn all_agree(count: usize, form: impl Fn(&str) -> Result<Equations, String> + Sync) -> Vec<String> {
    let results = parallel::each(count, |number| {
        let mut mechanism = closed_mechanism(23, number);
        let mut random = SplitMix::new(900 + number as u64);
        let (source, equations, asked) = derived(&mechanism, &form);
        if asked {
            mechanism.classes.push("independent speeds as the engine asked".to_owned());
        }
        let refused = equations.is_err();
        let shown = match agrees(&source, equations, 1, &mut random) {
            Err(refusal) if asked && refused => Err(format!("with the line that was offered {refusal}")),
            shown => shown,
        };
        (RandomModel { source, ..mechanism }, shown)
    });
    let (mut failures, mut found, mut in_vain, mut total) = (Vec::new(), Vec::new(), Vec::new(), Report::default());
    let kind = |refusal: &str| {
        REFUSED.iter().position(|(said, _)| refusal.starts_with("was refused") && refusal.contains(said))
    };
    for (mechanism, shown) in results {
        match shown {
            Ok(mut shown) => {
                shown.report.worst_in = format!("{} of {}", shown.report.worst_in, mechanism.name);
                total.add(shown.report);
                found.extend(mechanism.classes);
            }
            Err(refusal) => match kind(&refusal) {
                Some(kind) => in_vain.push((kind, format!("{} {refusal}", mechanism.name))),
                None => failures.push(format!("{} {refusal}\n{}", mechanism.name, mechanism.source)),
            },
        }
    }
    println!("{}{} numbers compared", counted(found.iter().map(String::as_str)), total.compared);
    println!("largest error {:.1e} of its bound, in {}", total.worst, total.worst_in);
    for (at, (said, most)) in REFUSED.iter().enumerate() {
        let of_kind: Vec<&str> =
            in_vain.iter().filter(|(kind, _)| *kind == at).map(|(_, refusal)| refusal.as_str()).collect();
        println!("{} drawn in vain: {said}", of_kind.len());
        of_kind.iter().for_each(|refusal| println!("    {}", refusal.chars().take(160).collect::<String>()));
        assert!(of_kind.len() <= *most, "{} refused: {said}", of_kind.len());
    }
    assert!(failures.is_empty(), "{} of {count} mechanisms\n{}", failures.len(), failures.join("\n"));
    println!("{} of {count} mechanisms compared", count - in_vain.len());
    found
}

#[test]
fn random_closed_mechanisms_as_projected_agree_with_the_oracle() {
    let found = all_agree(PROJECTED, projected);
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
    let (drawn, least) = JOINT_BY_JOINT;
    all_agree(drawn, |source| {
        let equations = joint_by_joint(source)?;
        recursive.fetch_add(usize::from(equations.is_recursive()), Ordering::Relaxed);
        Ok(equations)
    });
    let recursive = recursive.into_inner();
    println!("{recursive} of {drawn} mechanisms joint by joint");
    assert!(recursive >= least, "{recursive} of {drawn} joint by joint");
}

#[test]
fn random_closed_mechanisms_as_emitted_agree_with_the_oracle() {
    all_agree(EMITTED, simplified);
}
