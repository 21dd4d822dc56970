//! What an expression is: a scalar, kept open as a sum, or a vector.

use super::geometry::Vector;
use super::names::Mentions;
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Rational};
use crate::syntax::{Diagnostics, Operator, messages};
use proc_macro2::Span;

/// An expression of the graph and what it mentions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lowered {
    pub expr: Expr,
    pub mentions: Mentions,
}

/// A sum is kept open until something else is done with it, so that a long one becomes one node.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Expr(Expr),
    Sum(Vec<(Rational, Expr)>),
    Vector(Vector),
}

/// A scalar or a vector, and what it mentions.
#[derive(Clone, Debug)]
pub(super) struct Valued {
    pub value: Value,
    pub mentions: Mentions,
}

impl From<Lowered> for Valued {
    fn from(lowered: Lowered) -> Self {
        Valued { value: Value::Expr(lowered.expr), mentions: lowered.mentions }
    }
}

impl Value {
    fn terms(self) -> Vec<(Rational, Expr)> {
        match self {
            Value::Expr(expr) => vec![(Rational::ONE, expr)],
            Value::Sum(terms) => terms,
            // Operations with vectors are apart.
            Value::Vector(_) => Vec::new(),
        }
    }

    pub fn plus(self, other: Value) -> Value {
        let mut terms = self.terms();
        terms.extend(other.terms());
        Value::Sum(terms)
    }

    pub fn scaled(self, factor: Rational) -> Value {
        let mut terms = self.terms();
        terms.iter_mut().for_each(|(coefficient, _)| *coefficient = coefficient.mul(&factor));
        Value::Sum(terms)
    }

    pub fn finish(self, graph: &mut Graph) -> Expr {
        match self {
            Value::Expr(expr) => expr,
            sum => graph.linear(Rational::ZERO, &sum.terms()),
        }
    }
}

impl Vocabulary<'_> {
    /// An operation of which one side at least is a vector.
    pub(super) fn of_vectors(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        span: Span,
        diagnostics: &mut Diagnostics,
    ) -> Option<Value> {
        let (graph, geometry) = (&mut self.graph, &self.geometry);
        let message = match (operator, left, right) {
            (Operator::Add, Value::Vector(a), Value::Vector(b)) => {
                return Some(Value::Vector(a.plus(&b, graph, geometry)));
            }
            (Operator::Subtract, Value::Vector(a), Value::Vector(b)) => {
                let back = b.negative(graph, geometry);
                return Some(Value::Vector(a.plus(&back, graph, geometry)));
            }
            (Operator::Multiply, Value::Vector(_), Value::Vector(_)) => messages::vector_times_vector(),
            (Operator::Multiply, left, right) => {
                let (vector, scalar) = match (left, right) {
                    (Value::Vector(vector), scalar) => (vector, scalar),
                    (scalar, Value::Vector(vector)) => (vector, scalar),
                    _ => return None,
                };
                let scalar = scalar.finish(graph);
                return Some(Value::Vector(vector.times(scalar, graph, geometry)));
            }
            (Operator::Divide, Value::Vector(vector), scalar) if !matches!(scalar, Value::Vector(_)) => {
                let scalar = scalar.finish(graph);
                if graph.vanishes(scalar) {
                    messages::division_by_zero()
                } else {
                    let one = graph.one();
                    let scale = graph.div(one, scalar);
                    return Some(Value::Vector(vector.times(scale, graph, geometry)));
                }
            }
            (Operator::Divide, ..) => messages::division_by_vector(),
            (Operator::Add | Operator::Subtract, ..) => messages::vector_plus_scalar(),
        };
        diagnostics.report(span, message);
        None
    }
}
