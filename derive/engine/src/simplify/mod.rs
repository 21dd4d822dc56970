//! Cheaper expressions that are identical to what went in. Only this folder knows egg.
//!
//! | file | idea |
//! |---|---|
//! | [`mod@cost`] | what expressions cost once they run |
//! | [`limits`] | the bounds, all in one place |
//! | [`polynomial`] | sparse polynomials over atoms, exact division |
//! | [`expand`] | from expressions to polynomials, sin² + cos² = 1 |
//! | [`angles`] | sines and cosines of sums of angles |
//! | [`fraction`] | one denominator, and what divides out of it |
//! | [`factor`] | from polynomials to nested expressions |
//! | [`mod@normalise`] | a cheap canonical form of one expression |
//! | [`language`] | the e-graph's nodes |
//! | [`rules`] | what the e-graph knows |
//! | [`extract`] | the choice that makes all roots together cheap |
//! | [`group`] | all of it, over groups of roots |

pub mod angles;
pub mod cost;
pub mod expand;
pub mod extract;
pub mod factor;
pub mod fraction;
pub mod group;
pub mod language;
pub mod limits;
pub mod normalise;
pub mod polynomial;
pub mod rules;
#[cfg(test)]
mod tests;

pub use cost::{Cost, cost};
pub use group::{Search, candidates, simplify};
pub use normalise::{normalise, normalise_within};
