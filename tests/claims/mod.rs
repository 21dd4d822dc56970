//! What derived models claim at a state, in the form in which the oracle checks it.
#![allow(dead_code, unused_imports, reason = "every test file uses its own part")]

pub mod agreement;
pub mod compiled;
pub mod evaluated;
pub mod stages;
pub mod states;
