//! Replacing symbols by expressions.

use super::tables::Table;
use super::{Expr, Graph, Node, Symbol};

impl Graph {
    /// The expressions with each named symbol replaced, all at once.
    pub fn substitute(&mut self, expressions: &[Expr], map: &[(Symbol, Expr)]) -> Vec<Expr> {
        let replaced: Vec<(Expr, Expr)> = map.iter().map(|(symbol, value)| (self.var(*symbol), *value)).collect();
        self.replace(expressions, &replaced)
    }

    /// The expressions with each named subexpression replaced, all at once.
    pub fn replace(&mut self, expressions: &[Expr], map: &[(Expr, Expr)]) -> Vec<Expr> {
        if map.iter().all(|(a, b)| a == b) {
            return expressions.to_vec();
        }
        let mut changed = Table::new(self.len());
        map.iter().filter(|(a, b)| a != b).for_each(|(a, b)| changed.set(*a, *b));
        for e in self.reachable(expressions) {
            if changed.get(e).is_some() || !self.node(e).any_child(|c| changed.get(c).is_some()) {
                continue;
            }
            let new = self.rebuild(e, |child| changed.get(child).unwrap_or(child));
            if new != e {
                changed.set(e, new);
            }
        }
        expressions.iter().map(|e| changed.get(*e).unwrap_or(*e)).collect()
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
