//! Random models as source text: the same models on every machine, in known classes.
//!
//! Everything is well conditioned by construction: bounded smooth functions, kinematics and constraints with a dominant pivot,
//! M = L Lᵀ with a diagonal near one. What is random is the structure.
#![allow(dead_code, unused_imports, reason = "every test file uses its own part")]

mod constraints;
mod crate_text;
mod expression;
mod generate;
mod higher;
mod rows;
mod statements;

pub use crate_text::crate_text;
pub use generate::{KINDS, RandomModel, generate};

use std::collections::BTreeMap;

/// How many models go through the engine.
pub const MODELS: usize = 3000;

/// Whether the derive takes all statements of a model; the oracle is ahead of it.
pub fn taken(model: &RandomModel) -> bool {
    let kinds = ["redundant"];
    !model.source.contains("kinetic_energy") && !kinds.iter().any(|kind| model.classes[0].contains(kind))
}

/// The first models of a series that the derive takes.
pub fn first(count: usize, seed: u64) -> Vec<RandomModel> {
    (0..).map(|number| generate(seed, number)).filter(taken).take(count).collect()
}

/// How often each class occurs, as a table.
pub fn counted<'a>(classes: impl Iterator<Item = &'a str>) -> String {
    let mut counts = BTreeMap::new();
    for class in classes {
        *counts.entry(class).or_insert(0) += 1;
    }
    counts.iter().map(|(class, count)| format!("{count:5} {class}\n")).collect()
}
