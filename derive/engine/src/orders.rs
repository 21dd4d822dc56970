//! Derivatives of the user's functions: whether all that the equations need are given.

use crate::program::Arguments;
use crate::program::entry::entries;
use crate::projection::Equations;
use crate::syntax::{Declarations, Diagnostics, messages};

/// Reports every function of which a derivative is missing, with the function of the model that needs it; notes those
/// whose last derivative is used, so that dual numbers find none beyond it.
pub fn check(declarations: &Declarations, equations: &mut Equations, errors: &mut Diagnostics) {
    let graph = &equations.graph;
    // What the model states comes before what follows from it.
    let mut all = entries(equations);
    all.sort_by_key(|entry| matches!(entry.arguments, Arguments::State | Arguments::StateInputs));
    let mut notes = Vec::new();
    for (number, function) in declarations.functions.iter().enumerate() {
        // The highest order that is used, and by what first.
        let mut highest: Option<(usize, &str)> = None;
        for entry in &all {
            let used = graph.given_in(&entry.roots()).into_iter().map(|at| &graph.given()[at]);
            let order = used.filter(|given| given.function == number).map(|given| given.order).max();
            if let Some(order) = order
                && highest.is_none_or(|(known, _)| order > known)
            {
                highest = Some((order, entry.name.as_str()));
            }
        }
        let Some((order, equation)) = highest else { continue };
        let last = function.orders.len() - 1;
        if order > last {
            errors.report(&function.name, messages::function_lacks_derivative(&function.name, order, equation));
        } else if order == last {
            notes.push(format!(
                "the last derivative given of `{}` (order {last}) is used by `{equation}`: dual numbers have no derivative \
                 there, it is not a number; name one more for `linearize`",
                function.name
            ));
        }
    }
    equations.notes.extend(notes);
}
