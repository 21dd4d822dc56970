//! Vector equations as rows: components along the axes of one frame.

use super::Vector;
use crate::model::names::Mentions;
use crate::model::value::{Value, Valued};
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::Expr;
use crate::syntax::{AXES, Constraint, Diagnostics, Place, messages};

/// The rows of a constraint, left minus right, with their names; `None` where something was reported.
pub(in crate::model) fn sides(
    constraint: &Constraint,
    left: Valued,
    right: Valued,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<(String, Expr, Mentions)>> {
    let mentions = left.mentions.and(right.mentions);
    let name = constraint.name.to_string();
    let zero =
        |value: &Value, vocabulary: &Vocabulary<'_>| matches!(value, Value::Expr(e) if vocabulary.graph.is_zero(*e));
    let (left, right) = match (left.value, right.value) {
        (Value::Vector(left), Value::Vector(right)) => (left, right),
        (Value::Vector(left), right) => match zero(&right, vocabulary) {
            true => (left, Vector::default()),
            false => {
                diagnostics.report(place_of_right(constraint), messages::scalar_equation_of_vector());
                return None;
            }
        },
        (left, Value::Vector(right)) => match zero(&left, vocabulary) {
            true => (Vector::default(), right),
            false => {
                diagnostics.report(place_of_right(constraint), messages::vector_equation_of_scalar());
                return None;
            }
        },
        (left, right) => {
            if constraint.expressed.is_some() {
                diagnostics.report(&constraint.name, messages::expressed_of_scalar(&name));
                return None;
            }
            let graph = &mut vocabulary.graph;
            let (left, right) = (left.finish(graph), right.finish(graph));
            return Some(vec![(name, graph.sub(left, right), mentions)]);
        }
    };
    let (graph, geometry) = (&mut vocabulary.graph, &vocabulary.geometry);
    let back = right.negative(graph, geometry);
    let vector = left.plus(&back, graph, geometry);
    let rows = components(constraint, &vector, mentions, vocabulary, diagnostics)?;
    if rows.is_empty() {
        diagnostics.report(&constraint.name, messages::vector_equation_empty(&name));
        return None;
    }
    Some(rows)
}

fn place_of_right(constraint: &Constraint) -> Place {
    constraint.right.as_ref().unwrap_or(&constraint.left).place()
}

/// The components of a vector that do not vanish, in the axes in which the constraint is expressed.
pub(super) fn components(
    constraint: &Constraint,
    vector: &Vector,
    mentions: Mentions,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<(String, Expr, Mentions)>> {
    let name = &constraint.name;
    let (frame, turning) = match &constraint.expressed {
        Some(frame) => {
            let frame = vocabulary.frame_named(&frame.to_string(), frame.span(), diagnostics)?;
            (frame, vocabulary.geometry.frames[frame].mentions)
        }
        None => (0, Mentions::NONE),
    };
    let (graph, geometry) = (&mut vocabulary.graph, &vocabulary.geometry);
    let components = vector.expressed(frame, graph, geometry).into_iter().zip(AXES);
    let rows: Vec<(String, Expr, Mentions)> =
        components.map(|(e, axis)| (format!("{name}_{axis}"), e, mentions.and(turning))).collect();
    Some(rows.into_iter().filter(|(_, e, _)| !vocabulary.vanishes(*e)).collect())
}
