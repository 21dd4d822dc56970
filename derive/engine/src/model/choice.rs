//! What the model says about the independent speeds: their list, or D by rows.

use super::context::Context;
use super::linear;
use super::names::Meaning;
use super::system::{ComplementRow, Configuration, Independent, IndependentSpeed, Kinematics};
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Kind, Symbol};
use crate::syntax::{Diagnostics, IndependentEntry, Place, Quantity, Speed, messages};

/// The lists of independent speeds, each speed over the carriers: v, or with a configuration its rates or quasi-velocities.
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
    let combinations = combinations(&rates, configuration, vocabulary, diagnostics);
    let lists = declarations.independent.iter();
    let mut read = 0;
    lists
        .map(|written| Independent {
            speeds: list(&written.entries, &rates, (&combinations, &mut read), vocabulary, diagnostics),
            span: written.span,
        })
        .collect()
}

/// What `s = ..` stands for in each of the lists, over the carriers; `None` where something was reported.
fn combinations(
    rates: &Rates,
    configuration: Option<&Configuration>,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<Option<IndependentSpeed>> {
    let context = if configuration.is_some() { Context::COMBINATION_OF_RATES } else { Context::COMBINATION };
    // Speeds and rates become those of the carriers, and x becomes g(q, t).
    let mut adapt = configuration.map_or(Vec::new(), |given| coordinate_map(given, vocabulary));
    adapt.extend(vocabulary.speeds.iter().copied().zip(rates.speeds.iter().copied()));
    if vocabulary.rates != vocabulary.speeds {
        adapt.extend(vocabulary.rates.iter().copied().zip(rates.rates.iter().copied()));
    }
    adapt.extend(vocabulary.further_rates.iter().flatten().copied().zip(rates.further.iter().copied()));
    let declarations = vocabulary.declarations;
    let mut found = Vec::new();
    for (at, (name, value)) in declarations.independent.iter().flat_map(|list| list.combinations()).enumerate() {
        let lowered = vocabulary.lower_held(value, context, diagnostics);
        found.push(lowered.and_then(|lowered| {
            let expr = vocabulary.graph.substitute(&[lowered.expr], &adapt)[0];
            let read = reading(&mut vocabulary.graph, expr, &rates.carriers);
            let message = match read {
                Ok((gradient, _)) if gradient.iter().all(|entry| vocabulary.graph.vanishes(*entry)) => {
                    messages::combination_without_speed(&name.ident)
                }
                Ok((gradient, offset)) => {
                    let (symbol, place) = (vocabulary.combinations[at], (&name.ident).into());
                    return Some(IndependentSpeed { symbol, expr, gradient, offset, place });
                }
                Err(nonlinear) => {
                    let variable = vocabulary.graph.name(nonlinear.variable);
                    let derivative = vocabulary.graph.display(nonlinear.derivative);
                    messages::combination_not_linear(&name.ident, variable, derivative)
                }
            };
            diagnostics.report(value.place(), message);
            None
        }));
    }
    found
}

/// L and l0 of a speed L w + l0 over the carriers w.
fn reading(graph: &mut Graph, expr: Expr, carriers: &[Symbol]) -> Result<(Vec<Expr>, Expr), linear::Nonlinear> {
    match linear::split(graph, &[expr], carriers) {
        Ok(split) => Ok((split.coefficients.row(0).to_vec(), split.constant[0])),
        Err(mut refused) => Err(refused.remove(0)),
    }
}

/// One list of independent speeds; of the combinations of all lists so many were `read` before.
fn list(
    entries: &[IndependentEntry],
    rates: &Rates,
    (combinations, read): (&[Option<IndependentSpeed>], &mut usize),
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<IndependentSpeed> {
    let mut list: Vec<IndependentSpeed> = Vec::new();
    for entry in entries {
        let (ident, quantity) = match entry {
            IndependentEntry::Speed(quantity) => (quantity.ident(), Some(quantity)),
            IndependentEntry::Combination { name, .. } => (&name.ident, None),
        };
        let written = ident.to_string();
        let place = quantity.map_or(ident.into(), Quantity::place);
        let this = *read;
        *read += usize::from(quantity.is_none());
        let found = match (quantity, vocabulary.names.get(&written)) {
            // Its name is taken, which was reported, or what it stands for was.
            (None, meaning) if meaning != Some(Meaning::Combination(this)) => continue,
            (Some(Quantity::Name(_)) | None, Some(Meaning::Combination(i))) => match &combinations[i] {
                Some(speed) => Ok(IndependentSpeed { place, ..speed.clone() }),
                None => continue,
            },
            (Some(Quantity::Name(_)), Some(Meaning::Speed(i))) if matches!(vocabulary.kinds[i], Speed::Norm(_)) => {
                Err(messages::norm_rate_independent(&written))
            }
            (Some(Quantity::Name(_)), Some(Meaning::Speed(i))) => {
                rates.plain(rates.speeds[i], &written, place, vocabulary)
            }
            (Some(Quantity::Rate(..)), Some(Meaning::Coordinate(i))) if vocabulary.quaternion_of(i).is_some() => {
                let (frame, angular) = vocabulary.quaternion_of(i).unwrap_or_default();
                Err(messages::quaternion_rate_independent(&written, frame, angular))
            }
            (Some(Quantity::Name(_)), Some(Meaning::Quasi(i))) => {
                let quasi = vocabulary.graph.var(vocabulary.quasi[i]);
                rates.plain(quasi, &written, place, vocabulary)
            }
            (Some(Quantity::Rate(..)), Some(Meaning::Coordinate(i))) => {
                rates.plain(rates.rates[i], &format!("dot_{written}"), place, vocabulary)
            }
            (Some(Quantity::Rate(..)), Some(Meaning::Further(i))) => {
                rates.plain(rates.further[i], &format!("dot_{written}"), place, vocabulary)
            }
            (Some(Quantity::Name(_)), Some(Meaning::Coordinate(_) | Meaning::Further(_))) => {
                Err(messages::name_of_coordinate(&written))
            }
            (Some(Quantity::Rate(..)), Some(Meaning::Speed(_))) => Err(messages::acceleration("dot", &written)),
            (_, Some(meaning)) => Err(messages::independent_form(&written, meaning.describe())),
            (_, None) => Err(vocabulary.names.unknown(&written)),
        };
        let message = match found {
            Ok(speed) if list.iter().any(|other| other.expr == speed.expr) => {
                let text = quantity.map_or(written, ToString::to_string);
                messages::independent_twice(text)
            }
            Ok(speed) => {
                list.push(speed);
                continue;
            }
            Err(message) => message,
        };
        diagnostics.report(place, message);
    }
    list
}

/// All speeds and rates of the initial system, in v or in q̇.
struct Rates {
    speeds: Vec<Expr>,
    rates: Vec<Expr>,
    further: Vec<Expr>,
    carriers: Vec<Symbol>,
}

impl Rates {
    fn of(kinematics: &Kinematics, configuration: Option<&Configuration>, vocabulary: &mut Vocabulary<'_>) -> Self {
        let graph = &mut vocabulary.graph;
        let Some(configuration) = configuration else {
            let speeds = graph.vars(&vocabulary.speeds);
            let moved = kinematics.a.mul_vec(graph, &speeds);
            let rates = moved.into_iter().zip(&kinematics.a0).map(|(rate, bias)| graph.add(rate, *bias)).collect();
            return Rates { speeds, rates, further: Vec::new(), carriers: vocabulary.speeds.clone() };
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
        Rates { speeds, rates, further, carriers: configuration.speeds.clone() }
    }

    /// A speed or rate as it is: one of the carriers, or a combination of them under its own name.
    fn plain(
        &self,
        expr: Expr,
        name: &str,
        place: Place,
        vocabulary: &mut Vocabulary<'_>,
    ) -> Result<IndependentSpeed, String> {
        let graph = &mut vocabulary.graph;
        let own = graph.as_symbol(expr).filter(|symbol| self.carriers.contains(symbol));
        // Both directions of the kinematics are linear, and so is what they make of a speed.
        let (gradient, offset) = reading(graph, expr, &self.carriers).map_err(|nonlinear| {
            let (variable, derivative) = (graph.name(nonlinear.variable), graph.display(nonlinear.derivative));
            messages::combination_not_linear(name, variable, derivative)
        })?;
        if gradient.iter().all(|entry| graph.vanishes(*entry)) {
            return Err(messages::combination_without_speed(name));
        }
        let symbol = own.unwrap_or_else(|| graph.symbol(name, Kind::Speed));
        Ok(IndependentSpeed { symbol, expr, gradient, offset, place })
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
    let carriers = configuration.map_or(&vocabulary.speeds, |given| &given.speeds).clone();
    check_names(&rows, &carriers, vocabulary, diagnostics);
    Some(rows)
}

/// A row's name is new, or that of the carrier that it sets free: then D's column for that speed is a unit vector.
fn check_names(
    rows: &[ComplementRow],
    carriers: &[Symbol],
    vocabulary: &Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) {
    let graph = &vocabulary.graph;
    for (i, row) in rows.iter().enumerate() {
        if rows[..i].iter().any(|other| other.name == row.name) {
            diagnostics.report(row.span, messages::complement_twice(&row.name));
            continue;
        }
        let column = carriers.iter().position(|carrier| graph.name(*carrier) == row.name);
        let message = match (column, vocabulary.names.get(&row.name), vocabulary.names.rate_of(&row.name)) {
            (Some(column), ..) => {
                let unit = rows.iter().enumerate().all(|(k, row)| {
                    let unit = if k == i { graph.one() } else { graph.zero() };
                    row.entries.get(column).is_none_or(|entry| graph.identical(*entry, unit))
                });
                if unit {
                    continue;
                }
                messages::complement_is_not_speed(&row.name)
            }
            (None, Some(meaning), _) => messages::duplicate_name(&row.name, "a row of D", meaning.describe()),
            (None, None, Some(of)) => messages::name_of_rate(&row.name, of),
            (None, None, None) => continue,
        };
        diagnostics.report(row.span, message);
    }
}
