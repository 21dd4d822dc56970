//! Inverse dynamics and power.

use super::Prepared;
use crate::vector::{convert, entry};
use crate::{ConstrainedSystem, Dual, Error, Matrix, Scalar, Vector};

impl<M: ConstrainedSystem, T: Scalar> Prepared<M, T> {
    /// Inverse dynamics: the further generalised forces Q along the independent speeds under which their rates are ν,
    /// Q = D (M (Dᵀ ν + a_u) − h*) = M_d ν − h_u* (4.10), k of them; the constraints act as well.
    ///
    /// The inputs are those that act all the same: with zeros, Q is what motors at the independent speeds have to give. Models of
    /// bodies whose speeds are those of their joints go along the tree, without M.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let aside = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
    /// let [alone] = pendulum.accelerations(0.0, &aside, &[]);
    /// let [nothing] = pendulum.inverse_dynamics(0.0, &aside, &[alone], &[]);
    /// assert!(nothing.abs() < 1e-12);                                // it moves so by itself
    /// let [held] = pendulum.inverse_dynamics(0.0, &PendulumState { dot_x: 0.0, ..aside }, &[0.0], &[]);
    /// assert!((held - 2.0 * 9.81 * 0.3 / 0.4).abs() < 1e-12);        // along x, with y = -√(l² - x²)
    /// # Ok::<(), Error>(())
    /// ```
    pub fn inverse_dynamics(&self, t: T, s: &M::State<T>, rates: &M::Reduced<T>, i: &M::Inputs<T>) -> M::Reduced<T> {
        let (x, v) = (self.coordinates(t, s), self.velocities(t, s));
        let (d, bias, rates) = (self.complement(t, s), self.complement_bias(t, s), entry(rates));
        let (k, n, bias) = (M::Complement::<T>::ROWS, M::Complement::<T>::COLUMNS, entry(&bias));
        let dv = M::Velocities::from_fn(|j| (0..k).fold(bias(j), |sum, row| sum + d.entry(row, j) * rates(row)));
        let forces = M::inverse_dynamics(self.values(), t, &x, &v, &dv, i);
        let forces = entry(&forces);
        let zero = T::from_f64(0.0);
        M::Reduced::from_fn(|row| (0..n).fold(zero, |sum, j| sum + d.entry(row, j) * forces(j)))
    }
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// The rate of the [`energy`](Self::energy) along the motion: the power of all forces that have no potential, of inputs, and of
    /// constraints that move by themselves; zero where energy is conserved.
    ///
    /// Functions of the model's own need one derivative more than the energy has of them; without it the power is not a number.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let aside = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
    /// assert!(pendulum.power(0.0, &aside, &[])?.abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of preparing the model with its own parameters, which was done before.
    pub fn power(&self, t: f64, s: &M::State<f64>, i: &M::Inputs<f64>) -> Result<f64, Error> {
        let parameters = convert(self.parameters(), |_, value| Dual::constant(value));
        let moving: Prepared<M, Dual> = Prepared::with_parameters(self.system().clone(), parameters)?;
        let rate = entry(&self.derivative(t, s, i).0);
        let along = convert(s, |at, value| Dual::new(value, rate(at)));
        Ok(moving.energy(Dual::variable(t), &along).derivative)
    }
}
