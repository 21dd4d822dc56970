//! Constraints, sorted by what they bind.

use super::context::Context;
use super::linear;
use super::lower::Vocabulary;
use super::names::Mentions;
use super::system::{Row, RowKind};
use crate::symbolic::{Expr, Symbol};
use crate::syntax::{Constraint, Diagnostics, messages};

/// A row as written: left minus right, rates not yet replaced.
pub(super) struct Written<'a> {
    constraint: &'a Constraint,
    expr: Expr,
    is_velocity: bool,
}

/// Lowers every constraint; those with errors are left out.
pub(super) fn lower<'a>(vocabulary: &mut Vocabulary<'a>, diagnostics: &mut Diagnostics) -> Vec<Written<'a>> {
    let mut written = Vec::new();
    let mut names: Vec<String> = Vec::new();
    for constraint in &vocabulary.declarations.constraints {
        let name = constraint.name.to_string();
        if names.contains(&name) {
            diagnostics.report(&constraint.name, messages::constraint_twice(&name));
        }
        let left = vocabulary.lower(&constraint.left, Context::CONSTRAINT, diagnostics);
        let right = vocabulary.lower(&constraint.right, Context::CONSTRAINT, diagnostics);
        if let (Some(left), Some(right)) = (left, right) {
            let mentions = left.mentions.and(right.mentions);
            let is_velocity = mentions.intersects(Mentions::SPEEDS.and(Mentions::RATES));
            if is_velocity || mentions.intersects(Mentions::COORDINATES) {
                let expr = vocabulary.graph.sub(left.expr, right.expr);
                written.push(Written { constraint, expr, is_velocity });
            } else {
                diagnostics.report(&constraint.name, messages::constraint_without_variable(&name));
            }
        }
        names.push(name);
    }
    written
}

/// The rows over x, v and t; `rates` replaces `dot(x)` by A v + a0.
pub(super) fn finish(
    written: &[Written<'_>],
    rates: &[(Symbol, Expr)],
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<Row> {
    let graph = &mut vocabulary.graph;
    let mut rows = Vec::new();
    for Written { constraint, expr, is_velocity } in written {
        let name = constraint.name.to_string();
        // Speeds without names are written as rates.
        let unnamed = vocabulary.declarations.speeds.is_none();
        let kind = if *is_velocity {
            let phi = graph.substitute(&[*expr], rates)[0];
            match linear::split(graph, &[phi], &vocabulary.speeds) {
                Err(refused) => {
                    for nonlinear in refused {
                        let variable = graph.name(nonlinear.variable);
                        let variable = match variable.strip_prefix("dot_") {
                            Some(of) if unnamed => format!("dot({of})"),
                            _ => variable.to_owned(),
                        };
                        diagnostics.report(&constraint.name, messages::constraint_not_linear(&name, variable));
                    }
                    continue;
                }
                Ok(split) if split.coefficients.entries().iter().all(|entry| graph.vanishes(*entry)) => {
                    diagnostics.report(&constraint.name, messages::constraint_without_speed(&name));
                    continue;
                }
                Ok(_) => RowKind::Velocity(phi),
            }
        } else {
            let gradient = graph.jacobian(&[*expr], &vocabulary.coordinates);
            if gradient.entries().iter().all(|entry| graph.vanishes(*entry)) {
                diagnostics.report(&constraint.name, messages::constraint_without_variable(&name));
                continue;
            }
            RowKind::Position(*expr)
        };
        rows.push(Row { name, span: constraint.name.span(), kind });
    }
    rows
}
