//! Canonical elementary functions.

use super::{Expr, Function, Graph, Node, Rational, Stage};

/// Exponents up to this magnitude are multiplied out.
const LARGEST_POWER: i64 = 999;

impl Graph {
    /// A function of its arguments, in canonical form.
    pub fn function(&mut self, function: Function, arguments: &[Expr]) -> Expr {
        match (function, arguments) {
            (Function::Sin, [a]) => self.sin(*a),
            (Function::Cos, [a]) => self.cos(*a),
            (Function::Sqrt, [a]) => self.sqrt(*a),
            (Function::Exp, [a]) if self.is_zero(*a) => self.one(),
            (Function::Ln, [a]) if self.is_one(*a) => self.zero(),
            (Function::Asin | Function::Acos | Function::Atan, [a]) => self.arc(function, *a),
            (Function::Sinh | Function::Cosh | Function::Tanh, [a]) => self.hyperbolic(function, *a),
            (Function::Abs, [a]) => self.abs(*a),
            (Function::Sign, [a]) => self.sign(*a),
            (Function::Whole, [a]) => self.whole(*a),
            (Function::Power, [a, b]) => self.powf(*a, *b),
            (Function::Select, [condition, negative, other]) => self.select(*condition, *negative, *other),
            _ => self.intern(Node::Function(function, arguments.into())),
        }
    }

    /// The same quantity, of which nothing that is made of it sees the inside: what a recursion passes on is not written out again
    /// at every step. Only sums that change along the motion need it.
    pub fn whole(&mut self, e: Expr) -> Expr {
        let (constant, terms) = self.as_sum(e);
        let several = terms.len() + usize::from(!constant.is_zero()) > 1;
        match several && self.stage(e) > Stage::Parameter {
            true => self.odd(Function::Whole, e),
            false => e,
        }
    }

    /// Sine: odd in its argument, exact at multiples of π/2.
    pub fn sin(&mut self, angle: Expr) -> Expr {
        self.sine(angle, 0)
    }

    /// Cosine: even in its argument, exact at multiples of π/2.
    pub fn cos(&mut self, angle: Expr) -> Expr {
        self.sine(angle, 1)
    }

    /// Tangent, as sine over cosine.
    pub fn tan(&mut self, angle: Expr) -> Expr {
        let (s, c) = (self.sin(angle), self.cos(angle));
        self.div(s, c)
    }

    /// sin(angle + quarters·π/2), the quarter turns in the angle itself taken out.
    fn sine(&mut self, angle: Expr, quarters: i64) -> Expr {
        let (mut quarters, mut angle) = (quarters, angle);
        let (constant, terms) = self.as_sum(angle);
        let pi = self.pi();
        if let Some(at) = terms.iter().position(|(_, e)| *e == pi)
            && let Some(turns) = terms[at].0.mul(&Rational::integer(2)).as_integer()
        {
            let rest: Vec<_> = terms.iter().filter(|(_, e)| *e != pi).cloned().collect();
            angle = self.linear(constant, &rest);
            quarters += turns.rem_euclid(4);
        }
        let (constant, terms) = self.as_sum(angle);
        let negative = terms.first().map_or(&constant, |(c, _)| c).is_negative();
        if negative {
            angle = self.neg(angle);
        }
        // sin(-a + q π/2) = -sin(a - q π/2)
        let turns = if negative { -quarters } else { quarters }.rem_euclid(4);
        let (function, minus) = match turns {
            0 => (Function::Sin, false),
            1 => (Function::Cos, false),
            2 => (Function::Sin, true),
            _ => (Function::Cos, true),
        };
        let value = if self.is_zero(angle) {
            if function == Function::Sin { self.zero() } else { self.one() }
        } else {
            self.intern(Node::Function(function, Box::new([angle])))
        };
        if minus != negative { self.neg(value) } else { value }
    }

    /// Square root, exact for squares of rationals.
    pub fn sqrt(&mut self, a: Expr) -> Expr {
        match self.as_number(a).and_then(Rational::sqrt) {
            Some(root) => self.number(root),
            None => self.intern(Node::Function(Function::Sqrt, Box::new([a]))),
        }
    }

    /// The angle of (x, y) from the x axis.
    pub fn atan2(&mut self, y: Expr, x: Expr) -> Expr {
        self.function(Function::Atan2, &[y, x])
    }

    /// Inverse sine, cosine and tangent: exact at 0 and ±1, the odd ones odd.
    fn arc(&mut self, function: Function, a: Expr) -> Expr {
        let quarters = |n: i64| Rational::fraction(n, 4);
        let exact = match (function, self.as_number(a).and_then(Rational::as_integer)) {
            (Function::Acos, Some(0)) => quarters(2),
            (Function::Acos, Some(1)) | (Function::Asin | Function::Atan, Some(0)) => quarters(0),
            (Function::Acos, Some(-1)) => quarters(4),
            (Function::Asin, Some(1)) => quarters(2),
            (Function::Atan, Some(1)) => quarters(1),
            _ => None,
        };
        match exact {
            Some(turns) => self.scale(turns, self.pi()),
            None if function == Function::Acos => self.intern(Node::Function(function, Box::new([a]))),
            None => self.odd(function, a),
        }
    }

    /// Hyperbolic functions: odd or even, exact at 0.
    fn hyperbolic(&mut self, function: Function, a: Expr) -> Expr {
        match (function, self.is_zero(a)) {
            (Function::Cosh, true) => self.one(),
            (_, true) => self.zero(),
            (Function::Cosh, false) => {
                let a = if self.leads_with_minus(a) { self.neg(a) } else { a };
                self.intern(Node::Function(function, Box::new([a])))
            }
            (_, false) => self.odd(function, a),
        }
    }

    /// f(-a) = -f(a).
    fn odd(&mut self, function: Function, a: Expr) -> Expr {
        let negative = self.leads_with_minus(a);
        let a = if negative { self.neg(a) } else { a };
        let value = self.intern(Node::Function(function, Box::new([a])));
        if negative { self.neg(value) } else { value }
    }

    fn leads_with_minus(&self, e: Expr) -> bool {
        let (constant, terms) = self.as_sum(e);
        terms.first().map_or(&constant, |(c, _)| c).is_negative()
    }

    /// |a|, the rational content taken out.
    pub fn abs(&mut self, a: Expr) -> Expr {
        if let Some(number) = self.as_number(a) {
            let number = number.abs();
            return self.number(number);
        }
        let (content, part) = self.content(a);
        let positive = match self.node(part) {
            Node::Function(function, _) => {
                matches!(function, Function::Abs | Function::Sqrt | Function::Exp | Function::Cosh)
            }
            Node::Product(factors) => factors.iter().all(|(_, k)| k % 2 == 0),
            _ => false,
        };
        let magnitude = if positive { part } else { self.intern(Node::Function(Function::Abs, Box::new([part]))) };
        self.scale(content.abs(), magnitude)
    }

    /// -1, 0 or 1, odd; the rational content does not matter.
    pub fn sign(&mut self, a: Expr) -> Expr {
        if let Some(number) = self.as_number(a) {
            let sign = if number.is_zero() { 0 } else { 1 - 2 * i64::from(number.is_negative()) };
            return self.integer(sign);
        }
        let (content, part) = self.content(a);
        let value = self.intern(Node::Function(Function::Sign, Box::new([part])));
        if content.is_negative() { self.neg(value) } else { value }
    }

    /// `base^exponent`: integers are multiplied out, halves are powers of the root.
    pub fn powf(&mut self, base: Expr, exponent: Expr) -> Expr {
        if let Some(exponent) = self.as_number(exponent) {
            let small = |n: &i64| n.abs() <= LARGEST_POWER;
            if let Some(n) = exponent.as_integer().filter(small) {
                return self.powi(base, n as i32);
            }
            if let Some(n) = exponent.mul(&Rational::integer(2)).as_integer().filter(small) {
                let root = self.sqrt(base);
                return self.powi(root, n as i32);
            }
        }
        if self.is_one(base) {
            return base;
        }
        self.intern(Node::Function(Function::Power, Box::new([base, exponent])))
    }

    /// `negative` where the condition is below zero, else `other`. Where the condition is not a number, neither is the
    /// result; so the two branches may change places with the sign of the condition only where they agree at zero.
    pub fn select(&mut self, condition: Expr, negative: Expr, other: Expr) -> Expr {
        if negative == other {
            return other;
        }
        if let Some(number) = self.as_number(condition) {
            return if number.is_negative() { negative } else { other };
        }
        let (content, part) = self.content(condition);
        let condition = if content.is_negative() { self.neg(part) } else { part };
        self.intern(Node::Function(Function::Select, Box::new([condition, negative, other])))
    }

    /// The smaller of two.
    pub fn min(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = (a.min(b), a.max(b));
        let difference = self.sub(a, b);
        self.select(difference, a, b)
    }

    /// The larger of two.
    pub fn max(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = (a.min(b), a.max(b));
        let difference = self.sub(a, b);
        self.select(difference, b, a)
    }

    /// Exponential.
    pub fn exp(&mut self, a: Expr) -> Expr {
        self.function(Function::Exp, &[a])
    }

    /// Natural logarithm.
    pub fn ln(&mut self, a: Expr) -> Expr {
        self.function(Function::Ln, &[a])
    }
}
