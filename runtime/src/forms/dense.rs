//! Dense linear equations that say when they have no unique solution.

use nalgebra::{DMatrix, DVector};

use crate::Error;
use crate::math::double::pow;

/// Pivots below this many units of rounding, times the size of the matrix, count as zero.
const SINGULAR: f64 = 16.0 * f64::EPSILON;
/// Rounds of scaling; each halves the exponent by which rows and columns differ.
const ROUNDS: usize = 6;

/// Solves K Z = R by LU with complete pivoting, after scaling rows and columns by powers of two so that units do not matter.
///
/// `name` names K in errors.
pub(crate) fn solve(
    name: &'static str,
    mut matrix: DMatrix<f64>,
    mut right: DMatrix<f64>,
) -> Result<DMatrix<f64>, Error> {
    let n = matrix.nrows();
    if n == 0 {
        return Ok(right);
    }
    let columns = equilibrate(&mut matrix, &mut right);
    if matrix.iter().chain(right.iter()).any(|entry| !entry.is_finite()) {
        return Err(Error::NonFinite { name });
    }
    let lu = matrix.full_piv_lu();
    let diagonal = lu.u().diagonal();
    let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
    for pivot in diagonal.iter() {
        smallest = smallest.min(pivot.abs());
        largest = largest.max(pivot.abs());
    }
    if smallest <= SINGULAR * n as f64 * largest {
        let pivot = if largest > 0.0 { smallest / largest } else { 0.0 };
        return Err(Error::SingularMatrix { matrix: name, pivot });
    }
    let singular = Error::SingularMatrix { matrix: name, pivot: 0.0 };
    let mut solution = lu.solve(&right).ok_or(singular)?;
    for (i, scale) in columns.iter().enumerate() {
        solution.row_mut(i).scale_mut(*scale);
    }
    Ok(solution)
}

/// Solves K z = r for K = D M Dᵀ, which must be positive definite, by LDLᵀ.
///
/// `sizes` are the sums of the magnitudes behind the entries on K's diagonal: what is left of one of them after the elimination
/// counts as zero below a few units of its rounding. `name` names a pivot of K in errors.
pub(super) fn solve_definite(
    name: &'static str,
    mut matrix: DMatrix<f64>,
    mut right: DVector<f64>,
    sizes: &[f64],
) -> Result<DVector<f64>, Error> {
    let n = matrix.nrows();
    if matrix.iter().chain(right.iter()).any(|entry| !entry.is_finite()) {
        return Err(Error::NonFinite { name });
    }
    for j in 0..n {
        let pivot = matrix[(j, j)];
        if pivot <= SINGULAR * n as f64 * sizes[j] {
            return Err(Error::Indefinite { pivot: name, value: pivot, time: None });
        }
        for i in j + 1..n {
            let multiple = matrix[(i, j)] / pivot;
            for k in j + 1..=i {
                matrix[(i, k)] -= multiple * matrix[(k, j)];
            }
            right[i] -= multiple * right[j];
        }
        // The column stays as it is: rows below subtract multiples of it.
    }
    for j in (0..n).rev() {
        let known: f64 = (j + 1..n).map(|i| matrix[(i, j)] * right[i]).sum();
        right[j] = (right[j] - known) / matrix[(j, j)];
    }
    Ok(right)
}

/// A vector as a matrix with one column.
pub(super) fn column(vector: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_column_slice(vector.len(), 1, vector.as_slice())
}

/// Scales rows (with the right sides) and columns until their largest entries are near one; gives the columns' scales.
fn equilibrate(matrix: &mut DMatrix<f64>, right: &mut DMatrix<f64>) -> alloc::vec::Vec<f64> {
    let n = matrix.nrows();
    let mut columns = alloc::vec![1.0; n];
    for _ in 0..ROUNDS {
        let rows: alloc::vec::Vec<f64> = (0..n).map(|i| factor(matrix.row(i).amax())).collect();
        let scales: alloc::vec::Vec<f64> = (0..n).map(|j| factor(matrix.column(j).amax())).collect();
        for (i, scale) in rows.iter().enumerate() {
            matrix.row_mut(i).scale_mut(*scale);
            right.row_mut(i).scale_mut(*scale);
        }
        for (j, scale) in scales.iter().enumerate() {
            matrix.column_mut(j).scale_mut(*scale);
            columns[j] *= scale;
        }
    }
    columns
}

/// A power of two near 1/√largest.
fn factor(largest: f64) -> f64 {
    match exponent(largest) {
        Some(exponent) => pow(2.0, f64::from(-exponent / 2)),
        None => 1.0,
    }
}

/// A power of two near 1/largest; one where that is zero or not a number.
pub(super) fn unit_scale(largest: f64) -> f64 {
    match exponent(largest) {
        Some(exponent) => pow(2.0, f64::from(-exponent)),
        None => 1.0,
    }
}

/// The binary exponent of a positive number.
fn exponent(largest: f64) -> Option<i32> {
    (largest > 0.0 && largest.is_finite()).then(|| ((largest.to_bits() >> 52) & 0x7ff) as i32 - 1023)
}
