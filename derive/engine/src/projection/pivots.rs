//! The choice of a pivot, in the order of what it costs at run time: ±1, other numbers, parameters, quantities that cannot
//! vanish or are guarded already, and only then quantities that need a new guard.

use crate::symbolic::{Expr, Graph, Matrix, Rational, Stage};
use std::collections::{BTreeMap, VecDeque};

/// The highest rank of a pivot that cannot vanish.
pub const SAFE: u8 = 3;

/// The rank of a pivot that needs a guard of its own.
pub const NEW_GUARD: u8 = 5;

/// How dear an entry is as a pivot; `None` where it is zero.
pub fn rank(graph: &Graph, e: Expr) -> Option<u8> {
    if graph.is_zero(e) {
        return None;
    }
    if let Some(number) = graph.as_number(e) {
        let unit = *number == Rational::ONE || *number == Rational::MINUS_ONE;
        return Some(if unit { 0 } else { 1 });
    }
    if graph.stage(e) <= Stage::Parameter {
        return Some(2);
    }
    let (_, factors) = graph.as_term(e);
    let cannot_vanish = |base: Expr| graph.stage(base) <= Stage::Parameter || graph.bounds(base).exclude_zero();
    if factors.iter().all(|(base, _)| cannot_vanish(*base)) {
        return Some(SAFE);
    }
    let known = factors.iter().all(|(base, _)| graph.is_nonzero(*base) || cannot_vanish(*base));
    Some(if known { 4 } else { NEW_GUARD })
}

/// The cheapest pivot: by kind, then by fill-in (Markowitz), then by position. A pivot that cannot vanish is passed over
/// where taking it would leave another row without one.
pub fn cheapest(
    graph: &Graph,
    matrix: &Matrix,
    pivots: &[Option<usize>],
    allowed: &[bool],
) -> Option<(usize, usize, u8)> {
    let open: Vec<usize> = (0..matrix.rows()).filter(|i| pivots[*i].is_none()).collect();
    let in_row = |i: usize| matrix.row(i).iter().filter(|e| !graph.is_zero(**e)).count();
    let in_column = |j: usize| (0..matrix.rows()).filter(|i| !graph.is_zero(matrix.get(*i, j))).count();
    let columns: Vec<usize> = (0..matrix.columns()).map(in_column).collect();
    let mut candidates: Vec<(u8, usize, usize, usize)> = Vec::new();
    for i in &open {
        let width = in_row(*i);
        for j in (0..matrix.columns()).filter(|j| allowed[*j]) {
            if let Some(dear) = rank(graph, matrix.get(*i, j)) {
                candidates.push((dear, (width - 1) * (columns[j] - 1), *i, j));
            }
        }
    }
    candidates.sort_unstable();
    let safe: Vec<(usize, usize)> = candidates.iter().filter(|c| c.0 <= SAFE).map(|c| (c.2, c.3)).collect();
    let most = matching(&safe, None);
    let keeps_the_others = |c: &&(u8, usize, usize, usize)| c.0 > SAFE || matching(&safe, Some((c.2, c.3))) + 1 == most;
    let best = candidates.iter().find(keeps_the_others).or(candidates.first());
    best.map(|(dear, _, i, j)| (*i, *j, *dear))
}

/// How many rows can have a column of their own among the entries (row, column), without one entry's row and column.
fn matching(entries: &[(usize, usize)], without: Option<(usize, usize)>) -> usize {
    let mut columns_of: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (i, j) in entries {
        if without.is_none_or(|(row, column)| *i != row && *j != column) {
            columns_of.entry(*i).or_default().push(*j);
        }
    }
    let mut row_of: BTreeMap<usize, usize> = BTreeMap::new();
    columns_of.keys().filter(|row| augment(**row, &columns_of, &mut row_of)).count()
}

/// Finds a column for the row, moving other rows to other columns where that helps: breadth first.
fn augment(row: usize, columns_of: &BTreeMap<usize, Vec<usize>>, row_of: &mut BTreeMap<usize, usize>) -> bool {
    // The row from which each column was reached.
    let mut reached: BTreeMap<usize, usize> = BTreeMap::new();
    let mut queue = VecDeque::from([row]);
    while let Some(from) = queue.pop_front() {
        for column in &columns_of[&from] {
            if reached.contains_key(column) {
                continue;
            }
            reached.insert(*column, from);
            if let Some(next) = row_of.get(column) {
                queue.push_back(*next);
                continue;
            }
            // Free: shift every row on the way back.
            let mut column = *column;
            loop {
                let owner = reached[&column];
                let before = row_of.iter().find(|(_, r)| **r == owner).map(|(c, _)| *c);
                row_of.insert(column, owner);
                match before.filter(|_| owner != row) {
                    Some(previous) => column = previous,
                    None => return true,
                }
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    #[test]
    fn pivots_are_ranked_by_what_they_cost() {
        let mut g = Graph::new();
        let [x, m] = [("x", Kind::Coordinate), ("m", Kind::Parameter)].map(|(name, kind)| {
            let symbol = g.symbol(name, kind);
            g.var(symbol)
        });
        let two = g.integer(2);
        let (one, minus) = (g.one(), g.neg(g.one()));
        let cosine = g.cos(x);
        let safe = g.add(two, cosine);
        let scaled = g.mul(m, safe);
        let with_guard = g.mul(scaled, cosine);
        let ranks = |g: &Graph| [one, minus, two, m, safe, scaled, cosine, with_guard, x].map(|e| rank(g, e));
        assert_eq!(ranks(&g), [0, 0, 1, 2, 3, 3, 5, 5, 5].map(Some));
        g.assume_nonzero(cosine);
        assert_eq!(ranks(&g), [0, 0, 1, 2, 3, 3, 4, 4, 5].map(Some));
        assert_eq!(rank(&g, g.zero()), None);
    }

    /// Of two pivots that cannot vanish the one is taken that leaves the other row a safe one; a pivot that may vanish takes
    /// nothing from anybody.
    #[test]
    fn the_cheapest_pivot_keeps_safe_ones_for_other_rows() {
        let mut g = Graph::new();
        let [x, y] = ["x", "y"].map(|name| {
            let symbol = g.symbol(name, Kind::Coordinate);
            g.var(symbol)
        });
        let (zero, one, cosine) = (g.zero(), g.one(), g.cos(x));
        let two = g.integer(2);
        let safe = g.add(two, cosine);
        let taken = |rows: Vec<Vec<Expr>>| {
            let matrix = Matrix::from_rows(rows, 2);
            cheapest(&g, &matrix, &[None, None], &[true, true]).map(|(i, j, _)| (i, j))
        };
        // Column 0 is the only safe one of the second row.
        assert_eq!(taken(vec![vec![one, one], vec![one, x]]), Some((0, 1)));
        assert_eq!(taken(vec![vec![safe, safe], vec![safe, x]]), Some((0, 1)));
        assert_eq!(taken(vec![vec![x, zero], vec![y, y]]), Some((0, 0)));
        assert_eq!(taken(vec![vec![zero, zero], vec![zero, y]]), Some((1, 1)));
    }

    /// Against all ways to give rows columns of their own.
    #[test]
    fn matchings_are_those_of_a_search_through_all() {
        fn most(rows: &[Vec<usize>], taken: &mut Vec<usize>) -> usize {
            let Some((first, others)) = rows.split_first() else { return 0 };
            let mut best = most(others, taken);
            for column in first {
                if !taken.contains(column) {
                    taken.push(*column);
                    best = best.max(1 + most(others, taken));
                    taken.pop();
                }
            }
            best
        }
        let mut seed = 1_u64;
        for _ in 0..400 {
            let mut rows = vec![Vec::new(); 6];
            for (i, row) in rows.iter_mut().enumerate() {
                for j in 0..6 {
                    seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    if (seed >> 60) < 3 + i as u64 % 3 {
                        row.push(j);
                    }
                }
            }
            let entries: Vec<(usize, usize)> =
                rows.iter().enumerate().flat_map(|(i, row)| row.iter().map(move |j| (i, *j))).collect();
            assert_eq!(matching(&entries, None), most(&rows, &mut Vec::new()), "{rows:?}");
        }
    }

    #[test]
    fn matchings_are_the_largest() {
        assert_eq!(matching(&[(0, 0), (0, 1), (1, 0), (2, 1), (2, 2)], None), 3);
        assert_eq!(matching(&[(0, 0), (1, 0), (2, 0)], None), 1);
        assert_eq!(matching(&[(0, 0), (0, 1), (1, 0), (2, 1), (2, 2)], Some((0, 0))), 1);
        assert_eq!(matching(&[(0, 0), (0, 1), (1, 0), (2, 1), (2, 2)], Some((1, 0))), 2);
    }
}
