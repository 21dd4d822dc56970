//! C_d⁻¹ by Gauss-Jordan elimination on the arena.
//!
//! Pivots are taken in the order of what they cost at run time: ±1, other numbers, parameters, quantities that are
//! guarded already, and only then quantities that need a new guard. Every zero test is decided.

use super::Simplifier;
use crate::symbolic::{Expr, Graph, Matrix, Rational, Stage};

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
    /// The value of each row's pivot when it was chosen.
    pub values: Vec<Expr>,
    /// C_d⁻¹ C.
    pub reduced: Matrix,
    /// C_d⁻¹, rows in the order of C's rows: C_d⁻¹ maps C's rows to the reduced ones.
    pub inverse: Matrix,
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

/// How dear an entry is as a pivot; `None` where it is zero.
fn rank(graph: &Graph, e: Expr) -> Option<u8> {
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
    let known = factors.iter().all(|(base, _)| graph.is_nonzero(*base) || graph.stage(*base) <= Stage::Parameter);
    Some(if known { 3 } else { 4 })
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
    let mut inverse = Matrix::identity(graph, m);
    let mut pivots: Vec<Option<usize>> = vec![None; m];
    let mut values = vec![graph.one(); m];
    for _ in 0..m {
        let Some((row, column, dear)) = cheapest(graph, &reduced, &pivots, choice) else {
            let row = pivots.iter().position(Option::is_none).expect("a row without a pivot is left");
            return Err(match reduced.row(row).iter().all(|e| graph.is_zero(*e)) {
                true => Stuck::Dependent { row, combination: inverse.row(row).to_vec() },
                false => Stuck::Forbidden { row },
            });
        };
        if dear == 4 && !choice.new_guards {
            return Err(Stuck::NeedsGuard);
        }
        let pivot = reduced.get(row, column);
        if dear >= 3 {
            graph.assume_nonzero(pivot);
        }
        pivots[row] = Some(column);
        values[row] = pivot;
        scale_row(graph, &mut reduced, row, pivot);
        scale_row(graph, &mut inverse, row, pivot);
        let one = graph.one();
        reduced.set(row, column, one);
        for other in (0..m).filter(|i| *i != row) {
            let factor = reduced.get(other, column);
            if !graph.is_zero(factor) {
                subtract_row(graph, simplifier, &mut reduced, other, row, factor);
                subtract_row(graph, simplifier, &mut inverse, other, row, factor);
                let zero = graph.zero();
                reduced.set(other, column, zero);
            }
        }
    }
    debug_assert!(pivots.iter().flatten().all(|j| *j < n));
    Ok(Elimination { pivots: pivots.into_iter().flatten().collect(), values, reduced, inverse })
}

/// The cheapest pivot: by kind, then by fill-in (Markowitz), then by position.
fn cheapest(graph: &Graph, matrix: &Matrix, pivots: &[Option<usize>], choice: &Choice) -> Option<(usize, usize, u8)> {
    let open: Vec<usize> = (0..matrix.rows()).filter(|i| pivots[*i].is_none()).collect();
    let in_row = |i: usize| matrix.row(i).iter().filter(|e| !graph.is_zero(**e)).count();
    let in_column = |j: usize| (0..matrix.rows()).filter(|i| !graph.is_zero(matrix.get(*i, j))).count();
    let rows: Vec<usize> = open.iter().map(|i| in_row(*i)).collect();
    let columns: Vec<usize> = (0..matrix.columns()).map(in_column).collect();
    let mut best: Option<((u8, usize, usize, usize), u8)> = None;
    for (at, i) in open.iter().enumerate() {
        for j in (0..matrix.columns()).filter(|j| choice.columns[*j]) {
            if let Some(dear) = rank(graph, matrix.get(*i, j)) {
                let fill = (rows[at] - 1) * (columns[j] - 1);
                let score = (dear, fill, *i, j);
                if best.is_none_or(|(least, _)| score < least) {
                    best = Some((score, dear));
                }
            }
        }
    }
    best.map(|((_, _, i, j), dear)| (i, j, dear))
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
