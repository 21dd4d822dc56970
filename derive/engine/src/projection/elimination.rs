//! C_d⁻¹ by Gauss-Jordan elimination on the arena.
//!
//! Pivots are taken in the order of what they cost at run time ([`pivots`](super::pivots)). Every zero test is decided.
//!
//! Where new guards are needed, the rows that are left are cut into the blocks of their block-triangular form, and a block
//! is inverted as a whole: its determinant is the only divisor. Rows eliminated one at a time would divide by an entry as
//! well, which may vanish where the determinant does not: in a planar loop sin q2 instead of sin(q2 - q3), and digits are
//! lost like its third power. Only what has too many minors (a full block of more than six rows) goes one row at a time.

use super::Simplifier;
use super::pivots::{NEW_GUARD, SAFE, cheapest, rank};
use super::steps::Step;
use crate::symbolic::blocks::{COFACTORS, cofactors, triangular};
use crate::symbolic::minors::by_minors;
use crate::symbolic::{Expr, Graph, Matrix};

/// What the elimination may use as pivots.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Columns in which pivots may stand.
    pub columns: Vec<bool>,
    /// Whether a pivot may need a guard that the model does not have yet.
    pub new_guards: bool,
}

/// A matrix in reduced form: `inverse · C = reduced`, with unit columns at the pivots.
#[derive(Clone, Debug)]
pub struct Elimination {
    /// The pivot column of each row.
    pub pivots: Vec<usize>,
    /// The value of each row's pivot when it was chosen; where a block was inverted as a whole its determinant, and one for
    /// its other rows.
    pub values: Vec<Expr>,
    /// How dear each of these was when it was chosen ([`pivots`](super::pivots)).
    pub ranks: Vec<u8>,
    /// The row of the block's determinant for each row; the row itself where it was eliminated alone.
    pub leaders: Vec<usize>,
    /// C_d⁻¹ C.
    pub reduced: Matrix,
    /// C_d⁻¹, rows in the order of C's rows: C_d⁻¹ maps C's rows to the reduced ones.
    pub inverse: Matrix,
    /// How the reduced form was made of C.
    steps: Vec<Step>,
}

impl Elimination {
    /// C_d⁻¹ b.
    ///
    /// In a long row of blocks that need each other C_d⁻¹ is full, although few things were done to the rows: where that is
    /// less, they are done to b.
    pub fn solve(&self, graph: &mut Graph, simplifier: &mut dyn Simplifier, b: &[Expr]) -> Vec<Expr> {
        if !self.is_shorter_by_steps(graph) {
            return self.inverse.mul_vec(graph, b);
        }
        let mut solution = b.to_vec();
        self.steps.iter().for_each(|step| step.apply(graph, simplifier, &mut solution));
        solution
    }

    /// C_d⁻ᵀ r, of r for the pivot of each row.
    pub fn solve_transposed(&self, graph: &mut Graph, simplifier: &mut dyn Simplifier, r: &[Expr]) -> Vec<Expr> {
        if !self.is_shorter_by_steps(graph) {
            return self.inverse.transpose().mul_vec(graph, r);
        }
        let mut solution = r.to_vec();
        self.steps.iter().rev().for_each(|step| step.apply_transposed(graph, simplifier, &mut solution));
        solution
    }

    fn is_shorter_by_steps(&self, graph: &Graph) -> bool {
        let entries = self.inverse.entries().iter().filter(|e| !graph.is_zero(**e)).count();
        self.steps.iter().map(|step| step.terms(graph)).sum::<usize>() < entries
    }

    /// What each row's pivot is, over names of the rows.
    pub fn pivot_names(&self, names: &[String]) -> Vec<String> {
        let block = |row: usize| {
            let rows = (0..names.len()).filter(|other| self.leaders[*other] == row);
            rows.map(|other| names[other].as_str()).collect::<Vec<_>>().join(", ")
        };
        let name = |row: usize| match self.leaders.iter().filter(|leader| **leader == row).count() {
            0 | 1 => format!("pivot of {}", names[row]),
            _ => format!("determinant of {}", block(row)),
        };
        (0..names.len()).map(name).collect()
    }
}

/// Why there is no reduced form.
#[derive(Clone, Debug)]
pub enum Stuck {
    /// The row is the zero combination with these coefficients over the rows of C.
    Dependent {
        /// The row at which it was found.
        row: usize,
        /// Coefficients of the combination that vanishes.
        combination: Vec<Expr>,
    },
    /// The row has no entry left in the allowed columns, though it is independent.
    Forbidden {
        /// The row.
        row: usize,
    },
    /// The row's remaining entries would need a new guard.
    NeedsGuard,
}

/// Reduces C.
pub fn eliminate(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    c: &Matrix,
    choice: &Choice,
) -> Result<Elimination, Stuck> {
    let (m, n) = (c.rows(), c.columns());
    let mut reduced = c.clone();
    for e in reduced.entries_mut() {
        *e = if graph.vanishes(*e) { graph.zero() } else { simplifier.one(graph, *e) };
    }
    let inverse = Matrix::identity(graph, m);
    let mut work = Work {
        reduced,
        inverse,
        pivots: vec![None; m],
        values: vec![graph.one(); m],
        ranks: vec![0; m],
        leaders: (0..m).collect(),
        steps: Vec::new(),
        columns: choice.columns.clone(),
    };
    let mut blocks_done = !choice.new_guards;
    while work.pivots.iter().any(Option::is_none) {
        let Some((row, column, dear)) = cheapest(graph, &work.reduced, &work.pivots, &work.columns) else {
            return Err(work.stuck(graph));
        };
        if dear == NEW_GUARD && !choice.new_guards {
            return Err(Stuck::NeedsGuard);
        }
        if dear == NEW_GUARD && !blocks_done {
            work.blocks(graph, simplifier);
            blocks_done = true;
            continue;
        }
        work.pivot(graph, simplifier, row, column, dear);
    }
    let Work { reduced, inverse, pivots, values, ranks, leaders, steps, .. } = work;
    debug_assert!(pivots.iter().flatten().all(|j| *j < n));
    Ok(Elimination { pivots: pivots.into_iter().flatten().collect(), values, ranks, leaders, reduced, inverse, steps })
}

/// An elimination on its way.
#[derive(Clone)]
struct Work {
    reduced: Matrix,
    inverse: Matrix,
    pivots: Vec<Option<usize>>,
    values: Vec<Expr>,
    ranks: Vec<u8>,
    leaders: Vec<usize>,
    steps: Vec<Step>,
    /// Columns in which pivots may stand.
    columns: Vec<bool>,
}

impl Work {
    fn open(&self) -> Vec<usize> {
        (0..self.pivots.len()).filter(|i| self.pivots[*i].is_none()).collect()
    }

    fn stuck(&self, graph: &Graph) -> Stuck {
        let row = self.open().first().copied().expect("a row without a pivot is left");
        match self.reduced.row(row).iter().all(|e| graph.is_zero(*e)) {
            true => Stuck::Dependent { row, combination: self.inverse.row(row).to_vec() },
            false => Stuck::Forbidden { row },
        }
    }

    /// One row by one of its entries.
    fn pivot(&mut self, graph: &mut Graph, simplifier: &mut dyn Simplifier, row: usize, column: usize, dear: u8) {
        let pivot = self.reduced.get(row, column);
        if dear >= SAFE {
            graph.assume_nonzero(pivot);
        }
        self.pivots[row] = Some(column);
        self.values[row] = pivot;
        self.ranks[row] = dear;
        scale_row(graph, &mut self.reduced, row, pivot);
        scale_row(graph, &mut self.inverse, row, pivot);
        let one = graph.one();
        self.reduced.set(row, column, one);
        self.steps.push(Step::Solve { rows: vec![row], adjugate: Matrix::identity(graph, 1), determinant: pivot });
        self.clear(graph, simplifier, row, column);
    }

    /// Clears a column whose pivot is one in all other rows.
    fn clear(&mut self, graph: &mut Graph, simplifier: &mut dyn Simplifier, row: usize, column: usize) {
        for other in (0..self.pivots.len()).filter(|i| *i != row) {
            let factor = self.reduced.get(other, column);
            if !graph.is_zero(factor) {
                subtract_row(graph, simplifier, &mut self.reduced, other, row, factor);
                subtract_row(graph, simplifier, &mut self.inverse, other, row, factor);
                self.steps.push(Step::Subtract { row: other, other: row, factor });
                let zero = graph.zero();
                self.reduced.set(other, column, zero);
            }
        }
    }

    /// The blocks of the open rows that are small enough to be inverted as a whole, each by its determinant.
    fn blocks(&mut self, graph: &mut Graph, simplifier: &mut dyn Simplifier) {
        let open = self.open();
        let Some(columns) = self.likely_columns(graph, simplifier, &open) else { return };
        let filled = |i: usize, j: usize| !graph.is_zero(self.reduced.get(open[i], columns[j]));
        let Some(found) = triangular(open.len(), filled) else { return };
        if found.iter().all(|block| block.rows.len() == 1) {
            return;
        }
        for block in found {
            let rows: Vec<usize> = block.rows.iter().map(|i| open[*i]).collect();
            let columns: Vec<usize> = block.columns.iter().map(|j| columns[*j]).collect();
            if !self.block(graph, simplifier, &rows, &columns) {
                // One row at a time; what follows may depend on it.
                return;
            }
        }
    }

    /// The columns that the open rows are solved for: those that are left, if they are as many, else those that
    /// pivots one at a time would take.
    fn likely_columns(&self, graph: &mut Graph, simplifier: &mut dyn Simplifier, open: &[usize]) -> Option<Vec<usize>> {
        let entry = |graph: &Graph, j: usize| open.iter().any(|i| !graph.is_zero(self.reduced.get(*i, j)));
        let left: Vec<usize> = (0..self.columns.len()).filter(|j| self.columns[*j] && entry(graph, *j)).collect();
        if left.len() <= open.len() {
            return (left.len() == open.len()).then_some(left);
        }
        let mut trial = self.clone();
        graph.without_new_assumptions(|graph| {
            while trial.pivots.iter().any(Option::is_none) {
                let (row, column, dear) = cheapest(graph, &trial.reduced, &trial.pivots, &trial.columns)?;
                trial.pivot(graph, simplifier, row, column, dear);
            }
            Some(())
        })?;
        Some(open.iter().filter_map(|i| trial.pivots[*i]).collect())
    }

    /// Solves the rows for the columns by the block's adjugate over its determinant; false where that vanishes, or the
    /// block has too many minors.
    fn block(&mut self, graph: &mut Graph, simplifier: &mut dyn Simplifier, rows: &[usize], columns: &[usize]) -> bool {
        let n = rows.len();
        let block = Matrix::from_fn(n, n, |i, j| self.reduced.get(rows[i], columns[j]));
        let found = match n <= COFACTORS {
            true => Some(cofactors(graph, &block)),
            false => by_minors(graph, &block, &mut |graph, e| simplifier.one(graph, e)),
        };
        let Some((adjugate, determinant)) = found else { return false };
        if graph.vanishes(determinant) {
            return false;
        }
        let determinant = simplifier.one(graph, determinant);
        let dear = rank(graph, determinant).unwrap_or(NEW_GUARD);
        graph.assume_nonzero(determinant);
        for half in [&mut self.reduced, &mut self.inverse] {
            let solved = adjugate.mul(graph, &half.select_rows(rows));
            for (i, row) in rows.iter().enumerate() {
                for j in 0..half.columns() {
                    let numerator = solved.get(i, j);
                    let entry = if graph.vanishes(numerator) {
                        graph.zero()
                    } else {
                        let numerator = simplifier.one(graph, numerator);
                        graph.div(numerator, determinant)
                    };
                    half.set(*row, j, entry);
                }
            }
        }
        for (i, (row, column)) in rows.iter().zip(columns).enumerate() {
            self.pivots[*row] = Some(*column);
            (self.values[*row], self.ranks[*row]) = if i == 0 { (determinant, dear) } else { (graph.one(), 0) };
            self.leaders[*row] = rows[0];
            for other in rows {
                let unit = if other == row { graph.one() } else { graph.zero() };
                self.reduced.set(*other, *column, unit);
            }
        }
        self.steps.push(Step::Solve { rows: rows.to_vec(), adjugate, determinant });
        for (row, column) in rows.iter().zip(columns) {
            self.clear(graph, simplifier, *row, *column);
        }
        true
    }
}

fn scale_row(graph: &mut Graph, matrix: &mut Matrix, row: usize, pivot: Expr) {
    for j in 0..matrix.columns() {
        let entry = matrix.get(row, j);
        if !graph.is_zero(entry) {
            let quotient = graph.div(entry, pivot);
            matrix.set(row, j, quotient);
        }
    }
}

fn subtract_row(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    matrix: &mut Matrix,
    row: usize,
    pivot_row: usize,
    factor: Expr,
) {
    for j in 0..matrix.columns() {
        let above = matrix.get(pivot_row, j);
        if graph.is_zero(above) {
            continue;
        }
        let product = graph.mul(factor, above);
        let difference = graph.sub(matrix.get(row, j), product);
        let entry = if graph.vanishes(difference) { graph.zero() } else { simplifier.one(graph, difference) };
        matrix.set(row, j, entry);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::projection::AsIs;
    use crate::symbolic::{Kind, Symbol};

    #[test]
    fn a_safe_pivot_is_left_to_the_row_that_has_no_other() {
        // [1 1; 1 s]: the second row's only safe pivot is the first column.
        let mut g = Graph::new();
        let x = g.symbol("x", Kind::Coordinate);
        let x = g.var(x);
        let (s, one) = (g.sin(x), g.one());
        let c = Matrix::from_rows(vec![vec![one, one, one], vec![one, s, g.zero()]], 3);
        let choice = Choice { columns: vec![true; 3], new_guards: false };
        let e = eliminate(&mut g, &mut AsIs, &c, &choice).expect("safe pivots suffice");
        assert_eq!(e.pivots[1], 0);
        let product = e.inverse.mul(&mut g, &c);
        for (a, b) in product.entries().iter().zip(e.reduced.entries()) {
            assert!(g.identical(*a, *b));
        }
    }

    #[test]
    fn a_block_divides_by_its_determinant_alone() {
        // A planar loop: [-l1 s1, -l2 s2, l3 s3; l1 c1, l2 c2, -l3 c3], solved for the second and third rates.
        let mut g = Graph::new();
        let symbols = ["q1", "q2", "q3"].map(|n| g.symbol(n, Kind::Coordinate));
        let q = g.vars(&symbols);
        let (s, c): (Vec<Expr>, Vec<Expr>) = q.iter().map(|q| (g.sin(*q), g.cos(*q))).unzip();
        let (s, c) = (vec![g.neg(s[0]), g.neg(s[1]), s[2]], vec![c[0], c[1], g.neg(c[2])]);
        let matrix = Matrix::from_rows(vec![s, c], 3);
        let choice = Choice { columns: vec![false, true, true], new_guards: true };
        let e = eliminate(&mut g, &mut AsIs, &matrix, &choice).expect("regular");
        let difference = g.sub(q[1], q[2]);
        let expected = g.sin(difference);
        let negative = g.neg(expected);
        assert!(g.identical(e.values[0], expected) || g.identical(e.values[0], negative));
        assert!(g.is_one(e.values[1]));
        let product = e.inverse.mul(&mut g, &matrix);
        for (a, b) in product.entries().iter().zip(e.reduced.entries()) {
            assert!(g.identical(*a, *b));
        }
        // At q2 = 0 the entry that a single pivot would divide by vanishes; the result is finite.
        let at = |s: Symbol| [0.0, 1.6, 0.0, 2.1][s.index().min(3)];
        assert!(g.evaluate(e.reduced.entries(), &at).iter().all(|value| value.is_finite()));
    }
}
