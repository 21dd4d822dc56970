//! Derived models in plain lists of numbers: running them, and what they claim at a state.
#![allow(
    dead_code,
    unused_imports,
    reason = "every test file uses its own part"
)]

mod running;

pub use running::{Running, by_rows, dense, entries};
