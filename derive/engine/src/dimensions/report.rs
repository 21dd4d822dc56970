//! Contradictions become errors.

use super::Checker;
use super::dimension::Dimension;
use super::words::{unit, words};
use crate::syntax::{Expression, Place, Term, messages};

/// What is compared: a dimension, and the part of an expression that has it, for those who ask where it comes from.
pub struct Side<'e> {
    pub dimension: Dimension,
    pub part: Option<(&'e Expression, usize)>,
}

impl Side<'_> {
    pub fn whole(dimension: Dimension, expression: &Expression) -> Side<'_> {
        Side { dimension, part: Some((expression, expression.terms().len().saturating_sub(1))) }
    }
}

/// So many symbols with units that were not declared are named in one error.
const NAMED: usize = 2;

impl Checker<'_> {
    /// Both sides are the same: `left relation right` where they cannot be, "a length (m) plus a mass (kg)".
    pub fn equal(&mut self, place: impl Into<Place>, left: &Side<'_>, relation: &str, right: &Side<'_>) -> bool {
        let fits = self.solver.equate(&left.dimension, &right.dimension, &self.origin);
        if !fits {
            let hint = self.hint(left, right);
            let message = match (self.in_words(&left.dimension), self.in_words(&right.dimension)) {
                (Some(left), Some(right)) => messages::dimensions_differ(left, relation, right, hint),
                _ => messages::dimensions_apart("the two sides", self.apart(&left.dimension, &right.dimension), hint),
            };
            self.say(place, message);
        }
        fits
    }

    /// Something has the dimension that it must have: "the mass of a body must be a mass (kg), and this is a length (m)".
    pub fn expect(&mut self, place: impl Into<Place>, what: &str, found: &Side<'_>, expected: &Dimension) -> bool {
        let fits = self.solver.equate(&found.dimension, expected, &self.origin);
        if !fits {
            let expected = Side { dimension: expected.clone(), part: None };
            let hint = self.hint(found, &expected);
            let message = match (self.in_words(&expected.dimension), self.in_words(&found.dimension)) {
                (Some(expected), Some(found)) => messages::dimension_expected(what, expected, found, hint),
                _ => {
                    let factor = self.apart(&found.dimension, &expected.dimension);
                    let what = format!("{what} and what it must be");
                    messages::dimensions_apart(what, factor, hint)
                }
            };
            self.say(place, message);
        }
        fits
    }

    /// Something is a pure number; `message` is told of its dimension in words and of the hint where it is not.
    pub fn pure(&mut self, place: impl Into<Place>, found: &Side<'_>, message: impl Fn(String, String) -> String) {
        if !self.solver.equate(&found.dimension, &Dimension::pure(), &self.origin) {
            let number = Side { dimension: Dimension::pure(), part: None };
            let hint = self.hint(found, &number);
            let found = self.in_words(&found.dimension);
            self.say(place, message(found.unwrap_or_else(|| "something".to_owned()), hint));
        }
    }

    /// Once for all of a family, whose entries differ by their numbers.
    fn say(&mut self, place: impl Into<Place>, message: String) {
        let place = place.into();
        let (mut common, mut number) = (String::new(), false);
        for character in message.chars() {
            number = character.is_ascii_digit() && (number || common.ends_with('_'));
            if !number {
                common.push(character);
            }
        }
        // Spans can be compared as text only.
        if self.said.insert(format!("{place:?} {common}")) {
            self.diagnostics.report(place, message);
        }
    }

    /// A dimension in words, if it is known.
    pub fn in_words(&self, dimension: &Dimension) -> Option<String> {
        let resolved = self.solver.resolved(dimension);
        self.solver.is_known(&resolved).then(|| words(&resolved.without_unknowns()))
    }

    /// The known factor between two.
    fn apart(&self, left: &Dimension, right: &Dimension) -> String {
        let factor = self.solver.resolved(&left.over(right)).without_unknowns();
        format!("a factor in {}", unit(&factor))
    }

    /// Why two cannot be equal: another power of ten, or units that were not declared.
    fn hint(&self, left: &Side<'_>, right: &Side<'_>) -> String {
        let difference = self.solver.resolved(&left.dimension.over(&right.dimension));
        let mut hint = String::new();
        if difference.is_scale() {
            hint.push_str(&messages::hint_scale());
        }
        let mut told: Vec<&str> = Vec::new();
        for (expression, at) in [left.part, right.part].into_iter().flatten() {
            for name in names(expression, at) {
                let Some(entry) = self.table.get(name) else { continue };
                let origin = self.solver.origin(&entry.dimension).filter(|origin| !origin.is_empty());
                let Some(origin) = origin.filter(|_| !entry.declared && entry.constant.is_none()) else { continue };
                if told.len() < NAMED && !told.contains(&name) && origin != self.origin {
                    hint.push_str(&messages::hint_origin(name, origin));
                    told.push(name);
                }
            }
        }
        hint
    }
}

/// The names in a part of an expression, in order.
fn names(expression: &Expression, at: usize) -> Vec<&str> {
    let terms = expression.terms();
    let mut found = Vec::new();
    let mut open = vec![at];
    while let Some((term, _)) = open.pop().and_then(|at| terms.get(at)) {
        if let Term::Name(name) = term {
            found.push(name.as_str());
        }
        open.extend(term.operands().into_iter().rev());
    }
    found
}
