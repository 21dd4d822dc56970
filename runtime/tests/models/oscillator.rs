// A driven oscillator without constraints: m (1 + a x) ẍ = −k x − c x³ + b sin t + tau, written by hand as the derive would.
// The inertia depends on x if a ≠ 0, so that it can become indefinite on the way.

/// The model.
#[derive(Clone, Debug)]
pub struct Oscillator {
    /// Mass.
    pub m: f64,
    /// Growth of the mass.
    pub a: f64,
    /// Stiffness.
    pub k: f64,
    /// Cubic stiffness.
    pub c: f64,
    /// Amplitude of a force.
    pub b: f64,
}

named!(/// x and ẋ.
    OscillatorState { x, dot_x } 2);
named!(/// Parameters.
    OscillatorParameters { m, a, k, c, b } 5);
named!(/// ẋ.
    OscillatorVelocities { dot_x } 1);
named!(/// The drive.
    OscillatorInputs { tau } 1);

impl ConstrainedSystem for Oscillator {
    const MODEL: &'static Description = &Description {
        name: "Oscillator",
        coordinates: &["x"],
        state_coordinates: &["x"],
        state_speeds: &["dot_x"],
        reduced_speeds: &["dot_x"],
        velocities: &["dot_x"],
        parameters: &["m", "a", "k", "c", "b"],
        inputs: &["tau"],
        units: &[],
        outputs: &[],
        defines: &[],
        rows: &[],
        position_rows: &[],
        multipliers: &[],
        guards: &[GuardInfo {
            name: "m*(1 + a*x)",
            kind: GuardKind::Positive,
            origin: "pivot of M_d",
            rows: &[],
            start: None,
        }],
        parameter_guards: &[GuardInfo {
            name: "m",
            kind: GuardKind::Pivot,
            origin: "divided by",
            rows: &[],
            start: None,
        }],
        charts: &[ChartInfo {
            speeds: &["dot_x"],
            guards: &[GuardInfo {
                name: "m*(1 + a*x)",
                kind: GuardKind::Positive,
                origin: "pivot of M_d",
                rows: &[],
                start: None,
            }],
            relative_pivot: None,
        }],
        carriers: &["dot_x"],
        notes: &[],
        equations: &[],
        operations: &[],
    };
    type State<T: Scalar> = OscillatorState<T>;
    type Parameters<T: Scalar> = OscillatorParameters<T>;
    type Velocities<T: Scalar> = OscillatorVelocities<T>;
    type Multipliers<T: Scalar> = [T; 0];
    type Inputs<T: Scalar> = OscillatorInputs<T>;
    type Outputs<T: Scalar> = [T; 0];
    type Coordinates<T: Scalar> = [T; 1];
    type Speeds<T: Scalar> = [T; 1];
    type Reduced<T: Scalar> = [T; 1];
    type Guards<T: Scalar> = [T; 1];
    type ChartGuards<T: Scalar> = [T; 1];
    type Carriers<T: Scalar> = [T; 1];
    type StateCoordinates<T: Scalar> = [T; 1];
    type Rows<T: Scalar> = [T; 0];
    type VelocityRows<T: Scalar> = [T; 0];
    type PositionRows<T: Scalar> = [T; 0];
    type Values<T: Scalar> = OscillatorParameters<T>;
    type MassMatrix<T: Scalar> = SMatrix<T, 1, 1>;
    type SystemMatrix<T: Scalar> = SMatrix<T, 1, 1>;
    type ConstraintMatrix<T: Scalar> = SMatrix<T, 0, 1>;
    type Complement<T: Scalar> = SMatrix<T, 1, 1>;

    fn parameters(&self) -> OscillatorParameters {
        OscillatorParameters { m: self.m, a: self.a, k: self.k, c: self.c, b: self.b }
    }
    fn values<T: Scalar>(&self, p: &OscillatorParameters<T>) -> Result<OscillatorParameters<T>, Error> {
        holonomy::__private::check_parameters(Self::MODEL.parameters, &[p.m, p.a, p.k, p.c, p.b])?;
        holonomy::__private::check_parameter_guards(Self::MODEL.parameter_guards, &[p.m])?;
        Ok(*p)
    }
    fn derivative<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &OscillatorState<T>,
        i: &OscillatorInputs<T>,
    ) -> (OscillatorState<T>, [T; 1]) {
        let [rate] = Self::accelerations(p, t, s, i);
        (OscillatorState { x: s.dot_x, dot_x: rate }, Self::guards(p, t, s))
    }
    fn accelerations<T: Scalar>(p: &Self::Values<T>, t: T, s: &OscillatorState<T>, i: &OscillatorInputs<T>) -> [T; 1] {
        let (mass, [force]) = Self::mass_matrix_and_forcing(p, t, s, i);
        [force / mass[(0, 0)]]
    }
    fn mass_matrix<T: Scalar>(p: &Self::Values<T>, t: T, s: &OscillatorState<T>) -> SMatrix<T, 1, 1> {
        Self::inertia(p, t, &[s.x])
    }
    fn forcing<T: Scalar>(p: &Self::Values<T>, t: T, s: &OscillatorState<T>, i: &OscillatorInputs<T>) -> [T; 1] {
        [Self::forces(p, t, &[s.x], &OscillatorVelocities { dot_x: s.dot_x }, i).dot_x]
    }
    fn mass_matrix_and_forcing<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &OscillatorState<T>,
        i: &OscillatorInputs<T>,
    ) -> (SMatrix<T, 1, 1>, [T; 1]) {
        (Self::mass_matrix(p, t, s), Self::forcing(p, t, s, i))
    }
    fn coordinates<T: Scalar>(_: &Self::Values<T>, _: T, s: &OscillatorState<T>) -> [T; 1] {
        [s.x]
    }
    fn velocities<T: Scalar>(_: &Self::Values<T>, _: T, s: &OscillatorState<T>) -> OscillatorVelocities<T> {
        OscillatorVelocities { dot_x: s.dot_x }
    }
    fn complement<T: Scalar>(_: &Self::Values<T>, _: T, _: &OscillatorState<T>) -> SMatrix<T, 1, 1> {
        SMatrix::from_fn(|_, _| T::from_f64(1.0))
    }
    fn complement_bias<T: Scalar>(_: &Self::Values<T>, _: T, _: &OscillatorState<T>) -> OscillatorVelocities<T> {
        OscillatorVelocities::default()
    }
    fn velocity_rates<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &OscillatorState<T>,
        i: &OscillatorInputs<T>,
    ) -> OscillatorVelocities<T> {
        let [dot_x] = Self::accelerations(p, t, s, i);
        OscillatorVelocities { dot_x }
    }
    fn multipliers<T: Scalar>(_: &Self::Values<T>, _: T, _: &OscillatorState<T>, _: &OscillatorInputs<T>) -> [T; 0] {
        []
    }
    fn guards<T: Scalar>(p: &Self::Values<T>, _: T, s: &OscillatorState<T>) -> [T; 1] {
        [p.m * (T::from_f64(1.0) + p.a * s.x)]
    }
    fn kinematic_matrix<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 1]) -> SMatrix<T, 1, 1> {
        SMatrix::from_fn(|_, _| T::from_f64(1.0))
    }
    fn kinematic_bias<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 1]) -> [T; 1] {
        [T::default()]
    }
    fn inertia<T: Scalar>(p: &Self::Values<T>, _: T, x: &[T; 1]) -> SMatrix<T, 1, 1> {
        SMatrix::from_fn(|_, _| p.m * (T::from_f64(1.0) + p.a * x[0]))
    }
    fn forces<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &[T; 1],
        _: &OscillatorVelocities<T>,
        i: &OscillatorInputs<T>,
    ) -> OscillatorVelocities<T> {
        OscillatorVelocities { dot_x: p.b * t.sin_cos().0 + i.tau - x[0] * (p.k + p.c * x[0] * x[0]) }
    }
    fn constraint_matrix<T: Scalar>(
        _: &Self::Values<T>,
        _: T,
        _: &[T; 1],
        _: &OscillatorVelocities<T>,
    ) -> SMatrix<T, 0, 1> {
        SMatrix::from_fn(|_, _| T::default())
    }
    fn constraint_bias<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 1], _: &OscillatorVelocities<T>) -> [T; 0] {
        []
    }
    fn position_residual<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 1]) -> [T; 0] {
        []
    }
    fn velocity_residual<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 1], _: &OscillatorVelocities<T>) -> [T; 0] {
        []
    }
    fn kinetic_energy<T: Scalar>(p: &Self::Values<T>, _: T, x: &[T; 1], v: &OscillatorVelocities<T>) -> T {
        T::from_f64(0.5) * p.m * (T::from_f64(1.0) + p.a * x[0]) * v.dot_x * v.dot_x
    }
    fn potential_energy<T: Scalar>(p: &Self::Values<T>, _: T, x: &[T; 1]) -> Option<T> {
        let square = x[0] * x[0];
        Some(T::from_f64(0.5) * p.k * square + T::from_f64(0.25) * p.c * square * square)
    }
    fn carried_velocities<T: Scalar>(
        _: &Self::Values<T>,
        _: T,
        _: &OscillatorState<T>,
        w: &[T; 1],
    ) -> OscillatorVelocities<T> {
        OscillatorVelocities { dot_x: w[0] }
    }
    fn carried_rates<T: Scalar>(_: &Self::Values<T>, _: T, _: &OscillatorState<T>, w: &[T; 1]) -> [T; 1] {
        *w
    }
    fn chart_speeds<T: Scalar>(
        _: usize,
        _: &Self::Values<T>,
        _: T,
        _: &OscillatorState<T>,
        v: &OscillatorVelocities<T>,
    ) -> [T; 1] {
        [v.dot_x]
    }
}
