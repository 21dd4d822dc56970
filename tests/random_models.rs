//! The random models by themselves: the same text everywhere, in all classes, consistent for the oracle. No engine.

mod random;
mod support;

use oracle::{CLASSES, Motion, System, classes, closed, onto_velocity_rows, read_models};
use random::{KINDS, MODELS, RandomModel, counted, crate_text, first, generate};
use support::parallel;
use support::splitmix::SplitMix;

fn models() -> Vec<RandomModel> {
    (0..MODELS).map(|number| generate(7, number)).collect()
}

#[test]
fn every_kind_is_there() {
    let models = models();
    let count = |class: &str| models.iter().filter(|m| m.classes.iter().any(|c| c == class)).count();
    for kind in KINDS {
        assert!(count(&format!("kind: {kind}")) >= 100, "{kind}");
    }
    for n in 1..=6 {
        assert!(count(&format!("n = {n}")) >= 200, "n = {n}");
    }
}

/// A state of the model on its manifold, with the motion there.
fn state(system: &System<'_>, random: &mut SplitMix) -> Option<(f64, Vec<f64>, Vec<f64>, Motion)> {
    let t = random.between(0.0, 2.0);
    let q = closed(system, t, &random.vector(system.model.state_coordinates().len(), -1.0, 1.0))?;
    let rates = random.vector(q.len(), -1.0, 1.0);
    let (x, v) = (system.coordinates(t, &q), system.velocities_of(t, &q, &rates));
    if system.model.configuration.is_some() {
        let motion = system.configured_motion(t, &q, &rates);
        return Some((t, x, v, motion));
    }
    let v = onto_velocity_rows(system, t, &x, &v)?;
    let motion = system.motion(t, &x, &v);
    Some((t, x, v, motion))
}

/// Every model can be read, its manifold reached and its motion solved, and the conditions are moderate; every class is there.
#[test]
fn every_model_has_a_motion() {
    let models = models();
    let results = parallel::each(models.len(), |number| {
        let model = &models[number];
        let mut random = SplitMix::new(11 + number as u64);
        let declared = read_models(&model.source);
        let system = System::nominal(&declared[0]);
        let reached = (0..20).find_map(|_| state(&system, &mut random));
        let Some((t, x, v, motion)) = reached else { panic!("{} cannot be closed\n{}", model.name, model.source) };
        assert!(motion.acceleration.iter().all(|a| a.is_finite()), "{}\n{}", model.name, model.source);
        (motion.condition, classes(&system, t, &x, &v, motion.freedom))
    });
    let worst = results.iter().fold(0.0_f64, |worst, (condition, _)| worst.max(*condition));
    let found: Vec<&str> = results.into_iter().flat_map(|(_, classes)| classes).collect();
    println!("largest condition of (2.8): {worst:.1e}\n{}", counted(found.iter().copied()));
    assert!(worst < 1e6);
    for class in CLASSES {
        assert!(found.iter().filter(|c| **c == class).count() >= 100, "fewer than 100 of {class}");
    }
}

/// The models that tests/random_compiled.rs derives; `HOLONOMY_BLESS=1` writes the file anew.
#[test]
fn the_committed_models_are_the_generated_ones() {
    let text = crate_text(&first(200, 23));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/random_models.rs");
    if std::env::var_os("HOLONOMY_BLESS").is_some() {
        std::fs::write(path, &text).expect("the file is written");
    }
    let committed = std::fs::read_to_string(path).expect("the file is there");
    assert!(text == committed, "{path} is out of date: run this test with HOLONOMY_BLESS=1");
}
