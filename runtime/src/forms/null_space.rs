//! The null space of C at run time: D with D Cᵀ = 0 (3.1), found numerically at one state.
//!
//! | method | D | [`particular`](NullSpace::particular) | [`figures`](NullSpace::figures) | its price |
//! |---|---|---|---|---|
//! | [`Lu`](NullSpaceMethod::Lu) | unit block in the columns [`independent`](NullSpace::independent): u = those v | zero there | pivots of an LU with complete pivoting | cheapest, sparse; not orthogonal |
//! | [`Qr`](NullSpaceMethod::Qr) | orthonormal rows | of least norm | diagonal of R in a QR of Cᵀ with column pivoting | jumps between states |
//! | [`Svd`](NullSpaceMethod::Svd) | orthonormal rows | of least norm | singular values | dearest; tells the rank best |
//!
//! All three may be used in (3.5), whose v̇ does not depend on the choice. None gives a D that is smooth in the state, so none
//! may be differentiated.
//!
//! The rows of C are scaled to entries near one first, so that their units do not matter. The velocities are compared as they
//! are; [`InitialEquations::null_space`](super::InitialEquations::null_space) lets `Lu` compare v_j √M_jj, so that the unit of
//! a velocity does not decide which ones become independent.

mod householder;
mod jacobi;
mod lu;

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::dense::unit_scale;
use crate::Error;

pub(super) use householder::householder;

/// A pivot or singular value of the scaled C below this fraction of the largest counts as zero.
pub const RANK_THRESHOLD: f64 = 1e-12;

/// How the null space of C is found; the module's page compares them.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum NullSpaceMethod {
    /// LU with complete pivoting: D has a unit block.
    Lu,
    /// QR of Cᵀ with column pivoting: D is orthonormal.
    Qr,
    /// Singular values, by Jacobi rotations: D is orthonormal.
    Svd,
}

/// The null space of a matrix C: D of (3.1), and what solves C z + r = 0.
///
/// ```
/// use holonomy::forms::{NullSpace, NullSpaceMethod};
/// use nalgebra::{DMatrix, DVector};
///
/// let c = DMatrix::from_row_slice(1, 3, &[2.0, 0.0, -1.0]);
/// for method in [NullSpaceMethod::Lu, NullSpaceMethod::Qr, NullSpaceMethod::Svd] {
///     let null = NullSpace::new(&c, method)?;
///     assert_eq!((null.rank, null.complement.shape()), (1, (2, 3)));
///     assert!((&null.complement * c.transpose()).amax() < 1e-15);
///     let z = null.particular(&DVector::from_element(1, -4.0));
///     assert!(((&c * z)[0] - 4.0).abs() < 1e-14);
/// }
/// // The largest entry is the pivot: v1 depends on the others.
/// assert_eq!(NullSpace::new(&c, NullSpaceMethod::Lu)?.independent, [1, 2]);
/// # Ok::<(), holonomy::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NullSpace {
    /// How it was found.
    pub method: NullSpaceMethod,
    /// D, k × n, with k = n − rank.
    pub complement: DMatrix<f64>,
    /// The rank of C: the number of figures above the threshold.
    pub rank: usize,
    /// Pivots or singular values of the scaled C relative to the largest, in falling order (pivots: nearly so).
    pub figures: Vec<f64>,
    /// With a unit block: the columns in which it stands, one for each row of D. Empty otherwise.
    pub independent: Vec<usize>,
    /// G, n × m, with C G C = C.
    pub inverse: DMatrix<f64>,
}

impl NullSpace {
    /// The null space of C with the default threshold, [`RANK_THRESHOLD`].
    pub fn new(c: &DMatrix<f64>, method: NullSpaceMethod) -> Result<Self, Error> {
        Self::with_threshold(c, method, RANK_THRESHOLD)
    }

    /// The same with another threshold, relative to the largest pivot or singular value of the scaled C.
    pub fn with_threshold(c: &DMatrix<f64>, method: NullSpaceMethod, threshold: f64) -> Result<Self, Error> {
        Self::weighted(c, method, threshold, &[])
    }

    /// The same; complete pivoting compares the columns after a division by the weights (one, where there are none).
    pub(super) fn weighted(
        c: &DMatrix<f64>,
        method: NullSpaceMethod,
        threshold: f64,
        weights: &[f64],
    ) -> Result<Self, Error> {
        if c.iter().any(|entry| !entry.is_finite()) {
            return Err(Error::NonFinite { name: "C" });
        }
        let columns: Vec<f64> =
            (0..c.ncols()).map(|j| weights.get(j).map_or(1.0, |weight| unit_scale(*weight))).collect();
        let weighted = DMatrix::from_fn(c.nrows(), c.ncols(), |i, j| c[(i, j)] * columns[j]);
        let (scaled, scales) = scale_rows(if method == NullSpaceMethod::Lu { &weighted } else { c });
        let mut null = match method {
            NullSpaceMethod::Lu => lu::null_space(scaled, threshold, &columns),
            NullSpaceMethod::Qr => householder::null_space(&scaled, threshold),
            NullSpaceMethod::Svd => jacobi::null_space(scaled, threshold),
        };
        for (i, scale) in scales.iter().enumerate() {
            null.inverse.column_mut(i).scale_mut(*scale);
        }
        Ok(null)
    }

    /// z with C z + r = 0, where there is one: velocities v_p for r = η of C v + η = 0 (5.1), a_u for r = c0* (4.5), (5.5).
    ///
    /// With a unit block its independent entries are zero, so that u = v there and no derivative of D is needed; otherwise it
    /// is the z of least norm. Where C has dependent rows that contradict each other, it meets the independent ones (`Lu`) or
    /// comes as near as possible (`Svd`).
    pub fn particular(&self, r: &DVector<f64>) -> DVector<f64> {
        -(&self.inverse * r)
    }
}

/// The shortest z for which J z comes nearest to r; singular values below `threshold` times the largest count as zero.
pub(crate) fn least_squares(j: DMatrix<f64>, r: &DVector<f64>, threshold: f64) -> DVector<f64> {
    jacobi::null_space(j, threshold).inverse * r
}

/// Orthonormal rows z with J z = 0; singular values below `threshold` times the largest count as zero.
pub(crate) fn null_directions(j: DMatrix<f64>, threshold: f64) -> DMatrix<f64> {
    jacobi::null_space(j, threshold).complement
}

/// C with rows whose largest entry is near one, and the powers of two by which they were multiplied.
pub(super) fn scale_rows(c: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let scales: Vec<f64> = c.row_iter().map(|row| unit_scale(row.amax())).collect();
    let mut scaled = c.clone();
    for (i, scale) in scales.iter().enumerate() {
        scaled.row_mut(i).scale_mut(*scale);
    }
    (scaled, scales)
}

/// Divides figures by the largest and fills up with zeros.
fn relative(figures: &mut Vec<f64>, count: usize) {
    let largest = figures.iter().fold(0.0_f64, |largest, figure| largest.max(*figure));
    if largest > 0.0 {
        figures.iter_mut().for_each(|figure| *figure /= largest);
    }
    figures.resize(count, 0.0);
}
