//! The random models by themselves: the same text everywhere, in all classes, consistent for the oracle. No engine.

mod oracle;
mod random;
mod support;

use oracle::{System, closed, onto_velocity_rows, read_models};
use random::{KINDS, RandomModel, counted, crate_text, generate};
use support::splitmix::SplitMix;

/// How many models go through the engine.
const MODELS: usize = 500;

fn models() -> Vec<RandomModel> {
    (0..MODELS).map(|number| generate(7, number)).collect()
}

#[test]
fn every_class_is_there() {
    let models = models();
    println!("{}", counted(&models));
    let count = |class: &str| models.iter().filter(|m| m.classes.iter().any(|c| c == class)).count();
    for kind in KINDS {
        assert!(count(&format!("kind: {kind}")) >= 40, "{kind}");
    }
    for n in 1..=6 {
        assert!(count(&format!("n = {n}")) >= 40, "n = {n}");
    }
}

/// Every model can be read, its manifold reached and its motion solved, and the conditions are moderate.
#[test]
fn every_model_has_a_motion() {
    let mut random = SplitMix::new(11);
    let mut worst = 0.0_f64;
    for model in models() {
        let declared = read_models(&model.source);
        let system = System::nominal(&declared[0]);
        let (t, q) = (0..20)
            .find_map(|_| {
                let t = random.between(0.0, 2.0);
                let guess = random.vector(declared[0].state_coordinates().len(), -1.0, 1.0);
                closed(&system, t, &guess).map(|q| (t, q))
            })
            .unwrap_or_else(|| panic!("{} cannot be closed\n{}", model.name, model.source));
        let rates = random.vector(q.len(), -1.0, 1.0);
        let motion = if declared[0].configuration.is_some() {
            system.configured_motion(t, &q, &rates)
        } else {
            let v = system.velocities_of(t, &q, &rates);
            system.motion(t, &q, &onto_velocity_rows(&system, t, &q, &v))
        };
        assert!(motion.acceleration.iter().all(|a| a.is_finite()), "{}\n{}", model.name, model.source);
        worst = worst.max(motion.condition);
    }
    println!("largest condition of (2.8): {worst:.1e}");
    assert!(worst < 1e6);
}

/// The models that tests/random_compiled.rs derives; `HOLONOMY_BLESS=1` writes the file anew.
#[test]
fn the_committed_models_are_the_generated_ones() {
    let text = crate_text(&(0..50).map(|number| generate(23, number)).collect::<Vec<_>>());
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/random_models.rs");
    if std::env::var_os("HOLONOMY_BLESS").is_some() {
        std::fs::write(path, &text).expect("the file is written");
    }
    let committed = std::fs::read_to_string(path).expect("the file is there");
    assert!(text == committed, "{path} is out of date: run this test with HOLONOMY_BLESS=1");
}
