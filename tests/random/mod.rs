//! Random models as source text: the same models on every machine, in known classes.
//!
//! Everything is well conditioned by construction: bounded smooth functions, kinematics and constraints with a dominant pivot,
//! M = L Lᵀ with a diagonal near one. What is random is the structure.
#![allow(dead_code, unused_imports, reason = "every test file uses its own part")]

mod constraints;
mod crate_text;
mod expression;
mod generate;
mod rows;
mod statements;

pub use crate_text::crate_text;
pub use generate::{KINDS, RandomModel, generate};

use std::collections::BTreeMap;

/// How many models there are of each class, as text.
pub fn counted(models: &[RandomModel]) -> String {
    let mut counts = BTreeMap::new();
    for class in models.iter().flat_map(|model| &model.classes) {
        *counts.entry(class.as_str()).or_insert(0) += 1;
    }
    counts.iter().map(|(class, count)| format!("{count:5} {class}\n")).collect()
}
