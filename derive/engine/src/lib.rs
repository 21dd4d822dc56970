//! The engine behind `holonomy-derive`: from the declarations of a mechanism to straight-line Rust.
//!
//! Data flows one way; each folder is a step and knows only the ones before it:
//! [`syntax`] → [`model`] (and [`dimensions`] beside it) → [`projection`] → [`simplify`] → [`program`] → [`emit`], with [`symbolic`] under all and
//! [`pipeline`] to run them. The interface of this crate may change with every release; depend on `holonomy` instead.

mod carried;
mod choices;
pub mod dimensions;
mod elimination;
pub mod emit;
mod forms;
pub mod model;
mod orders;
pub mod pipeline;
mod plain;
pub mod program;
pub mod projection;
pub mod simplify;
pub mod symbolic;
pub mod syntax;
mod target;

pub use pipeline::{Analysis, Observer, Step, analyse, analyse_by, expand, expand_observed, expand_plainly};
