//! The rules of expressions, term by term in postfix order.

use super::Checker;
use super::dimension::Dimension;
use super::report::Side;
use crate::symbolic::Rational;
use crate::syntax::{Expression, Operator, Place, Term};

/// What a term is; no dimension where it fits anything: the number 0, and what is no value.
#[derive(Clone, Debug, Default)]
pub struct Value {
    pub dimension: Option<Dimension>,
    pub constant: Option<Rational>,
}

impl Value {
    pub fn of(dimension: Dimension) -> Self {
        Value { dimension: Some(dimension), constant: None }
    }

    fn number(number: Rational) -> Self {
        let dimension = (!number.is_zero()).then(Dimension::pure);
        Value { dimension, constant: Some(number) }
    }
}

impl Checker<'_> {
    /// The dimension of an expression; `None` where it fits anything. Vectors have one as scalars have.
    pub fn dimension(&mut self, expression: &Expression) -> Option<Dimension> {
        self.value(expression).dimension
    }

    pub fn value(&mut self, expression: &Expression) -> Value {
        let mut values: Vec<Value> = Vec::with_capacity(expression.terms().len());
        for at in 0..expression.terms().len() {
            let value = self.term(expression, at, &values);
            values.push(value);
        }
        values.pop().unwrap_or_default()
    }

    /// The number that an expression of numbers is.
    pub fn constant(&self, expression: &Expression) -> Option<Rational> {
        let mut values: Vec<Value> = Vec::with_capacity(expression.terms().len());
        for (term, _) in expression.terms() {
            let constant = match term {
                Term::Number(number) => Some(number.clone()),
                Term::Name(name) => self.table.get(name).and_then(|entry| entry.constant.clone()),
                Term::Negative(of) => values[*of].constant.as_ref().map(Rational::neg),
                Term::Binary(operator, left, right) => folded(*operator, &values[*left], &values[*right]),
                _ => None,
            };
            values.push(Value { dimension: None, constant: Some(constant?) });
        }
        values.pop()?.constant
    }

    fn term(&mut self, expression: &Expression, at: usize, values: &[Value]) -> Value {
        let (term, span) = &expression.terms()[at];
        match term {
            Term::Hole => Value::of(self.solver.fresh()),
            Term::Number(number) => Value::number(number.clone()),
            Term::Axis(..) => Value::of(Dimension::pure()),
            Term::Name(name) => self.name(name),
            Term::Negative(of) => {
                let Value { dimension, constant } = values[*of].clone();
                Value { dimension, constant: constant.map(|number| number.neg()) }
            }
            Term::Binary(operator, left, right) => {
                let (a, b) = (&values[*left], &values[*right]);
                if let Some(number) = folded(*operator, a, b) {
                    // A number is what comes of numbers, 0 too.
                    return Value::number(number);
                }
                match (operator, &a.dimension, &b.dimension) {
                    (Operator::Add | Operator::Subtract, Some(_), Some(_)) => {
                        let relation = if *operator == Operator::Add { "plus" } else { "minus" };
                        self.same(expression, [*left, *right], values, relation, (*span).into())
                    }
                    (Operator::Add | Operator::Subtract, one, None)
                    | (Operator::Add | Operator::Subtract, None, one) => {
                        Value { dimension: one.clone(), constant: None }
                    }
                    (Operator::Multiply, Some(a), Some(b)) => Value::of(a.times(b)),
                    (Operator::Divide, Some(a), Some(b)) => Value::of(a.over(b)),
                    _ => Value::default(),
                }
            }
            Term::If(_, [left, right, then, other]) => {
                self.same(expression, [*left, *right], values, "compared with", (*span).into());
                let relation = "in one branch and, in the other,";
                self.same(expression, [*then, *other], values, relation, (*span).into())
            }
            Term::Call(function, arguments) => self.call(expression, at, function, arguments, values),
        }
    }

    /// What a name stands for; outputs where it is nobody else's.
    fn name(&mut self, name: &str) -> Value {
        if let Some(entry) = self.table.get(name) {
            return match &entry.constant {
                Some(number) => Value::number(number.clone()),
                None => Value::of(entry.dimension.clone()),
            };
        }
        match self.table.outputs.get(name) {
            Some(dimension) => Value::of(dimension.clone()),
            None => Value::of(self.solver.fresh()),
        }
    }

    /// Two parts of an expression that have one dimension.
    pub fn same(
        &mut self,
        expression: &Expression,
        [left, right]: [usize; 2],
        values: &[Value],
        relation: &str,
        place: Place,
    ) -> Value {
        match (&values[left].dimension, &values[right].dimension) {
            (Some(a), Some(b)) => {
                let side =
                    |dimension: &Dimension, at| Side { dimension: dimension.clone(), part: Some((expression, at)) };
                let fits = self.equal(place, &side(a, left), relation, &side(b, right));
                // What does not fit has been told, and tells nothing further.
                if fits { Value::of(a.clone()) } else { Value::of(self.solver.fresh()) }
            }
            (one, None) | (None, one) => Value { dimension: one.clone(), constant: None },
        }
    }

    /// An expression that has the dimension which it must have.
    pub fn expected(&mut self, expression: &Expression, what: &str, expected: &Dimension) {
        if let Some(dimension) = self.dimension(expression) {
            self.expect(expression.place(), what, &Side::whole(dimension, expression), expected);
        }
    }
}

/// So large may the parts of a number be that is still looked at.
const BITS: u64 = 64;

fn folded(operator: Operator, left: &Value, right: &Value) -> Option<Rational> {
    let (a, b) = (left.constant.as_ref()?, right.constant.as_ref()?);
    let folded = match operator {
        Operator::Add => a.add(b),
        Operator::Subtract => a.add(&b.neg()),
        Operator::Multiply => a.mul(b),
        Operator::Divide => a.mul(&b.recip()?),
    };
    (folded.bits() <= BITS).then_some(folded)
}

/// From the first token of a part to the last one that is known.
pub fn place_of(expression: &Expression, at: usize) -> Place {
    let terms = expression.terms();
    let (mut first, mut last) = (at, at);
    while let Term::Binary(_, left, _) = &terms[first].0 {
        first = *left;
    }
    loop {
        last = match &terms[last].0 {
            Term::Binary(_, _, right) => *right,
            Term::Negative(of) => *of,
            Term::Call(_, arguments) if !arguments.is_empty() => arguments[arguments.len() - 1],
            Term::If(_, parts) => parts[3],
            _ => return Place::between(terms[first].1, terms[last].1),
        };
    }
}
