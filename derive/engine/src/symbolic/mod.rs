//! Expressions: a hash-consed arena with exact numbers, derivatives and a decision procedure.
//!
//! | file | idea |
//! |---|---|
//! | [`blocks`] | block-triangular form, cofactors |
//! | [`minors`] | the adjugate of a larger block |
//! | [`rational`] | exact numbers, small ones without allocation |
//! | [`node`] | what an expression is: symbols, n-ary sums and products, functions |
//! | [`given`] | functions of the user's |
//! | [`graph`] | the arena: interning, names, stages, reachability |
//! | [`construct`] | canonical sums, products and powers |
//! | [`functions`] | canonical sin, cos, √, atan2, exp, ln |
//! | [`differentiate`] | derivatives, partial and along the motion |
//! | [`slopes`] | those of what is linear, by one sweep back |
//! | [`substitute`] | replacing symbols by expressions |
//! | [`evaluate`] | values over any scalar |
//! | [`bounds`] | intervals that hold all values |
//! | [`modular`] | arithmetic modulo a prime of 61 bits |
//! | [`identity`] | identity decided by modular evaluation |
//! | [`tables`] | sets of expressions and tables over them |
//! | [`samples`] | values in double precision, for what holds roots |
//! | [`powers`] | expressions that are powers of others |
//! | [`matrix`] | matrices of expressions |
//! | [`display`] | text for messages and documentation |
//! | [`triple`] | vectors and rotations of mechanics |
//! | [`unicode`] | names as in print |

pub mod blocks;
pub mod bounds;
pub mod construct;
pub mod differentiate;
pub mod display;
pub mod evaluate;
pub mod functions;
pub mod given;
pub mod graph;
pub mod identity;
pub mod matrix;
pub mod minors;
pub mod modular;
pub mod node;
pub mod powers;
pub mod rational;
pub mod samples;
pub mod slopes;
pub mod substitute;
pub mod tables;
#[cfg(test)]
mod tests;
pub mod triple;
pub mod unicode;

pub use construct::Assumptions;
pub use display::{Notation, Parts};
pub use evaluate::Algebra;
pub use given::Given;
pub use graph::Graph;
pub use matrix::Matrix;
pub use node::{Expr, Function, Kind, Node, Stage, Symbol};
pub use rational::Rational;
pub use triple::{Rotation, Triple};
