//! x = g(q, t) (4.2), and the speeds in which q̇ is written (4.3).

use super::context::Context;
use super::kinematics::{self, Subject};
use super::names::Meaning;
use super::system::{Configuration, Kinematics};
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Kind, Matrix, Symbol};
use crate::syntax::{Configuration as Written, Diagnostics, Term, did_you_mean, messages, nearest};

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
    let free = coordinates.len() - vocabulary.further.len();
    let rate_names: Vec<String> = coordinates[..free].iter().map(|q| format!("dot_{}", graph.name(*q))).collect();
    let mut rates: Vec<Symbol> = rate_names.iter().map(|name| graph.symbol(name, Kind::Speed)).collect();
    let values = given.iter().zip(&vocabulary.coordinates);
    let map: Vec<Expr> = values.map(|(value, x)| value.unwrap_or(graph.var(*x))).collect();
    rates.extend((0..vocabulary.further.len()).map(|i| vocabulary.further_rate("dot", i)));
    let graph = &mut vocabulary.graph;
    let n = rates.len();
    if written.speeds.is_empty() {
        if let Some((left, _)) = written.kinematics.first() {
            diagnostics.report(left.place(), messages::configuration_kinematics_without_speeds());
            sound = false;
        }
        let (unit, zero) = (Matrix::identity(graph, n), vec![graph.zero(); n]);
        let kinematics = Kinematics { a: unit.clone(), a0: zero.clone(), b: unit, b0: zero, pivots: Vec::new() };
        let speeds = rates.clone();
        return sound.then_some(Configuration { coordinates, rates, speeds, kinematics, map, span: written.span });
    }
    let kinematics = quasi_velocities(written, &coordinates, &rates, &map, vocabulary, diagnostics)?;
    let speeds = vocabulary.quasi.clone();
    sound.then_some(Configuration { coordinates, rates, speeds, kinematics, map, span: written.span })
}

/// q̇ = Ã u + ã0 (4.3), in either direction.
fn quasi_velocities(
    written: &Written,
    coordinates: &[Symbol],
    rates: &[Symbol],
    map: &[Expr],
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Kinematics> {
    let fits = written.speeds.len() == rates.len();
    if !fits {
        let message = messages::configuration_number_of_speeds(written.speeds.len(), rates.len());
        diagnostics.report(written.span, message);
    }
    if written.kinematics.is_empty() {
        let names: Vec<String> = written.speeds.iter().map(|speed| format!("`{}`", speed.ident)).collect();
        let message = messages::configuration_speeds_without_kinematics(names.join(", "));
        diagnostics.report(written.span, message);
        return None;
    }
    let meaning = |q: &Symbol| {
        let initial = vocabulary.coordinates.iter().position(|x| x == q).map(Meaning::Coordinate);
        initial.or(vocabulary.further.iter().position(|x| x == q).map(Meaning::Further))
    };
    let of_rates: Vec<Meaning> = coordinates.iter().filter_map(meaning).collect();
    let of_speeds = (0..written.speeds.len()).map(Meaning::Quasi).collect();
    let rates_as_they_are: Vec<Expr> = vocabulary.graph.vars(rates);
    let subject = Subject {
        entries: &written.kinematics,
        span: written.span,
        speeds: vocabulary.quasi.clone(),
        rates: rates.to_vec(),
        meanings: (of_speeds, of_rates),
        contexts: (Context::QUASI_SPEEDS, Context::QUASI_RATES),
        adapt: in_generalised(vocabulary, coordinates, &rates_as_they_are, map),
    };
    kinematics::directions(&subject, fits, vocabulary, diagnostics)
}

/// x ↦ g(q, t), `dot(x)` ↦ ∂g/∂q q̇ + ∂g/∂t and `dot(q)` ↦ q̇, with q̇ as given.
pub(super) fn in_generalised(
    vocabulary: &mut Vocabulary<'_>,
    coordinates: &[Symbol],
    rates: &[Expr],
    map: &[Expr],
) -> Vec<(Symbol, Expr)> {
    let graph = &mut vocabulary.graph;
    let mut motion: Vec<(Symbol, Expr)> = coordinates.iter().copied().zip(rates.iter().copied()).collect();
    motion.push((vocabulary.time, graph.one()));
    let moved = graph.along(map, &motion);
    let mut adapt: Vec<(Symbol, Expr)> = vocabulary.coordinates.iter().copied().zip(map.iter().copied()).collect();
    adapt.extend(vocabulary.rates.iter().copied().zip(moved));
    let further = &rates[rates.len() - vocabulary.further_rates.len()..];
    let known = vocabulary.further_rates.iter().zip(further);
    adapt.extend(known.filter_map(|(symbol, value)| Some(((*symbol)?, *value))));
    adapt
}
