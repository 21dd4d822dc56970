//! Derivatives of the user's functions: whether all that the equations need are given.

use crate::program::Arguments;
use crate::program::entry::{entries, of_outputs};
use crate::projection::Equations;
use crate::symbolic::Expr;
use crate::syntax::{Declarations, Diagnostics, messages};

/// Reports every function of which a derivative is missing, with the function of the model that needs it; notes those
/// whose last derivative is used, so that dual numbers find none beyond it.
pub fn check(declarations: &Declarations, equations: &mut Equations, errors: &mut Diagnostics) {
    let graph = &equations.graph;
    // What the model states comes before what follows from it.
    let mut entries = entries(equations);
    entries.sort_by_key(|entry| matches!(entry.arguments, Arguments::State | Arguments::StateInputs));
    let of_model = entries.iter().filter(|entry| !of_outputs(&entry.name));
    let mut all: Vec<(String, Vec<Expr>)> = of_model.map(|entry| (entry.name.clone(), entry.roots())).collect();
    let outputs = &equations.outputs;
    for (name, roots) in outputs.names.iter().zip(outputs.values.iter().zip(&outputs.carried)) {
        all.push((format!("output {name}"), vec![*roots.0, *roots.1]));
    }
    let mut notes = Vec::new();
    for (number, function) in declarations.functions.iter().enumerate() {
        // The highest order that is used, and by what first.
        let mut highest: Option<(usize, &str)> = None;
        for (equation, roots) in &all {
            let used = graph.given_in(roots).into_iter().map(|at| &graph.given()[at]);
            let order = used.filter(|given| given.function == number).map(|given| given.order).max();
            if let Some(order) = order
                && highest.is_none_or(|(known, _)| order > known)
            {
                highest = Some((order, equation.as_str()));
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
