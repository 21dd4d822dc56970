//! What M_d as a whole takes at least, before it is derived: its entries, L D Lᵀ along its zero pattern, and the solution.
//!
//! Where nothing ties the speeds M_d is M, which is eliminated from the leaves along the tree without filling anything. Where rows tie
//! them, M_d = D M Dᵀ is filled by every dependent speed that moves with several independent ones: a loop couples all speeds on its
//! ways to the ground. Then the pattern is that of the product, and it is eliminated as [`factorise`] does, the sparsest row first.
//! What is counted are products that no form is without; that some might cancel is not.
//!
//! [`factorise`]: crate::projection::factorisation::factorise

use crate::program::eliminated;
use crate::projection::{Equations, ways};
use crate::symbolic::Matrix;
use std::collections::BTreeSet;

/// Operations in an entry of M off the diagonal, as of a cosine of a difference.
const ENTRY: usize = 4;
/// ... in the solution, for each entry of L: forwards and backwards,
const SOLVED: usize = 4;
/// ... in what a dependent speed adds to an entry of M_d: a product and a sum,
const CARRIED: usize = 2;
/// ... and for an entry of D: itself, and its product in h_u*.
const TIED: usize = 3;

/// Cycles that M_d as a whole takes at least.
pub fn factorisation(equations: &Equations) -> usize {
    let ways = ways(equations);
    let entries = ENTRY * ways.iter().map(Vec::len).sum::<usize>();
    let lower = |a: usize| a * (1 + SOLVED) + a * (a + 1);
    if equations.is_untied() {
        let deepest = ways.iter().map(|way| way.len() + 1).max().unwrap_or(0);
        let simple = ways.iter().map(|way| lower(way.len())).sum::<usize>();
        return eliminated(entries + simple, ways.len(), deepest);
    }
    let (graph, d) = (&equations.graph, &equations.complement);
    let moved: Vec<BTreeSet<usize>> = rows(d, |i, j| !graph.is_zero(d.get(i, j)));
    // Columns with a single one in a unit row cost nothing: those of the independent speeds.
    let carried: Vec<BTreeSet<usize>> = rows(d, |i, j| !graph.is_zero(d.get(i, j)) && !graph.is_one(d.get(i, j)));
    let mut simple = entries + TIED * carried.iter().map(BTreeSet::len).sum::<usize>();
    // What is accelerated with each speed: M D ᵀ, column by column.
    let coupled = |i: usize, j: usize| i == j || ways[i].contains(&j) || ways[j].contains(&i);
    let felt: Vec<BTreeSet<usize>> =
        moved.iter().map(|row| (0..ways.len()).filter(|j| row.iter().any(|i| coupled(*i, *j))).collect()).collect();
    let k = moved.len();
    let mut open: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); k];
    for i in 0..k {
        for j in 0..=i {
            if moved[i].is_disjoint(&felt[j]) {
                continue;
            }
            simple += CARRIED * carried[i].union(&carried[j]).count();
            if i != j {
                open[i].insert(j);
                open[j].insert(i);
            }
        }
    }
    let (more, deepest) = sparsest_first(open, lower);
    eliminated(simple + more, k, deepest)
}

/// Eliminates a symmetric pattern, of equally sparse rows the one that waits for the fewest others; what each row costs with so many
/// couplings, all together, and the longest chain of pivots.
fn sparsest_first(mut open: Vec<BTreeSet<usize>>, cost: impl Fn(usize) -> usize) -> (usize, usize) {
    let mut left: BTreeSet<usize> = (0..open.len()).collect();
    let (mut total, mut depth) = (0, vec![1; open.len()]);
    while let Some(p) = left.iter().copied().min_by_key(|p| (open[*p].len(), depth[*p], *p)) {
        left.remove(&p);
        let others = std::mem::take(&mut open[p]);
        total += cost(others.len());
        for i in &others {
            open[*i].extend(&others);
            open[*i].remove(i);
            open[*i].remove(&p);
            depth[*i] = depth[*i].max(depth[p] + 1);
        }
    }
    (total, depth.into_iter().max().unwrap_or(0))
}

/// The columns of each row for which something holds.
fn rows(matrix: &Matrix, holds: impl Fn(usize, usize) -> bool) -> Vec<BTreeSet<usize>> {
    (0..matrix.rows()).map(|i| (0..matrix.columns()).filter(|j| holds(i, *j)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern(n: usize, couplings: &[(usize, usize)]) -> Vec<BTreeSet<usize>> {
        let mut open = vec![BTreeSet::new(); n];
        for (i, j) in couplings {
            open[*i].insert(*j);
            open[*j].insert(*i);
        }
        open
    }

    /// A full pattern is eliminated row by row, a star from its points inwards, a row of neighbours from both ends or one.
    #[test]
    fn patterns_are_filled_as_little_as_possible() {
        let full: Vec<(usize, usize)> = (0..4).flat_map(|i| (0..i).map(move |j| (i, j))).collect();
        assert_eq!(sparsest_first(pattern(4, &full), |a| a), (6, 4));
        assert_eq!(sparsest_first(pattern(4, &[(0, 1), (0, 2), (0, 3)]), |a| a), (3, 2));
        let row = [(0, 1), (1, 2), (2, 3), (3, 4)];
        assert_eq!(sparsest_first(pattern(5, &row), |a| a).0, 4);
        // a ring needs two couplings for each of its rows but the last two
        let ring = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0)];
        assert_eq!(sparsest_first(pattern(5, &ring), |a| a).0, 2 + 2 + 2 + 1);
    }
}
