//! Values over any scalar: one sweep, written once for every number type.

use super::{Expr, Function, Graph, Node, Rational, Symbol};

/// A number type in which expressions can be evaluated, together with what it needs to know.
pub trait Algebra {
    /// The values.
    type Value: Clone;
    /// An exact number.
    fn number(&mut self, value: &Rational) -> Self::Value;
    /// The value of a symbol.
    fn symbol(&mut self, symbol: Symbol) -> Self::Value;
    /// The sum of two values.
    fn add(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// The product of two values.
    fn mul(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// The reciprocal.
    fn recip(&mut self, a: &Self::Value) -> Self::Value;
    /// An elementary function.
    fn function(&mut self, function: Function, arguments: &[Self::Value]) -> Self::Value;
    /// An integer power.
    fn powi(&mut self, a: &Self::Value, exponent: i32) -> Self::Value {
        let mut result: Option<Self::Value> = None;
        let (mut square, mut n) = (a.clone(), exponent.unsigned_abs());
        while n > 0 {
            if n & 1 == 1 {
                result = Some(match result {
                    Some(r) => self.mul(&r, &square),
                    None => square.clone(),
                });
            }
            n >>= 1;
            if n > 0 {
                square = self.mul(&square.clone(), &square);
            }
        }
        match result {
            Some(r) if exponent < 0 => self.recip(&r),
            Some(r) => r,
            None => self.number(&Rational::ONE),
        }
    }
}

impl Graph {
    /// The values of the expressions in an algebra.
    pub fn evaluate_in<A: Algebra>(&self, expressions: &[Expr], algebra: &mut A) -> Vec<A::Value> {
        self.evaluate_further(expressions, algebra, &mut Vec::new())
    }

    /// [`Graph::evaluate_in`] with the values found before, by position in the arena, to which the new ones are added.
    pub(super) fn evaluate_further<A: Algebra>(
        &self,
        expressions: &[Expr],
        algebra: &mut A,
        values: &mut Vec<Option<A::Value>>,
    ) -> Vec<A::Value> {
        let order = self.reachable(expressions);
        let length = order.last().map_or(0, |e| e.index() + 1);
        values.resize_with(length.max(values.len()), || None);
        for e in order {
            if values[e.index()].is_none() {
                let value =
                    self.value_of(e, algebra, &|c: Expr| values[c.index()].clone().expect("children come first"));
                values[e.index()] = Some(value);
            }
        }
        expressions.iter().map(|e| values[e.index()].clone().expect("roots are reachable")).collect()
    }

    fn value_of<A: Algebra>(&self, e: Expr, algebra: &mut A, child: &dyn Fn(Expr) -> A::Value) -> A::Value {
        match self.node(e) {
            Node::Number(number) => algebra.number(number),
            Node::Symbol(symbol) => algebra.symbol(*symbol),
            Node::Sum { constant, terms } => {
                let mut total = (!constant.is_zero()).then(|| algebra.number(constant));
                for (coefficient, term) in terms {
                    let mut value = child(*term);
                    if !coefficient.is_one() {
                        let factor = algebra.number(coefficient);
                        value = algebra.mul(&factor, &value);
                    }
                    total = Some(match total {
                        Some(t) => algebra.add(&t, &value),
                        None => value,
                    });
                }
                total.expect("a sum has a term")
            }
            Node::Product(factors) => {
                let mut total: Option<A::Value> = None;
                for (base, exponent) in factors {
                    let mut value = child(*base);
                    if *exponent != 1 {
                        value = algebra.powi(&value, *exponent);
                    }
                    total = Some(match total {
                        Some(t) => algebra.mul(&t, &value),
                        None => value,
                    });
                }
                total.expect("a product has a factor")
            }
            Node::Function(function, arguments) => {
                let arguments: Vec<A::Value> = arguments.iter().map(|a| child(*a)).collect();
                algebra.function(*function, &arguments)
            }
        }
    }

    /// The values of the expressions in double precision; π is known, other symbols are asked for.
    pub fn evaluate(&self, expressions: &[Expr], values: &dyn Fn(Symbol) -> f64) -> Vec<f64> {
        self.evaluate_in(expressions, &mut Doubles { pi: self.pi_symbol(), values })
    }
}

struct Doubles<'a> {
    pi: Symbol,
    values: &'a dyn Fn(Symbol) -> f64,
}

impl Algebra for Doubles<'_> {
    type Value = f64;
    fn number(&mut self, value: &Rational) -> f64 {
        value.to_f64()
    }
    fn symbol(&mut self, symbol: Symbol) -> f64 {
        if symbol == self.pi { std::f64::consts::PI } else { (self.values)(symbol) }
    }
    fn add(&mut self, a: &f64, b: &f64) -> f64 {
        a + b
    }
    fn mul(&mut self, a: &f64, b: &f64) -> f64 {
        a * b
    }
    fn recip(&mut self, a: &f64) -> f64 {
        1.0 / a
    }
    fn function(&mut self, function: Function, arguments: &[f64]) -> f64 {
        double(function, arguments)
    }
}

/// An elementary function in double precision; one of the user's has no value here.
pub fn double(function: Function, arguments: &[f64]) -> f64 {
    match function {
        Function::Sin => arguments[0].sin(),
        Function::Cos => arguments[0].cos(),
        Function::Sqrt => arguments[0].sqrt(),
        Function::Atan2 => arguments[0].atan2(arguments[1]),
        Function::Exp => arguments[0].exp(),
        Function::Ln => arguments[0].ln(),
        Function::Asin => arguments[0].asin(),
        Function::Acos => arguments[0].acos(),
        Function::Atan => arguments[0].atan(),
        Function::Sinh => arguments[0].sinh(),
        Function::Cosh => arguments[0].cosh(),
        Function::Tanh => arguments[0].tanh(),
        Function::Whole => arguments[0],
        Function::Abs => arguments[0].abs(),
        Function::Sign if arguments[0] == 0.0 || arguments[0].is_nan() => arguments[0],
        Function::Sign => arguments[0].signum(),
        Function::Power => arguments[0].powf(arguments[1]),
        Function::Given(_) => f64::NAN,
        Function::Select if arguments[0].is_nan() => arguments[0],
        Function::Select => arguments[if arguments[0] < 0.0 { 1 } else { 2 }],
    }
}
