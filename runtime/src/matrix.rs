//! Small matrices of a fixed shape.

use core::fmt::Debug;

use nalgebra::SMatrix;

use crate::Scalar;

/// A matrix whose shape is known to the compiler; emitted models use nalgebra's `SMatrix`.
///
/// ```
/// use holonomy::Matrix;
/// use nalgebra::SMatrix;
///
/// let m = <SMatrix<f64, 2, 3> as Matrix<f64>>::from_fn(|i, j| (10 * i + j) as f64);
/// assert_eq!(m.entry(1, 2), 12.0);
/// assert_eq!(<SMatrix<f64, 2, 3> as Matrix<f64>>::COLUMNS, 3);
/// ```
pub trait Matrix<T: Scalar>: Copy + Debug + PartialEq {
    /// The number of rows.
    const ROWS: usize;
    /// The number of columns.
    const COLUMNS: usize;

    /// The entry in row i and column j, both from zero. Panics outside of the shape, as an index does.
    fn entry(&self, i: usize, j: usize) -> T;

    /// The matrix with the entries f(i, j).
    fn from_fn(f: impl FnMut(usize, usize) -> T) -> Self;
}

impl<T: Scalar, const R: usize, const C: usize> Matrix<T> for SMatrix<T, R, C> {
    const ROWS: usize = R;
    const COLUMNS: usize = C;

    #[inline(always)]
    fn entry(&self, i: usize, j: usize) -> T {
        self[(i, j)]
    }

    #[inline(always)]
    fn from_fn(f: impl FnMut(usize, usize) -> T) -> Self {
        SMatrix::from_fn(f)
    }
}
