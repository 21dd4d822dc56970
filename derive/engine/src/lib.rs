//! The engine behind `holonomy-derive`: from the declarations of a mechanism to straight-line Rust.
//!
//! Data flows one way; each folder is a step and knows only the ones before it:
//! [`syntax`] → [`model`] → [`projection`] → [`simplify`] → program → emit, with [`symbolic`] under all.
//! The interface of this crate may change with every release; depend on `holonomy` instead.

pub mod model;
pub mod projection;
pub mod simplify;
pub mod symbolic;
pub mod syntax;
