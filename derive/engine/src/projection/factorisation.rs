//! L D Lᵀ of a symmetric positive definite matrix, along its zero pattern.
//!
//! The order of elimination takes constant pivots first, then parameters, then the sparsest row: on the rolling disk
//! that eliminates ψ before φ and leaves the pivot J cos²θ instead of a dense one.

use super::Simplifier;
use crate::symbolic::{Expr, Graph, Matrix, Stage};

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
        for (position, i) in coupled.iter().enumerate() {
            for j in &coupled[..=position] {
                let product = graph.mul(columns.get(*i, p), schur.get(*j, p));
                let difference = graph.sub(schur.get(*i, *j), product);
                let entry = if graph.vanishes(difference) { graph.zero() } else { simplifier.one(graph, difference) };
                schur.set(*i, *j, entry);
                schur.set(*j, *i, entry);
            }
        }
    }
    let lower = Matrix::from_fn(k, k, |i, j| columns.get(order[i], order[j]));
    Ok(Factorisation { order, pivots, lower })
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
