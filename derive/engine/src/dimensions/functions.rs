//! The dimensions of calls.

use super::Checker;
use super::dimension::Dimension;
use super::expressions::{Value, place_of};
use super::report::Side;
use crate::symbolic::Rational;
use crate::syntax::{Expression, Term, messages};

/// Functions of a pure number that are one.
const PURE: [&str; 11] = ["sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "ln"];

/// What is rated by its name is the rate of a symbol.
pub fn is_rate(function: &str, arguments: usize) -> bool {
    arguments == 1 && matches!(function, "dot" | "ddot")
}

impl Checker<'_> {
    pub fn call(
        &mut self,
        expression: &Expression,
        at: usize,
        function: &str,
        arguments: &[usize],
        values: &[Value],
    ) -> Value {
        let place = expression.terms()[at].1.into();
        let name = |argument: usize| match &expression.terms()[argument].0 {
            Term::Name(name) => name.as_str(),
            _ => "",
        };
        let value = |of: usize| values[of].dimension.clone();
        let map = |of: usize, f: &dyn Fn(Dimension) -> Dimension| Value {
            dimension: values[of].dimension.clone().map(f),
            constant: None,
        };
        let time = self.time.clone();
        match (function, arguments) {
            ("dot", [of]) => Value::of(self.rate_of(name(*of))),
            ("ddot", [of]) => Value::of(self.rate_of(name(*of)).over(&time)),
            ("reaction", [of]) => Value::of(self.reaction(name(*of))),
            ("dot" | "cross", [a, b]) => match (value(*a), value(*b)) {
                (Some(a), Some(b)) => Value::of(a.times(&b)),
                _ => Value::default(),
            },
            (function, [of]) if PURE.contains(&function) => {
                if let Some(dimension) = value(*of) {
                    let side = Side { dimension, part: Some((expression, *of)) };
                    let message = |found, hint| messages::dimension_argument(function, found, hint);
                    self.pure(place_of(expression, *of), &side, message);
                }
                Value::of(Dimension::pure())
            }
            ("sign" | "unit", [_]) => Value::of(Dimension::pure()),
            ("abs" | "norm", [of]) => map(*of, &|dimension| dimension),
            ("sqrt", [of]) => map(*of, &|dimension| match Rational::fraction(1, 2) {
                Some(half) => dimension.power(&half),
                None => dimension,
            }),
            ("min" | "max", [a, b]) => self.same(expression, [*a, *b], values, "compared with", place),
            ("atan2", [a, b]) => {
                self.same(expression, [*a, *b], values, "over", place);
                Value::of(Dimension::pure())
            }
            ("powi" | "powf", [base, exponent]) => self.power_of(expression, [*base, *exponent], values),
            ("velocity", [of, ..]) => map(*of, &|dimension| dimension.over(&time)),
            ("acceleration", [of]) => map(*of, &|dimension| dimension.over(&time.powi(2))),
            ("angular_velocity", [_]) => Value::of(time.powi(-1)),
            ("angular_acceleration", [_]) => Value::of(time.powi(-2)),
            ("momentum", [_]) => Value::of(self.mass.times(&self.length).over(&time)),
            ("angular_momentum", [_, about]) => {
                if let Some(dimension) = value(*about) {
                    let side = Side { dimension, part: Some((expression, *about)) };
                    let length = self.length.clone();
                    self.expect(place_of(expression, *about), "a point", &side, &length);
                }
                Value::of(self.mass.times(&self.length.powi(2)).over(&time))
            }
            (function, [of]) => match self.functions.get(function).cloned() {
                Some([argument, result]) => {
                    if let Some(dimension) = value(*of) {
                        let what = format!("the argument of `{function}`");
                        let side = Side { dimension, part: Some((expression, *of)) };
                        self.expect(place_of(expression, *of), &what, &side, &argument);
                    }
                    Value::of(result)
                }
                None => Value::of(self.solver.fresh()),
            },
            _ => Value::of(self.solver.fresh()),
        }
    }

    /// A power: constant exponents scale, others need pure numbers.
    fn power_of(&mut self, expression: &Expression, [base, exponent]: [usize; 2], values: &[Value]) -> Value {
        let Some(of_base) = values[base].dimension.clone() else {
            // Powers of 0, of which the zeroth is one.
            return if values[exponent].constant.as_ref().is_some_and(|exponent| !exponent.is_zero()) {
                Value::default()
            } else {
                Value::of(Dimension::pure())
            };
        };
        if let Some(constant) = &values[exponent].constant {
            return Value::of(of_base.power(constant));
        }
        if let Some(dimension) = values[exponent].dimension.clone() {
            let side = Side { dimension, part: Some((expression, exponent)) };
            self.expect(place_of(expression, exponent), "an exponent", &side, &Dimension::pure());
        }
        if matches!(&expression.terms()[exponent].0, Term::Hole) {
            return Value::of(self.solver.fresh());
        }
        let side = Side { dimension: of_base, part: Some((expression, base)) };
        self.pure(place_of(expression, base), &side, messages::dimension_of_base);
        Value::of(Dimension::pure())
    }
}
