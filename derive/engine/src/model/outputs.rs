//! Outputs: what a model tells of a state besides its motion.

use proc_macro2::Span;

use super::context::Context;
use super::names::{Mentions, reserved};
use super::rows::second_rates;
use super::system::{Output, Outputs, Reaction};
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::{Diagnostics, Term, messages};

/// Lowers every output, rates still as written.
pub(super) fn lower(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    let declarations = vocabulary.declarations;
    for output in &declarations.outputs {
        let name = output.name.ident.to_string();
        if vocabulary.outputs.iter().any(|(other, _)| *other == name) {
            diagnostics.report(&output.name.ident, messages::output_twice(&name));
        }
        reserved(&output.name.ident, diagnostics);
        // `output(mu)` gives out something else of that name.
        let lowered = match output.value.terms() {
            [(Term::Name(other), span)] if *other == name && vocabulary.names.get(&name).is_none() => {
                diagnostics.report(*span, vocabulary.names.missing(&name));
                None
            }
            _ => vocabulary.lower(&output.value, Context::OUTPUT, diagnostics),
        };
        vocabulary.outputs.push((name, lowered));
    }
}

/// The outputs over x, v, v̇, the symbols of a configuration, inputs and t; `rates` replaces `dot(x)` by A v + a0, and
/// `ddot(x)` follows by differentiation.
pub(super) fn finish(rates: &[(Symbol, Expr)], vocabulary: &mut Vocabulary<'_>) -> Outputs {
    let accelerations = |(_, lowered): &(String, Option<super::value::Lowered>)| {
        lowered.is_some_and(|lowered| lowered.mentions.intersects(Mentions::ACCELERATIONS))
    };
    let second = match vocabulary.outputs.iter().any(accelerations) {
        true => second_rates(rates, vocabulary),
        false => Vec::new(),
    };
    let all: Vec<(Symbol, Expr)> = rates.iter().chain(&second).copied().collect();
    let declared = vocabulary.declarations.outputs.iter().zip(&vocabulary.outputs);
    // What could not be lowered is reported.
    let sound = declared.filter_map(|(output, (name, lowered))| Some((name.clone(), &output.name, (*lowered)?.expr)));
    let (named, written): (Vec<(String, Span)>, Vec<Expr>) =
        sound.map(|(name, declared, expr)| ((name, declared.ident.span()), expr)).unzip();
    let exprs = vocabulary.graph.substitute(&written, &all);
    let exprs: Vec<Expr> = exprs.into_iter().map(|e| vocabulary.held(e)).collect();
    if !vocabulary.outputs.is_empty() {
        // Their rates as a whole: those of the carriers are among them.
        for i in 0..vocabulary.further.len() {
            vocabulary.further_rate("dot", i);
            vocabulary.further_rate("ddot", i);
        }
        for i in 0..vocabulary.quasi.len() {
            vocabulary.quasi_rate(i);
        }
    }
    let all_of = |symbols: &[Option<Symbol>]| -> Vec<Symbol> { symbols.iter().flatten().copied().collect() };
    let reaction =
        |(name, symbol, span): &(String, Symbol, Span)| Reaction { name: name.clone(), symbol: *symbol, span: *span };
    Outputs {
        entries: named.into_iter().zip(exprs).map(|((name, span), expr)| Output { name, span, expr }).collect(),
        accelerations: vocabulary.accelerations.clone(),
        further_rates: all_of(&vocabulary.further_rates),
        further_accelerations: all_of(&vocabulary.further_accelerations),
        quasi_rates: all_of(&vocabulary.quasi_rates),
        reactions: vocabulary.reactions.iter().map(reaction).collect(),
    }
}
