//! Whether a mechanism is eliminated joint by joint: O(n) operations in a long chain of divisions, or O(n³) side by side.
//!
//! Loops are closed on top of the tree, one sweep a row, so that few rows on many speeds are what it is for. Both are judged by
//! [`cycles`](crate::program::Code::cycles), not by counts. Joint by joint the equations are soon found. M_d as a whole is not even
//! derived where its factorisation alone, along the zero pattern of the tree, takes longer, and no cheaper forms of it are searched
//! where it takes longer as it comes, by more than forms are likely to save.

mod whole;

use crate::forms::Forms;
use crate::model::InitialSystem;
use crate::program::cycles;
use crate::projection::{AsIs, Equations, inverse_dynamics, messages, project};
use crate::simplify::Search;
use crate::symbolic::Expr;
use crate::syntax::{Diagnostics, Elimination};
use proc_macro2::Span;
use whole::factorisation;

/// Mechanisms of fewer independent speeds have M_d as a whole without a question.
const FEWEST: usize = 6;
/// What part of a motion as it comes may be saved by cheaper forms.
const SAVED: usize = 10;

/// The motion joint by joint, and what it takes.
pub struct Recursive {
    equations: Equations,
    cycles: usize,
    /// What M_d as a whole takes, as far as it is known.
    whole: usize,
    /// Whether the model asks for it.
    asked: bool,
}

/// The equations joint by joint, where the mechanism has them and they are wanted or may be better. An error where they are wanted and
/// the mechanism has none. What rows need (pivots of the chart, shares of those that repeat others) is brought to cheaper forms on the
/// way; what passes from joint to joint is not.
pub fn joint_by_joint(
    system: &InitialSystem,
    wanted: Option<(Elimination, Span)>,
    search: Search,
) -> Result<Option<Recursive>, Diagnostics> {
    let asked = match wanted {
        Some((Elimination::Recursive, span)) => Some(span),
        Some((Elimination::Matrix, _)) => return Ok(None),
        None if system.mechanism.is_none() || !system.is_tree() || left(system) < FEWEST => return Ok(None),
        None => None,
    };
    let mut tried = system.clone();
    tried.elimination = Elimination::Recursive;
    let projected = match search {
        Search::Off => project(tried, &mut AsIs),
        _ if system.rows.is_empty() => project(tried, &mut AsIs),
        _ => project(tried, &mut Forms::new(search)),
    };
    let equations = match projected {
        Ok(equations) => equations,
        // What is wrong with the model is told by M_d as a whole.
        Err(_) if asked.is_none() => return Ok(None),
        Err(errors) => return Err(errors),
    };
    if !equations.is_recursive() {
        return match asked {
            Some(span) => {
                let mut errors = Diagnostics::new();
                errors.report(span, messages::not_joint_by_joint());
                Err(errors)
            }
            None => Ok(None),
        };
    }
    let (cycles, whole) = (of_motion(&equations), factorisation(&equations));
    Ok(Some(Recursive { equations, cycles, whole, asked: asked.is_some() }))
}

/// How many speeds the rows leave at least.
fn left(system: &InitialSystem) -> usize {
    system.speeds.len().saturating_sub(system.rows.len())
}

impl Recursive {
    /// How many expressions there are.
    pub fn size(&self) -> usize {
        self.equations.graph.len()
    }

    /// Whether it is asked for, or M_d as a whole takes longer without a doubt.
    pub fn is_surely_faster(&mut self, system: &InitialSystem) -> bool {
        if self.asked || self.cycles <= self.whole {
            return true;
        }
        if let Ok(equations) = project(system.clone(), &mut AsIs) {
            self.whole = of_motion(&equations);
        }
        self.cycles <= self.whole - self.whole / SAVED
    }

    /// Whether the motion by M_d as a whole takes longer in the forms that were found.
    pub fn is_faster_than(&mut self, equations: &Equations) -> bool {
        self.whole = of_motion(equations);
        self.cycles < self.whole
    }

    /// The equations, told why.
    pub fn taken(self) -> Equations {
        let mut equations = self.equations;
        equations.notes.push(messages::joint_by_joint(self.cycles, self.whole));
        inverse_dynamics(&mut equations);
        equations
    }
}

/// What the rates of a state take.
fn of_motion(equations: &Equations) -> usize {
    let roots: Vec<Expr> = equations.coordinate_rates.iter().chain(&equations.accelerations).copied().collect();
    cycles(&mut equations.graph.clone(), &roots)
}
