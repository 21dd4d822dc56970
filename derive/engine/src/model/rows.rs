//! Constraints, sorted by what they bind.

use super::context::Context;
use super::geometry::Released;
use super::geometry::equations::sides;
use super::geometry::joints;
use super::linear;
use super::names::Mentions;
use super::system::{Row, RowKind};
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Symbol};
use crate::syntax::{Constraint, Diagnostics, Quaternion, messages};

/// A row as written: left minus right, rates not yet replaced.
pub(super) struct Written<'a> {
    constraint: &'a Constraint,
    /// Its name: the constraint's, or that of a component of it.
    name: String,
    expr: Expr,
    mentions: Mentions,
}

/// Lowers every constraint; those with errors are left out.
pub(super) fn lower<'a>(vocabulary: &mut Vocabulary<'a>, diagnostics: &mut Diagnostics) -> Vec<Written<'a>> {
    let variables = Mentions::COORDINATES.and(Mentions::SPEEDS).and(Mentions::RATES).and(Mentions::ACCELERATIONS);
    let mut written = Vec::new();
    let mut names: Vec<String> = vocabulary.quaternions.iter().map(Quaternion::norm).collect();
    for constraint in &vocabulary.declarations.constraints {
        let name = constraint.name.to_string();
        if names.contains(&name) {
            diagnostics.report(&constraint.name, messages::constraint_twice(&name));
        }
        let rows = match &constraint.right {
            None => joints::rows(constraint, vocabulary, diagnostics),
            Some(right) => {
                let left = vocabulary.value(&constraint.left, Context::CONSTRAINT, diagnostics);
                let right = vocabulary.value(right, Context::CONSTRAINT, diagnostics);
                left.zip(right).and_then(|(left, right)| sides(constraint, left, right, vocabulary, diagnostics))
            }
        };
        for (name, expr, mentions) in rows.into_iter().flatten() {
            if names.contains(&name) && constraint.name != name {
                diagnostics.report(&constraint.name, messages::constraint_twice(&name));
            }
            if mentions.intersects(variables) {
                names.push(name.clone());
                written.push(Written { constraint, name, expr, mentions });
            } else {
                diagnostics.report(&constraint.name, messages::constraint_without_variable(&name));
            }
        }
        names.push(name);
    }
    // Their reactions are asked for by name alike.
    for release in vocabulary.declarations.geometry.releases() {
        let name = release.name.to_string();
        if names.contains(&name) {
            diagnostics.report(&release.name, messages::constraint_twice(&name));
        }
        names.push(name);
    }
    written
}

/// The rows over x, v, v̇ and t; `rates` replaces `dot(x)` by A v + a0, and `ddot(x)` follows by differentiation.
pub(super) fn finish(
    written: &[Written<'_>],
    rates: &[(Symbol, Expr)],
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<Row> {
    let needed = written.iter().any(|row| row.mentions.intersects(Mentions::ACCELERATIONS));
    let second = if needed { second_rates(rates, vocabulary) } else { Vec::new() };
    let all: Vec<(Symbol, Expr)> = rates.iter().chain(&second).copied().collect();
    let mut rows = Vec::new();
    for Written { constraint, name, expr, mentions } in written {
        let expr = vocabulary.graph.substitute(&[*expr], &all)[0];
        let released = vocabulary.released.clone();
        let (expr, gradient) = held(&mut vocabulary.graph, expr, &released);
        let kind = if mentions.intersects(Mentions::ACCELERATIONS) {
            acceleration(expr, (constraint, name), vocabulary, diagnostics)
        } else if mentions.intersects(Mentions::SPEEDS.and(Mentions::RATES)) {
            velocity(expr, (constraint, name), vocabulary, diagnostics)
        } else {
            position(expr, (constraint, name), vocabulary, diagnostics)
        };
        if let Some(kind) = kind {
            let (name, span) = (name.clone(), constraint.name.span());
            // A row binds what is let go as it binds v.
            let level = match &kind {
                RowKind::Position(_) => 0,
                RowKind::Velocity(_) | RowKind::Nonlinear(_) | RowKind::Norm { .. } => 1,
                RowKind::Acceleration { .. } => 2,
            };
            let released = gradient.iter().map(|slopes| slopes[level]).collect();
            rows.push(Row { name, span, kind, redundant: constraint.redundant, released });
        }
    }
    rows.extend(norms(vocabulary));
    rows
}

/// The rows that hold the norms of quaternions.
fn norms(vocabulary: &mut Vocabulary<'_>) -> Vec<Row> {
    let mut rows = Vec::new();
    for (quaternion, turning) in vocabulary.quaternions.iter().zip(&vocabulary.turnings) {
        let f = turning.norm(&vocabulary.coordinates, &mut vocabulary.graph);
        rows.push(Row {
            name: quaternion.norm(),
            span: quaternion.name.span(),
            kind: RowKind::Norm { f, rate: turning.norm_rate },
            redundant: false,
            released: vec![vocabulary.graph.zero(); vocabulary.released.len()],
        });
    }
    rows
}

/// An expression with all releases held, and its slopes by ε, ε̇ and ε̈ of each.
fn held(graph: &mut Graph, e: Expr, released: &[Released]) -> (Expr, Vec<[Expr; 3]>) {
    let zeros: Vec<(Symbol, Expr)> = released.iter().flat_map(|released| released.zeros(graph)).collect();
    let slopes: Vec<[Expr; 3]> = released
        .iter()
        .map(|released| {
            let symbols = [released.coordinate, released.rate, released.second];
            let slopes = graph.jacobian(&[e], &symbols).row(0).to_vec();
            let held = graph.substitute(&slopes, &zeros);
            [held[0], held[1], held[2]]
        })
        .collect();
    (graph.substitute(&[e], &zeros)[0], slopes)
}

/// What replaces each `ddot(x)`: d/dt (A v + a0), with v̇ in it; nothing where these are the accelerations themselves.
pub(super) fn second_rates(rates: &[(Symbol, Expr)], vocabulary: &mut Vocabulary<'_>) -> Vec<(Symbol, Expr)> {
    if rates.is_empty() {
        return Vec::new();
    }
    let graph = &mut vocabulary.graph;
    // Behind the rates of coordinates there are components of angular velocities that are no speeds.
    let n = vocabulary.coordinates.len();
    let first: Vec<Expr> = rates.iter().map(|(_, rate)| *rate).collect();
    let accelerations = graph.vars(&vocabulary.accelerations);
    let mut motion: Vec<(Symbol, Expr)> =
        vocabulary.coordinates.iter().copied().zip(first[..n].iter().copied()).collect();
    motion.extend(vocabulary.speeds.iter().copied().zip(accelerations));
    motion.push((vocabulary.time, graph.one()));
    let second = graph.along(&first, &motion);
    let angular = vocabulary.turnings.iter().flat_map(|turning| turning.omega_rates);
    vocabulary.second_rates.iter().copied().chain(angular).zip(second).collect()
}

fn position(
    f: Expr,
    (constraint, name): (&Constraint, &str),
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<RowKind> {
    let graph = &mut vocabulary.graph;
    let gradient = graph.jacobian(&[f], &vocabulary.coordinates);
    if all_vanish(graph, gradient.entries()) {
        diagnostics.report(&constraint.name, messages::constraint_without_variable(name));
        return None;
    }
    if graph.vanishes(f) {
        diagnostics.report(&constraint.name, messages::constraint_of_norm(name));
        return None;
    }
    Some(RowKind::Position(f))
}

fn velocity(
    phi: Expr,
    (constraint, name): (&Constraint, &str),
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<RowKind> {
    let graph = &mut vocabulary.graph;
    match linear::split(graph, &[phi], &vocabulary.speeds) {
        // Chetaev: its reaction is along ∂φ/∂v.
        Err(_) => Some(RowKind::Nonlinear(phi)),
        Ok(split) if all_vanish(graph, split.coefficients.entries()) => {
            diagnostics.report(&constraint.name, messages::constraint_without_speed(name));
            None
        }
        Ok(_) => Some(RowKind::Velocity(phi)),
    }
}

fn acceleration(
    row: Expr,
    (constraint, name): (&Constraint, &str),
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<RowKind> {
    let graph = &mut vocabulary.graph;
    match linear::split(graph, &[row], &vocabulary.accelerations) {
        Err(refused) => {
            for nonlinear in refused {
                let variable = graph.name(nonlinear.variable);
                diagnostics.report(&constraint.name, messages::constraint_not_linear(name, variable));
            }
            None
        }
        Ok(split) if all_vanish(graph, split.coefficients.entries()) => {
            diagnostics.report(&constraint.name, messages::constraint_without_acceleration(name));
            None
        }
        Ok(split) => {
            Some(RowKind::Acceleration { gradient: split.coefficients.row(0).to_vec(), bias: split.constant[0] })
        }
    }
}

fn all_vanish(graph: &Graph, entries: &[Expr]) -> bool {
    entries.iter().all(|entry| graph.vanishes(*entry))
}
