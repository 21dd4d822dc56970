//! Replacing symbols by expressions.

use super::{Expr, Graph, Node, Symbol};
use std::collections::HashMap;

impl Graph {
    /// The expressions with each named symbol replaced, all at once.
    pub fn substitute(&mut self, expressions: &[Expr], map: &[(Symbol, Expr)]) -> Vec<Expr> {
        let replaced: Vec<(Expr, Expr)> = map.iter().map(|(symbol, value)| (self.var(*symbol), *value)).collect();
        self.replace(expressions, &replaced)
    }

    /// The expressions with each named subexpression replaced, all at once.
    pub fn replace(&mut self, expressions: &[Expr], map: &[(Expr, Expr)]) -> Vec<Expr> {
        let mut changed: HashMap<Expr, Expr> = map.iter().copied().filter(|(a, b)| a != b).collect();
        if changed.is_empty() {
            return expressions.to_vec();
        }
        for e in self.reachable(expressions) {
            if changed.contains_key(&e) || !self.node(e).children().iter().any(|c| changed.contains_key(c)) {
                continue;
            }
            let new = self.rebuild(e, |child| changed.get(&child).copied().unwrap_or(child));
            if new != e {
                changed.insert(e, new);
            }
        }
        expressions.iter().map(|e| changed.get(e).copied().unwrap_or(*e)).collect()
    }

    /// The node built again, in canonical form, over other children.
    pub fn rebuild(&mut self, e: Expr, child: impl Fn(Expr) -> Expr) -> Expr {
        match self.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) => e,
            Node::Sum { constant, terms } => {
                let terms: Vec<_> = terms.iter().map(|(c, t)| (c.clone(), child(*t))).collect();
                self.linear(constant, &terms)
            }
            Node::Product(factors) => {
                let factors: Vec<_> = factors.iter().map(|(b, k)| (child(*b), *k)).collect();
                self.power_product(super::Rational::ONE, &factors)
            }
            Node::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|a| child(*a)).collect();
                self.function(function, &arguments)
            }
        }
    }
}
