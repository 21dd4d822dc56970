//! What takes a name and not its value: rates, reactions; and names of outputs.

use proc_macro2::Span;

use super::context::Context;
use super::functions::wrong_number_of_arguments;
use super::lower::named_function;
use super::names::{Meaning, Mentions};
use super::value::Lowered;
use super::vocabulary::Vocabulary;
use crate::symbolic::{Kind, Symbol};
use crate::syntax::{AXES, Diagnostics, Term, messages};

impl Vocabulary<'_> {
    /// An output that another one mentions.
    pub(super) fn output(&self, name: &str, span: Span, diagnostics: &mut Diagnostics) -> Option<Lowered> {
        let known = self.outputs.iter().find(|(other, _)| other == name);
        if known.is_none() {
            diagnostics.report(span, messages::output_later(name));
        }
        known?.1
    }

    /// `reaction(rod)`, the multiplier of a constraint
    pub(super) fn reaction(
        &mut self,
        span: Span,
        arguments: &[usize],
        terms: &[(Term, Span)],
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<Lowered> {
        let [argument] = arguments else {
            diagnostics.report(span, wrong_number_of_arguments("reaction", 1, arguments.len()));
            return None;
        };
        let (name, place) = match &terms[*argument] {
            (Term::Name(name), place) => (name, *place),
            (Term::Hole, _) => return None,
            _ => {
                diagnostics.report(span, messages::reaction_of_expression());
                return None;
            }
        };
        let constraints = &self.declarations.constraints;
        // The rows of a vector equation have the names of its components.
        let component = AXES.iter().find_map(|axis| name.strip_suffix(axis)?.strip_suffix('_'));
        let released = || self.declarations.geometry.releases().map(|release| &release.name);
        let declared = |name: &str| constraints.iter().map(|c| &c.name).chain(released()).any(|known| known == name);
        let about_axes = constraints
            .iter()
            .filter(|constraint| constraint.right.is_none())
            .any(|joint| name.strip_prefix(&joint.name.to_string()).is_some_and(|rest| rest.starts_with("_axes")));
        if !declared(name) && !component.is_some_and(declared) && !about_axes {
            let names = constraints.iter().map(|constraint| &constraint.name).chain(released());
            let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
            let list = match names.as_slice() {
                [] => "the model has none".to_owned(),
                names => format!("the constraints are {}", names.join(", ")),
            };
            diagnostics.report(place, messages::reaction_of_no_constraint(name, list));
            return None;
        }
        let mentions = Mentions::REACTIONS;
        if mentions.beyond(context.allowed) != Mentions::NONE {
            let text = format!("reaction({name})");
            diagnostics.report(span, messages::out_of_place(text, mentions.describe(), context.rule));
            return None;
        }
        let symbol = match self.reactions.iter().find(|(other, ..)| other == name) {
            Some((_, symbol, _)) => *symbol,
            None => {
                let symbol = self.graph.symbol(&format!("reaction({name})"), Kind::Speed);
                self.reactions.push((name.clone(), symbol, place));
                symbol
            }
        };
        Some(Lowered { expr: self.graph.var(symbol), mentions })
    }

    /// `dot(x)`, `dot(v)` or `ddot(x)`
    pub(super) fn dot(
        &mut self,
        function: &str,
        span: Span,
        arguments: &[usize],
        terms: &[(Term, Span)],
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<Lowered> {
        let message = match arguments {
            [argument] => match &terms[*argument] {
                (Term::Name(name), place) => match self.names.get(name) {
                    None => {
                        diagnostics.report(*place, self.names.unknown(name));
                        return None;
                    }
                    Some(Meaning::Speed(i)) if function == "dot" => {
                        let found = (self.accelerations[i], Mentions::ACCELERATIONS);
                        return self.rate(function, name, found, span, context, diagnostics);
                    }
                    Some(Meaning::Speed(_)) => messages::second_rate_of_speed(name),
                    Some(Meaning::Coordinate(i)) => {
                        let found = match function {
                            "dot" => (self.rates[i], Mentions::RATES),
                            _ => (self.second_rates[i], Mentions::ACCELERATIONS),
                        };
                        return self.rate(function, name, found, span, context, diagnostics);
                    }
                    Some(Meaning::Further(i)) if context.allowed.intersects(Mentions::of_further(function)) => {
                        let found = (self.further_rate(function, i), Mentions::of_further(function));
                        return self.rate(function, name, found, span, context, diagnostics);
                    }
                    Some(Meaning::Quasi(i))
                        if function == "dot" && context.allowed.intersects(Mentions::FURTHER_ACCELERATIONS) =>
                    {
                        let found = (self.quasi_rate(i), Mentions::FURTHER_ACCELERATIONS);
                        return self.rate(function, name, found, span, context, diagnostics);
                    }
                    Some(meaning @ (Meaning::Free(_) | Meaning::Combination(_)))
                        if context.allowed.intersects(Mentions::FREE) =>
                    {
                        messages::rate_without_name(name, meaning.describe())
                    }
                    Some(Meaning::Further(_)) => {
                        let what = Mentions::FURTHER.describe();
                        messages::out_of_place(name, what, context.rule)
                    }
                    Some(meaning) => messages::dot_of_no_coordinate(name, meaning.describe()),
                },
                (Term::Hole, _) => return None,
                (Term::Call(inner, _), _) if named_function(inner) => messages::rate_of_rate(),
                _ => messages::dot_of_expression(),
            },
            _ => wrong_number_of_arguments(function, 1, arguments.len()),
        };
        diagnostics.report(span, message);
        None
    }

    /// The rate, if it may occur here.
    fn rate(
        &mut self,
        function: &str,
        name: &str,
        (symbol, mentions): (Symbol, Mentions),
        span: Span,
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<Lowered> {
        if mentions.beyond(context.allowed) != Mentions::NONE {
            let text = format!("{function}({name})");
            diagnostics.report(span, messages::out_of_place(text, mentions.describe(), context.rule));
            return None;
        }
        Some(Lowered { expr: self.graph.var(symbol), mentions })
    }

    /// The symbol of a rate of one of the configuration's further coordinates.
    pub(super) fn further_rate(&mut self, function: &str, i: usize) -> Symbol {
        let coordinate = self.graph.name(self.further[i]);
        let (slot, name) = match function {
            "dot" => (&mut self.further_rates[i], format!("dot_{coordinate}")),
            _ => (&mut self.further_accelerations[i], format!("ddot({coordinate})")),
        };
        *slot.get_or_insert_with(|| self.graph.symbol(&name, Kind::Speed))
    }

    /// The symbol of the rate of one of the configuration's quasi-velocities.
    pub(super) fn quasi_rate(&mut self, i: usize) -> Symbol {
        let name = format!("dot({})", self.graph.name(self.quasi[i]));
        *self.quasi_rates[i].get_or_insert_with(|| self.graph.symbol(&name, Kind::Speed))
    }
}
