//! Derivatives: forward sweeps over the arena, so shared expressions are differentiated once.

use super::{Expr, Function, Graph, Matrix, Node, Rational, Symbol};
use std::collections::HashMap;

impl Graph {
    /// ∂e/∂symbol.
    pub fn derivative(&mut self, e: Expr, symbol: Symbol) -> Expr {
        let one = self.one();
        self.along(&[e], &[(symbol, one)])[0]
    }

    /// The matrix ∂(expressions)/∂(symbols), one row an expression.
    pub fn jacobian(&mut self, expressions: &[Expr], symbols: &[Symbol]) -> Matrix {
        let one = self.one();
        let columns: Vec<Vec<Expr>> = symbols.iter().map(|s| self.along(expressions, &[(*s, one)])).collect();
        Matrix::from_fn(expressions.len(), symbols.len(), |i, j| columns[j][i])
    }

    /// The derivatives of the expressions in the direction in which each symbol changes at the given rate; symbols
    /// that are not named stand still. With ẋ = A v + a0 and ṫ = 1 this is the derivative along the motion.
    pub fn along(&mut self, expressions: &[Expr], tangent: &[(Symbol, Expr)]) -> Vec<Expr> {
        let mut rates: HashMap<Expr, Expr> = HashMap::new();
        for (symbol, rate) in tangent {
            if !self.is_zero(*rate) {
                rates.insert(self.var(*symbol), *rate);
            }
        }
        for e in self.reachable(expressions) {
            if rates.contains_key(&e) || !self.node(e).children().iter().any(|c| rates.contains_key(c)) {
                continue;
            }
            let rate = self.rate(e, &rates);
            if !self.is_zero(rate) {
                rates.insert(e, rate);
            }
        }
        let zero = self.zero();
        expressions.iter().map(|e| rates.get(e).copied().unwrap_or(zero)).collect()
    }

    /// The rate of a node from the rates of its children; a child without a rate stands still.
    fn rate(&mut self, e: Expr, rates: &HashMap<Expr, Expr>) -> Expr {
        match self.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) => self.zero(),
            Node::Sum { terms, .. } => {
                let terms: Vec<_> =
                    terms.iter().filter_map(|(c, e)| rates.get(e).map(|rate| (c.clone(), *rate))).collect();
                self.linear(Rational::ZERO, &terms)
            }
            Node::Product(factors) => {
                let mut terms = Vec::new();
                for (at, (base, exponent)) in factors.iter().enumerate() {
                    if let Some(rate) = rates.get(base) {
                        let mut term = factors.to_vec();
                        term[at].1 -= 1;
                        term.push((*rate, 1));
                        terms.push(self.power_product(Rational::integer((*exponent).into()), &term));
                    }
                }
                self.sum(&terms)
            }
            Node::Function(function, arguments) => {
                let zero = self.zero();
                let rate: Vec<Expr> = arguments.iter().map(|a| rates.get(a).copied().unwrap_or(zero)).collect();
                match function {
                    Function::Sin => {
                        let cos = self.cos(arguments[0]);
                        self.mul(cos, rate[0])
                    }
                    Function::Cos => {
                        let sin = self.sin(arguments[0]);
                        self.power_product(Rational::MINUS_ONE, &[(sin, 1), (rate[0], 1)])
                    }
                    Function::Sqrt => {
                        let half = Rational::Small(1, 2);
                        self.power_product(half, &[(rate[0], 1), (e, -1)])
                    }
                    Function::Exp => self.mul(e, rate[0]),
                    Function::Ln => self.div(rate[0], arguments[0]),
                    Function::Atan2 => {
                        let (y, x) = (arguments[0], arguments[1]);
                        let (a, b) = (self.mul(x, rate[0]), self.mul(y, rate[1]));
                        let (x2, y2) = (self.powi(x, 2), self.powi(y, 2));
                        let (above, below) = (self.sub(a, b), self.add(x2, y2));
                        self.div(above, below)
                    }
                }
            }
        }
    }
}
