//! From an expression as written to an expression of the graph.

use proc_macro2::Span;
use quote::ToTokens;

use super::context::Context;
use super::functions::Call;
use super::geometry::{Geometry, Released, VECTOR_FUNCTIONS, Vector, VectorCall, names_a_body};
use super::names::{Meaning, Mentions, Names};
use crate::symbolic::{Expr, Function, Graph, Kind, Rational, Symbol};
use crate::syntax::{Comparison, Declarations, Diagnostics, Expression, Operator, Term, messages};

/// An expression of the graph and what it mentions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lowered {
    pub expr: Expr,
    pub mentions: Mentions,
}

/// The symbols of a model, by their names.
pub(super) struct Vocabulary<'a> {
    pub declarations: &'a Declarations,
    pub graph: Graph,
    pub names: Names,
    pub time: Symbol,
    /// One for each field; only scalar ones are ever used.
    pub fields: Vec<Symbol>,
    /// Which fields some expression mentions.
    pub used: Vec<bool>,
    pub coordinates: Vec<Symbol>,
    pub further: Vec<Symbol>,
    pub speeds: Vec<Symbol>,
    /// The rates of the initial coordinates; the speeds themselves where these have no names.
    pub rates: Vec<Symbol>,
    /// The rates of the speeds.
    pub accelerations: Vec<Symbol>,
    /// The second rates of the initial coordinates; the rates of the speeds themselves where these have no names.
    pub second_rates: Vec<Symbol>,
    /// The rates of `further`; those that nothing has mentioned come with the configuration.
    pub further_rates: Vec<Option<Symbol>>,
    /// The quasi-velocities of the configuration.
    pub quasi: Vec<Symbol>,
    /// The independent speeds of `velocities(of(..))`.
    pub free: Vec<Symbol>,
    /// The combinations of speeds of `independent(s = ..)`, through all lists.
    pub combinations: Vec<Symbol>,
    /// The second rates of `further`, where something has mentioned them.
    pub further_accelerations: Vec<Option<Symbol>>,
    /// The rates of the quasi-velocities, where something has mentioned them.
    pub quasi_rates: Vec<Option<Symbol>>,
    pub inputs: Vec<Symbol>,
    /// The reactions that are mentioned, by the names of their rows, and where they are first.
    pub reactions: Vec<(String, Symbol, Span)>,
    /// The outputs that are lowered so far; without a value where that failed.
    pub outputs: Vec<(String, Option<Lowered>)>,
    /// The functions of the user's.
    pub functions: Vec<Function>,
    /// `None` before a define is lowered, and where that failed.
    pub defines: Vec<Option<Valued>>,
    /// Frames, points and bodies.
    pub geometry: Geometry,
    /// What is released, in the order of the model's releases.
    pub released: Vec<Released>,
    /// The generalised forces on rates that are no speeds: the coordinate and the force.
    pub forces_on_rates: Vec<(usize, Expr)>,
}

impl<'a> Vocabulary<'a> {
    pub fn new(declarations: &'a Declarations, names: Names) -> Self {
        let mut graph = Graph::new();
        let time = graph.symbol("t", Kind::Time);
        let mut symbols =
            |names: Vec<String>, kind| -> Vec<Symbol> { names.iter().map(|name| graph.symbol(name, kind)).collect() };
        let of = |names: &[crate::syntax::Name]| names.iter().map(|name| name.ident.to_string()).collect::<Vec<_>>();
        let coordinate_names = of(&declarations.coordinates);
        let rate_names = |format: fn(&String) -> String| coordinate_names.iter().map(format).collect::<Vec<_>>();
        let fields = symbols(declarations.fields.iter().map(|f| f.ident.to_string()).collect(), Kind::Parameter);
        let coordinates = symbols(coordinate_names.clone(), Kind::Coordinate);
        let further = match &declarations.configuration {
            Some(configuration) => symbols(of(&configuration.further), Kind::Coordinate),
            None => Vec::new(),
        };
        let second_rates = symbols(rate_names(|x| format!("ddot({x})")), Kind::Speed);
        let (speeds, rates, accelerations) = match &declarations.speeds {
            Some(speeds) => {
                let names = of(&speeds.names);
                let accelerations = names.iter().map(|v| format!("dot({v})")).collect();
                let speeds = symbols(names, Kind::Speed);
                let rates = symbols(rate_names(|x| format!("dot({x})")), Kind::Speed);
                (speeds, rates, symbols(accelerations, Kind::Speed))
            }
            None => {
                let speeds = symbols(rate_names(|x| format!("dot_{x}")), Kind::Speed);
                (speeds.clone(), speeds, second_rates.clone())
            }
        };
        let inputs = symbols(of(&declarations.inputs), Kind::Input);
        let quasi = declarations.configuration.as_ref().map_or(Vec::new(), |c| symbols(of(&c.speeds), Kind::Speed));
        let free = declarations.velocities.as_ref().map_or(Vec::new(), |v| symbols(of(&v.further), Kind::Speed));
        let combined = declarations.independent.iter().flat_map(|list| list.combinations());
        let combinations = symbols(combined.map(|(name, _)| name.ident.to_string()).collect(), Kind::Speed);
        let functions = declarations.functions.iter().map(|function| {
            let names: Vec<String> = function.orders.iter().map(last_name).collect();
            graph.give(&names)
        });
        let functions = functions.collect();
        let geometry = Geometry::new(&graph, declarations);
        let released = declarations.geometry.releases().map(|release| Released::new(release, &mut graph)).collect();
        Vocabulary {
            declarations,
            graph,
            names,
            time,
            used: vec![false; fields.len()],
            fields,
            coordinates,
            further_rates: vec![None; further.len()],
            further_accelerations: vec![None; further.len()],
            quasi_rates: vec![None; quasi.len()],
            further,
            speeds,
            rates,
            accelerations,
            second_rates,
            quasi,
            free,
            combinations,
            inputs,
            reactions: Vec::new(),
            outputs: Vec::new(),
            functions,
            defines: vec![None; declarations.defines.len()],
            geometry,
            released,
            forces_on_rates: Vec::new(),
        }
    }

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

    /// An operation of which one side at least is a vector.
    fn of_vectors(
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

/// The last segment of a path.
fn last_name(path: &syn::Path) -> String {
    path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default()
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

    fn plus(self, other: Value) -> Value {
        let mut terms = self.terms();
        terms.extend(other.terms());
        Value::Sum(terms)
    }

    fn scaled(self, factor: Rational) -> Value {
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
