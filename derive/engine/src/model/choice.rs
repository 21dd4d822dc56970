//! What the model says about the independent speeds: their list, or D by rows.

use super::context::Context;
use super::lower::Vocabulary;
use super::names::Meaning;
use super::system::{ComplementRow, Configuration, Independent, IndependentSpeed, Kinematics};
use crate::symbolic::{Expr, Symbol};
use crate::syntax::{Diagnostics, Quantity, messages};

/// The lists of independent speeds, each speed in v, or in q̇ where there is a configuration.
pub(super) fn independent(
    kinematics: &Kinematics,
    configuration: Option<&Configuration>,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<Independent> {
    let declarations = vocabulary.declarations;
    if declarations.independent.is_empty() {
        return Vec::new();
    }
    let rates = Rates::of(kinematics, configuration, vocabulary);
    let lists = declarations.independent.iter();
    lists
        .map(|written| Independent {
            speeds: list(&written.entries, &rates, vocabulary, diagnostics),
            span: written.span,
        })
        .collect()
}

/// One list of independent speeds.
fn list(
    entries: &[Quantity],
    rates: &Rates,
    vocabulary: &Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<IndependentSpeed> {
    let mut list: Vec<IndependentSpeed> = Vec::new();
    for quantity in entries {
        let written = quantity.ident().to_string();
        let found = match (quantity, vocabulary.names.get(&written)) {
            (Quantity::Name(_), Some(Meaning::Speed(i))) => Ok((written, rates.speeds[i])),
            (Quantity::Name(_), Some(Meaning::Quasi(i))) => Ok((written, vocabulary.graph.var(vocabulary.quasi[i]))),
            (Quantity::Rate(..), Some(Meaning::Coordinate(i))) => Ok((format!("dot_{written}"), rates.rates[i])),
            (Quantity::Rate(..), Some(Meaning::Further(i))) => Ok((format!("dot_{written}"), rates.further[i])),
            (Quantity::Name(_), Some(Meaning::Coordinate(_) | Meaning::Further(_))) => {
                Err(messages::name_of_coordinate(written))
            }
            (Quantity::Rate(..), Some(Meaning::Speed(_))) => Err(messages::acceleration("dot", written)),
            (_, Some(meaning)) => Err(messages::independent_form(written, meaning.describe())),
            (_, None) => Err(vocabulary.names.unknown(&written)),
        };
        let message = match found {
            Ok((name, _)) if list.iter().any(|other| other.name == name) => messages::independent_twice(quantity),
            Ok((name, expr)) => {
                list.push(IndependentSpeed { name, expr, place: quantity.place() });
                continue;
            }
            Err(message) => message,
        };
        diagnostics.report(quantity.place(), message);
    }
    list
}

/// All speeds and rates of the initial system, in v or in q̇.
struct Rates {
    speeds: Vec<Expr>,
    rates: Vec<Expr>,
    further: Vec<Expr>,
}

impl Rates {
    fn of(kinematics: &Kinematics, configuration: Option<&Configuration>, vocabulary: &mut Vocabulary<'_>) -> Self {
        let graph = &mut vocabulary.graph;
        let Some(configuration) = configuration else {
            let speeds = graph.vars(&vocabulary.speeds);
            let moved = kinematics.a.mul_vec(graph, &speeds);
            let rates = moved.into_iter().zip(&kinematics.a0).map(|(rate, bias)| graph.add(rate, *bias)).collect();
            return Rates { speeds, rates, further: Vec::new() };
        };
        // ẋ = ∂g/∂q q̇ + ∂g/∂t, and v = B(g) ẋ + b0(g).
        let quasi = graph.vars(&configuration.speeds);
        let moved = configuration.kinematics.a.mul_vec(graph, &quasi);
        let biased = moved.into_iter().zip(&configuration.kinematics.a0);
        let velocities: Vec<Expr> = biased.map(|(rate, bias)| graph.add(rate, *bias)).collect();
        let mut tangent: Vec<(Symbol, Expr)> =
            configuration.coordinates.iter().copied().zip(velocities.clone()).collect();
        tangent.push((vocabulary.time, graph.one()));
        let rates = graph.along(&configuration.map, &tangent);
        let map = coordinate_map(configuration, vocabulary);
        let graph = &mut vocabulary.graph;
        let b = kinematics.b.map(|entries| graph.substitute(entries, &map));
        let b0 = graph.substitute(&kinematics.b0, &map);
        let moved = b.mul_vec(graph, &rates);
        let speeds = moved.into_iter().zip(b0).map(|(speed, bias)| graph.add(speed, bias)).collect();
        let further = velocities[velocities.len() - vocabulary.further.len()..].to_vec();
        Rates { speeds, rates, further }
    }
}

/// x ↦ g(q, t).
fn coordinate_map(configuration: &Configuration, vocabulary: &Vocabulary<'_>) -> Vec<(Symbol, Expr)> {
    vocabulary.coordinates.iter().copied().zip(configuration.map.iter().copied()).collect()
}

/// D by rows.
pub(super) fn complement(
    configuration: Option<&Configuration>,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<ComplementRow>> {
    let declarations = vocabulary.declarations;
    let written = declarations.complement.as_ref()?;
    if let Some(independent) = declarations.independent.first() {
        diagnostics.report(independent.span, messages::independent_and_complement());
    }
    let (columns, what, context) = match configuration {
        Some(configuration) => {
            let count = configuration.rates.len();
            (count, messages::counted(count, "coordinate", "coordinates"), Context::COMPLEMENT_OF_RATES)
        }
        None => {
            let count = vocabulary.coordinates.len();
            (count, messages::counted(count, "speed", "speeds"), Context::COMPLEMENT)
        }
    };
    let mut rows: Vec<ComplementRow> = Vec::new();
    for row in &written.rows {
        let name = row.name.to_string();
        let lowered: Vec<Option<Expr>> = row
            .entries
            .iter()
            .map(|entry| vocabulary.lower(entry, context, diagnostics).map(|lowered| lowered.expr))
            .collect();
        if row.entries.len() != columns {
            let entries = messages::counted(row.entries.len(), "entry", "entries");
            diagnostics.report(row.span, messages::wrong_length(format!("the row `{name}`"), entries, &what));
        }
        let Some(mut entries) = lowered.into_iter().collect::<Option<Vec<Expr>>>() else { continue };
        if let Some(configuration) = configuration {
            let map = coordinate_map(configuration, vocabulary);
            entries = vocabulary.graph.substitute(&entries, &map);
        }
        rows.push(ComplementRow { name, entries, span: row.name.span() });
    }
    check_names(&rows, configuration.is_some(), vocabulary, diagnostics);
    Some(rows)
}

/// A row's name is new, or that of the speed that it sets free: then D's column for that speed is a unit vector.
fn check_names(
    rows: &[ComplementRow],
    has_configuration: bool,
    vocabulary: &Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) {
    for (i, row) in rows.iter().enumerate() {
        if rows[..i].iter().any(|other| other.name == row.name) {
            diagnostics.report(row.span, messages::complement_twice(&row.name));
            continue;
        }
        match vocabulary.names.get(&row.name) {
            Some(Meaning::Speed(column)) if !has_configuration => {
                let graph = &vocabulary.graph;
                let unit = rows.iter().enumerate().all(|(k, row)| {
                    let unit = if k == i { graph.one() } else { graph.zero() };
                    row.entries.get(column).is_none_or(|entry| graph.identical(*entry, unit))
                });
                if !unit {
                    diagnostics.report(row.span, messages::complement_is_not_speed(&row.name));
                }
            }
            Some(meaning) => {
                diagnostics.report(row.span, messages::duplicate_name(&row.name, "a row of D", meaning.describe()));
            }
            None => {}
        }
    }
}
