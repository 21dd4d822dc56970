//! Singular values by one-sided Jacobi rotations: small ones are as accurate as large ones.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::{NullSpace, NullSpaceMethod, relative};
use crate::math::double::sqrt;

/// Sweeps over all pairs of columns; a handful is needed.
const SWEEPS: usize = 60;

/// C with scaled rows → an orthonormal D, and the pseudo-inverse G = V Σ⁺ Uᵀ.
///
/// Rotations V make the columns of C V orthogonal; their norms are the singular values, and the columns of V that C sends to
/// zero span the null space.
pub(super) fn null_space(mut c: DMatrix<f64>, threshold: f64) -> NullSpace {
    let (m, n) = c.shape();
    let mut v = DMatrix::identity(n, n);
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for i in 0..n {
            for j in i + 1..n {
                rotated |= rotate(&mut c, &mut v, i, j);
            }
        }
        if !rotated {
            break;
        }
    }
    let norms: Vec<f64> = c.column_iter().map(|column| column.norm()).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| norms[*b].total_cmp(&norms[*a]));
    let largest = order.first().map_or(0.0, |first| norms[*first]);
    let rank = order.iter().take(m).filter(|at| norms[**at] > threshold * largest).count();
    let complement = DMatrix::from_fn(n - rank, n, |i, j| v[(j, order[rank + i])]);
    let mut inverse = DMatrix::zeros(n, m);
    for &at in order.iter().take(rank) {
        inverse.ger(1.0 / (norms[at] * norms[at]), &v.column(at), &c.column(at), 1.0);
    }
    let mut figures: Vec<f64> = order.iter().take(m.min(n)).map(|at| norms[*at]).collect();
    relative(&mut figures, m.min(n));
    NullSpace { method: NullSpaceMethod::Svd, complement, rank, figures, independent: Vec::new(), inverse }
}

/// Rotates two columns of C, and of V with them, until they are orthogonal; tells whether they were not.
fn rotate(c: &mut DMatrix<f64>, v: &mut DMatrix<f64>, i: usize, j: usize) -> bool {
    let (a, b) = (c.column(i).norm_squared(), c.column(j).norm_squared());
    let product = c.column(i).dot(&c.column(j));
    if product.abs() <= f64::EPSILON * sqrt(a) * sqrt(b) {
        return false;
    }
    let ratio = (b - a) / (2.0 * product);
    let tangent = 1.0_f64.copysign(ratio) / (ratio.abs() + sqrt(1.0 + ratio * ratio));
    let cosine = 1.0 / sqrt(1.0 + tangent * tangent);
    let sine = cosine * tangent;
    for matrix in [c, v] {
        for row in 0..matrix.nrows() {
            let (x, y) = (matrix[(row, i)], matrix[(row, j)]);
            matrix[(row, i)] = cosine * x - sine * y;
            matrix[(row, j)] = sine * x + cosine * y;
        }
    }
    true
}
