// A bead of mass m on a rod that turns at the rate w in a vertical plane (a constraint that moves), in x, y.
// The row stands twice in f, the second time scaled by three, so that the way back onto f = 0 meets dependent rows.
// The independent speed is u = ẋ: D = [1, tan wt], and cos wt is a pivot.

/// The model.
#[derive(Clone, Debug)]
pub struct Bead {
    /// Mass.
    pub m: f64,
    /// Rate.
    pub w: f64,
    /// Gravity.
    pub g: f64,
}

named!(/// x, y and ẋ.
    BeadState { x, y, dot_x } 3);
named!(/// Parameters.
    BeadParameters { m, w, g } 3);
named!(/// ẋ, ẏ.
    BeadVelocities { dot_x, dot_y } 2);
named!(/// λ: the name of a merged row shares it.
    BeadMultipliers { rod, again, nowhere } 3);

/// (sin wt, cos wt).
fn turn<T: Scalar>(p: &BeadParameters<T>, t: T) -> (T, T) {
    (p.w * t).sin_cos()
}

impl ConstrainedSystem for Bead {
    const MODEL: &'static Description = &Description {
        name: "Bead",
        coordinates: &["x", "y"],
        state_coordinates: &["x", "y"],
        state_speeds: &["dot_x"],
        reduced_speeds: &["dot_x"],
        velocities: &["dot_x", "dot_y"],
        parameters: &["m", "w", "g"],
        inputs: &[],
        units: &[],
        outputs: &[],
        defines: &[],
        rows: &[RowInfo { name: "rod", level: Level::Position, linear: true, redundant: false }],
        position_rows: &["rod", "again"],
        multipliers: &[
            MultiplierInfo { name: "rod", row: Some(0) },
            MultiplierInfo { name: "again", row: Some(0) },
            MultiplierInfo { name: "nowhere", row: None },
        ],
        guards: &[GuardInfo {
            name: "cos(w*t)",
            kind: GuardKind::Pivot,
            origin: "pivot of the row `rod`",
            rows: &["rod"],
            start: None,
        }],
        parameter_guards: &[],
        charts: &[ChartInfo {
            speeds: &["dot_x"],
            guards: &[GuardInfo {
                name: "cos(w*t)",
                kind: GuardKind::Pivot,
                origin: "pivot of the row `rod`",
                rows: &["rod"],
                start: None,
            }],
            relative_pivot: None,
        }],
        carriers: &["dot_x", "dot_y"],
        notes: &[],
        equations: &[],
        operations: &[],
    };
    type State<T: Scalar> = BeadState<T>;
    type Parameters<T: Scalar> = BeadParameters<T>;
    type Velocities<T: Scalar> = BeadVelocities<T>;
    type Multipliers<T: Scalar> = BeadMultipliers<T>;
    type Inputs<T: Scalar> = [T; 0];
    type Outputs<T: Scalar> = [T; 0];
    type Coordinates<T: Scalar> = [T; 2];
    type Speeds<T: Scalar> = [T; 1];
    type Reduced<T: Scalar> = [T; 1];
    type Guards<T: Scalar> = [T; 1];
    type ChartGuards<T: Scalar> = [T; 1];
    type Carriers<T: Scalar> = [T; 2];
    type StateCoordinates<T: Scalar> = [T; 2];
    type Rows<T: Scalar> = [T; 1];
    type VelocityRows<T: Scalar> = [T; 1];
    type PositionRows<T: Scalar> = [T; 2];
    type Values<T: Scalar> = BeadParameters<T>;
    type MassMatrix<T: Scalar> = SMatrix<T, 1, 1>;
    type SystemMatrix<T: Scalar> = SMatrix<T, 2, 2>;
    type ConstraintMatrix<T: Scalar> = SMatrix<T, 1, 2>;
    type Complement<T: Scalar> = SMatrix<T, 1, 2>;

    fn parameters(&self) -> BeadParameters {
        BeadParameters { m: self.m, w: self.w, g: self.g }
    }
    fn values<T: Scalar>(&self, p: &BeadParameters<T>) -> Result<BeadParameters<T>, Error> {
        holonomy::__private::check_parameters(Self::MODEL.parameters, &[p.m, p.w, p.g])?;
        Ok(*p)
    }
    fn derivative<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>, i: &[T; 0]) -> (BeadState<T>, [T; 1]) {
        let v = Self::velocities(p, t, s);
        let [rate] = Self::accelerations(p, t, s, i);
        (BeadState { x: v.dot_x, y: v.dot_y, dot_x: rate }, Self::guards(p, t, s))
    }
    fn accelerations<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>, i: &[T; 0]) -> [T; 1] {
        let (mass, [forcing]) = Self::mass_matrix_and_forcing(p, t, s, i);
        [forcing / mass[(0, 0)]]
    }
    fn mass_matrix<T: Scalar>(p: &Self::Values<T>, t: T, _: &BeadState<T>) -> SMatrix<T, 1, 1> {
        let (_, cos) = turn(p, t);
        SMatrix::from_fn(|_, _| p.m / (cos * cos))
    }
    fn forcing<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>, _: &[T; 0]) -> [T; 1] {
        let (sin, cos) = turn(p, t);
        let bias = Self::complement_bias(p, t, s);
        [-(sin / cos * p.m * (p.g + bias.dot_y))]
    }
    fn mass_matrix_and_forcing<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &BeadState<T>,
        i: &[T; 0],
    ) -> (SMatrix<T, 1, 1>, [T; 1]) {
        (Self::mass_matrix(p, t, s), Self::forcing(p, t, s, i))
    }
    fn coordinates<T: Scalar>(_: &Self::Values<T>, _: T, s: &BeadState<T>) -> [T; 2] {
        [s.x, s.y]
    }
    fn velocities<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>) -> BeadVelocities<T> {
        let (sin, cos) = turn(p, t);
        BeadVelocities { dot_x: s.dot_x, dot_y: (sin * (s.dot_x + p.w * s.y) + cos * p.w * s.x) / cos }
    }
    fn complement<T: Scalar>(p: &Self::Values<T>, t: T, _: &BeadState<T>) -> SMatrix<T, 1, 2> {
        let (sin, cos) = turn(p, t);
        SMatrix::from_fn(|_, j| if j == 0 { T::from_f64(1.0) } else { sin / cos })
    }
    fn complement_bias<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>) -> BeadVelocities<T> {
        let v = Self::velocities(p, t, s);
        let [bias] = Self::constraint_bias(p, t, &[s.x, s.y], &v);
        BeadVelocities { dot_x: T::default(), dot_y: -(bias / turn(p, t).1) }
    }
    fn velocity_rates<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>, i: &[T; 0]) -> BeadVelocities<T> {
        let ([u], d, a) = (Self::accelerations(p, t, s, i), Self::complement(p, t, s), Self::complement_bias(p, t, s));
        BeadVelocities { dot_x: u + a.dot_x, dot_y: d[(0, 1)] * u + a.dot_y }
    }
    fn multipliers<T: Scalar>(p: &Self::Values<T>, t: T, s: &BeadState<T>, _: &[T; 0]) -> BeadMultipliers<T> {
        let (_, cos) = turn(p, t);
        let v = Self::velocities(p, t, s);
        let [bias] = Self::constraint_bias(p, t, &[s.x, s.y], &v);
        let rod = -(p.m * (bias - cos * p.g));
        BeadMultipliers { rod, again: rod, nowhere: T::default() }
    }
    fn guards<T: Scalar>(p: &Self::Values<T>, t: T, _: &BeadState<T>) -> [T; 1] {
        [turn(p, t).1]
    }
    fn kinematic_matrix<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 2]) -> SMatrix<T, 2, 2> {
        SMatrix::from_fn(|i, j| T::from_f64(if i == j { 1.0 } else { 0.0 }))
    }
    fn kinematic_bias<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 2]) -> [T; 2] {
        [T::default(); 2]
    }
    fn inertia<T: Scalar>(p: &Self::Values<T>, _: T, _: &[T; 2]) -> SMatrix<T, 2, 2> {
        SMatrix::from_fn(|i, j| if i == j { p.m } else { T::default() })
    }
    fn forces<T: Scalar>(
        p: &Self::Values<T>,
        _: T,
        _: &[T; 2],
        _: &BeadVelocities<T>,
        _: &[T; 0],
    ) -> BeadVelocities<T> {
        BeadVelocities { dot_x: T::default(), dot_y: -(p.m * p.g) }
    }
    fn constraint_matrix<T: Scalar>(p: &Self::Values<T>, t: T, _: &[T; 2], _: &BeadVelocities<T>) -> SMatrix<T, 1, 2> {
        let (sin, cos) = turn(p, t);
        SMatrix::from_fn(|_, j| if j == 0 { -sin } else { cos })
    }
    fn constraint_bias<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2], v: &BeadVelocities<T>) -> [T; 1] {
        let (sin, cos) = turn(p, t);
        let two = T::from_f64(2.0);
        [p.w * p.w * (sin * x[0] - cos * x[1]) - two * p.w * (cos * v.dot_x + sin * v.dot_y)]
    }
    fn position_residual<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2]) -> [T; 2] {
        let (sin, cos) = turn(p, t);
        let f = x[1] * cos - x[0] * sin;
        [f, f * T::from_f64(3.0)]
    }
    fn velocity_residual<T: Scalar>(p: &Self::Values<T>, t: T, x: &[T; 2], v: &BeadVelocities<T>) -> [T; 1] {
        let (sin, cos) = turn(p, t);
        [cos * v.dot_y - sin * v.dot_x - p.w * (sin * x[1] + cos * x[0])]
    }
    fn kinetic_energy<T: Scalar>(p: &Self::Values<T>, _: T, _: &[T; 2], v: &BeadVelocities<T>) -> T {
        T::from_f64(0.5) * p.m * (v.dot_x * v.dot_x + v.dot_y * v.dot_y)
    }
    fn potential_energy<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 2]) -> Option<T> {
        None
    }
    fn carried_velocities<T: Scalar>(_: &Self::Values<T>, _: T, _: &BeadState<T>, w: &[T; 2]) -> BeadVelocities<T> {
        BeadVelocities { dot_x: w[0], dot_y: w[1] }
    }
    fn carried_rates<T: Scalar>(_: &Self::Values<T>, _: T, _: &BeadState<T>, w: &[T; 2]) -> [T; 2] {
        *w
    }
    fn chart_speeds<T: Scalar>(_: usize, _: &Self::Values<T>, _: T, _: &BeadState<T>, v: &BeadVelocities<T>) -> [T; 1] {
        [v.dot_x]
    }
}
