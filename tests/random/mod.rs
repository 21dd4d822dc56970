//! Random models as source text: the same models on every machine, in known classes.
//!
//! Everything is well conditioned by construction: bounded smooth functions, kinematics and constraints with a dominant pivot,
//! M = L Lᵀ with a diagonal near one. What is random is the structure.
#![allow(dead_code, unused_imports, reason = "every test file uses its own part")]

mod charts;
mod closed;
mod closed_pose;
mod closed_redundant;
mod constraints;
mod crate_text;
mod expression;
mod families;
mod generate;
mod higher;
mod mechanism_loads;
mod mechanism_parts;
mod mechanism_quaternions;
mod mechanisms;
mod rows;
mod statements;

pub use closed::closed_mechanism;
pub use crate_text::crate_text;
pub use generate::{KINDS, RandomModel, generate};
pub use mechanism_quaternions::quaternion_mechanism;
pub use mechanisms::{MECHANISMS, mechanism};

use std::collections::BTreeMap;

/// How many models go through the engine.
pub const MODELS: usize = 3000;

/// The first models of a series.
pub fn first(count: usize, seed: u64) -> Vec<RandomModel> {
    (0..count).map(|number| generate(seed, number)).collect()
}

/// The same mechanism without its configuration, where every reaction of it is declared: the rows alone then say all.
pub fn in_one_stage(model: &RandomModel) -> Option<RandomModel> {
    if !model.source.contains("#[configuration(") || !model.source.contains("held_") {
        return None;
    }
    let of_the_stage = |line: &&str| line.starts_with("#[configuration(") || line.starts_with("#[independent(");
    let rest: Vec<&str> = model.source.lines().filter(|line| !of_the_stage(line)).collect();
    let name = format!("{}Whole", model.name);
    let source = rest.join("\n").replace(&format!("struct {} ", model.name), &format!("struct {name} "));
    Some(RandomModel { name, source: source + "\n", ..model.clone() })
}

/// How often each class occurs, as a table.
pub fn counted<'a>(classes: impl Iterator<Item = &'a str>) -> String {
    let mut counts = BTreeMap::new();
    for class in classes {
        *counts.entry(class).or_insert(0) += 1;
    }
    counts.iter().map(|(class, count)| format!("{count:5} {class}\n")).collect()
}
