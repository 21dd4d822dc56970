//! What the examples share: promises that are checked, and pictures.
//!
//! A folder without a `main.rs`, so that cargo takes it for no example of its own; each example names what it uses.

pub mod checks;
pub mod picture;
