//! Dense linear equations that say when they have no unique solution.

use nalgebra::DMatrix;

use crate::Error;
use crate::math::double::pow;

/// Pivots below this many units of rounding, times the size of the matrix, count as zero.
const SINGULAR: f64 = 16.0 * f64::EPSILON;
/// Rounds of scaling; each halves the exponent by which rows and columns differ.
const ROUNDS: usize = 6;

/// Solves K Z = R by LU with complete pivoting, after scaling rows and columns by powers of two so that units do not matter.
///
/// `name` names K in errors.
pub(super) fn solve(
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
    if largest > 0.0 && largest.is_finite() {
        let exponent = ((largest.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        pow(2.0, f64::from(-exponent / 2))
    } else {
        1.0
    }
}
