//! L D Lᵀ of a symmetric positive definite matrix, along its zero pattern.
//!
//! The order of elimination takes constant pivots first, then parameters, then the sparsest row: on the rolling disk
//! that eliminates ψ before φ and leaves the pivot J cos²θ instead of a dense one.
//!
//! What is left of an entry, a − l s, may be written over the pivot that l divides by. Where the pivot is an entry of the matrix
//! itself, the numerator is a minor of two rows and cancels no more than the difference does. Where the pivot is a difference
//! already, the numerator is a minor of more rows, its terms are products of entries, and what cancels in them is what cancels in
//! the differences one after another, all at once: with ten pendulums in a row it loses seven times as much (rms). So there the
//! entry stays the difference, which is cheaper as well, since l and s are there anyway, unless the pivot divides out.

use super::Simplifier;
use crate::symbolic::{Expr, Graph, Matrix, Node, Stage};

/// A factorised matrix: P A Pᵀ = L D Lᵀ.
#[derive(Clone, Debug)]
pub struct Factorisation {
    /// The index that is eliminated first, second, ...
    pub order: Vec<usize>,
    /// The pivots, in the order of elimination.
    pub pivots: Vec<Expr>,
    /// L below its unit diagonal, indices in the order of elimination.
    lower: Matrix,
}

/// Factorises. A pivot that vanishes identically is `Err(index)`.
pub fn factorise(graph: &mut Graph, simplifier: &mut dyn Simplifier, matrix: &Matrix) -> Result<Factorisation, usize> {
    let k = matrix.rows();
    let mut schur = matrix.clone();
    for e in schur.entries_mut() {
        if graph.vanishes(*e) {
            *e = graph.zero();
        }
    }
    let mut open: Vec<usize> = (0..k).collect();
    let (mut order, mut pivots) = (Vec::with_capacity(k), Vec::with_capacity(k));
    // Columns of L by original index; brought into the order of elimination at the end.
    let mut columns = Matrix::zeros(graph, k, k);
    // Whether anything has been subtracted from a row.
    let mut reduced = vec![false; k];
    while !open.is_empty() {
        let at = next(graph, &schur, &open);
        let p = open.remove(at);
        let pivot = schur.get(p, p);
        if graph.is_zero(pivot) {
            return Err(p);
        }
        graph.assume_nonzero(pivot);
        order.push(p);
        pivots.push(pivot);
        let coupled: Vec<usize> = open.iter().copied().filter(|i| !graph.is_zero(schur.get(*i, p))).collect();
        for i in &coupled {
            let quotient = graph.div(schur.get(*i, p), pivot);
            let quotient = simplifier.one(graph, quotient);
            columns.set(*i, p, quotient);
        }
        let mut kept = false;
        for (position, i) in coupled.iter().enumerate() {
            for j in &coupled[..=position] {
                let product = graph.mul(columns.get(*i, p), schur.get(*j, p));
                let difference = graph.sub(schur.get(*i, *j), product);
                let simplest =
                    if graph.vanishes(difference) { graph.zero() } else { simplifier.one(graph, difference) };
                let minor = reduced[p] && divided(graph, simplest);
                kept |= minor;
                let entry = if minor { difference } else { simplest };
                schur.set(*i, *j, entry);
                schur.set(*j, *i, entry);
            }
        }
        coupled.iter().for_each(|i| reduced[*i] = true);
        if kept {
            // Nor may a later simplification open the pivot.
            simplifier.keep(graph, pivot);
        }
    }
    let lower = Matrix::from_fn(k, k, |i, j| columns.get(order[i], order[j]));
    Ok(Factorisation { order, pivots, lower })
}

/// Whether the whole expression is divided by a sum that changes along the motion.
fn divided(graph: &Graph, e: Expr) -> bool {
    let runs = |base: &Expr| matches!(graph.node(*base), Node::Sum { .. }) && graph.stage(*base) > Stage::Parameter;
    graph.as_term(e).1.iter().any(|(base, power)| *power < 0 && runs(base))
}

/// The position in `open` of the cheapest pivot.
fn next(graph: &Graph, schur: &Matrix, open: &[usize]) -> usize {
    let score = |p: usize| {
        let pivot = schur.get(p, p);
        let stage = if graph.is_zero(pivot) { Stage::Speed } else { graph.stage(pivot) };
        let couplings = open.iter().filter(|i| **i != p && !graph.is_zero(schur.get(**i, p))).count();
        // Parameters cost nothing per step, so a parameter is as good as a number.
        (graph.is_zero(pivot), stage > Stage::Parameter, couplings, p)
    };
    (0..open.len()).min_by_key(|at| score(open[*at])).unwrap_or(0)
}

impl Factorisation {
    /// The solution of A x = b.
    pub fn solve(&self, graph: &mut Graph, simplifier: &mut dyn Simplifier, right: &[Expr]) -> Vec<Expr> {
        let k = self.order.len();
        let mut x: Vec<Expr> = self.order.iter().map(|p| right[*p]).collect();
        for i in 0..k {
            x[i] = self.reduce(graph, &x, x[i], (0..i).map(|j| (self.lower.get(i, j), j)));
        }
        for (value, pivot) in x.iter_mut().zip(&self.pivots) {
            *value = graph.div(*value, *pivot);
            *value = simplifier.one(graph, *value);
        }
        for i in (0..k).rev() {
            x[i] = self.reduce(graph, &x, x[i], (i + 1..k).map(|j| (self.lower.get(j, i), j)));
        }
        let mut solution = right.to_vec();
        for (value, p) in x.into_iter().zip(&self.order) {
            solution[*p] = value;
        }
        solution
    }

    fn reduce(&self, graph: &mut Graph, x: &[Expr], start: Expr, factors: impl Iterator<Item = (Expr, usize)>) -> Expr {
        let mut terms = vec![start];
        for (factor, j) in factors {
            let product = graph.mul(factor, x[j]);
            terms.push(graph.neg(product));
        }
        graph.sum(&terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forms::Forms;
    use crate::simplify::Search;
    use crate::symbolic::Kind;

    /// M of the upper four of ten equal pendulums in a row.
    fn chain(graph: &mut Graph) -> Matrix {
        let [m, l] = ["m", "l"].map(|name| graph.symbol(name, Kind::Parameter));
        let [m, l] = [m, l].map(|symbol| graph.var(symbol));
        let square = graph.powi(l, 2);
        let inertia = graph.mul(m, square);
        let angles: Vec<Expr> = (0..4)
            .map(|i| {
                let symbol = graph.symbol(&format!("a{i}"), Kind::Coordinate);
                graph.var(symbol)
            })
            .collect();
        Matrix::from_fn(4, 4, |i, j| {
            let (turn, below) = (graph.sub(angles[i], angles[j]), graph.integer(10 - i.max(j) as i64));
            let (cos, inertia) = (graph.cos(turn), graph.mul(below, inertia));
            graph.mul(inertia, cos)
        })
    }

    #[test]
    fn entries_over_a_difference_stay_differences() {
        let graph = &mut Graph::new();
        let matrix = chain(graph);
        let mut forms = Forms::new(Search::Full);
        let factors = factorise(graph, &mut forms, &matrix).expect("M is regular");
        assert_eq!(factors.order, [0, 1, 2, 3]);
        assert!(factors.pivots.iter().all(|pivot| !divided(graph, *pivot)));
        // What divides by the third pivot still divides by the second one inside it.
        let second = graph.primitive_part(factors.pivots[1]);
        let below = graph.powi(factors.pivots[2], -1);
        let alone = forms.one(graph, below);
        let together = forms.all(graph, &[below])[0];
        for form in [alone, together] {
            assert!(graph.reachable(&[form]).contains(&second), "{}", graph.display(form));
        }
    }

    /// (1 + y²) - x² y²/(1 + x²) is (1 + x² + y²)/(1 + x²), where nothing cancels.
    #[test]
    fn entries_over_an_entry_of_the_matrix_are_joined() {
        let graph = &mut Graph::new();
        let [x, y] = ["x", "y"].map(|name| graph.symbol(name, Kind::Coordinate));
        let [x, y] = [x, y].map(|symbol| graph.var(symbol));
        let one = graph.one();
        let matrix = Matrix::from_fn(2, 2, |i, j| {
            let product = graph.mul([x, y][i], [x, y][j]);
            if i == j { graph.add(one, product) } else { product }
        });
        let factors = factorise(graph, &mut Forms::new(Search::Full), &matrix).expect("the matrix is regular");
        assert!(divided(graph, factors.pivots[1]), "{}", graph.display(factors.pivots[1]));
    }
}
