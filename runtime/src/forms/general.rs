//! The general form: (3.5) with a D found at run time, for rows that may depend on each other and an M that may be singular.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::dense::solve_definite;
use super::null_space::{householder, scale_rows};
use super::rank::dependencies;
use super::{InitialEquations, NullSpace, NullSpaceMethod, RANK_THRESHOLD};
use crate::Error;
use crate::math::double::sqrt;

/// Dependent rows agree if what remains of C v̇ + c0* is below this fraction of the largest terms, rows scaled to one size.
const CONSISTENT: f64 = 1e-8;

/// The change δ of velocities with C δ + r = 0 (nearest to it, where rows contradict each other) and δᵀ M δ least.
///
/// It is (3.5) without forces: of all z with C z + r = 0 the one without a part in ker C, in the metric M.
pub(crate) fn least_change(inertia: &DMatrix<f64>, c: &DMatrix<f64>, r: &DVector<f64>) -> Result<DVector<f64>, Error> {
    let null = NullSpace::new(c, NullSpaceMethod::Svd)?;
    let any = null.particular(r);
    let along = definite_on(inertia, &null.complement, &null.complement * (inertia * &any))?;
    Ok(any - null.complement.tr_mul(&along))
}

/// M_d⁻¹ r; M_d = D M Dᵀ must be positive definite.
fn definite_on(inertia: &DMatrix<f64>, d: &DMatrix<f64>, right: DVector<f64>) -> Result<DVector<f64>, Error> {
    let metric = d * inertia * d.transpose();
    let magnitudes = d.abs() * inertia.abs() * d.abs().transpose();
    solve_definite("a pivot of D M Dᵀ, M on ker C,", metric, right, magnitudes.diagonal().as_slice())
}

impl InitialEquations {
    /// The null space of C. Complete pivoting compares v_j √M_jj, so that it does not depend on units which velocities become
    /// independent.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::forms::NullSpaceMethod;
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let full = pendulum.initial_equations_at(0.0, &PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 }, &[]);
    /// let null = full.null_space(NullSpaceMethod::Lu)?;
    /// assert_eq!((null.rank, null.independent.as_slice()), (1, [0].as_slice()));    // ẋ, as |x| < |y|
    /// assert!((null.complement[(0, 1)] - 0.75).abs() < 1e-15);                      // ẏ = −x/y ẋ
    /// # Ok::<(), Error>(())
    /// ```
    pub fn null_space(&self, method: NullSpaceMethod) -> Result<NullSpace, Error> {
        let masses = self.inertia.diagonal();
        // One velocity without inertia, and there is no common measure.
        let weights: Vec<f64> = match masses.iter().all(|mass| *mass > 0.0) {
            true => masses.iter().map(|mass| sqrt(*mass)).collect(),
            false => Vec::new(),
        };
        NullSpace::weighted(&self.constraint_matrix, method, RANK_THRESHOLD, &weights)
    }

    /// (v̇, λ) by (3.5) with D from the null space of C.
    ///
    /// Holds where (3.6) does not: rows may depend on each other, if they agree, and M may be singular, if it is definite on
    /// ker C. v̇ is unique all the same; λ is the one of least norm, and Cᵀ λ is unique. The errors: [`Error::Inconsistent`],
    /// [`Error::Indefinite`].
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::forms::NullSpaceMethod;
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
    /// let mut full = pendulum.initial_equations_at(0.0, &s, &[]);
    /// let (rates, multipliers) = full.solve()?;
    /// // The rod twice: each row carries half.
    /// full.rows = vec!["rod", "rod again"];
    /// full.constraint_matrix = full.constraint_matrix.insert_row(1, 0.0);
    /// let row = full.constraint_matrix.row(0).into_owned();
    /// full.constraint_matrix.set_row(1, &row);
    /// full.constraint_bias = full.constraint_bias.push(full.constraint_bias[0]);
    /// let (same, halves) = full.solve_by(NullSpaceMethod::Svd)?;
    /// assert!((same - rates).amax() < 1e-12);
    /// assert!((halves[0] - 0.5 * multipliers[0]).abs() < 1e-12 && (halves[1] - halves[0]).abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn solve_by(&self, method: NullSpaceMethod) -> Result<(DVector<f64>, DVector<f64>), Error> {
        let (null, _, rates) = self.tangent(method)?;
        let multipliers = self.least_norm(&null, &rates);
        Ok((rates, multipliers))
    }

    /// D, a and v̇ = Dᵀ u̇ + a.
    pub(super) fn tangent(&self, method: NullSpaceMethod) -> Result<(NullSpace, DVector<f64>, DVector<f64>), Error> {
        let null = self.null_space(method)?;
        let bias = null.particular(&self.constraint_bias);
        let accelerations = self.tangent_accelerations(&null.complement, &bias)?;
        let rates = null.complement.tr_mul(&accelerations) + &bias;
        if rates.iter().any(|rate| !rate.is_finite()) {
            return Err(Error::NonFinite { name: "v̇" });
        }
        self.check_consistent(&null, &rates)?;
        Ok((null, bias, rates))
    }

    /// λ of least norm with Cᵀ λ = M v̇ − h*, for a v̇ that the constraints allow: (C Cᵀ)⁻¹ C (M v̇ − h*) where the rows are
    /// independent. M need not be regular.
    pub fn multipliers_of(&self, rates: &DVector<f64>) -> Result<DVector<f64>, Error> {
        super::shape("v̇", (self.forces.len(), 1), (rates.len(), 1))?;
        if rates.iter().chain(self.forces.iter()).chain(self.inertia.iter()).any(|entry| !entry.is_finite()) {
            return Err(Error::NonFinite { name: "M v̇ − h*" });
        }
        Ok(self.least_norm(&NullSpace::new(&self.constraint_matrix, NullSpaceMethod::Qr)?, rates))
    }

    /// Any λ with Cᵀ λ = M v̇ − h* is Gᵀ (M v̇ − h*); without its part in ker Cᵀ it is the shortest.
    fn least_norm(&self, null: &NullSpace, rates: &DVector<f64>) -> DVector<f64> {
        let any = null.inverse.tr_mul(&(&self.inertia * rates - &self.forces));
        if null.rank == self.rows.len() {
            return any;
        }
        let factors = householder(self.constraint_matrix.clone(), 0.0, null.rank);
        let range = factors.transposed.rows(0, factors.rank).into_owned();
        range.tr_mul(&(&range * any))
    }

    /// u̇ of M_d u̇ = D (h* − M a) (4.10), (5.6).
    fn tangent_accelerations(&self, complement: &DMatrix<f64>, bias: &DVector<f64>) -> Result<DVector<f64>, Error> {
        self.tangent_solve(complement, complement * (&self.forces - &self.inertia * bias))
    }

    /// M_d⁻¹ r; M_d = D M Dᵀ must be positive definite.
    pub(super) fn tangent_solve(&self, complement: &DMatrix<f64>, right: DVector<f64>) -> Result<DVector<f64>, Error> {
        definite_on(&self.inertia, complement, right)
    }

    /// Rows that depend on others must say the same: v̇ meets them too.
    fn check_consistent(&self, null: &NullSpace, rates: &DVector<f64>) -> Result<(), Error> {
        if null.rank == self.rows.len() {
            return Ok(());
        }
        // Rows scaled to one size have terms of one size; where all is at rest, one row may have none.
        let (c, scales) = scale_rows(&self.constraint_matrix);
        let bias = DVector::from_fn(scales.len(), |i, _| self.constraint_bias[i] * scales[i]);
        let residual = &c * rates + &bias;
        let terms = (c.abs() * rates.abs() + bias.abs()).amax();
        let missed: Vec<usize> = (0..scales.len()).filter(|i| residual[*i].abs() > CONSISTENT * terms).collect();
        let Some(worst) = missed.iter().copied().max_by(|i, j| residual[*i].abs().total_cmp(&residual[*j].abs()))
        else {
            return Ok(());
        };
        let mut combinations = dependencies(&self.constraint_matrix, null.rank);
        combinations.retain(|combination| combination.iter().any(|row| missed.contains(row)));
        Err(Error::Inconsistent { rows: self.names(&combinations), residual: residual[worst] / scales[worst] })
    }
}
