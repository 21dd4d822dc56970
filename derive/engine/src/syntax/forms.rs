//! The form of each statement: from its entries to what they declare.

use proc_macro2::{Delimiter, Span, TokenTree};
use syn::Path;

use super::declarations::*;
use super::diagnostics::{Diagnostics, Place, messages};
use super::entries::{self, Before, Entry, double_equals, is_colon, quantity, single_equals, single_ident};
use super::expression::{Expression, is_punct};
use super::joints::is_joint;

pub(super) fn names(entries: &[Entry], diagnostics: &mut Diagnostics) -> Vec<Name> {
    entries.iter().flat_map(|entry| entry.names(diagnostics)).collect()
}

pub(super) fn expressions(entries: &[Entry], diagnostics: &mut Diagnostics) -> Vec<Expression> {
    entries.iter().map(|entry| entry.expression(diagnostics)).collect()
}

/// One expression and no more.
pub(super) fn single(entries: &[Entry], diagnostics: &mut Diagnostics) -> Option<Expression> {
    if let [_, second, ..] = entries {
        diagnostics.report(second.place(), messages::one_expression());
        return None;
    }
    entries.first().map(|entry| entry.expression(diagnostics))
}

pub(super) fn assignments(entries: &[Entry], form: &str, diagnostics: &mut Diagnostics) -> Vec<Assignment> {
    entries
        .iter()
        .filter_map(|entry| {
            let (name, value) = entry.named_expression(form, diagnostics)?;
            Some(Assignment { name, value })
        })
        .collect()
}

/// `power = ..` or `mu`, with doc comments before it
pub(super) fn output(entry: &Entry, diagnostics: &mut Diagnostics) -> Option<Output> {
    let (Before { docs, unit }, entry) = entry.documented(diagnostics);
    let (ident, value) = match entry.tokens.as_slice() {
        [token @ TokenTree::Ident(_)] => (entries::ident(token, diagnostics)?, entry.expression(diagnostics)),
        _ => entry.named_expression("power = expression` or `mu", diagnostics)?,
    };
    Some(Output { name: Name { ident, docs, unit }, value })
}

/// `v1 = ..` or `dot(x) = ..`
pub(super) fn kinematic(entry: &Entry, diagnostics: &mut Diagnostics) -> Option<(Quantity, Expression)> {
    let form = "v1 = expression` or `dot(x) = expression";
    let (left, equals, right) = entry.assignment(form, diagnostics)?;
    let quantity = quantity(left, entry.place(), diagnostics);
    let value = Expression::read(right, equals, diagnostics);
    Some((quantity?, value))
}

/// `diag(..)` or `matrix([..], ..)`
pub(super) fn inertia(entries: &[Entry], span: Span, diagnostics: &mut Diagnostics) -> Option<Inertia> {
    let form = match entries {
        [Entry { tokens, .. }] => match tokens.as_slice() {
            [TokenTree::Ident(form), TokenTree::Group(list)] if list.delimiter() == Delimiter::Parenthesis => {
                let inner = entries::split(list.stream(), list.span_close());
                match form.to_string().as_str() {
                    "diag" => Some(InertiaForm::Diagonal(expressions(&inner, diagnostics))),
                    "matrix" => Some(InertiaForm::Matrix(
                        inner.iter().filter_map(|row| inertia_row(row, diagnostics)).collect(),
                    )),
                    _ => None,
                }
            }
            _ => None,
        },
        _ => None,
    };
    if form.is_none() {
        let first = entries.first().map_or(span.into(), Entry::place);
        let last = entries.last().map_or(span.into(), Entry::place);
        let place = Place::between(first.start, last.end);
        diagnostics.report(place, messages::inertia_form());
    }
    Some(Inertia { form: form?, span })
}

fn inertia_row(row: &Entry, diagnostics: &mut Diagnostics) -> Option<InertiaRow> {
    let (entries, span) = bracketed(&row.tokens).or_else(|| {
        diagnostics.report(row.place(), messages::matrix_row_expected());
        None
    })?;
    let entries = entries
        .iter()
        .map(|entry| match entry.tokens.as_slice() {
            [TokenTree::Ident(underscore)] if underscore == "_" => InertiaEntry::Symmetric(underscore.span()),
            _ => InertiaEntry::Given(entry.expression(diagnostics)),
        })
        .collect();
    Some(InertiaRow { entries, span })
}

/// `name: left == right`, each perhaps with `redundant` or `expressed = B` behind it
pub(super) fn constraints(entries: &[Entry], diagnostics: &mut Diagnostics) -> Vec<Constraint> {
    let mut read: Vec<Constraint> = Vec::new();
    // Whether the entry before was a constraint, if only an unreadable one.
    let mut follows = false;
    for entry in entries {
        match entry.tokens.as_slice() {
            [TokenTree::Ident(mark)] if mark == "redundant" => {
                if !follows {
                    diagnostics.report(mark, messages::redundant_alone());
                } else if let Some(constraint) = read.last_mut() {
                    constraint.redundant = true;
                }
                follows = false;
            }
            [TokenTree::Ident(word), equals, frame @ ..] if word == "expressed" && is_punct(equals, '=') => {
                let frame = single_ident(frame, entry.place(), diagnostics);
                match read.last_mut() {
                    Some(constraint) if follows => constraint.expressed = frame,
                    _ if follows => {}
                    _ => diagnostics.report(word, messages::expressed_form()),
                }
            }
            _ => {
                read.extend(constraint(entry, diagnostics));
                follows = true;
            }
        }
    }
    read
}

/// `name: left == right`, or `name: spherical(P, Q)`
fn constraint(entry: &Entry, diagnostics: &mut Diagnostics) -> Option<Constraint> {
    let (name, colon, equation) = match entry.tokens.as_slice() {
        [name, colon, equation @ ..] if is_colon(colon) => (entries::ident(name, diagnostics), colon.span(), equation),
        _ => {
            diagnostics.report(entry.place(), messages::constraint_form());
            return None;
        }
    };
    match double_equals(equation).as_slice() {
        [at] => {
            let left = Expression::read(&equation[..*at], colon, diagnostics);
            let right = Expression::read(&equation[at + 2..], equation[at + 1].span(), diagnostics);
            let sign = Place::between(equation[*at].span(), equation[at + 1].span());
            Some(Constraint { name: name?, left, right: Some(right), sign, redundant: false, expressed: None })
        }
        [] if is_joint(equation) => {
            let left = Expression::read(equation, colon, diagnostics);
            let sign = equation[0].span().into();
            Some(Constraint { name: name?, left, right: None, sign, redundant: false, expressed: None })
        }
        [] => {
            match single_equals(equation) {
                Some(at) => {
                    diagnostics.report(equation[at].span(), messages::single_equals());
                }
                None => diagnostics.report(entry.place(), messages::equation_expected()),
            }
            None
        }
        [_, second, ..] => {
            let signs = [equation[*second].span(), equation[second + 1].span()];
            diagnostics.report(Place::between(signs[0], signs[1]), messages::second_equation());
            None
        }
    }
}

/// `road(s), derivatives = [droad, ddroad]`
pub(super) fn function(entries: &[Entry], diagnostics: &mut Diagnostics) -> Option<UserFunction> {
    let (first, rest) = entries.split_first()?;
    let (path, argument) = match first.tokens.split_last() {
        Some((TokenTree::Group(argument), path)) if argument.delimiter() == Delimiter::Parenthesis => (path, argument),
        _ => {
            diagnostics.report(first.place(), messages::function_form());
            return None;
        }
    };
    match entries::split(argument.stream(), argument.span_close()).as_slice() {
        [one] if matches!(one.tokens.as_slice(), [TokenTree::Ident(_)]) => {}
        _ => diagnostics.report(argument.span(), messages::function_of_one_argument()),
    }
    let path = path_of(path, first.place(), diagnostics)?;
    let name = path.segments.last().map(|segment| segment.ident.clone())?;
    let mut orders = vec![path];
    match rest {
        [] => {}
        [derivatives] => {
            let list = match derivatives.tokens.as_slice() {
                [TokenTree::Ident(word), equals, list @ ..] if word == "derivatives" && is_punct(equals, '=') => {
                    bracketed(list)
                }
                _ => None,
            };
            let Some((list, _)) = list else {
                diagnostics.report(derivatives.place(), messages::function_form());
                return None;
            };
            for entry in &list {
                orders.push(path_of(&entry.tokens, entry.place(), diagnostics)?);
            }
        }
        [_, second, ..] => diagnostics.report(second.place(), messages::function_form()),
    }
    Some(UserFunction { name, orders })
}

/// A path to a function, as emitted code can use it.
fn path_of(tokens: &[TokenTree], place: Place, diagnostics: &mut Diagnostics) -> Option<Path> {
    let read = syn::parse::Parser::parse2(Path::parse_mod_style, tokens.iter().cloned().collect());
    if read.is_err() {
        diagnostics.report(place, messages::function_path());
    }
    read.ok()
}

pub(super) fn configuration(entries: &[Entry], span: Span, diagnostics: &mut Diagnostics) -> Configuration {
    let (mut further, mut speeds) = (Vec::new(), Vec::new());
    let (mut map, mut kinematics): (Vec<Assignment>, Vec<(Quantity, Expression)>) = Default::default();
    for entry in entries {
        if let Some(names) = named_list(entry, "of", diagnostics) {
            further.extend(names);
        } else if let Some(names) = named_list(entry, "speeds", diagnostics) {
            speeds.extend(names);
        } else if matches!(entry.tokens.first(), Some(TokenTree::Ident(dot)) if dot == "dot") {
            kinematics.extend(kinematic(entry, diagnostics));
        } else {
            let form = "x = expression` or `of(alpha)";
            let assignment = entry.named_expression(form, diagnostics);
            map.extend(assignment.map(|(name, value)| Assignment { name, value }));
        }
    }
    // What is given for a speed belongs to the kinematics, wherever `speeds(..)` stands.
    let (of_speeds, map): (Vec<Assignment>, Vec<Assignment>) =
        map.into_iter().partition(|given| speeds.iter().any(|speed: &Name| speed.ident == given.name));
    kinematics.extend(of_speeds.into_iter().map(|given| (Quantity::Name(given.name), given.value)));
    Configuration { further, speeds, kinematics, map, span }
}

pub(super) fn velocities(entries: &[Entry], span: Span, diagnostics: &mut Diagnostics) -> Velocities {
    let (mut further, mut map) = (Vec::new(), Vec::new());
    for entry in entries {
        match named_list(entry, "of", diagnostics) {
            Some(names) => further.extend(names),
            None => map.extend(kinematic(entry, diagnostics)),
        }
    }
    Velocities { further, map, span }
}

/// The names in `of(..)`, where the entry is that.
fn named_list(entry: &Entry, word: &str, diagnostics: &mut Diagnostics) -> Option<Vec<Name>> {
    match entry.tokens.as_slice() {
        [TokenTree::Ident(of), TokenTree::Group(list)] if of == word && list.delimiter() == Delimiter::Parenthesis => {
            Some(names(&entries::split(list.stream(), list.span_close()), diagnostics))
        }
        _ => None,
    }
}

/// `w1 = [..]`
pub(super) fn complement_row(entry: &Entry, diagnostics: &mut Diagnostics) -> Option<ComplementRow> {
    let form = "w1 = [e1, .., en]";
    let (left, _, right) = entry.assignment(form, diagnostics)?;
    let name = single_ident(left, entry.place(), diagnostics);
    let Some((inner, span)) = bracketed(right) else {
        diagnostics.report(entry.place(), messages::assignment_expected(form));
        return None;
    };
    Some(ComplementRow { name: name?, entries: expressions(&inner, diagnostics), span })
}

/// The entries of `[..]`.
fn bracketed(tokens: &[TokenTree]) -> Option<(Vec<Entry>, Span)> {
    match tokens {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Bracket => {
            Some((entries::split(group.stream(), group.span_close()), group.span()))
        }
        _ => None,
    }
}
