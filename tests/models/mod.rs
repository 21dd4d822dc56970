//! The models that have an answer of their own: golden data, a closed form, or a published set.
#![allow(dead_code, unused_imports, reason = "every test file uses its own models")]

mod blades;
mod kinds;
mod particles;
mod rolling_disc;
mod rolling_disk;

pub use blades::*;
pub use kinds::*;
pub use particles::*;
pub use rolling_disc::*;
pub use rolling_disk::*;

/// The source text of every file with models, for the oracle.
pub const SOURCES: [&str; 4] = [
    include_str!("blades.rs"),
    include_str!("particles.rs"),
    include_str!("rolling_disc.rs"),
    include_str!("rolling_disk.rs"),
];
