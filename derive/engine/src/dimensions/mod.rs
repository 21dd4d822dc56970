//! Dimensions of what a model says: whether lengths are added to lengths, and what the units are that follow.
//!
//! Every symbol without a declared unit has an unknown dimension. The dimension of an expression is a product of powers of base
//! units, of ten, and of unknowns; sums, comparisons, equations and the laws of mechanics are linear equations between exponents.
//! Each is solved as it comes, and one that contradicts those before it is an error at its token and is not added, so that one
//! contradiction is told once. Inference goes as far as it goes: what stays unknown is no error.
//!
//! A model that declares no unit is never refused: nothing is checked, and a number that is added to a length is an error only
//! where units say that it is a length. Literals are pure numbers, and 0 fits anything. As soon as one unit is declared that is not
//! `1`, `t` is in seconds, points are lengths and masses of bodies masses, each up to a power of ten of its own.
//!
//! | file | idea |
//! |---|---|
//! | `dimension` | products of powers |
//! | `solver` | equations between them |
//! | `units` | the names of units |
//! | `words` | dimensions in words |
//! | `table` | the names of a model with their dimensions |
//! | `report` | contradictions become errors |
//! | `expressions` | the rules of expressions |
//! | `functions` | those of calls |
//! | `statements` | kinematics, inertia, forces, energies, maps |
//! | `constraints` | rows, and what their multipliers measure |
//! | `geometry` | frames, points, bodies and what acts on them |
//! | `found` | the units that are known in the end |

mod constraints;
mod dimension;
mod expressions;
mod found;
mod functions;
mod geometry;
mod report;
mod solver;
mod statements;
mod table;
#[cfg(test)]
mod tests;
mod units;
mod words;

pub use found::Units;

use crate::syntax::{Declarations, Diagnostics};
use dimension::Dimension;
use solver::Solver;
use std::collections::{BTreeMap, BTreeSet};
use table::Table;

/// The declared units alone: names that are none are reported.
pub fn declared(declarations: &Declarations, diagnostics: &mut Diagnostics) {
    table::declared(declarations, diagnostics);
}

/// Checks the dimensions of a well-formed model. What is wrong with the names of units is told by [`declared`].
pub fn check(declarations: &Declarations, diagnostics: &mut Diagnostics) -> Units {
    let units = table::declared(declarations, &mut Diagnostics::new());
    if units.is_empty() {
        return Units::default();
    }
    let mut checker = Checker::new(declarations, &units, diagnostics);
    checker.constants();
    checker.frames_and_points();
    checker.defines(false);
    checker.statements();
    checker.elements();
    checker.constraints();
    checker.defines(true);
    checker.outputs();
    found::units(&checker)
}

/// A model on its way.
struct Checker<'a> {
    declarations: &'a Declarations,
    diagnostics: &'a mut Diagnostics,
    solver: Solver,
    table: Table,
    /// What `reaction(name)` is, by the names of rows.
    reactions: BTreeMap<String, Dimension>,
    /// Arguments and results of the user's functions.
    functions: BTreeMap<String, [Dimension; 2]>,
    /// What all have in common.
    time: Dimension,
    length: Dimension,
    mass: Dimension,
    energy: Dimension,
    /// What was said, and where.
    said: BTreeSet<String>,
    /// The statement that is looked at, for those whose units follow from it.
    origin: String,
}
