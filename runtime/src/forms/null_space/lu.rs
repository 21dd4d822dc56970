//! Null space by LU with complete pivoting.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::{NullSpace, NullSpaceMethod, relative};

/// C with scaled rows → D with a unit block, and G with zeros in the independent rows.
///
/// Gauss-Jordan on [C | 1]: with the pivots' columns d and the others i, `C = C_d [1, X]` on the independent rows, so that
/// D = [−Xᵀ, 1] and G = [C_d⁻¹; 0]. The columns come multiplied by
/// `scales`, which is undone at the end.
pub(super) fn null_space(mut c: DMatrix<f64>, threshold: f64, scales: &[f64]) -> NullSpace {
    let (m, n) = c.shape();
    let mut inverse = DMatrix::identity(m, m);
    let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut figures = Vec::new();
    for _ in 0..m.min(n) {
        let (i, j, pivot) = largest(&c, &rows, &columns);
        figures.push(pivot.abs());
        if pivot.abs() <= threshold * figures[0] {
            break;
        }
        c.row_mut(i).unscale_mut(pivot);
        inverse.row_mut(i).unscale_mut(pivot);
        let (pivot_row, pivot_inverse) = (c.row(i).into_owned(), inverse.row(i).into_owned());
        for other in (0..m).filter(|other| *other != i) {
            let multiple = c[(other, j)];
            if multiple != 0.0 {
                c.row_mut(other).zip_apply(&pivot_row, |entry, pivot| *entry -= multiple * pivot);
                inverse.row_mut(other).zip_apply(&pivot_inverse, |entry, pivot| *entry -= multiple * pivot);
                c[(other, j)] = 0.0;
            }
        }
        rows.push(i);
        columns.push(j);
    }
    let rank = rows.len();
    let independent: Vec<usize> = (0..n).filter(|j| !columns.contains(j)).collect();
    let mut complement = DMatrix::zeros(n - rank, n);
    for (at, &j) in independent.iter().enumerate() {
        complement[(at, j)] = 1.0;
        for (&row, &column) in rows.iter().zip(&columns) {
            complement[(at, column)] = -c[(row, j)] * scales[column] / scales[j];
        }
    }
    let mut general = DMatrix::zeros(n, m);
    for (&row, &column) in rows.iter().zip(&columns) {
        general.row_mut(column).copy_from(&(inverse.row(row) * scales[column]));
    }
    // Dependent rows have no part in the inverse of the others.
    for row in (0..m).filter(|row| !rows.contains(row)) {
        general.column_mut(row).fill(0.0);
    }
    relative(&mut figures, m.min(n));
    NullSpace { method: NullSpaceMethod::Lu, complement, rank, figures, independent, inverse: general }
}

/// The largest entry outside of the rows and columns that are done.
fn largest(c: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> (usize, usize, f64) {
    let mut found = (0, 0, 0.0_f64);
    for j in (0..c.ncols()).filter(|j| !columns.contains(j)) {
        for i in (0..c.nrows()).filter(|i| !rows.contains(i)) {
            if c[(i, j)].abs() > found.2.abs() {
                found = (i, j, c[(i, j)]);
            }
        }
    }
    found
}
