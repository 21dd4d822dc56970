//! What several test files need beside the oracle.
#![allow(dead_code, unused_imports, unused_macros, reason = "every test file uses its own part")]

pub mod andrews;
pub mod declared;
pub mod extrapolation;
pub mod fields;
pub mod golden;
pub mod kept;
pub mod parallel;
pub mod running;
pub mod special;
pub mod splitmix;
