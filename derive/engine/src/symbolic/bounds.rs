//! Bounds of values, as far as they follow from the form: sines lie in [-1, 1], even powers are not negative.

use super::{Expr, Function, Graph, Node};

/// An interval that holds all values of an expression.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Bounds {
    /// No value is below this.
    pub low: f64,
    /// No value is above this.
    pub high: f64,
}

impl Bounds {
    const ALL: Bounds = Bounds { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// Whether zero is kept off by more than rounding.
    pub fn exclude_zero(self) -> bool {
        let largest = self.low.abs().max(self.high.abs());
        let reach = if largest.is_finite() { 1e-9 * largest } else { 0.0 };
        self.low > reach || self.high < -reach
    }

    fn times(self, other: Bounds) -> Bounds {
        let corners = [
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ];
        Bounds {
            low: corners.iter().copied().fold(f64::INFINITY, f64::min),
            high: corners.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    fn power(self, exponent: i32) -> Bounds {
        let k = exponent.unsigned_abs();
        let raise = |x: f64| x.powi(i32::try_from(k).unwrap_or(i32::MAX));
        let positive = match (k.is_multiple_of(2), self.low >= 0.0, self.high <= 0.0) {
            (false, _, _) | (true, true, _) => Bounds { low: raise(self.low), high: raise(self.high) },
            (true, _, true) => Bounds { low: raise(self.high), high: raise(self.low) },
            _ => Bounds { low: 0.0, high: raise(self.low).max(raise(self.high)) },
        };
        match exponent > 0 {
            true => positive,
            false if positive.low > 0.0 || positive.high < 0.0 => {
                Bounds { low: 1.0 / positive.high, high: 1.0 / positive.low }
            }
            false if positive.low >= 0.0 => Bounds { low: 0.0, high: f64::INFINITY },
            false => Bounds::ALL,
        }
    }
}

/// 0 · ∞ = 0: an interval's end is a bound, not a value.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

impl Graph {
    /// Bounds of the expression over all real values of its symbols.
    pub fn bounds(&self, e: Expr) -> Bounds {
        let order = self.reachable(&[e]);
        let mut found = vec![Bounds::ALL; e.index() + 1];
        for node in order {
            found[node.index()] = self.bounds_of(node, &found);
        }
        found[e.index()]
    }

    fn bounds_of(&self, e: Expr, found: &[Bounds]) -> Bounds {
        match self.node(e) {
            Node::Number(number) => Bounds { low: number.to_f64(), high: number.to_f64() },
            Node::Symbol(_) => Bounds::ALL,
            Node::Sum { constant, terms } => {
                let mut total = Bounds { low: constant.to_f64(), high: constant.to_f64() };
                for (c, term) in terms {
                    let c = c.to_f64();
                    let part = found[term.index()].times(Bounds { low: c, high: c });
                    total = Bounds { low: total.low + part.low, high: total.high + part.high };
                }
                total
            }
            Node::Product(factors) => factors
                .iter()
                .fold(Bounds { low: 1.0, high: 1.0 }, |total, (b, k)| total.times(found[b.index()].power(*k))),
            Node::Function(function, arguments) => match function {
                Function::Sin | Function::Cos => Bounds { low: -1.0, high: 1.0 },
                Function::Exp | Function::Sqrt => Bounds { low: 0.0, high: f64::INFINITY },
                Function::Sign | Function::Tanh => Bounds { low: -1.0, high: 1.0 },
                Function::Asin | Function::Atan => Bounds { low: -1.6, high: 1.6 },
                Function::Acos => Bounds { low: 0.0, high: 3.2 },
                Function::Cosh => Bounds { low: 1.0, high: f64::INFINITY },
                Function::Sinh | Function::Given(_) => Bounds::ALL,
                // A negative base with an integer exponent has a power of either sign.
                Function::Power if found[arguments[0].index()].low >= 0.0 => Bounds { low: 0.0, high: f64::INFINITY },
                Function::Power => Bounds::ALL,
                Function::Whole => found[arguments[0].index()],
                Function::Abs => {
                    let Bounds { low, high } = found[arguments[0].index()];
                    Bounds { low: low.max(-high).max(0.0), high: high.max(-low) }
                }
                Function::Select => {
                    let [a, b] = [1, 2].map(|k: usize| found[arguments[k].index()]);
                    Bounds { low: a.low.min(b.low), high: a.high.max(b.high) }
                }
                Function::Atan2 => Bounds { low: -std::f64::consts::PI, high: std::f64::consts::PI },
                Function::Ln => {
                    let Bounds { low, high } = found[arguments[0].index()];
                    match low > 0.0 {
                        true => Bounds { low: low.ln() - 1e-12, high: high.ln() + 1e-12 },
                        false => Bounds::ALL,
                    }
                }
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Kind, Rational};

    #[test]
    fn what_cannot_vanish_is_seen() {
        let mut g = Graph::new();
        let x = g.symbol("x", Kind::Coordinate);
        let x = g.var(x);
        let (s, square) = (g.sin(x), g.powi(x, 2));
        let two = g.integer(2);
        let shifted = g.add(two, s);
        assert_eq!(g.bounds(shifted), Bounds { low: 1.0, high: 3.0 });
        let root = g.linear(Rational::ONE, &[(Rational::ONE, square)]);
        assert!(g.bounds(root).exclude_zero() && !g.bounds(square).exclude_zero() && !g.bounds(s).exclude_zero());
        let inverse = g.div(s, shifted);
        assert_eq!(g.bounds(inverse), Bounds { low: -1.0, high: 1.0 });
        let minus = g.neg(root);
        assert!(g.bounds(minus).exclude_zero());
    }
}
