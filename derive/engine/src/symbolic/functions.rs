//! Canonical elementary functions.

use super::{Expr, Function, Graph, Node, Rational};

impl Graph {
    /// A function of its arguments, in canonical form.
    pub fn function(&mut self, function: Function, arguments: &[Expr]) -> Expr {
        match (function, arguments) {
            (Function::Sin, [a]) => self.sin(*a),
            (Function::Cos, [a]) => self.cos(*a),
            (Function::Sqrt, [a]) => self.sqrt(*a),
            (Function::Exp, [a]) if self.is_zero(*a) => self.one(),
            (Function::Ln, [a]) if self.is_one(*a) => self.zero(),
            _ => self.intern(Node::Function(function, arguments.into())),
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

    /// Exponential.
    pub fn exp(&mut self, a: Expr) -> Expr {
        self.function(Function::Exp, &[a])
    }

    /// Natural logarithm.
    pub fn ln(&mut self, a: Expr) -> Expr {
        self.function(Function::Ln, &[a])
    }
}
