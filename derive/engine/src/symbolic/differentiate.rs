//! Derivatives: forward sweeps over the arena, so shared expressions are differentiated once.

use super::tables::Table;
use super::{Expr, Function, Graph, Matrix, Node, Rational, Symbol};

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
        let mut rates = Table::new(self.len());
        for (symbol, rate) in tangent {
            if !self.is_zero(*rate) {
                rates.set(self.var(*symbol), *rate);
            }
        }
        for e in self.reachable(expressions) {
            if rates.get(e).is_some() || !self.node(e).any_child(|c| rates.get(c).is_some()) {
                continue;
            }
            let rate = self.rate(e, &rates);
            if !self.is_zero(rate) {
                rates.set(e, rate);
            }
        }
        let zero = self.zero();
        expressions.iter().map(|e| rates.get(*e).unwrap_or(zero)).collect()
    }

    /// The rate of a node from the rates of its children; a child without a rate stands still.
    fn rate(&mut self, e: Expr, rates: &Table) -> Expr {
        match self.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) => self.zero(),
            Node::Sum { terms, .. } => {
                let terms: Vec<_> =
                    terms.iter().filter_map(|(c, e)| rates.get(*e).map(|rate| (c.clone(), rate))).collect();
                self.linear(Rational::ZERO, &terms)
            }
            Node::Product(factors) => {
                let mut terms = Vec::new();
                for (at, (base, exponent)) in factors.iter().enumerate() {
                    if let Some(rate) = rates.get(*base) {
                        let mut term = factors.to_vec();
                        term[at].1 -= 1;
                        term.push((rate, 1));
                        terms.push(self.power_product(Rational::integer((*exponent).into()), &term));
                    }
                }
                self.sum(&terms)
            }
            Node::Function(function, arguments) => {
                let zero = self.zero();
                let rate: Vec<Expr> = arguments.iter().map(|a| rates.get(*a).unwrap_or(zero)).collect();
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
                    Function::Asin | Function::Acos => {
                        // d asin x = dx / √(1 - x²) = -d acos x
                        let square = self.powi(arguments[0], 2);
                        let below = self.linear(Rational::ONE, &[(Rational::MINUS_ONE, square)]);
                        let root = self.sqrt(below);
                        let rate = self.div(rate[0], root);
                        if function == Function::Acos { self.neg(rate) } else { rate }
                    }
                    Function::Atan => {
                        let square = self.powi(arguments[0], 2);
                        let below = self.linear(Rational::ONE, &[(Rational::ONE, square)]);
                        self.div(rate[0], below)
                    }
                    Function::Sinh => {
                        let cosh = self.function(Function::Cosh, &arguments);
                        self.mul(cosh, rate[0])
                    }
                    Function::Cosh => {
                        let sinh = self.function(Function::Sinh, &arguments);
                        self.mul(sinh, rate[0])
                    }
                    Function::Tanh => {
                        let square = self.powi(e, 2);
                        let slope = self.linear(Rational::ONE, &[(Rational::MINUS_ONE, square)]);
                        self.mul(slope, rate[0])
                    }
                    Function::Abs => {
                        let sign = self.sign(arguments[0]);
                        self.mul(sign, rate[0])
                    }
                    Function::Whole => self.whole(rate[0]),
                    Function::Sign => zero,
                    Function::Power => {
                        // d x^y = y x^(y-1) dx + x^y ln x dy
                        let (base, exponent) = (arguments[0], arguments[1]);
                        let one = self.one();
                        let lower = self.sub(exponent, one);
                        let lower = self.powf(base, lower);
                        let by_base = self.product(&[exponent, lower, rate[0]]);
                        let ln = self.ln(base);
                        let by_exponent = self.product(&[e, ln, rate[1]]);
                        self.add(by_base, by_exponent)
                    }
                    Function::Given(at) => {
                        let derivative = self.derivative_of_given(at);
                        let slope = self.function(derivative, &arguments);
                        self.mul(slope, rate[0])
                    }
                    // Branch by branch: where the condition changes its sign there is no derivative.
                    Function::Select => self.select(arguments[0], rate[1], rate[2]),
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
