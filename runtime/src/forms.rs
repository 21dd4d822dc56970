//! All forms of the equations of motion, written once for every model.
//!
//! The emitted pieces of the initial system are evaluated at any (t, x, v), on the constraint manifold or off it, and solved by
//! dense algebra. These are independent of the elimination that the derive does, and so serve to check it.
//!
//! | form | function | needs |
//! |---|---|---|
//! | (2.8) | [`solve`](InitialEquations::solve) | independent rows, M definite on ker C |
//! | (3.2), (3.3): T, M_t, M_c, M_d | [`transformation`](InitialEquations::transformation), [`metric`](InitialEquations::metric), … | M regular |
//! | (3.5) with a given D | [`tangent_rates`](InitialEquations::tangent_rates) | independent rows, M definite on ker C |
//! | (3.5) with D found by LU, QR or SVD | [`solve_by`](InitialEquations::solve_by) | M definite on ker C |
//! | (3.6), (3.7) | [`multipliers`](InitialEquations::multipliers), [`reactions`](InitialEquations::reactions) | independent rows, M regular |
//! | v̇ = P M⁻¹h* − M⁻¹Cᵀ M_c⁻¹ c0* | [`projected_rates`](InitialEquations::projected_rates) | independent rows, M regular |
//! //! | (4.10), (5.6), stage after stage | [`stages`](InitialEquations::stages) | M definite on ker C |
//! | components (A.1)-(A.6) | [`Metric`] | M regular |
//! | Gauss' principle, power | [`gauss_constraint`](InitialEquations::gauss_constraint), [`reaction_power`](InitialEquations::reaction_power) | M regular; nothing |
//!
//! Whatever is missing is an error that names the rows which depend on each other, or the figure that vanished.

mod components;
mod dense;
mod full;
mod general;
mod null_space;
mod principles;
mod rank;
mod stages;

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::{ConstrainedSystem, Error, Matrix, Prepared, Scalar, Vector};

pub use components::{ChangeOfBase, Metric};
pub use null_space::{NullSpace, NullSpaceMethod, RANK_THRESHOLD};
pub use stages::Stages;

pub(crate) use dense::solve;
pub(crate) use general::least_change;
pub(crate) use null_space::{least_squares, null_directions};

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
    /// The names of the rows of C, for errors.
    pub rows: Vec<&'static str>,
    /// v.
    pub velocities: DVector<f64>,
    /// A of ẋ = A v + a0 (2.1), n × n; in a stage of a projection A Dᵀ (5.7), with as many rows as there are coordinates.
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
            rows: M::MODEL.rows.iter().map(|row| row.name).collect(),
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

fn shape(matrix: &'static str, needed: (usize, usize), given: (usize, usize)) -> Result<(), Error> {
    if needed == given { Ok(()) } else { Err(Error::Shape { matrix, needed, given }) }
}

fn dynamic_vector<T: Scalar, V: Vector<T>>(v: &V) -> DVector<T> {
    let array: V::Array = (*v).into();
    DVector::from_vec(Vec::from(array.as_ref()))
}

pub(crate) fn dynamic_matrix<T: Scalar, A: Matrix<T>>(matrix: &A) -> DMatrix<T> {
    DMatrix::from_fn(A::ROWS, A::COLUMNS, |i, j| matrix.entry(i, j))
}
