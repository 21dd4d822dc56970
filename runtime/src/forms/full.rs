//! (2.8) and the projections of section 3 as they stand in the paper, with a D that is given.

use nalgebra::{DMatrix, DVector};

use super::dense::{column, solve};
use super::{InitialEquations, shape};
use crate::Error;

impl InitialEquations {
    /// ẋ = A v + a0 (2.8b).
    pub fn coordinate_rates(&self) -> DVector<f64> {
        &self.kinematic_matrix * &self.velocities + &self.kinematic_bias
    }

    /// (v̇, λ) of the differential-algebraic form (2.8), with `[M, −Cᵀ; C, 0] [v̇; λ] = [h*; −c0*]`.
    pub fn solve(&self) -> Result<(DVector<f64>, DVector<f64>), Error> {
        let (n, m) = (self.forces.len(), self.constraint_bias.len());
        let mut matrix = DMatrix::zeros(n + m, n + m);
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.inertia);
        matrix.view_mut((0, n), (n, m)).copy_from(&-self.constraint_matrix.transpose());
        matrix.view_mut((n, 0), (m, n)).copy_from(&self.constraint_matrix);
        let mut right = DMatrix::zeros(n + m, 1);
        right.view_mut((0, 0), (n, 1)).copy_from(&self.forces);
        right.view_mut((n, 0), (m, 1)).copy_from(&-&self.constraint_bias);
        let solution = solve("the matrix of (2.8)", matrix, right).map_err(|error| self.explain(error))?;
        let column = solution.column(0);
        Ok((column.rows(0, n).into_owned(), column.rows(n, m).into_owned()))
    }

    /// T of (3.2): its columns are those of M⁻¹ Cᵀ, then those of Dᵀ; n × n.
    pub fn transformation(&self, complement: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
        self.check_complement(complement)?;
        let (n, m) = (self.forces.len(), self.constraint_bias.len());
        let mut transformation = DMatrix::zeros(n, n);
        transformation.view_mut((0, 0), (n, m)).copy_from(&self.compliance()?);
        transformation.view_mut((0, m), (n, n - m)).copy_from(&complement.transpose());
        Ok(transformation)
    }

    /// M_c = C M⁻¹ Cᵀ (3.3), m × m.
    pub fn constraint_metric(&self) -> Result<DMatrix<f64>, Error> {
        Ok(&self.constraint_matrix * self.compliance()?)
    }

    /// M_d = D M Dᵀ (3.3), k × k.
    pub fn tangent_metric(&self, complement: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
        self.check_complement(complement)?;
        Ok(complement * &self.inertia * complement.transpose())
    }

    /// M_t = Tᵀ M T (3.3), n × n; with blocks M_c and M_d, and zero between them where D Cᵀ = 0.
    pub fn metric(&self, complement: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
        let transformation = self.transformation(complement)?;
        Ok(transformation.transpose() * &self.inertia * transformation)
    }

    /// Tᵀ M = [C; D M] and h_t* = [−c0*; D h*] of the tangent form Tᵀ M v̇ = h_t* (3.5).
    pub fn tangent_form(&self, complement: &DMatrix<f64>) -> Result<(DMatrix<f64>, DVector<f64>), Error> {
        self.check_complement(complement)?;
        let (n, m) = (self.forces.len(), self.constraint_bias.len());
        let mut matrix = DMatrix::zeros(n, n);
        matrix.view_mut((0, 0), (m, n)).copy_from(&self.constraint_matrix);
        matrix.view_mut((m, 0), (n - m, n)).copy_from(&(complement * &self.inertia));
        let mut right = DVector::zeros(n);
        right.rows_mut(0, m).copy_from(&-&self.constraint_bias);
        right.rows_mut(m, n - m).copy_from(&(complement * &self.forces));
        Ok((matrix, right))
    }

    /// v̇ of the tangent form (3.5); it does not depend on the choice of D.
    pub fn tangent_rates(&self, complement: &DMatrix<f64>) -> Result<DVector<f64>, Error> {
        let (matrix, right) = self.tangent_form(complement)?;
        let solution = solve("[C; D M] of (3.5)", matrix, column(&right)).map_err(|error| self.explain(error))?;
        Ok(solution.column(0).into_owned())
    }

    /// λ = −M_c⁻¹ (c0* + C M⁻¹ h*) (3.6).
    pub fn multipliers(&self) -> Result<DVector<f64>, Error> {
        let free = solve("M", self.inertia.clone(), column(&self.forces))?;
        let mut right = -(&self.constraint_matrix * free);
        right -= &self.constraint_bias;
        let metric = self.constraint_metric()?;
        let solution = solve("M_c of (3.6)", metric, right).map_err(|error| self.explain(error))?;
        Ok(solution.column(0).into_owned())
    }

    /// P = 1 − M⁻¹ Cᵀ M_c⁻¹ C, which projects velocities onto ker C, orthogonally in the metric M; n × n of rank k.
    pub fn projector(&self) -> Result<DMatrix<f64>, Error> {
        let n = self.forces.len();
        Ok(DMatrix::identity(n, n) - self.compliance()? * self.constrained(self.constraint_matrix.clone())?)
    }

    /// v̇ = P M⁻¹ h* − M⁻¹ Cᵀ M_c⁻¹ c0*: the explicit form, without any D.
    pub fn projected_rates(&self) -> Result<DVector<f64>, Error> {
        let free = solve("M", self.inertia.clone(), column(&self.forces))?;
        let bound = self.compliance()? * self.constrained(column(&self.constraint_bias))?;
        Ok((self.projector()? * free - bound).column(0).into_owned())
    }

    /// M_c⁻¹ R.
    fn constrained(&self, right: DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
        solve("M_c", self.constraint_metric()?, right).map_err(|error| self.explain(error))
    }

    /// The reactions r_i* = C_iᵀ λ_i (3.7), one column for each row of C; n × m.
    pub fn reactions(&self, multipliers: &DVector<f64>) -> Result<DMatrix<f64>, Error> {
        let m = self.constraint_bias.len();
        shape("λ", (m, 1), (multipliers.len(), 1))?;
        let n = self.forces.len();
        Ok(DMatrix::from_fn(n, m, |j, i| self.constraint_matrix[(i, j)] * multipliers[i]))
    }

    /// M⁻¹ Cᵀ.
    fn compliance(&self) -> Result<DMatrix<f64>, Error> {
        solve("M", self.inertia.clone(), self.constraint_matrix.transpose())
    }

    fn check_complement(&self, complement: &DMatrix<f64>) -> Result<(), Error> {
        let (n, m) = (self.forces.len(), self.constraint_bias.len());
        shape("D", (n.saturating_sub(m), n), complement.shape())
    }
}
