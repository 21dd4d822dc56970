//! The oracle: an evaluator of declared models that shares nothing with the engine.
//!
//! It reads the attributes of a model from its source text, evaluates the expressions as they stand over its own numbers,
//! differentiates by nested dual numbers, and solves the full system (2.8) of Blajer (1992) by dense algebra:
//!
//! ```text
//!     [ M  −Cᵀ ] [ v̇ ]   [  h*  ]
//!     [ C   0  ] [ λ ] = [ −c0* ]
//! ```
//!
//! What a derivation claims (a [`Claim`]) is then held against that solution, see [`check`].

mod bodies;
mod charts;
mod check;
mod claim;
mod classes;
mod condition;
mod consistency;
mod declaration;
mod evaluate;
mod families;
mod geometry;
mod given;
mod inertia;
mod joints;
mod kkt;
mod lagrange;
mod linear;
mod loads;
mod motion;
mod number;
mod outputs;
mod principles;
mod quaternions;
mod reader;
mod releases;
mod report;
mod rows;
/// The generator of the tests.
#[path = "../support/splitmix.rs"]
pub mod splitmix;
mod statements;
mod switches;
mod system;
mod vectors;

pub use check::check;
pub use claim::{ChartClaim, Claim, Multiplier};
pub use classes::{CLASSES, classes};
pub use consistency::{closed, onto_nonlinear_rows, onto_velocity_rows};
pub use declaration::{Chosen, Configuration, Constraint, Declaration, Level};
pub use given::derivative;
pub use kkt::{Motion, conditioned_rank};
pub use number::{Dual, Number, Scaled};
pub use reader::read_models;
pub use report::Report;
pub use rows::Rows;
pub use system::{Dynamics, System};
