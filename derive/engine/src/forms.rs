//! The simplifier as the projection sees it: with a memory of what has its final form.

use crate::projection::Simplifier;
use crate::simplify::limits::{OPENED, PROJECTION_WORK, SETTLED_ALONE, SETTLED_TOGETHER};
use crate::simplify::{Search, candidates, normalise_within, simplify};
use crate::symbolic::tables::Set;
use crate::symbolic::{Expr, Graph, Kind, Node, Stage, Symbol};

/// The simplifier of one model.
///
/// A large sum that has its final form, an entry of a_u or of M_d, is a symbol to all later simplifications: what is made
/// of it is then small again, and opening it once more would find nothing that was not found before.
pub struct Forms {
    search: Search,
    /// What entries may still cost to normalise: in a large model most of them have no cheaper form.
    left: usize,
    /// The sums that stay closed, with the symbols that stand for them.
    settled: Vec<(Expr, Symbol)>,
    /// The results of each group that was simplified as a whole.
    done: Vec<Set>,
}

impl Forms {
    /// Without any memory.
    pub fn new(search: Search) -> Self {
        Forms { search, left: PROJECTION_WORK, settled: Vec::new(), done: Vec::new() }
    }

    /// Runs a simplification over expressions in which settled sums are symbols.
    fn closed(
        &mut self,
        graph: &mut Graph,
        roots: &[Expr],
        simplification: impl FnOnce(&mut Self, &mut Graph, &[Expr]) -> Vec<Expr>,
    ) -> Vec<Expr> {
        let inside = graph.reachable_beyond(roots, Stage::Parameter);
        let present = Set::of(&inside);
        let used: Vec<(Expr, Symbol)> = self.settled.iter().filter(|(e, _)| present.contains(*e)).copied().collect();
        if used.is_empty() {
            return simplification(self, graph, roots);
        }
        for (e, symbol) in &used {
            if graph.is_nonzero(*e) {
                graph.assume_nonzero(graph.var(*symbol));
            }
        }
        let close: Vec<(Expr, Expr)> = used.iter().map(|(e, symbol)| (*e, graph.var(*symbol))).collect();
        let roots = graph.replace(roots, &close);
        let found = simplification(self, graph, &roots);
        let open: Vec<(Symbol, Expr)> = used.into_iter().map(|(e, symbol)| (symbol, e)).collect();
        // A divisor that took another form is no less a divisor that was checked.
        let mut divisors = Vec::new();
        for e in graph.reachable_beyond(&found, Stage::Parameter) {
            if let Node::Product(factors) = graph.node(e) {
                divisors.extend(factors.iter().filter(|(b, k)| *k < 0 && graph.is_nonzero(*b)).map(|(b, _)| *b));
            }
        }
        graph.substitute(&divisors, &open).into_iter().for_each(|e| graph.assume_nonzero(e));
        graph.substitute(&found, &open)
    }

    /// Remembers the sums among the factors of the expressions that are larger than a bound.
    fn close(&mut self, graph: &mut Graph, expressions: &[Expr], bound: usize) {
        for e in expressions {
            for (base, _) in graph.as_term(*e).1 {
                let sum = graph.primitive_part(base);
                let large = |graph: &Graph| graph.reachable_beyond(&[sum], Stage::Parameter).len() > bound;
                let kind = match (graph.node(sum), graph.stage(sum)) {
                    (Node::Sum { .. }, Stage::Time) => Kind::Time,
                    (Node::Sum { .. }, Stage::Coordinate) => Kind::Coordinate,
                    (Node::Sum { .. }, Stage::Speed) => Kind::Speed,
                    _ => continue,
                };
                if self.settled.iter().all(|(known, _)| *known != sum) && large(graph) {
                    self.settled.push((sum, graph.symbol("settled", kind)));
                }
            }
        }
    }

    /// The forms of a group that weigh least, those that it has among them.
    pub fn lightest(
        &mut self,
        graph: &mut Graph,
        roots: &[Expr],
        weigh: impl Fn(&mut Graph, &[Expr]) -> usize,
    ) -> Vec<Expr> {
        let found = self.closed(graph, roots, |forms, graph, roots| candidates(graph, roots, forms.search).concat());
        let all = found.chunks(roots.len().max(1)).map(<[Expr]>::to_vec).chain([roots.to_vec()]);
        let weighed = all.map(|form| (weigh(graph, &form), form)).enumerate();
        let lightest = weighed.min_by_key(|(i, (weight, _))| (*weight, *i)).map(|(_, (_, form))| form);
        let lightest = lightest.unwrap_or_else(|| roots.to_vec());
        self.done.push(Set::of(&lightest));
        self.close(graph, &lightest, SETTLED_TOGETHER);
        lightest
    }
}

impl Simplifier for Forms {
    fn one(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        self.closed(graph, &[e], |forms, graph, roots| {
            let small = graph.reachable_beyond(roots, Stage::Parameter).len() <= OPENED;
            vec![if small { normalise_within(graph, roots[0], &mut forms.left) } else { roots[0] }]
        })[0]
    }

    fn all(&mut self, graph: &mut Graph, roots: &[Expr]) -> Vec<Expr> {
        let running = |graph: &Graph, e: &Expr| graph.stage(*e) > Stage::Parameter;
        if self.done.iter().any(|done| roots.iter().all(|e| done.contains(*e) || !running(graph, e))) {
            return roots.to_vec();
        }
        let found = self.closed(graph, roots, |forms, graph, roots| simplify(graph, roots, forms.search));
        self.done.push(Set::of(&found));
        self.close(graph, &found, SETTLED_TOGETHER);
        found
    }

    fn settle(&mut self, graph: &mut Graph, settled: &[Expr]) {
        self.close(graph, settled, SETTLED_ALONE);
    }

    fn keep(&mut self, graph: &mut Graph, e: Expr) {
        self.close(graph, &[e], 0);
    }
}
