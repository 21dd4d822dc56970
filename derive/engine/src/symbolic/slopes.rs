//! Slopes of what is linear in some symbols: one sweep back for all of them.
//!
//! A forward sweep for each symbol writes what a long chain hands on once for each of them. Back from the expression every node has one
//! slope, the sum of what its parents need of it, and it is handed on whole.

use super::tables::Set;
use super::{Expr, Function, Graph, Node, Rational, Symbol};
use std::collections::HashMap;

impl Graph {
    /// ∂e/∂symbols where e is made of these by sums and products alone, each product with one of them at most; `None` where it is not.
    pub fn slopes(&mut self, e: Expr, symbols: &[Symbol]) -> Option<Vec<Expr>> {
        let variables = self.vars(symbols);
        let order = self.reachable(&[e]);
        let mut moved = Set::of(&variables);
        for node in &order {
            if self.node(*node).any_child(|child| moved.contains(child)) {
                moved.insert(*node);
            }
        }
        let mut needed: HashMap<Expr, Vec<Expr>> = HashMap::from([(e, vec![self.one()])]);
        for node in order.into_iter().rev().filter(|node| moved.contains(*node) && !variables.contains(node)) {
            let Some(terms) = needed.remove(&node) else { continue };
            let sum = self.sum(&terms);
            let slope = self.whole(sum);
            match self.node(node).clone() {
                Node::Sum { terms, .. } => {
                    for (factor, child) in terms.iter().filter(|(_, child)| moved.contains(*child)) {
                        let part = self.scale(factor.clone(), slope);
                        needed.entry(*child).or_default().push(part);
                    }
                }
                Node::Product(factors) => {
                    let at = factors.iter().position(|(base, _)| moved.contains(*base))?;
                    let mut rest = factors.to_vec();
                    let (child, exponent) = rest.remove(at);
                    if exponent != 1 || rest.iter().any(|(base, _)| moved.contains(*base)) {
                        return None;
                    }
                    rest.push((slope, 1));
                    let part = self.power_product(Rational::ONE, &rest);
                    needed.entry(child).or_default().push(part);
                }
                Node::Function(Function::Whole, arguments) => needed.entry(arguments[0]).or_default().push(slope),
                _ => return None,
            }
        }
        let each = variables.iter().map(|variable| {
            let terms = needed.remove(variable).unwrap_or_default();
            self.sum(&terms)
        });
        Some(each.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    /// Of a chain of turns, as forward sweeps give them; of what is not linear, none.
    #[test]
    fn slopes_are_derivatives() {
        let graph = &mut Graph::new();
        let named = |graph: &mut Graph, letter: &str, kind| -> Vec<Symbol> {
            (0..4).map(|i| graph.symbol(&format!("{letter}{i}"), kind)).collect()
        };
        let (x, v) = (named(graph, "x", Kind::Coordinate), named(graph, "v", Kind::Speed));
        let (angles, speeds) = (graph.vars(&x), graph.vars(&v));
        // p <- (p + v_i) cos x_i + q sin x_i, q <- q cos x_i - 2 p sin x_i
        let (mut p, mut q) = (speeds[0], graph.zero());
        for (angle, speed) in angles.iter().zip(&speeds) {
            let (sin, cos) = (graph.sin(*angle), graph.cos(*angle));
            let sum = graph.add(p, *speed);
            let terms = [graph.mul(sum, cos), graph.mul(q, sin)];
            let lower = [graph.mul(q, cos), graph.product(&[p, sin])];
            let twice = graph.scale(Rational::integer(-2), lower[1]);
            p = graph.sum(&terms);
            q = graph.add(lower[0], twice);
            p = graph.whole(p);
        }
        let slopes = graph.slopes(p, &v).expect("it is linear");
        for (slope, speed) in slopes.into_iter().zip(&v) {
            let derivative = graph.derivative(p, *speed);
            assert!(!graph.vanishes(derivative) && graph.identical(slope, derivative));
        }
        let square = graph.powi(speeds[0], 2);
        let product = graph.mul(speeds[0], speeds[1]);
        let sine = graph.sin(speeds[0]);
        for e in [square, product, sine] {
            assert!(graph.slopes(e, &v).is_none());
        }
        // what does not move has no slope
        assert!(graph.slopes(angles[0], &v).is_some_and(|slopes| slopes.iter().all(|slope| graph.is_zero(*slope))));
    }
}
