//! `start` and `nominal`: numbers by which choices are judged. They never enter emitted arithmetic.

use super::context::Context;
use super::names::Meaning;
use super::vocabulary::Vocabulary;
use crate::symbolic::Symbol;
use crate::syntax::{Diagnostics, Expression, messages};

/// Values of coordinates and speeds.
pub(super) fn start(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Vec<(Symbol, f64)> {
    let mut values: Vec<(Symbol, f64)> = Vec::new();
    for assignment in &vocabulary.declarations.start {
        let name = assignment.name.to_string();
        let symbol = match vocabulary.names.get(&name) {
            Some(Meaning::Coordinate(i)) => Ok(vocabulary.coordinates[i]),
            Some(Meaning::Further(i)) => Ok(vocabulary.further[i]),
            Some(Meaning::Speed(i)) => Ok(vocabulary.speeds[i]),
            Some(Meaning::Quasi(i)) => Ok(vocabulary.quasi[i]),
            Some(Meaning::Free(i)) => Ok(vocabulary.free[i]),
            Some(Meaning::Combination(i)) => Ok(vocabulary.combinations[i]),
            Some(meaning) => Err(messages::start_of(name, meaning.describe())),
            None => Err(vocabulary.names.unknown(&name)),
        };
        let value = number(&assignment.value, vocabulary, diagnostics);
        match symbol {
            Ok(symbol) if values.iter().any(|(other, _)| *other == symbol) => {
                diagnostics.report(&assignment.name, messages::start_twice(&assignment.name));
            }
            Ok(symbol) => values.extend(value.map(|value| (symbol, value))),
            Err(message) => diagnostics.report(&assignment.name, message),
        }
    }
    values
}

/// Values of those parameters that the model mentions.
pub(super) fn nominal(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Vec<(Symbol, f64)> {
    let mut values = Vec::new();
    for (i, field) in vocabulary.declarations.fields.iter().enumerate() {
        let Some(nominal) = &field.nominal else { continue };
        if !field.scalar {
            diagnostics.report(nominal.place(), messages::nominal_of_no_scalar(&field.ident));
            continue;
        }
        let value = number(nominal, vocabulary, diagnostics);
        if vocabulary.used[i] {
            values.extend(value.map(|value| (vocabulary.fields[i], value)));
        }
    }
    values
}

fn number(expression: &Expression, vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = vocabulary.lower(expression, Context::NUMBER, diagnostics)?.expr;
    let value = vocabulary.graph.evaluate(&[value], &|_| f64::NAN)[0];
    if value.is_finite() {
        Some(value)
    } else {
        diagnostics.report(expression.place(), messages::not_finite());
        None
    }
}
