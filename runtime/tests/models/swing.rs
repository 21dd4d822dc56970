// The pendulum again, with x = l sin α, y = −l cos α given (4.2): the state is α and its rate, and the row stays for λ.

/// The model.
#[derive(Clone, Debug)]
pub struct Swing {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}

named!(/// α and its rate.
    SwingState { alpha, dot_alpha } 2);

impl ConstrainedSystem for Swing {
    const MODEL: &'static Description = &Description {
        name: "Swing",
        state_coordinates: &["alpha"],
        state_speeds: &["dot_alpha"],
        reduced_speeds: &["dot_alpha"],
        guards: &[GuardInfo {
            name: "m*l*l",
            kind: GuardKind::Positive,
            origin: "pivot of M_d",
            rows: &[],
            start: None,
        }],
        charts: &[ChartInfo {
            speeds: &["dot_alpha"],
            guards: &[GuardInfo {
                name: "m*l*l",
                kind: GuardKind::Positive,
                origin: "pivot of M_d",
                rows: &[],
                start: None,
            }],
            relative_pivot: None,
        }],
        carriers: &["dot_alpha"],
        ..*Pendulum::MODEL
    };
    type State<T: Scalar> = SwingState<T>;
    type Parameters<T: Scalar> = PendulumParameters<T>;
    type Velocities<T: Scalar> = PendulumVelocities<T>;
    type Multipliers<T: Scalar> = PendulumMultipliers<T>;
    type Inputs<T: Scalar> = [T; 0];
    type Outputs<T: Scalar> = [T; 0];
    type Coordinates<T: Scalar> = [T; 2];
    type Speeds<T: Scalar> = [T; 1];
    type Reduced<T: Scalar> = [T; 1];
    type Guards<T: Scalar> = [T; 1];
    type ChartGuards<T: Scalar> = [T; 1];
    type Carriers<T: Scalar> = [T; 1];
    type StateCoordinates<T: Scalar> = [T; 1];
    type Rows<T: Scalar> = [T; 1];
    type VelocityRows<T: Scalar> = [T; 1];
    type PositionRows<T: Scalar> = [T; 1];
    type Values<T: Scalar> = PendulumParameters<T>;
    type MassMatrix<T: Scalar> = SMatrix<T, 1, 1>;
    type SystemMatrix<T: Scalar> = SMatrix<T, 2, 2>;
    type ConstraintMatrix<T: Scalar> = SMatrix<T, 1, 2>;
    type Complement<T: Scalar> = SMatrix<T, 1, 2>;

    fn parameters(&self) -> PendulumParameters {
        PendulumParameters { m: self.m, l: self.l, g: self.g }
    }
    fn values<T: Scalar>(&self, p: &PendulumParameters<T>) -> Result<PendulumParameters<T>, Error> {
        holonomy::__private::check_parameters(&["m", "l", "g"], &[p.m, p.l, p.g])?;
        Ok(*p)
    }
    fn derivative<T: Scalar>(p: &Self::Values<T>, t: T, s: &SwingState<T>, i: &[T; 0]) -> (SwingState<T>, [T; 1]) {
        let [rate] = Self::accelerations(p, t, s, i);
        (SwingState { alpha: s.dot_alpha, dot_alpha: rate }, Self::guards(p, t, s))
    }
    fn accelerations<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>, _: &[T; 0]) -> [T; 1] {
        [-(p.g / p.l * s.alpha.sin_cos().0)]
    }
    fn mass_matrix<T: Scalar>(p: &Self::Values<T>, _: T, _: &SwingState<T>) -> SMatrix<T, 1, 1> {
        SMatrix::from_fn(|_, _| p.m * p.l * p.l)
    }
    fn forcing<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>, _: &[T; 0]) -> [T; 1] {
        [-(p.m * p.g * p.l * s.alpha.sin_cos().0)]
    }
    fn mass_matrix_and_forcing<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &SwingState<T>,
        i: &[T; 0],
    ) -> (SMatrix<T, 1, 1>, [T; 1]) {
        (Self::mass_matrix(p, t, s), Self::forcing(p, t, s, i))
    }
    fn coordinates<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>) -> [T; 2] {
        let (sin, cos) = s.alpha.sin_cos();
        [p.l * sin, -(p.l * cos)]
    }
    fn velocities<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>) -> PendulumVelocities<T> {
        let (sin, cos) = s.alpha.sin_cos();
        PendulumVelocities { dot_x: p.l * cos * s.dot_alpha, dot_y: p.l * sin * s.dot_alpha }
    }
    fn complement<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>) -> SMatrix<T, 1, 2> {
        let (sin, cos) = s.alpha.sin_cos();
        SMatrix::from_fn(|_, j| p.l * if j == 0 { cos } else { sin })
    }
    fn complement_bias<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>) -> PendulumVelocities<T> {
        let (sin, cos) = s.alpha.sin_cos();
        let square = s.dot_alpha * s.dot_alpha * p.l;
        PendulumVelocities { dot_x: -(sin * square), dot_y: cos * square }
    }
    fn velocity_rates<T: Scalar>(p: &Self::Values<T>, t: T, s: &SwingState<T>, i: &[T; 0]) -> PendulumVelocities<T> {
        let ([u], d, a) = (Self::accelerations(p, t, s, i), Self::complement(p, t, s), Self::complement_bias(p, t, s));
        PendulumVelocities { dot_x: d[(0, 0)] * u + a.dot_x, dot_y: d[(0, 1)] * u + a.dot_y }
    }
    fn multipliers<T: Scalar>(p: &Self::Values<T>, _: T, s: &SwingState<T>, _: &[T; 0]) -> PendulumMultipliers<T> {
        let square = s.dot_alpha * s.dot_alpha * p.l;
        PendulumMultipliers { rod: -(p.m / p.l * (square + p.g * s.alpha.sin_cos().1)) }
    }
    fn guards<T: Scalar>(p: &Self::Values<T>, _: T, _: &SwingState<T>) -> [T; 1] {
        [p.m * p.l * p.l]
    }
    fn kinematic_matrix<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2]) -> SMatrix<T, 2, 2> {
        Pendulum::kinematic_matrix(p, t, x)
    }
    fn kinematic_bias<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2]) -> [T; 2] {
        Pendulum::kinematic_bias(p, t, x)
    }
    fn inertia<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2]) -> SMatrix<T, 2, 2> {
        Pendulum::inertia(p, t, x)
    }
    fn forces<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &[T; 2],
        v: &PendulumVelocities<T>,
        i: &[T; 0],
    ) -> PendulumVelocities<T> {
        Pendulum::forces(p, t, x, v, i)
    }
    fn constraint_matrix<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        x: &[T; 2],
        v: &PendulumVelocities<T>,
    ) -> SMatrix<T, 1, 2> {
        Pendulum::constraint_matrix(p, t, x, v)
    }
    fn constraint_bias<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2], v: &PendulumVelocities<T>) -> [T; 1] {
        Pendulum::constraint_bias(p, t, x, v)
    }
    fn position_residual<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2]) -> [T; 1] {
        Pendulum::position_residual(p, t, x)
    }
    fn velocity_residual<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2], v: &PendulumVelocities<T>) -> [T; 1] {
        Pendulum::velocity_residual(p, t, x, v)
    }
    fn kinetic_energy<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2], v: &PendulumVelocities<T>) -> T {
        Pendulum::kinetic_energy(p, t, x, v)
    }
    fn potential_energy<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2]) -> Option<T> {
        Pendulum::potential_energy(p, t, x)
    }
    fn carried_velocities<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &SwingState<T>,
        w: &[T; 1],
    ) -> PendulumVelocities<T> {
        Self::velocities(p, t, &SwingState { alpha: s.alpha, dot_alpha: w[0] })
    }
    fn carried_rates<T: Scalar>(_: &Self::Values<T>, _: T, _: &SwingState<T>, w: &[T; 1]) -> [T; 1] {
        *w
    }
    fn chart_speeds<T: Scalar>(
        _: usize,
        p: &Self::Values<T>,
        _: T,
        s: &SwingState<T>,
        v: &PendulumVelocities<T>,
    ) -> [T; 1] {
        let (sin, cos) = s.alpha.sin_cos();
        [(cos * v.dot_x + sin * v.dot_y) / p.l]
    }
}
