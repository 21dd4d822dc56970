//! v = g(u, x, t) (5.8): speeds as functions of others, so that rows that are not linear have minimal form.
//!
//! What is given are the carriers of the motion: v, or with a configuration its rates or quasi-velocities. Those that are
//! not given are independent speeds themselves, as the coordinates are that a configuration does not give.

use super::configuration::in_generalised;
use super::context::Context;
use super::names::Meaning;
use super::system::{Configuration, Velocities};
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::{Diagnostics, Quantity, messages};

/// The map and its speeds; `None` without the statement, and where something was reported.
pub(super) fn build(
    rates: &[(Symbol, Expr)],
    configuration: Option<&Configuration>,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Velocities> {
    let declarations = vocabulary.declarations;
    let written = declarations.velocities.as_ref()?;
    for (span, name) in [
        (declarations.independent.first().map(|list| list.span), "independent"),
        (declarations.complement.as_ref().map(|list| list.span), "complement"),
    ] {
        if let Some(span) = span {
            diagnostics.report(span, messages::velocities_and(name));
        }
    }
    let carriers = configuration.map_or(&vocabulary.speeds, |given| &given.speeds).clone();
    let context = if configuration.is_some() { Context::VELOCITIES_OF_RATES } else { Context::VELOCITIES };
    let adapt = match configuration {
        None => rates.to_vec(),
        Some(given) => {
            let graph = &mut vocabulary.graph;
            let speeds = graph.vars(&given.speeds);
            let moved = given.kinematics.a.mul_vec(graph, &speeds);
            let biased = moved.into_iter().zip(&given.kinematics.a0);
            let q_rates: Vec<Expr> = biased.map(|(rate, bias)| graph.add(rate, *bias)).collect();
            in_generalised(vocabulary, &given.coordinates, &q_rates, &given.map)
        }
    };
    let mut map: Vec<(Symbol, Expr)> = Vec::new();
    let mut targets: Vec<Symbol> = Vec::new();
    let mut sound = true;
    for (left, right) in &written.map {
        let target = carrier(left, configuration, vocabulary).filter(|symbol| carriers.contains(symbol));
        let name = left.to_string();
        match target {
            Some(symbol) if targets.contains(&symbol) => {
                diagnostics.report(left.place(), messages::velocities_twice(name));
                sound = false;
            }
            Some(symbol) => targets.push(symbol),
            None => {
                let all: Vec<String> =
                    carriers.iter().map(|symbol| format!("`{}`", spelt(*symbol, vocabulary))).collect();
                diagnostics.report(left.place(), messages::velocities_left_side(name, all.join(", ")));
                sound = false;
            }
        }
        match (target, vocabulary.lower_held(right, context, diagnostics)) {
            (Some(symbol), Some(value)) => {
                map.push((symbol, vocabulary.graph.substitute(&[value.expr], &adapt)[0]));
            }
            _ => sound = false,
        }
    }
    if !sound {
        return None;
    }
    for ((_, value), (_, right)) in map.iter().zip(&written.map) {
        let inside = vocabulary.graph.symbols_of(&[*value]);
        if let Some(symbol) = inside.iter().find(|symbol| targets.contains(symbol)) {
            diagnostics.report(right.place(), messages::velocities_of_given(spelt(*symbol, vocabulary)));
            sound = false;
        }
    }
    let kept = carriers.iter().copied().filter(|carrier| !targets.contains(carrier));
    let speeds: Vec<Symbol> = kept.chain(vocabulary.free.iter().copied()).collect();
    if speeds.is_empty() {
        diagnostics.report(written.span, messages::velocities_without_speed());
        sound = false;
    }
    for (name, symbol) in written.further.iter().zip(&vocabulary.free) {
        if !map.iter().any(|(_, value)| vocabulary.graph.contains(*value, &[*symbol])) {
            diagnostics.report(&name.ident, messages::velocities_without(&name.ident));
            sound = false;
        }
    }
    sound.then_some(Velocities { speeds, map, span: written.span })
}

/// The symbol that a left side names.
fn carrier(left: &Quantity, configuration: Option<&Configuration>, vocabulary: &Vocabulary<'_>) -> Option<Symbol> {
    let meaning = vocabulary.names.get(&left.ident().to_string())?;
    let rate = |q: Symbol| {
        let given = configuration?;
        given.coordinates.iter().position(|other| *other == q).map(|i| given.rates[i])
    };
    match (left, meaning) {
        (Quantity::Name(_), Meaning::Speed(i)) => Some(vocabulary.speeds[i]),
        (Quantity::Name(_), Meaning::Quasi(i)) => Some(vocabulary.quasi[i]),
        (Quantity::Rate(..), Meaning::Coordinate(i)) => match configuration {
            Some(_) => rate(vocabulary.coordinates[i]),
            None => Some(vocabulary.rates[i]),
        },
        (Quantity::Rate(..), Meaning::Further(i)) => rate(vocabulary.further[i]),
        _ => None,
    }
}

/// A carrier as the model writes it.
fn spelt(symbol: Symbol, vocabulary: &Vocabulary<'_>) -> String {
    let name = vocabulary.graph.name(symbol);
    match name.strip_prefix("dot_") {
        Some(of) if matches!(vocabulary.names.get(of), Some(Meaning::Coordinate(_) | Meaning::Further(_))) => {
            format!("dot({of})")
        }
        _ => name.to_owned(),
    }
}
