//! QR by Householder reflections, with column pivoting.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::{NullSpace, NullSpaceMethod, relative};

/// Qᵀ B P = R for a matrix B, p × q; the columns of B in the order of their pivots.
pub(in crate::forms) struct Factors {
    /// Qᵀ, p × p, orthogonal.
    pub(in crate::forms) transposed: DMatrix<f64>,
    /// R, p × q, upper triangular in the first `rank` columns.
    pub(in crate::forms) r: DMatrix<f64>,
    /// The column of B that stands at each place.
    pub(in crate::forms) order: Vec<usize>,
    /// The number of pivots above the threshold.
    pub(in crate::forms) rank: usize,
    /// |R_ii|, the first that falls below the threshold included.
    pub(in crate::forms) pivots: Vec<f64>,
}

/// QR with column pivoting; stops at a pivot below `threshold` times the first, or at `most` pivots.
pub(in crate::forms) fn householder(mut r: DMatrix<f64>, threshold: f64, most: usize) -> Factors {
    let (p, q) = r.shape();
    let mut transposed = DMatrix::identity(p, p);
    let mut order: Vec<usize> = (0..q).collect();
    let (mut rank, mut pivots) = (0, Vec::new());
    for i in 0..p.min(q).min(most) {
        let mut largest = (i, -1.0);
        for j in i..q {
            let norm = r.view((i, j), (p - i, 1)).norm();
            if norm > largest.1 {
                largest = (j, norm);
            }
        }
        let (j, norm) = largest;
        pivots.push(norm);
        if norm <= threshold * pivots[0] {
            break;
        }
        r.swap_columns(i, j);
        order.swap(i, j);
        let mut normal: DVector<f64> = r.view((i, i), (p - i, 1)).column(0).into_owned();
        normal[0] += if normal[0] < 0.0 { -norm } else { norm };
        normal.normalize_mut();
        reflect(&mut r, i, &normal);
        reflect(&mut transposed, i, &normal);
        rank += 1;
    }
    Factors { transposed, r, order, rank, pivots }
}

/// Reflects the rows from `first` on in the plane with that normal.
fn reflect(matrix: &mut DMatrix<f64>, first: usize, normal: &DVector<f64>) {
    let mut rows = matrix.rows_mut(first, normal.len());
    let heights = rows.tr_mul(normal);
    rows.ger(-2.0, normal, &heights, 1.0);
}

impl Factors {
    /// y with R₁₁ y = b, for the pivots' columns.
    pub(in crate::forms) fn solve(&self, b: &DMatrix<f64>) -> DMatrix<f64> {
        let mut y = b.clone();
        for column in 0..y.ncols() {
            for i in (0..self.rank).rev() {
                let known: f64 = (i + 1..self.rank).map(|j| self.r[(i, j)] * y[(j, column)]).sum();
                y[(i, column)] = (y[(i, column)] - known) / self.r[(i, i)];
            }
        }
        y
    }
}

/// C with scaled rows → an orthonormal D, and G of least norm: Cᵀ P = Q [R₁₁, R₁₂; 0, 0], G = Q₁ R₁₁⁻ᵀ on the independent rows.
pub(super) fn null_space(c: &DMatrix<f64>, threshold: f64) -> NullSpace {
    let (m, n) = c.shape();
    let factors = householder(c.transpose(), threshold, m.min(n));
    let rank = factors.rank;
    let complement = factors.transposed.rows(rank, n - rank).into_owned();
    // Gᵀ = R₁₁⁻¹ Q₁ᵀ.
    let solved = factors.solve(&factors.transposed.rows(0, rank).into_owned());
    let mut inverse = DMatrix::zeros(n, m);
    for (at, &row) in factors.order.iter().take(rank).enumerate() {
        inverse.column_mut(row).copy_from(&solved.row(at).transpose());
    }
    let mut figures = factors.pivots;
    relative(&mut figures, m.min(n));
    NullSpace { method: NullSpaceMethod::Qr, complement, rank, figures, independent: Vec::new(), inverse }
}
