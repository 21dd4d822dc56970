//! Outputs: what a model tells of a state besides its motion.

use proc_macro2::Span;

use super::context::Context;
use super::lower::Vocabulary;
use super::names::{Mentions, reserved};
use super::rows::second_rates;
use super::system::{Output, Outputs, Reaction};
use crate::symbolic::{Expr, Kind, Symbol};
use crate::syntax::{Diagnostics, messages};

/// Lowers every output, rates still as written.
pub(super) fn lower(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    let declarations = vocabulary.declarations;
    if declarations.outputs.is_empty() {
        return;
    }
    if vocabulary.further_rates.len() != vocabulary.further.len() {
        // The configuration makes no sense, which is reported: not its rates, then.
        vocabulary.further_rates = rates(vocabulary, vocabulary.further.clone(), "dot");
    }
    vocabulary.further_accelerations = rates(vocabulary, vocabulary.further.clone(), "ddot");
    vocabulary.quasi_rates = rates(vocabulary, vocabulary.quasi.clone(), "dot");
    for output in &declarations.outputs {
        let name = output.name.ident.to_string();
        if vocabulary.outputs.iter().any(|(other, _)| *other == name) {
            diagnostics.report(&output.name.ident, messages::output_twice(&name));
        }
        reserved(&output.name.ident, diagnostics);
        let lowered = vocabulary.lower(&output.value, Context::OUTPUT, diagnostics);
        vocabulary.outputs.push((name, lowered));
    }
}

/// Symbols that no other statement needs.
fn rates(vocabulary: &mut Vocabulary<'_>, of: Vec<Symbol>, function: &str) -> Vec<Symbol> {
    let graph = &mut vocabulary.graph;
    let rate = |symbol| {
        let name = format!("{function}({})", graph.name(symbol));
        graph.symbol(&name, Kind::Speed)
    };
    of.into_iter().map(rate).collect()
}

/// The outputs over x, v, v̇, the symbols of a configuration, inputs and t; `rates` replaces `dot(x)` by A v + a0, and
/// `ddot(x)` follows by differentiation.
pub(super) fn finish(rates: &[(Symbol, Expr)], vocabulary: &mut Vocabulary<'_>) -> Outputs {
    let accelerations = |(_, lowered): &(String, Option<super::lower::Lowered>)| {
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
    let reaction = |(at, symbol, span): &(usize, Symbol, Span)| Reaction {
        name: vocabulary.declarations.constraints[*at].name.to_string(),
        symbol: *symbol,
        span: *span,
    };
    Outputs {
        entries: named.into_iter().zip(exprs).map(|((name, span), expr)| Output { name, span, expr }).collect(),
        accelerations: vocabulary.accelerations.clone(),
        further_rates: vocabulary.further_rates.clone(),
        further_accelerations: vocabulary.further_accelerations.clone(),
        quasi_rates: vocabulary.quasi_rates.clone(),
        reactions: vocabulary.reactions.iter().map(reaction).collect(),
    }
}
