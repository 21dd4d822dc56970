//! The functions of the initial system: x and v need not satisfy the constraints.

use super::Prepared;
use crate::{ConstrainedSystem, Scalar};

impl<M: ConstrainedSystem, T: Scalar> Prepared<M, T> {
    /// A of ẋ = A v + a0 (2.1), n × n.
    #[inline]
    pub fn kinematic_matrix(&self, t: T, x: &M::Coordinates<T>) -> M::SystemMatrix<T> {
        M::kinematic_matrix(self.values(), t, x)
    }

    /// a0 of (2.1).
    #[inline]
    pub fn kinematic_bias(&self, t: T, x: &M::Coordinates<T>) -> M::Coordinates<T> {
        M::kinematic_bias(self.values(), t, x)
    }

    /// M of M v̇ = h* (2.3), n × n.
    #[inline]
    pub fn inertia(&self, t: T, x: &M::Coordinates<T>) -> M::SystemMatrix<T> {
        M::inertia(self.values(), t, x)
    }

    /// h* of (2.3).
    #[inline]
    pub fn forces(&self, t: T, x: &M::Coordinates<T>, v: &M::Velocities<T>, i: &M::Inputs<T>) -> M::Velocities<T> {
        M::forces(self.values(), t, x, v, i)
    }

    /// M v, n: the generalised momenta ∂T/∂v, but for what moves by itself, as a function of time.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState, PendulumVelocities};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let v = PendulumVelocities { dot_x: 3.0, dot_y: 1.0 };
    /// assert_eq!(pendulum.momenta(0.0, &[0.0, -0.5], &v), PendulumVelocities { dot_x: 6.0, dot_y: 2.0 });
    /// # Ok::<(), Error>(())
    /// ```
    #[inline]
    pub fn momenta(&self, t: T, x: &M::Coordinates<T>, v: &M::Velocities<T>) -> M::Velocities<T> {
        M::momenta(self.values(), t, x, v)
    }

    /// C of C v̇ + c0* = 0 (2.4), m × n.
    #[inline]
    pub fn constraint_matrix(&self, t: T, x: &M::Coordinates<T>, v: &M::Velocities<T>) -> M::ConstraintMatrix<T> {
        M::constraint_matrix(self.values(), t, x, v)
    }

    /// c0* of (2.4).
    #[inline]
    pub fn constraint_bias(&self, t: T, x: &M::Coordinates<T>, v: &M::Velocities<T>) -> M::Rows<T> {
        M::constraint_bias(self.values(), t, x, v)
    }

    /// f of every position row.
    #[inline]
    pub fn position_residual(&self, t: T, x: &M::Coordinates<T>) -> M::PositionRows<T> {
        M::position_residual(self.values(), t, x)
    }

    /// φ, or ḟ of a position row, for every row of C that binds velocities
    /// ([`Description::velocity_rows`](crate::Description::velocity_rows)).
    #[inline]
    pub fn velocity_residual(&self, t: T, x: &M::Coordinates<T>, v: &M::Velocities<T>) -> M::VelocityRows<T> {
        M::velocity_residual(self.values(), t, x, v)
    }

    /// ½ vᵀ M v.
    #[inline]
    pub fn kinetic_energy(&self, t: T, x: &M::Coordinates<T>, v: &M::Velocities<T>) -> T {
        M::kinetic_energy(self.values(), t, x, v)
    }

    /// The potential energy, where the model declares one.
    #[inline]
    pub fn potential_energy(&self, t: T, x: &M::Coordinates<T>) -> Option<T> {
        M::potential_energy(self.values(), t, x)
    }
}
