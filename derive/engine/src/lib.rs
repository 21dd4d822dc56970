//! The engine.

pub mod syntax;
