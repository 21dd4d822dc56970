//! Cheaper expressions that are identical to what went in. Only this folder knows egg.
//!
//! | file | idea |
//! |---|---|
//! | [`cost`] | what expressions cost once they run |
//! | [`limits`] | the bounds, all in one place |
//! | [`polynomial`] | sparse polynomials over atoms, exact division |
//! | [`expand`] | from expressions to polynomials, sin² + cos² = 1 |
//! | [`fraction`] | one denominator, and what divides out of it |
//! | [`factor`] | from polynomials to nested expressions |
//! | [`normalise`] | a cheap canonical form of one expression |

pub mod cost;
pub mod expand;
pub mod factor;
pub mod fraction;
pub mod limits;
pub mod normalise;
pub mod polynomial;
#[cfg(test)]
mod tests;

pub use cost::{Cost, cost};
pub use normalise::normalise;
