//! A model that is ready to run: parameters checked, parameter-only work done.

mod charts;
mod initial;
mod inputs;
mod outputs;
mod powers;
mod reactions;
mod velocities;

use core::fmt;

use crate::vector::convert;
use crate::{ConstrainedSystem, Error, Scalar};

pub use reactions::Reactions;

/// A model with its parameters, over one scalar; made by [`ConstrainedSystem::prepare`].
///
/// The methods have the names of the trait's functions, without the parameters.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let hanging = PendulumState { x: 0.0, y: -0.5, dot_x: 0.0 };
/// let (rate, guards) = pendulum.derivative(0.0, &hanging, &[]);
/// assert_eq!(rate.dot_x, 0.0);                                   // at rest
/// assert_eq!(guards, [-0.5]);                                    // y: a pivot
/// let weight = pendulum.multipliers(0.0, &hanging, &[]).rod * -0.5;
/// assert!((weight - 2.0 * 9.81).abs() < 1e-12);                  // Cᵀ λ, the y component
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct Prepared<M: ConstrainedSystem, T: Scalar = f64> {
    system: M,
    parameters: M::Parameters<T>,
    values: M::Values<T>,
}

impl<M: ConstrainedSystem, T: Scalar> fmt::Debug for Prepared<M, T> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Prepared")
            .field("model", &M::MODEL.name)
            .field("parameters", &self.parameters)
            .finish_non_exhaustive()
    }
}

impl<M: ConstrainedSystem, T: Scalar> Prepared<M, T> {
    /// Prepares a model with the parameters that stand in its struct.
    pub fn new(system: M) -> Result<Self, Error> {
        let given = system.parameters();
        let parameters = convert(&given, |_, value| T::from_f64(value));
        Self::with_parameters(system, parameters)
    }

    /// Prepares a model with other parameters than those in its struct: dual numbers, say, for sensitivities.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::{Dual, Prepared};
    ///
    /// // How the energy depends on the mass.
    /// let parameters = [Dual::variable(2.0), Dual::constant(0.5), Dual::constant(9.81)].into();
    /// let pendulum = Prepared::with_parameters(Pendulum { m: 2.0, l: 0.5, g: 9.81 }, parameters)?;
    /// let hanging = PendulumState { x: Dual::constant(0.0), y: Dual::constant(-0.5), dot_x: Dual::constant(0.0) };
    /// assert_eq!(pendulum.energy(Dual::constant(0.0), &hanging).derivative, 9.81 * -0.5);
    /// # Ok::<(), holonomy::Error>(())
    /// ```
    pub fn with_parameters(system: M, parameters: M::Parameters<T>) -> Result<Self, Error> {
        let values = system.values(&parameters)?;
        Ok(Prepared { system, parameters, values })
    }

    /// The struct that was prepared.
    pub fn system(&self) -> &M {
        &self.system
    }

    /// The parameters.
    pub fn parameters(&self) -> &M::Parameters<T> {
        &self.parameters
    }

    /// The parameters and the work that depends on them alone, as the static functions take them.
    pub fn values(&self) -> &M::Values<T> {
        &self.values
    }

    /// The state's rate (ẋ or q̇, then u̇), and the guards (their names: [`Description::guards`](crate::Description::guards)).
    #[inline]
    pub fn derivative(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> (M::State<T>, M::Guards<T>) {
        M::derivative(&self.values, t, s, i)
    }

    /// u̇, the rates of the state's speeds: the solution of M_d u̇ = h_u* (4.10), (5.6), where nothing binds u̇ alone.
    #[inline]
    pub fn accelerations(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> M::Speeds<T> {
        M::accelerations(&self.values, t, s, i)
    }

    /// M_d = D M Dᵀ, k × k.
    #[inline]
    pub fn mass_matrix(&self, t: T, s: &M::State<T>) -> M::MassMatrix<T> {
        M::mass_matrix(&self.values, t, s)
    }

    /// h_u* = D (h* − M a_u).
    #[inline]
    pub fn forcing(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> M::Reduced<T> {
        M::forcing(&self.values, t, s, i)
    }

    /// M_d and h_u* together.
    #[inline]
    pub fn mass_matrix_and_forcing(
        &self,
        t: T,
        s: &M::State<T>,
        i: &M::Inputs<T>,
    ) -> (M::MassMatrix<T>, M::Reduced<T>) {
        M::mass_matrix_and_forcing(&self.values, t, s, i)
    }

    /// x of the state (4.2).
    #[inline]
    pub fn coordinates(&self, t: T, s: &M::State<T>) -> M::Coordinates<T> {
        M::coordinates(&self.values, t, s)
    }

    /// v of the state (4.4), (5.3).
    #[inline]
    pub fn velocities(&self, t: T, s: &M::State<T>) -> M::Velocities<T> {
        M::velocities(&self.values, t, s)
    }

    /// D, k × n, with D Cᵀ = 0 (3.1).
    #[inline]
    pub fn complement(&self, t: T, s: &M::State<T>) -> M::Complement<T> {
        M::complement(&self.values, t, s)
    }

    /// a_u, the part of v̇ that does not depend on ν (4.5), (5.5).
    #[inline]
    pub fn complement_bias(&self, t: T, s: &M::State<T>) -> M::Velocities<T> {
        M::complement_bias(&self.values, t, s)
    }

    /// λ (3.6), all constraints acting; the force of the constraints on the system is Cᵀ λ.
    #[inline]
    pub fn multipliers(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> M::Multipliers<T> {
        M::multipliers(&self.values, t, s, i)
    }

    /// The figures that must not vanish for the state to be a regular one.
    #[inline]
    pub fn guards(&self, t: T, s: &M::State<T>) -> M::Guards<T> {
        M::guards(&self.values, t, s)
    }

    /// v̇ = Dᵀ ν + a_u (4.5), (5.5), for all velocities of the initial system.
    #[inline]
    pub fn velocity_rates(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> M::Velocities<T> {
        M::velocity_rates(&self.values, t, s, i)
    }

    /// Kinetic energy plus the potential energy, where the model declares one.
    pub fn energy(&self, t: T, s: &M::State<T>) -> T {
        let x = self.coordinates(t, s);
        let kinetic = self.kinetic_energy(t, &x, &self.velocities(t, s));
        match self.potential_energy(t, &x) {
            Some(potential) => kinetic + potential,
            None => kinetic,
        }
    }

    /// f of every position row at a state: rounding only, on the constraint manifold.
    pub fn position_residual_at(&self, t: T, s: &M::State<T>) -> M::PositionRows<T> {
        self.position_residual(t, &self.coordinates(t, s))
    }

    /// φ, or ḟ of a position row, for every row of C that binds velocities, at a state.
    pub fn velocity_residual_at(&self, t: T, s: &M::State<T>) -> M::VelocityRows<T> {
        self.velocity_residual(t, &self.coordinates(t, s), &self.velocities(t, s))
    }

    /// The reactions of all constraints in the base of the velocities: r_i* = C_iᵀ λ_i (3.7).
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let hanging = PendulumState { x: 0.0, y: -0.5, dot_x: 0.0 };
    /// let tension = pendulum.reactions(0.0, &hanging, &[]).get("rod").unwrap();
    /// assert!((tension.dot_y - 2.0 * 9.81).abs() < 1e-12);           // it carries the weight
    /// # Ok::<(), Error>(())
    /// ```
    pub fn reactions(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> Reactions<M, T> {
        let (x, v) = (self.coordinates(t, s), self.velocities(t, s));
        Reactions::new(self.constraint_matrix(t, &x, &v), self.multipliers(t, s, i))
    }
}
