//! The appendix: vectors in a base and in its dual base.

use nalgebra::{DMatrix, DVector};

use super::dense::solve;
use super::shape;
use crate::Error;

/// The metric M of a base e, and what it makes of components.
///
/// A vector a = aᵀ e = a*ᵀ e* (A.1) has contravariant components a in the base e and covariant ones a* in the dual base e*.
/// Velocities v are contravariant, forces h* and reactions r* covariant; the inertia is the metric (2.9).
///
/// ```
/// use holonomy::forms::Metric;
/// use nalgebra::{DMatrix, DVector};
///
/// // Two base vectors of the plane that are neither orthogonal nor of length one, as rows.
/// let e = DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 1.0, 1.0]);
/// let metric = Metric::of_base(&e)?;                                   // (A.2): M = e eᵀ
/// assert_eq!(metric.matrix(), &DMatrix::from_row_slice(2, 2, &[4.0, 2.0, 2.0, 2.0]));
/// let a = DVector::from_vec(vec![1.0, 3.0]);                           // the arrow (5, 3)
/// let b = DVector::from_vec(vec![-1.0, 1.0]);                          // the arrow (−1, 1)
/// assert_eq!(metric.dot(&a, &b), -2.0);                                // (A.4)
/// let (a, b) = (metric.covariant(&a), metric.covariant(&b));           // (A.3)
/// assert!((metric.dot_covariant(&a, &b) + 2.0).abs() < 1e-14);
/// # Ok::<(), holonomy::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Metric {
    matrix: DMatrix<f64>,
    inverse: DMatrix<f64>,
}

impl Metric {
    /// The metric with this matrix, square, symmetric and regular; its lower half counts.
    pub fn new(matrix: DMatrix<f64>) -> Result<Self, Error> {
        let n = matrix.nrows();
        shape("M", (n, n), matrix.shape())?;
        let matrix = DMatrix::from_fn(n, n, |i, j| matrix[(i.max(j), i.min(j))]);
        let inverse = solve("M", matrix.clone(), DMatrix::identity(n, n))?;
        Ok(Metric { matrix, inverse })
    }

    /// M = e eᵀ (A.2) of base vectors that are given as the rows of e, in orthonormal coordinates.
    pub fn of_base(e: &DMatrix<f64>) -> Result<Self, Error> {
        Self::new(e * e.transpose())
    }

    /// The dual base e* with e = M e* (A.3), as rows: each vector of the one base is orthogonal to all others of the other.
    pub fn dual_base(&self, e: &DMatrix<f64>) -> DMatrix<f64> {
        &self.inverse * e
    }

    /// M.
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.matrix
    }

    /// M⁻¹, the metric of the dual base.
    pub fn inverse(&self) -> &DMatrix<f64> {
        &self.inverse
    }

    /// a* = M a (A.3).
    pub fn covariant(&self, a: &DVector<f64>) -> DVector<f64> {
        &self.matrix * a
    }

    /// a = M⁻¹ a* (A.3).
    pub fn contravariant(&self, covariant: &DVector<f64>) -> DVector<f64> {
        &self.inverse * covariant
    }

    /// a · b = aᵀ M b (A.4), from contravariant components. From one of each kind it is the plain sum aᵀ b*.
    pub fn dot(&self, a: &DVector<f64>, b: &DVector<f64>) -> f64 {
        a.dot(&(&self.matrix * b))
    }

    /// a · b = a*ᵀ M⁻¹ b* (A.4), from covariant components.
    pub fn dot_covariant(&self, a: &DVector<f64>, b: &DVector<f64>) -> f64 {
        a.dot(&(&self.inverse * b))
    }

    /// The change to another base ê = Bᵀ e of the same space.
    pub fn change(&self, b: &DMatrix<f64>) -> Result<ChangeOfBase, Error> {
        let n = self.matrix.nrows();
        shape("B", (n, n), b.shape())?;
        let metric = Metric::new(b.transpose() * &self.matrix * b)?;
        let inverse = solve("B", b.clone(), DMatrix::identity(n, n))?;
        Ok(ChangeOfBase { matrix: b.clone(), inverse, metric })
    }
}

/// A change of base, ê = Bᵀ e; from [`Metric::change`].
///
/// (3.2) is one: B = T leads to the constraint vectors and the tangent vectors.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::forms::Metric;
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
/// let full = pendulum.initial_equations_at(0.0, &s, &[]);
/// let change = Metric::new(full.inertia.clone())?.change(&full.transformation(&pendulum.complement_at(0.0, &s))?)?;
/// let v = change.contravariant(&full.velocities);
/// assert!(v[0].abs() < 1e-15 && (v[1] - 0.2).abs() < 1e-15);      // no part across the constraint; u along it
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ChangeOfBase {
    matrix: DMatrix<f64>,
    inverse: DMatrix<f64>,
    metric: Metric,
}

impl ChangeOfBase {
    /// The metric of the new base, Bᵀ M B (A.6).
    pub fn metric(&self) -> &Metric {
        &self.metric
    }

    /// The new base vectors from the old ones, as rows: ê = Bᵀ e (A.5).
    pub fn base(&self, e: &DMatrix<f64>) -> DMatrix<f64> {
        self.matrix.tr_mul(e)
    }

    /// Contravariant components in the new base: a = B â (A.5).
    pub fn contravariant(&self, a: &DVector<f64>) -> DVector<f64> {
        &self.inverse * a
    }

    /// Covariant components in the new base: â* = Bᵀ a* (A.5).
    pub fn covariant(&self, a: &DVector<f64>) -> DVector<f64> {
        self.matrix.tr_mul(a)
    }
}
