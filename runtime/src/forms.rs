//! The unreduced forms of the equations of motion, written once for every model.
//!
//! The emitted pieces of the initial system are evaluated at any (t, x, v), on the constraint manifold or off it, and solved by
//! dense algebra: the differential-algebraic form (2.8), the projections (3.2)-(3.5), the multipliers (3.6) and the reactions
//! (3.7). These are independent of the elimination that the derive does, and so serve to check it.

mod dense;

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::{ConstrainedSystem, Error, Matrix, Prepared, Scalar, Vector};
use dense::solve;

/// The initial system and its constraints at one (t, x, v): n velocities, m rows.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
/// let full = pendulum.initial_equations_at(0.0, &s, &[]);
/// let (rates, multipliers) = full.solve()?;                            // (2.8)
/// assert!((rates[0] - pendulum.accelerations(0.0, &s, &[])[0]).abs() < 1e-12);
/// assert!((multipliers[0] - pendulum.multipliers(0.0, &s, &[]).rod).abs() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct InitialEquations {
    /// v.
    pub velocities: DVector<f64>,
    /// A of ẋ = A v + a0 (2.1), n × n.
    pub kinematic_matrix: DMatrix<f64>,
    /// a0 of (2.1).
    pub kinematic_bias: DVector<f64>,
    /// M of M v̇ = h* (2.3), n × n.
    pub inertia: DMatrix<f64>,
    /// h* of (2.3).
    pub forces: DVector<f64>,
    /// C of C v̇ + c0* = 0 (2.4), m × n.
    pub constraint_matrix: DMatrix<f64>,
    /// c0* of (2.4).
    pub constraint_bias: DVector<f64>,
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// Evaluates the initial system and its constraints at coordinates and velocities that need not satisfy the constraints.
    pub fn initial_equations(
        &self,
        t: f64,
        x: &M::Coordinates<f64>,
        v: &M::Velocities<f64>,
        i: &M::Inputs<f64>,
    ) -> InitialEquations {
        InitialEquations {
            velocities: dynamic_vector(v),
            kinematic_matrix: dynamic_matrix(&self.kinematic_matrix(t, x)),
            kinematic_bias: dynamic_vector(&self.kinematic_bias(t, x)),
            inertia: dynamic_matrix(&self.inertia(t, x)),
            forces: dynamic_vector(&self.forces(t, x, v, i)),
            constraint_matrix: dynamic_matrix(&self.constraint_matrix(t, x, v)),
            constraint_bias: dynamic_vector(&self.constraint_bias(t, x, v)),
        }
    }

    /// The same at a state.
    pub fn initial_equations_at(&self, t: f64, s: &M::State<f64>, i: &M::Inputs<f64>) -> InitialEquations {
        self.initial_equations(t, &self.coordinates(t, s), &self.velocities(t, s), i)
    }

    /// D of a state as a dynamic matrix, k × n, for the forms of [`InitialEquations`] that take it.
    pub fn complement_at(&self, t: f64, s: &M::State<f64>) -> DMatrix<f64> {
        dynamic_matrix(&self.complement(t, s))
    }
}

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
        let solution = solve("the matrix of (2.8)", matrix, right)?;
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
        let right = DMatrix::from_column_slice(right.len(), 1, right.as_slice());
        let solution = solve("[C; D M] of (3.5)", matrix, right)?;
        Ok(solution.column(0).into_owned())
    }

    /// λ = −M_c⁻¹ (c0* + C M⁻¹ h*) (3.6).
    pub fn multipliers(&self) -> Result<DVector<f64>, Error> {
        let n = self.forces.len();
        let forces = DMatrix::from_column_slice(n, 1, self.forces.as_slice());
        let free = solve("M", self.inertia.clone(), forces)?;
        let mut right = -(&self.constraint_matrix * free);
        right -= &self.constraint_bias;
        let solution = solve("M_c of (3.6)", self.constraint_metric()?, right)?;
        Ok(solution.column(0).into_owned())
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

fn shape(matrix: &'static str, needed: (usize, usize), given: (usize, usize)) -> Result<(), Error> {
    if needed == given { Ok(()) } else { Err(Error::Shape { matrix, needed, given }) }
}

fn dynamic_vector<T: Scalar, V: Vector<T>>(v: &V) -> DVector<T> {
    let array: V::Array = (*v).into();
    DVector::from_vec(Vec::from(array.as_ref()))
}

fn dynamic_matrix<T: Scalar, A: Matrix<T>>(matrix: &A) -> DMatrix<T> {
    DMatrix::from_fn(A::ROWS, A::COLUMNS, |i, j| matrix.entry(i, j))
}
