//! The programs of a model over numbers of 77 digits, and what doubles lose against them.

mod form;
mod loss;
mod number;
mod states;
mod subject;

pub use number::{Big, Number};
pub use states::{Choice, Draw};
pub use subject::Subject;
