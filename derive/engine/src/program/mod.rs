//! From the equations to straight-line programs: what is computed, in which order, under which names.
//!
//! | file | idea |
//! |---|---|
//! | [`entry`] | the functions of a model, what they read and what they return |
//! | [`mod@unit`] | n-ary sums and products over shared units |
//! | [`lower`] | the graph as units: parameter-only work split off, like terms collected |
//! | [`angles`] | sines and cosines, those of sums of angles by products |
//! | [`collect`] | sums with their coefficients grouped and common factors taken out |
//! | [`mod@cycles`] | how long a program takes, in estimate |
//! | [`share`] | the most frequent pairs of factors and of terms, each computed once |
//! | [`operation`] | the straight-line program and its operation counts |
//! | [`schedule`] | units as binary operations, ordered by stage |
//! | [`names`] | identifiers that mean something and never collide |
//! | [`layout`] | which results get a `let`; blocks and functions of bounded size |
//! | [`plan`] | all programs of a model |
//! | [`evaluate`] | programs run in double precision, for checks |

pub mod angles;
pub mod collect;
pub mod cycles;
pub mod entry;
pub mod evaluate;
pub mod layout;
pub mod lower;
pub mod names;
pub mod operation;
mod pairs;
pub mod plan;
pub mod schedule;
pub mod share;
#[cfg(test)]
pub(crate) mod tests;
pub mod unit;

pub use cycles::eliminated;
pub use entry::{Arguments, Entry, Output, Shape};
pub use layout::{Block, Layout, Let, Part};
pub use names::Names;
pub use operation::{Code, Count, Leaf, Operation, Reference};
pub use plan::{Program, Programs, Values, count, cycles, programs, weight};
