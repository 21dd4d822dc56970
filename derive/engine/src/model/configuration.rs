//! x = g(q, t) (4.2).

use super::context::Context;
use super::lower::Vocabulary;
use super::names::Meaning;
use super::system::Configuration;
use crate::symbolic::{Expr, Kind, Symbol};
use crate::syntax::{Diagnostics, Term, did_you_mean, messages, nearest};

/// The map and its coordinates; `None` without the statement, and where something was reported.
pub(super) fn build(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Configuration> {
    let declarations = vocabulary.declarations;
    let written = declarations.configuration.as_ref()?;
    let mut given: Vec<Option<Expr>> = vec![None; vocabulary.coordinates.len()];
    let mut targets: Vec<Option<usize>> = Vec::new();
    let mut sound = true;
    for assignment in &written.map {
        let name = assignment.name.to_string();
        let target = match vocabulary.names.get(&name) {
            Some(Meaning::Coordinate(i)) if !targets.contains(&Some(i)) => Ok(i),
            Some(Meaning::Coordinate(_)) => Err(messages::configuration_twice(name)),
            Some(meaning) => Err(messages::configuration_left_side(name, meaning.describe())),
            None => {
                let candidates: Vec<String> = declarations.coordinates.iter().map(|x| x.ident.to_string()).collect();
                let hint = did_you_mean(nearest(&name, candidates.iter().map(String::as_str)));
                Err(messages::unknown_name(name, hint))
            }
        };
        if let Err(message) = &target {
            diagnostics.report(&assignment.name, message.as_str());
            sound = false;
        }
        targets.push(target.ok());
    }
    for (assignment, target) in written.map.iter().zip(&targets) {
        // A coordinate that is itself given has no place on the right.
        for (term, span) in assignment.value.terms() {
            if let Term::Name(name) = term
                && let Some(Meaning::Coordinate(i)) = vocabulary.names.get(name)
                && targets.contains(&Some(i))
            {
                diagnostics.report(*span, messages::configuration_of_given(name));
                sound = false;
            }
        }
        let value = vocabulary.lower(&assignment.value, Context::CONFIGURATION, diagnostics);
        if let (Some(target), Some(value)) = (target, value) {
            given[*target] = Some(value.expr);
        } else {
            sound = false;
        }
    }
    if !sound {
        return None;
    }
    let given_symbols: Vec<Symbol> = targets.iter().flatten().map(|target| vocabulary.coordinates[*target]).collect();
    let graph = &mut vocabulary.graph;
    for (assignment, value) in written.map.iter().zip(targets.iter().flatten().map(|target| given[*target])) {
        // The same through a define.
        let inside = value.map(|value| graph.symbols_of(&[value])).unwrap_or_default();
        if let Some(symbol) = inside.iter().find(|symbol| given_symbols.contains(symbol)) {
            let message = messages::configuration_of_given(graph.name(*symbol));
            diagnostics.report(assignment.value.place(), message);
            sound = false;
        }
    }
    let free = vocabulary.coordinates.iter().copied().filter(|x| !given_symbols.contains(x));
    let coordinates: Vec<Symbol> = free.chain(vocabulary.further.iter().copied()).collect();
    if coordinates.is_empty() {
        diagnostics.report(written.span, messages::configuration_without_coordinate());
    }
    for (name, symbol) in written.further.iter().zip(&vocabulary.further) {
        let known = matches!(vocabulary.names.get(&name.ident.to_string()), Some(Meaning::Further(_)));
        if known && !given.iter().flatten().any(|value| graph.contains(*value, &[*symbol])) {
            diagnostics.report(&name.ident, messages::configuration_without(&name.ident));
        }
    }
    let rate_names: Vec<String> = coordinates.iter().map(|q| format!("dot_{}", graph.name(*q))).collect();
    let rates = rate_names.iter().map(|name| graph.symbol(name, Kind::Speed)).collect();
    let values = given.iter().zip(&vocabulary.coordinates);
    let map = values.map(|(value, x)| value.unwrap_or(graph.var(*x))).collect();
    sound.then_some(Configuration { coordinates, rates, map, span: written.span })
}
