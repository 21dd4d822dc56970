//! What the derive emits for a model: its description and its functions.

mod description;

use core::fmt::Debug;

use crate::vector::entry;
use crate::{Error, Matrix, Prepared, Scalar, Vector};

pub use description::{
    ChartInfo, Description, Equation, FunctionCost, GuardInfo, GuardKind, Level, MultiplierInfo, OutputInfo, RowInfo,
    UnitInfo, UnitKind,
};

/// The state of a model: `State::<RollingDisk> { theta: 0.3, .. }`.
pub type State<M, T = f64> = <M as ConstrainedSystem>::State<T>;

/// The equations of a constrained mechanism, as static functions; emitted by `#[derive(ConstrainedSystem)]`.
///
/// Users call [`prepare`](ConstrainedSystem::prepare) and work with what it returns. In all functions `p` are the prepared
/// values of the parameters, `t` is the time, `s` a state, `i` the inputs; `x` and `v` are coordinates and velocities of the
/// initial system, which need not satisfy the constraints.
///
/// With n velocities v, m independent rows of constraints and k = n − m. Position rows and velocity rows that are linear in v
/// leave the speeds u of the state. Nonlinear velocity rows and acceleration rows bind only their rates u̇, of which k are
/// independent: ν. Without such rows ν = u̇. C has all rows that carry a multiplier: redundant ones, which depend on others, too.
///
/// | symbol | function | shape | equation |
/// |---|---|---|---|
/// | A, a0 | `kinematic_matrix`, `kinematic_bias` | n × n, n | ẋ = A v + a0 (2.1) |
/// | M, h* | `inertia`, `forces` | n × n, n | M v̇ = h* (2.3) |
/// | M v, M v̇ − h* | `momenta`, `inverse_dynamics` | n, n | (2.3) |
/// | C, c0* | `constraint_matrix`, `constraint_bias` | m × n, m | C v̇ + c0* = 0 (2.4) |
/// | f, φ | `position_residual`, `velocity_residual` | one per row of that level | (2.5), (2.6) |
/// | D | `complement` | k × n | D Cᵀ = 0 (3.1) |
/// | a_u | `complement_bias` | n | v̇ = Dᵀ ν + a_u (4.5), (5.5) |
/// | M_d, h_u* | `mass_matrix`, `forcing` | k × k, k | M_d ν = h_u* (4.10), (5.6) |
/// | u̇, v̇ | `accelerations`, `velocity_rates` | that of u, n | C v̇ + c0* = 0 (2.4) |
/// | λ | `multipliers` | one per name | M v̇ = h* + Cᵀ λ (2.8), (3.6) |
pub trait ConstrainedSystem: Sized + Clone {
    /// Names, guards, notes and equations of the model.
    const MODEL: &'static Description;

    /// The state's coordinates, then the independent speeds u.
    type State<T: Scalar>: Vector<T> + Default;
    /// The parameters.
    type Parameters<T: Scalar>: Vector<T>;
    /// All velocities v of the initial system.
    type Velocities<T: Scalar>: Vector<T>;
    /// λ, one entry per name.
    type Multipliers<T: Scalar>: Vector<T>;
    /// The inputs; `[T; 0]` without inputs.
    type Inputs<T: Scalar>: Vector<T>;
    /// The outputs; `[T; 0]` without outputs.
    type Outputs<T: Scalar>: Vector<T>;
    /// x, the coordinates of the initial system.
    type Coordinates<T: Scalar>: Vector<T>;
    /// u, the speeds of the state.
    type Speeds<T: Scalar>: Vector<T>;
    /// ν, the independent accelerations, k of them.
    type Reduced<T: Scalar>: Vector<T>;
    /// One figure per entry of [`Description::guards`].
    type Guards<T: Scalar>: Vector<T>;
    /// One figure per guard of the chart with the most of them; shorter lists are filled up with ones.
    type ChartGuards<T: Scalar>: Vector<T>;
    /// w, the carriers of the motion: v without a configuration, with one the rates of the state's coordinates.
    type Carriers<T: Scalar>: Vector<T>;
    /// The coordinates of the state.
    type StateCoordinates<T: Scalar>: Vector<T>;
    /// One figure per row of C.
    type Rows<T: Scalar>: Vector<T>;
    /// One figure per row of C that binds velocities; see [`Description::velocity_rows`].
    type VelocityRows<T: Scalar>: Vector<T>;
    /// One figure per position row.
    type PositionRows<T: Scalar>: Vector<T>;
    /// The parameters, the work that depends on them alone, and the fields that are no scalars.
    type Values<T: Scalar>: Clone + Debug;
    /// k × k.
    type MassMatrix<T: Scalar>: Matrix<T>;
    /// n × n.
    type SystemMatrix<T: Scalar>: Matrix<T>;
    /// m × n.
    type ConstraintMatrix<T: Scalar>: Matrix<T>;
    /// k × n.
    type Complement<T: Scalar>: Matrix<T>;

    /// The parameters as they stand in the struct.
    fn parameters(&self) -> Self::Parameters<f64>;

    /// Checks the parameters (finite, parameter guards) and does the work that depends on them alone.
    fn values<T: Scalar>(&self, p: &Self::Parameters<T>) -> Result<Self::Values<T>, Error>;

    /// The state's rate (ẋ or q̇, then u̇), and the guards.
    fn derivative<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        i: &Self::Inputs<T>,
    ) -> (Self::State<T>, Self::Guards<T>);

    /// u̇: the solution of M_d u̇ = h_u*, where nothing binds u̇ alone.
    fn accelerations<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>, i: &Self::Inputs<T>) -> Self::Speeds<T>;

    /// M_d = D M Dᵀ, k × k.
    fn mass_matrix<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>) -> Self::MassMatrix<T>;

    /// h_u* = D (h* − M a_u).
    fn forcing<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>, i: &Self::Inputs<T>) -> Self::Reduced<T>;

    /// M_d and h_u* together; the work that they share is done once.
    fn mass_matrix_and_forcing<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        i: &Self::Inputs<T>,
    ) -> (Self::MassMatrix<T>, Self::Reduced<T>);

    /// x of the state (4.2).
    fn coordinates<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>) -> Self::Coordinates<T>;

    /// v of the state (4.4), (5.3).
    fn velocities<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>) -> Self::Velocities<T>;

    /// D, k × n.
    fn complement<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>) -> Self::Complement<T>;

    /// a_u, the part of v̇ that does not depend on ν.
    fn complement_bias<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>) -> Self::Velocities<T>;

    /// v̇ = Dᵀ ν + a_u, for all velocities of the initial system.
    fn velocity_rates<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        i: &Self::Inputs<T>,
    ) -> Self::Velocities<T>;

    /// λ (3.6), all constraints acting.
    fn multipliers<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        i: &Self::Inputs<T>,
    ) -> Self::Multipliers<T>;

    /// The figures that must not vanish for the state to be a regular one.
    fn guards<T: Scalar>(p: &Self::Values<T>, t: T, s: &Self::State<T>) -> Self::Guards<T>;

    /// A of ẋ = A v + a0 (2.1), n × n.
    fn kinematic_matrix<T: Scalar>(p: &Self::Values<T>, t: T, x: &Self::Coordinates<T>) -> Self::SystemMatrix<T>;

    /// a0 of (2.1).
    fn kinematic_bias<T: Scalar>(p: &Self::Values<T>, t: T, x: &Self::Coordinates<T>) -> Self::Coordinates<T>;

    /// M of (2.3), n × n.
    fn inertia<T: Scalar>(p: &Self::Values<T>, t: T, x: &Self::Coordinates<T>) -> Self::SystemMatrix<T>;

    /// h* of (2.3).
    fn forces<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &Self::Coordinates<T>,
        v: &Self::Velocities<T>,
        i: &Self::Inputs<T>,
    ) -> Self::Velocities<T>;

    /// M v: the generalised momenta of motions in which nothing moves by itself, T = ½ vᵀ M v. Models of bodies whose speeds are
    /// those of their joints have them along the tree, without M.
    fn momenta<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &Self::Coordinates<T>,
        v: &Self::Velocities<T>,
    ) -> Self::Velocities<T> {
        let (inertia, v) = (Self::inertia(p, t, x), entry(v));
        let columns = 0..Self::SystemMatrix::<T>::COLUMNS;
        Vector::from_fn(|i| columns.clone().fold(T::from_f64(0.0), |sum, j| sum + inertia.entry(i, j) * v(j)))
    }

    /// M v̇ − h*: the further forces along v that the rates v̇ need. Models of bodies whose speeds are those of their joints have
    /// them along the tree, without M.
    fn inverse_dynamics<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &Self::Coordinates<T>,
        v: &Self::Velocities<T>,
        dv: &Self::Velocities<T>,
        i: &Self::Inputs<T>,
    ) -> Self::Velocities<T> {
        let (inertial, forces) = (Self::momenta(p, t, x, dv), Self::forces(p, t, x, v, i));
        let (inertial, forces) = (entry(&inertial), entry(&forces));
        Vector::from_fn(|i| inertial(i) - forces(i))
    }

    /// C of (2.4), m × n.
    fn constraint_matrix<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &Self::Coordinates<T>,
        v: &Self::Velocities<T>,
    ) -> Self::ConstraintMatrix<T>;

    /// c0* of (2.4).
    fn constraint_bias<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &Self::Coordinates<T>,
        v: &Self::Velocities<T>,
    ) -> Self::Rows<T>;

    /// f of every position row.
    fn position_residual<T: Scalar>(p: &Self::Values<T>, t: T, x: &Self::Coordinates<T>) -> Self::PositionRows<T>;

    /// φ, or ḟ of a position row, for every row of C that binds velocities.
    fn velocity_residual<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &Self::Coordinates<T>,
        v: &Self::Velocities<T>,
    ) -> Self::VelocityRows<T>;

    /// The kinetic energy T: as the model gives it, else ½ vᵀ M v.
    fn kinetic_energy<T: Scalar>(p: &Self::Values<T>, t: T, x: &Self::Coordinates<T>, v: &Self::Velocities<T>) -> T;

    /// The potential energy, where the model declares one.
    fn potential_energy<T: Scalar>(p: &Self::Values<T>, t: T, x: &Self::Coordinates<T>) -> Option<T>;

    /// v of the carriers w, which the constraints that bind velocities need not satisfy: v = w without a configuration,
    /// (4.4) with one. Of `s` the coordinates are read.
    fn carried_velocities<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        w: &Self::Carriers<T>,
    ) -> Self::Velocities<T>;

    /// The rates of the state's coordinates for the carriers w (2.1), (4.3). Of `s` the coordinates are read.
    fn carried_rates<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        w: &Self::Carriers<T>,
    ) -> Self::StateCoordinates<T>;

    /// The outputs at a state. A model that has none need not say so; what is provided is not a number.
    fn outputs<T: Scalar>(_: &Self::Values<T>, _: T, _: &Self::State<T>, _: &Self::Inputs<T>) -> Self::Outputs<T> {
        Vector::from_fn(|_| T::from_f64(f64::NAN))
    }

    /// The outputs for the carriers w, their rates ẇ and the multipliers λ, whatever the speeds of the state: v̇ = D1ᵀ ẇ + a_1
    /// (4.5) with a configuration, v̇ = ẇ without. Of `s` the coordinates are read; where the model gives v = g(u, x, t) (5.8)
    /// also its speeds.
    fn carried_outputs<T: Scalar>(
        _: &Self::Values<T>,
        _: T,
        _: &Self::State<T>,
        _: &Self::Carriers<T>,
        _: &Self::Carriers<T>,
        _: &Self::Multipliers<T>,
        _: &Self::Inputs<T>,
    ) -> Self::Outputs<T> {
        Vector::from_fn(|_| T::from_f64(f64::NAN))
    }

    /// u of a chart (see [`Description::charts`]) from v. Of `s` the coordinates are read; where the model gives v = g(u, x, t) (5.8)
    /// with a nonlinear g also its speeds: then the result is one Gauss-Newton step from these, to be repeated.
    fn chart_speeds<T: Scalar>(
        chart: usize,
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        v: &Self::Velocities<T>,
    ) -> Self::Speeds<T>;

    /// The state's rate and the guards where the speeds of `s` are those of a chart; a chart that the model does not have
    /// counts as the first one.
    fn chart_derivative<T: Scalar>(
        _chart: usize,
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
        i: &Self::Inputs<T>,
    ) -> (Self::State<T>, Self::ChartGuards<T>) {
        let (rate, guards) = Self::derivative(p, t, s, i);
        let guards: <Self::Guards<T> as Vector<T>>::Array = guards.into();
        let one = T::from_f64(1.0);
        (rate, Vector::from_fn(|at| guards.as_ref().get(at).copied().unwrap_or(one)))
    }

    /// v where the speeds of `s` are those of a chart.
    fn chart_velocities<T: Scalar>(
        _chart: usize,
        p: &Self::Values<T>,
        t: T,
        s: &Self::State<T>,
    ) -> Self::Velocities<T> {
        Self::velocities(p, t, s)
    }

    /// Checks the parameters and gives the model that runs.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::Pendulum;
    /// use holonomy::prelude::*;
    ///
    /// assert!(Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().is_ok());
    /// let error = Pendulum { m: -2.0, l: 0.5, g: 9.81 }.prepare().unwrap_err();
    /// assert!(matches!(error, Error::Indefinite { .. }));
    /// ```
    fn prepare(self) -> Result<Prepared<Self>, Error> {
        Prepared::new(self)
    }

    /// The same over another scalar.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let single = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare_as::<f32>()?;
    /// let hanging = PendulumState { x: 0.0f32, y: -0.5, dot_x: 0.0 };
    /// assert!((single.energy(0.0, &hanging) + 9.81).abs() < 1e-5);
    /// # Ok::<(), Error>(())
    /// ```
    fn prepare_as<T: Scalar>(self) -> Result<Prepared<Self, T>, Error> {
        Prepared::new(self)
    }
}
