//! Inverses of matrices of expressions, with as few and as simple divisors as the matrix allows.
//!
//! Elimination by single pivots divides by what need not be divided by: a rotation matrix is regular everywhere, its
//! entries are not. So the matrix is first cut into the blocks of its block-triangular form (divisors of other blocks
//! never enter a block's inverse). Each block is then inverted as a whole: by its transpose where its rows or columns
//! are orthogonal, by cofactors up to 3 x 3, and only beyond that by pivots: numbers first, then parameters, then what
//! fills in least. A block's only divisors are then its determinant's factors.

use crate::symbolic::blocks::{COFACTORS, cofactors, triangular};
use crate::symbolic::{Expr, Graph, Matrix, Stage, Symbol};

/// An inverse and what it divides by.
pub(super) struct Inverse {
    pub matrix: Matrix,
    /// Divisors that are not numbers, each once, in the order of elimination. They are assumed non-zero in the graph.
    pub pivots: Vec<Expr>,
}

/// Coefficients with which the rows of a singular matrix add up to zero.
pub(super) struct Dependence(pub Vec<Expr>);

/// The inverse of a square matrix.
pub(super) fn inverse(graph: &mut Graph, matrix: &Matrix) -> Result<Inverse, Dependence> {
    let n = matrix.rows();
    let mut work = Elimination::new(graph, matrix);
    let found = triangular(n, |i, j| !graph.is_zero(work.left.get(i, j)));
    let Some(found) = found else { return Err(dependence(graph, matrix)) };
    for block in found {
        if !work.invert_block(graph, block.rows, block.columns) {
            return Err(dependence(graph, matrix));
        }
    }
    let Elimination { right, solved, pivots, .. } = work;
    let mut result = Matrix::zeros(graph, n, n);
    for (row, column) in solved {
        for j in 0..n {
            result.set(column, j, right.get(row, j));
        }
    }
    Ok(Inverse { matrix: result, pivots })
}

/// Gauss-Jordan elimination on `[matrix | 1]`, by blocks.
struct Elimination {
    left: Matrix,
    right: Matrix,
    /// Rows that hold the solution of a column.
    solved: Vec<(usize, usize)>,
    pivots: Vec<Expr>,
}

impl Elimination {
    fn new(graph: &mut Graph, matrix: &Matrix) -> Self {
        let n = matrix.rows();
        let mut left = matrix.clone();
        clear_vanishing(graph, left.entries_mut());
        Elimination { left, right: Matrix::identity(graph, n), solved: Vec::new(), pivots: Vec::new() }
    }

    /// Solves these rows for these columns; false if that is impossible.
    fn invert_block(&mut self, graph: &mut Graph, mut rows: Vec<usize>, mut columns: Vec<usize>) -> bool {
        loop {
            if let Some(inverse) = self.whole(graph, &rows, &columns) {
                return match inverse {
                    Ok(inverse) => {
                        self.eliminate(graph, &rows, &columns, &inverse);
                        true
                    }
                    Err(Singular) => false,
                };
            }
            let Some((i, j)) = self.pivot(graph, &rows, &columns) else { return false };
            self.eliminate_entry(graph, i, j);
            rows.retain(|row| *row != i);
            columns.retain(|column| *column != j);
        }
    }

    /// The inverse of a block by one of the closed forms; `None` if none applies.
    fn whole(&mut self, graph: &mut Graph, rows: &[usize], columns: &[usize]) -> Option<Result<Matrix, Singular>> {
        let n = rows.len();
        let block = Matrix::from_fn(n, n, |i, j| self.left.get(rows[i], columns[j]));
        if n > 1 {
            for by_rows in [true, false] {
                if let Some(norms) = orthogonal(graph, &block, by_rows) {
                    norms.iter().for_each(|norm| self.divide_by(graph, *norm));
                    return Some(Ok(Matrix::from_fn(n, n, |i, j| {
                        graph.div(block.get(j, i), norms[if by_rows { j } else { i }])
                    })));
                }
            }
        }
        if n > COFACTORS {
            return None;
        }
        let (adjugate, determinant) = cofactors(graph, &block);
        let determinant = settled(graph, determinant);
        if graph.vanishes(determinant) {
            return Some(Err(Singular));
        }
        self.divide_by(graph, determinant);
        Some(Ok(adjugate.map(|entries| {
            let quotients: Vec<Expr> = entries.iter().map(|entry| graph.div(*entry, determinant)).collect();
            quotients.into_iter().map(|entry| settled(graph, entry)).collect()
        })))
    }

    /// The best single pivot: a number before a parameter before the rest, ±1 before other numbers, then by the
    /// fill-in it may cause, then by position.
    fn pivot(&self, graph: &Graph, rows: &[usize], columns: &[usize]) -> Option<(usize, usize)> {
        let filled = |i: usize, j: usize| !graph.is_zero(self.left.get(i, j));
        let rank = |i: usize, j: usize| {
            let value = self.left.get(i, j);
            let class = match (graph.as_number(value), graph.stage(value)) {
                (Some(number), _) if number.as_integer().is_some_and(|number| number.abs() == 1) => 0,
                (Some(_), _) => 1,
                (None, Stage::Constant | Stage::Parameter) => 2,
                _ => 3,
            };
            let in_row = columns.iter().filter(|&&j| filled(i, j)).count().saturating_sub(1);
            let in_column = rows.iter().filter(|&&i| filled(i, j)).count().saturating_sub(1);
            (class, in_row * in_column, i, j)
        };
        let entries = rows.iter().flat_map(|&i| columns.iter().map(move |&j| (i, j)));
        entries.filter(|&(i, j)| filled(i, j)).min_by_key(|&(i, j)| rank(i, j))
    }

    fn eliminate_entry(&mut self, graph: &mut Graph, i: usize, j: usize) {
        let value = self.left.get(i, j);
        self.divide_by(graph, value);
        let inverse = Matrix::from_fn(1, 1, |_, _| graph.powi(value, -1));
        self.eliminate(graph, &[i], &[j], &inverse);
    }

    /// Turns the block into a unit matrix and clears its columns in all other rows.
    fn eliminate(&mut self, graph: &mut Graph, rows: &[usize], columns: &[usize], inverse: &Matrix) {
        let n = self.left.rows();
        for half in [&mut self.left, &mut self.right] {
            let block = half.select_rows(rows);
            let solved = inverse.mul(graph, &block);
            for (i, &row) in rows.iter().enumerate() {
                (0..n).for_each(|j| half.set(row, j, solved.get(i, j)));
            }
        }
        for (i, &row) in rows.iter().enumerate() {
            for (j, &column) in columns.iter().enumerate() {
                let unit = if i == j { graph.one() } else { graph.zero() };
                self.left.set(row, column, unit);
            }
        }
        for other in (0..n).filter(|row| !rows.contains(row)) {
            let factors: Vec<Expr> = columns.iter().map(|&column| self.left.get(other, column)).collect();
            if factors.iter().all(|factor| graph.is_zero(*factor)) {
                continue;
            }
            for half in [&mut self.left, &mut self.right] {
                for j in 0..n {
                    let mut terms = vec![half.get(other, j)];
                    for (factor, &row) in factors.iter().zip(rows) {
                        let product = graph.mul(*factor, half.get(row, j));
                        terms.push(graph.neg(product));
                    }
                    let mut entry = [graph.sum(&terms)];
                    clear_vanishing(graph, &mut entry);
                    half.set(other, j, entry[0]);
                }
            }
            columns.iter().for_each(|&column| self.left.set(other, column, graph.zero()));
        }
        self.solved.extend(rows.iter().copied().zip(columns.iter().copied()));
    }

    /// Records the factors of a divisor.
    fn divide_by(&mut self, graph: &mut Graph, divisor: Expr) {
        for (base, _) in graph.as_term(divisor).1 {
            if graph.as_number(base).is_none() && !self.pivots.contains(&base) {
                self.pivots.push(base);
            }
        }
        graph.assume_nonzero(divisor);
    }
}

/// A block without an inverse.
struct Singular;

/// Zero in place of what is identically zero.
fn clear_vanishing(graph: &Graph, entries: &mut [Expr]) {
    for entry in entries {
        if graph.vanishes(*entry) {
            *entry = graph.zero();
        }
    }
}

/// The squared norms of the rows (or columns), if these are orthogonal to each other.
fn orthogonal(graph: &mut Graph, block: &Matrix, by_rows: bool) -> Option<Vec<Expr>> {
    let n = block.rows();
    let across = block.transpose();
    let gram = if by_rows { block.mul(graph, &across) } else { across.mul(graph, block) };
    let diagonal = (0..n).all(|i| (0..i).all(|j| graph.vanishes(gram.get(i, j))));
    let norms: Vec<Expr> = (0..n).map(|i| settled(graph, gram.get(i, i))).collect();
    (diagonal && norms.iter().all(|norm| !graph.vanishes(*norm))).then_some(norms)
}

/// The expression without the symbols on which it does not depend: sin² + cos² is 1, as is the norm of a quaternion.
fn settled(graph: &mut Graph, expression: Expr) -> Expr {
    let mut settled = expression;
    for four in graph.spheres() {
        if graph.contains(settled, &four) {
            let (zero, one) = (graph.zero(), graph.one());
            let unit: Vec<(Symbol, Expr)> = four.iter().map(|s| (*s, if *s == four[0] { one } else { zero })).collect();
            let without = graph.substitute(&[settled], &unit)[0];
            if graph.identical(settled, without) {
                settled = without;
            }
        }
    }
    for symbol in graph.symbols_of(&[expression]) {
        if graph.contains(settled, &[symbol]) {
            let zero = graph.zero();
            let without = graph.substitute(&[settled], &[(symbol, zero)])[0];
            if graph.identical(settled, without) {
                settled = without;
            }
        }
    }
    settled
}

/// How the rows of a singular matrix depend on each other: elimination by single pivots until a row is left without.
fn dependence(graph: &mut Graph, matrix: &Matrix) -> Dependence {
    let n = matrix.rows();
    let mut work = Elimination::new(graph, matrix);
    let mut rows: Vec<usize> = (0..n).collect();
    let columns: Vec<usize> = (0..n).collect();
    while let Some((i, j)) = work.pivot(graph, &rows, &columns) {
        work.eliminate_entry(graph, i, j);
        rows.retain(|row| *row != i);
    }
    let row = rows.first().copied().unwrap_or_default();
    Dependence(work.right.row(row).to_vec())
}
