//! From an expression as written to an expression of the graph.

use proc_macro2::Span;
use quote::ToTokens;

use super::context::Context;
use super::functions::Call;
use super::geometry::{VECTOR_FUNCTIONS, Vector, VectorCall, names_a_body};
use super::names::{Meaning, Mentions};
use super::value::{Lowered, Value, Valued};
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Rational, Symbol};
use crate::syntax::{Comparison, Diagnostics, Expression, Operator, Term, messages, names_a_joint};

impl Vocabulary<'_> {
    /// A scalar in the graph. `None` where something in it was reported, now or before.
    pub fn lower(
        &mut self,
        expression: &Expression,
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<Lowered> {
        let Valued { value, mentions } = self.value(expression, context, diagnostics)?;
        match value {
            Value::Vector(_) => {
                diagnostics.report(expression.place(), messages::scalar_expected());
                None
            }
            value => Some(Lowered { expr: value.finish(&mut self.graph), mentions }),
        }
    }

    /// An expression with all releases held.
    pub fn held(&mut self, e: Expr) -> Expr {
        let graph = &mut self.graph;
        let zeros: Vec<(Symbol, Expr)> = self.released.iter().flat_map(|released| released.zeros(graph)).collect();
        if zeros.is_empty() { e } else { graph.substitute(&[e], &zeros)[0] }
    }

    /// Whether an expression vanishes while all releases are held.
    pub fn vanishes(&mut self, e: Expr) -> bool {
        let held = self.held(e);
        self.graph.vanishes(held)
    }

    /// A scalar with all releases held.
    pub fn lower_held(
        &mut self,
        expression: &Expression,
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<Lowered> {
        let lowered = self.lower(expression, context, diagnostics)?;
        Some(Lowered { expr: self.held(lowered.expr), ..lowered })
    }

    /// A vector; 0 stands for one.
    pub fn lower_vector(
        &mut self,
        expression: &Expression,
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<(Vector, Mentions)> {
        let Valued { value, mentions } = self.value(expression, context, diagnostics)?;
        match value {
            Value::Vector(vector) => Some((vector, mentions)),
            value => {
                let scalar = value.finish(&mut self.graph);
                if !self.graph.is_zero(scalar) {
                    diagnostics.report(expression.place(), messages::a_vector_expected());
                    return None;
                }
                Some((Vector::default(), mentions))
            }
        }
    }

    /// A scalar or a vector.
    pub fn value(
        &mut self,
        expression: &Expression,
        context: Context,
        diagnostics: &mut Diagnostics,
    ) -> Option<Valued> {
        let terms = expression.terms();
        let mut mentions = Mentions::NONE;
        let mut values: Vec<Option<Value>> = Vec::with_capacity(terms.len());
        // `dot` and `reaction` take the name itself, not its value.
        let mut named = vec![false; terms.len()];
        for (term, _) in terms {
            if let Term::Call(function, arguments) = term {
                let whole = takes_a_name(function, arguments.len());
                let taken = arguments.iter().enumerate().filter(|(i, _)| whole || names_a_body(function, *i));
                taken.for_each(|(_, argument)| named[*argument] = true);
            }
        }
        for (at, (term, span)) in terms.iter().enumerate() {
            let value = match term {
                Term::Hole => None,
                Term::Number(number) => Some(Value::Expr(self.graph.number(number.clone()))),
                Term::Name(_) if named[at] => None,
                Term::Name(name) => {
                    let found = self.name(name, *span, context, diagnostics);
                    mentions |= found.as_ref().map_or(Mentions::NONE, |found| found.mentions);
                    found.map(|found| found.value)
                }
                Term::Axis(name, axis) => {
                    let found = self.frame_axis(name, *axis, *span, diagnostics);
                    let found = found.filter(|(_, mentioned)| {
                        let beyond = mentioned.beyond(context.allowed);
                        if beyond != Mentions::NONE {
                            let what = beyond.describe();
                            diagnostics.report(*span, messages::frame_out_of_place(name, what, context.rule));
                        }
                        beyond == Mentions::NONE
                    });
                    mentions |= found.as_ref().map_or(Mentions::NONE, |(_, mentions)| *mentions);
                    found.map(|(vector, _)| Value::Vector(vector))
                }
                Term::Negative(of) => match take(&mut values, *of) {
                    Some(Value::Vector(of)) => Some(Value::Vector(of.negative(&mut self.graph, &self.geometry))),
                    of => of.map(|of| of.scaled(Rational::MINUS_ONE)),
                },
                Term::Binary(operator, left, right) => {
                    let right = take(&mut values, *right);
                    let left = take(&mut values, *left);
                    match (operator, left, right) {
                        (_, Some(left @ Value::Vector(_)), Some(right))
                        | (_, Some(left), Some(right @ Value::Vector(_))) => {
                            self.of_vectors(*operator, left, right, *span, diagnostics)
                        }
                        (Operator::Divide, left, Some(right)) => {
                            let right = right.finish(&mut self.graph);
                            if self.graph.vanishes(right) {
                                diagnostics.report(*span, messages::division_by_zero());
                                None
                            } else {
                                left.map(|left| {
                                    let left = left.finish(&mut self.graph);
                                    Value::Expr(self.graph.div(left, right))
                                })
                            }
                        }
                        (_, None, _) | (_, _, None) => None,
                        (Operator::Add, Some(left), Some(right)) => Some(left.plus(right)),
                        (Operator::Subtract, Some(left), Some(right)) => {
                            Some(left.plus(right.scaled(Rational::MINUS_ONE)))
                        }
                        (_, Some(left), Some(right)) => {
                            let (left, right) = (left.finish(&mut self.graph), right.finish(&mut self.graph));
                            Some(Value::Expr(self.graph.mul(left, right)))
                        }
                    }
                }
                Term::If(comparison, operands) => {
                    let parts = operands.map(|at| take(&mut values, at));
                    if parts.iter().flatten().any(|value| matches!(value, Value::Vector(_))) {
                        diagnostics.report(*span, messages::branch_of_vectors());
                        values.push(None);
                        continue;
                    }
                    let [left, right, then, other] =
                        parts.map(|value| value.map(|value| value.finish(&mut self.graph)));
                    match (left, right, then, other) {
                        (Some(left), Some(right), Some(then), Some(other)) => {
                            Some(Value::Expr(self.choose(*comparison, [left, right], [then, other])))
                        }
                        _ => None,
                    }
                }
                Term::Call(function, arguments) if is_vector_function(function, arguments.len()) => {
                    let taken = arguments.iter().map(|argument| take(&mut values, *argument)).collect();
                    let call = VectorCall { function, span: *span, arguments, terms };
                    let found = call.lower(taken, mentions, context, self, diagnostics);
                    mentions |= found.as_ref().map_or(Mentions::NONE, |(_, mentions)| *mentions);
                    found.map(|(value, _)| value)
                }
                Term::Call(function, arguments) if named_function(function) => {
                    let lowered = self.dot(function, *span, arguments, terms, context, diagnostics);
                    mentions |= lowered.map_or(Mentions::NONE, |lowered| lowered.mentions);
                    lowered.map(|lowered| Value::Expr(lowered.expr))
                }
                Term::Call(function, arguments) if function == "reaction" => {
                    let lowered = self.reaction(*span, arguments, terms, context, diagnostics);
                    mentions |= lowered.map_or(Mentions::NONE, |lowered| lowered.mentions);
                    lowered.map(|lowered| Value::Expr(lowered.expr))
                }
                Term::Call(function, _) if names_a_joint(function) && self.names.get(function).is_none() => {
                    diagnostics.report(*span, messages::joint_out_of_place(function));
                    None
                }
                Term::Call(function, arguments) => {
                    let taken: Vec<Option<Value>> =
                        arguments.iter().map(|argument| take(&mut values, *argument)).collect();
                    if taken.iter().flatten().any(|value| matches!(value, Value::Vector(_))) {
                        diagnostics.report(*span, messages::vector_argument(function));
                        values.push(None);
                        continue;
                    }
                    let values: Vec<Option<Expr>> =
                        taken.into_iter().map(|value| value.map(|value| value.finish(&mut self.graph))).collect();
                    let call = Call { function, span: *span, count: arguments.len() };
                    call.lower(&values, self, diagnostics).map(Value::Expr)
                }
            };
            values.push(value);
        }
        Some(Valued { value: values.pop()??, mentions })
    }

    /// `if left < right { then } else { other }`, and the same with `<=`, as a selection by the sign of a difference.
    fn choose(&mut self, comparison: Comparison, [left, right]: [Expr; 2], [then, other]: [Expr; 2]) -> Expr {
        let graph = &mut self.graph;
        match comparison {
            Comparison::Less => {
                let difference = graph.sub(left, right);
                graph.select(difference, then, other)
            }
            Comparison::AtMost => {
                let difference = graph.sub(right, left);
                graph.select(difference, other, then)
            }
        }
    }

    /// A name and what it mentions, if that may occur here.
    fn name(&mut self, name: &str, span: Span, context: Context, diagnostics: &mut Diagnostics) -> Option<Valued> {
        let Some(meaning) = self.names.get(name) else {
            if context.allowed.intersects(Mentions::OUTPUTS)
                && self.declarations.outputs.iter().any(|output| output.name.ident == name)
            {
                return self.output(name, span, diagnostics).map(Valued::from);
            }
            diagnostics.report(span, self.names.unknown(name));
            return None;
        };
        let (symbol, mentions) = match meaning {
            Meaning::Field(i) => {
                let field = &self.declarations.fields[i];
                if !field.scalar {
                    let ty = field.ty.to_token_stream();
                    diagnostics.report(span, messages::field_not_scalar(name, ty));
                    return None;
                }
                if name.starts_with("r#") {
                    diagnostics.report(span, messages::raw_identifier(name));
                    return None;
                }
                self.used[i] = true;
                (self.fields[i], Mentions::PARAMETERS)
            }
            Meaning::Coordinate(i) => (self.coordinates[i], Mentions::COORDINATES),
            Meaning::Further(i) => (self.further[i], Mentions::FURTHER),
            Meaning::Speed(i) => (self.speeds[i], Mentions::SPEEDS),
            Meaning::Quasi(i) => (self.quasi[i], Mentions::QUASI),
            Meaning::Free(i) => (self.free[i], Mentions::FREE),
            Meaning::Combination(i) => (self.combinations[i], Mentions::COMBINATIONS),
            Meaning::Input(i) => (self.inputs[i], Mentions::INPUTS),
            Meaning::Time => (self.time, Mentions::TIME),
            Meaning::Pi => (self.graph.pi_symbol(), Mentions::NONE),
            Meaning::Function(_) => {
                diagnostics.report(span, messages::function_as_name(name));
                return None;
            }
            Meaning::Inertial | Meaning::Frame(_) => {
                diagnostics.report(span, messages::frame_as_value(name));
                return None;
            }
            Meaning::Body(_) => {
                diagnostics.report(span, messages::body_as_value(name));
                return None;
            }
            Meaning::Acting(_) => {
                diagnostics.report(span, messages::element_as_value(name, meaning.describe()));
                return None;
            }
            Meaning::Origin => {
                return Some(Valued { value: Value::Vector(Vector::default()), mentions: Mentions::NONE });
            }
            Meaning::Point(i) => {
                let (place, mentions) = self.geometry.named_points[i]?;
                let beyond = mentions.beyond(context.allowed);
                if beyond != Mentions::NONE {
                    let what = beyond.describe();
                    diagnostics.report(span, messages::point_out_of_place(name, what, context.rule));
                    return None;
                }
                let vector = Vector { from: place, parts: Vec::new() };
                return Some(Valued { value: Value::Vector(vector), mentions });
            }
            Meaning::Define(i) => {
                let define = self.defines[i].clone()?;
                let beyond = define.mentions.beyond(context.allowed);
                if beyond != Mentions::NONE {
                    let contains = beyond.describe();
                    diagnostics.report(span, messages::define_out_of_place(name, contains, context.rule));
                    return None;
                }
                return Some(define);
            }
        };
        if mentions.beyond(context.allowed) != Mentions::NONE {
            let what = mentions.describe();
            diagnostics.report(span, messages::out_of_place(name, what, context.rule));
            return None;
        }
        Some(Valued { value: Value::Expr(self.graph.var(symbol)), mentions })
    }
}

/// Functions that take the name of a coordinate or of a speed.
pub(super) fn named_function(function: &str) -> bool {
    matches!(function, "dot" | "ddot")
}

/// Whether the arguments are names and no values.
fn takes_a_name(function: &str, arguments: usize) -> bool {
    function == "reaction" || (named_function(function) && !is_vector_function(function, arguments))
}

/// Whether the arguments are vectors: `dot` with two is the scalar product.
fn is_vector_function(function: &str, arguments: usize) -> bool {
    (function == "dot" && arguments == 2) || VECTOR_FUNCTIONS.iter().any(|(name, _)| *name == function)
}

/// Every term but the last is an operand exactly once.
fn take(values: &mut [Option<Value>], at: usize) -> Option<Value> {
    values[at].take()
}
