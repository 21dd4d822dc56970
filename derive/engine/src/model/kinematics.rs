//! Kinematics in either direction, the other one derived, or checked where both are given.

use proc_macro2::Span;

use super::context::Context;
use super::inverse::{self, Dependence, Inverse};
use super::joint_kinematics::{beside_quaternions, of_joints};
use super::linear::{self, Linear};
use super::names::Meaning;
use super::system::Kinematics;
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::{Diagnostics, Expression, Quantity, did_you_mean, messages, nearest};

/// One direction as written: for each left side, in order, its right side.
type Side<'a> = Vec<Option<&'a Expression>>;

/// (2.1) and (2.2); `None` where something was reported.
///
/// Frames by quaternions have kinematics of their own, ė = A (ω, σ). Where the model names speeds, what it says of them is
/// about ω and the rates of the other coordinates, and the two stages follow on each other.
pub(super) fn build(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Kinematics> {
    let declarations = vocabulary.declarations;
    let n = declarations.coordinates.len();
    match (&declarations.speeds, &declarations.kinematics) {
        (None, None) => {
            let kinds = vocabulary.kinds.clone();
            let (a, b) = of_joints(&kinds, vocabulary);
            let zero = vec![vocabulary.graph.zero(); n];
            Some(Kinematics { a, a0: zero.clone(), b, b0: zero, pivots: Vec::new() })
        }
        (None, Some(kinematics)) => {
            diagnostics.report(kinematics.span, messages::kinematics_without_speeds());
            None
        }
        (Some(speeds), None) => {
            diagnostics.report(speeds.span, messages::speeds_without_kinematics());
            None
        }
        (Some(speeds), Some(kinematics)) => {
            let (count, wanted) = (speeds.names.len(), n - vocabulary.quaternions.len());
            let fits = count == wanted;
            if !fits {
                let message = match vocabulary.quaternions.len() {
                    0 => messages::number_of_speeds(count, wanted),
                    _ => messages::number_of_speeds_beside_norms(count, wanted),
                };
                diagnostics.report(speeds.span, message);
            }
            if !vocabulary.quaternions.is_empty() {
                return beside_quaternions(kinematics, fits, vocabulary, diagnostics);
            }
            let subject = Subject {
                entries: &kinematics.entries,
                span: kinematics.span,
                speeds: vocabulary.speeds.clone(),
                rates: vocabulary.rates.clone(),
                meanings: ((0..count).map(Meaning::Speed).collect(), (0..n).map(Meaning::Coordinate).collect()),
                contexts: (Context::SPEEDS, Context::RATES),
                adapt: Vec::new(),
            };
            directions(&subject, fits, vocabulary, diagnostics)
        }
    }
}

/// The kinematics of some speeds: whose, and as what they are written.
pub(super) struct Subject<'a> {
    pub entries: &'a [(Quantity, Expression)],
    pub span: Span,
    pub speeds: Vec<Symbol>,
    pub rates: Vec<Symbol>,
    /// What the left sides of each direction are, in the order of the symbols: speeds, rates.
    pub meanings: (Vec<Meaning>, Vec<Meaning>),
    /// What may stand on the right for a speed, and for a rate.
    pub contexts: (Context, Context),
    /// What replaces symbols on the right.
    pub adapt: Vec<(Symbol, Expr)>,
}

/// Both directions from what is written; `fits` tells whether there are as many speeds as rates.
pub(super) fn directions(
    subject: &Subject<'_>,
    fits: bool,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Kinematics> {
    let span = subject.span;
    let (of_speeds, of_rates) = sort(subject, vocabulary, diagnostics)?;
    let partly = |side: &Side<'_>| side.iter().any(Option::is_some) && side.iter().any(Option::is_none);
    if partly(&of_speeds) && partly(&of_rates) {
        diagnostics.report(span, messages::kinematics_mixed());
        return None;
    }
    let of_speeds = complete(subject, vocabulary, of_speeds, Direction::Speeds, diagnostics);
    let of_rates = complete(subject, vocabulary, of_rates, Direction::Rates, diagnostics);
    let of_speeds = of_speeds.map(|side| one_direction(subject, vocabulary, &side, Direction::Speeds, diagnostics));
    let of_rates = of_rates.map(|side| one_direction(subject, vocabulary, &side, Direction::Rates, diagnostics));
    if !fits {
        return None;
    }
    match (of_speeds, of_rates) {
        (Some(of_speeds), Some(of_rates)) => checked(subject, vocabulary, of_speeds?, of_rates?, diagnostics),
        (Some(of_speeds), None) => {
            let Linear { coefficients: b, constant: b0 } = of_speeds?;
            let (a, a0, pivots) = inverted(subject, vocabulary, &b, &b0, Direction::Speeds, diagnostics)?;
            Some(Kinematics { a, a0, b, b0, pivots })
        }
        (None, Some(of_rates)) => {
            let Linear { coefficients: a, constant: a0 } = of_rates?;
            let (b, b0, pivots) = inverted(subject, vocabulary, &a, &a0, Direction::Rates, diagnostics)?;
            Some(Kinematics { a, a0, b, b0, pivots })
        }
        (None, None) => None,
    }
}

/// What the left sides are.
#[derive(Clone, Copy, PartialEq)]
enum Direction {
    /// `v1 = ..` (2.2)
    Speeds,
    /// `dot(x) = ..` (2.1)
    Rates,
}

/// Sorts the entries by their left sides; each may stand once.
fn sort<'a>(
    subject: &Subject<'a>,
    vocabulary: &Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(Side<'a>, Side<'a>)> {
    let (speeds, rates) = &subject.meanings;
    let mut of_speeds: Side<'a> = vec![None; speeds.len()];
    let mut of_rates: Side<'a> = vec![None; rates.len()];
    let mut sound = true;
    for (left, right) in subject.entries {
        let name = left.ident().to_string();
        let place = |list: &[Meaning]| {
            let meaning = vocabulary.names.get(&name)?;
            list.iter().position(|other| *other == meaning)
        };
        let slot = match left {
            Quantity::Name(_) => place(speeds).and_then(|i| of_speeds.get_mut(i)),
            Quantity::Rate(..) => place(rates).and_then(|i| of_rates.get_mut(i)),
        };
        let message = match slot {
            Some(slot) if slot.is_none() => {
                *slot = Some(right);
                continue;
            }
            Some(_) => messages::kinematics_twice(name),
            None => wrong_left_side(vocabulary, left),
        };
        diagnostics.report(left.place(), message);
        sound = false;
    }
    sound.then_some((of_speeds, of_rates))
}

fn wrong_left_side(vocabulary: &Vocabulary<'_>, left: &Quantity) -> String {
    let name = left.ident().to_string();
    let declarations = vocabulary.declarations;
    match (vocabulary.names.get(&name), left) {
        (Some(Meaning::Coordinate(_)), Quantity::Name(_)) => messages::name_of_coordinate(name),
        (Some(Meaning::Coordinate(_)), Quantity::Rate(..)) => messages::configuration_rate_of_given(name),
        (Some(Meaning::Speed(_)), Quantity::Rate(..)) => messages::acceleration("dot", name),
        (Some(meaning), _) => messages::kinematics_left_side(name, meaning.describe()),
        (None, _) => {
            let speeds = declarations.speeds.iter().flat_map(|speeds| &speeds.names);
            let candidates: Vec<String> = match left {
                Quantity::Name(_) => speeds.map(|name| name.ident.to_string()).collect(),
                Quantity::Rate(..) => declarations.coordinates.iter().map(|name| name.ident.to_string()).collect(),
            };
            let hint = did_you_mean(nearest(&name, candidates.iter().map(String::as_str)));
            messages::unknown_name(name, hint)
        }
    }
}

/// One direction, if any of it is given; then all of it must be.
fn complete<'a>(
    subject: &Subject<'_>,
    vocabulary: &Vocabulary<'_>,
    side: Side<'a>,
    direction: Direction,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<&'a Expression>> {
    if side.iter().all(Option::is_none) {
        return None;
    }
    let symbols = match direction {
        Direction::Speeds => &subject.speeds,
        Direction::Rates => &subject.rates,
    };
    let missing = side.iter().zip(symbols).filter(|(given, _)| given.is_none());
    let missing: Vec<String> = missing.map(|(_, symbol)| format!("`{}`", vocabulary.graph.name(*symbol))).collect();
    if !missing.is_empty() {
        diagnostics.report(subject.span, messages::kinematics_missing(missing.join(", ")));
    }
    side.into_iter().collect()
}

/// Lowers one direction and splits it into its matrix and the rest.
fn one_direction(
    subject: &Subject<'_>,
    vocabulary: &mut Vocabulary<'_>,
    side: &[&Expression],
    direction: Direction,
    diagnostics: &mut Diagnostics,
) -> Option<Linear> {
    let (context, what) = match direction {
        Direction::Speeds => (subject.contexts.0, "rates"),
        Direction::Rates => (subject.contexts.1, "speeds"),
    };
    let lowered: Vec<Option<Expr>> = side
        .iter()
        .map(|expression| vocabulary.lower_held(expression, context, diagnostics).map(|lowered| lowered.expr))
        .collect();
    let rows: Vec<Expr> = lowered.into_iter().collect::<Option<_>>()?;
    let variables = match direction {
        Direction::Speeds => subject.rates.clone(),
        Direction::Rates => subject.speeds.clone(),
    };
    let graph = &mut vocabulary.graph;
    let rows = graph.substitute(&rows, &subject.adapt);
    linear::split(graph, &rows, &variables)
        .map_err(|refused| {
            for nonlinear in refused {
                let variable = graph.name(nonlinear.variable);
                let derivative = graph.display(nonlinear.derivative);
                let place = side[nonlinear.row].place();
                diagnostics.report(place, messages::kinematics_not_linear(what, variable, derivative));
            }
        })
        .ok()
}

/// The other direction of `left = matrix·right + bias`.
fn inverted(
    subject: &Subject<'_>,
    vocabulary: &mut Vocabulary<'_>,
    matrix: &Matrix,
    bias: &[Expr],
    direction: Direction,
    diagnostics: &mut Diagnostics,
) -> Option<(Matrix, Vec<Expr>, Vec<Expr>)> {
    let graph = &mut vocabulary.graph;
    match inverse::inverse(graph, matrix) {
        Ok(Inverse { matrix: inverse, pivots }) => {
            let moved = inverse.mul_vec(graph, bias);
            let rest = moved.into_iter().map(|entry| graph.neg(entry)).collect();
            Some((inverse, rest, pivots))
        }
        Err(Dependence(coefficients)) => {
            let (left, right) = match direction {
                Direction::Speeds => (&subject.speeds, "rates"),
                Direction::Rates => (&subject.rates, "speeds"),
            };
            let combination = combination(graph, &coefficients, left);
            diagnostics.report(subject.span, messages::kinematics_not_invertible(combination, right));
            None
        }
    }
}

fn combination(graph: &mut Graph, coefficients: &[Expr], left: &[Symbol]) -> String {
    let vars = graph.vars(left);
    let terms: Vec<Expr> = coefficients.iter().zip(vars).map(|(c, v)| graph.mul(*c, v)).collect();
    let sum = graph.sum(&terms);
    graph.display(sum)
}

/// Both directions as given, if each undoes the other.
fn checked(
    subject: &Subject<'_>,
    vocabulary: &mut Vocabulary<'_>,
    of_speeds: Linear,
    of_rates: Linear,
    diagnostics: &mut Diagnostics,
) -> Option<Kinematics> {
    let Linear { coefficients: b, constant: b0 } = of_speeds;
    let Linear { coefficients: a, constant: a0 } = of_rates;
    // The chart's singularities are those of B, whoever writes down its inverse.
    let (speeds, span) = (&subject.speeds, subject.span);
    let (_, _, pivots) = inverted(subject, vocabulary, &b, &b0, Direction::Speeds, diagnostics)?;
    let graph = &mut vocabulary.graph;
    let product = b.mul(graph, &a);
    let shift = b.mul_vec(graph, &a0);
    let n = speeds.len();
    for i in 0..n {
        for j in 0..n {
            let unit = if i == j { graph.one() } else { graph.zero() };
            if !graph.identical(product.get(i, j), unit) {
                let (row, column) = (graph.name(speeds[i]), graph.name(speeds[j]));
                let found = graph.display(product.get(i, j));
                diagnostics.report(span, messages::kinematics_disagree(row, column, found));
                return None;
            }
        }
        let rest = graph.add(shift[i], b0[i]);
        if !graph.vanishes(rest) {
            let (row, found) = (graph.name(speeds[i]), graph.display(rest));
            diagnostics.report(span, messages::kinematics_biases_disagree(row, found));
            return None;
        }
    }
    Some(Kinematics { a, a0, b, b0, pivots })
}
