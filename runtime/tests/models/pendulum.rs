// A pendulum of mass m on a rod of length l in the coordinates x, y (y upwards), written by hand as the derive would write it.
// One position row f = (x² + y² − l²)/2; the independent speed is u = ẋ, so D = [1, −x/y] and y is a pivot. In a second chart
// it is u = ẏ, and x is the pivot.

use holonomy::__private::SMatrix;
use holonomy::{
    ChartInfo, ConstrainedSystem, Description, Error, GuardInfo, GuardKind, Level, MultiplierInfo, RowInfo, Scalar,
    Vector,
};

/// A struct of scalars with names, as the derive emits them.
#[allow(unused_macros)]
macro_rules! named {
    ($(#[$doc:meta])* $name:ident { $($field:ident),* } $count:literal) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, Default, PartialEq)]
        #[allow(missing_docs)]
        pub struct $name<T = f64> { $(pub $field: T),* }
        impl<T: Scalar> From<[T; $count]> for $name<T> {
            fn from([$($field),*]: [T; $count]) -> Self { $name { $($field),* } }
        }
        impl<T: Scalar> From<$name<T>> for [T; $count] {
            fn from(s: $name<T>) -> Self { [$(s.$field),*] }
        }
        impl<T: Scalar> Vector<T> for $name<T> {
            type Array = [T; $count];
            const NAMES: &'static [&'static str] = &[$(stringify!($field)),*];
            fn from_fn(f: impl FnMut(usize) -> T) -> Self { ::core::array::from_fn::<T, $count, _>(f).into() }
        }
    };
}

/// The model.
#[derive(Clone, Debug)]
pub struct Pendulum {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}

named!(/// x, y and the speed ẋ.
    PendulumState { x, y, dot_x } 3);
named!(/// Parameters.
    PendulumParameters { m, l, g } 3);
named!(/// ẋ and ẏ.
    PendulumVelocities { dot_x, dot_y } 2);
named!(/// λ.
    PendulumMultipliers { rod } 1);

impl ConstrainedSystem for Pendulum {
    const MODEL: &'static Description = &Description {
        name: "Pendulum",
        coordinates: &["x", "y"],
        state_coordinates: &["x", "y"],
        state_speeds: &["dot_x"],
        reduced_speeds: &["dot_x"],
        velocities: &["dot_x", "dot_y"],
        parameters: &["m", "l", "g"],
        inputs: &[],
        units: &[],
        outputs: &[],
        defines: &[],
        rows: &[RowInfo { name: "rod", level: Level::Position, linear: true, redundant: false }],
        position_rows: &["rod"],
        multipliers: &[MultiplierInfo { name: "rod", row: Some(0) }],
        guards: &[GuardInfo {
            name: "y",
            kind: GuardKind::Pivot,
            origin: "pivot of the row `rod`",
            rows: &["rod"],
            start: None,
        }],
        parameter_guards: &[GuardInfo {
            name: "m",
            kind: GuardKind::Positive,
            origin: "pivot of M",
            rows: &[],
            start: None,
        }],
        charts: &[
            ChartInfo {
                speeds: &["dot_x"],
                guards: &[GuardInfo {
                    name: "y",
                    kind: GuardKind::Pivot,
                    origin: "pivot of the row `rod`",
                    rows: &["rod"],
                    start: None,
                }],
                relative_pivot: None,
            },
            ChartInfo {
                speeds: &["dot_y"],
                guards: &[GuardInfo {
                    name: "x",
                    kind: GuardKind::Pivot,
                    origin: "pivot of the row `rod`",
                    rows: &["rod"],
                    start: None,
                }],
                relative_pivot: None,
            },
        ],
        carriers: &["dot_x", "dot_y"],
        notes: &["dot_x is independent"],
        equations: &[],
        operations: &[],
    };
    type State<T: Scalar> = PendulumState<T>;
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
    type Carriers<T: Scalar> = [T; 2];
    type StateCoordinates<T: Scalar> = [T; 2];
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
        holonomy::__private::check_parameter_guards(Self::MODEL.parameter_guards, &[p.m])?;
        Ok(*p)
    }
    fn derivative<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &PendulumState<T>,
        i: &[T; 0],
    ) -> (PendulumState<T>, [T; 1]) {
        let v = Self::velocities(p, t, s);
        let [dot_u] = Self::accelerations(p, t, s, i);
        (PendulumState { x: v.dot_x, y: v.dot_y, dot_x: dot_u }, [s.y])
    }
    fn accelerations<T: Scalar>(p: &Self::Values<T>, t: T, s: &PendulumState<T>, i: &[T; 0]) -> [T; 1] {
        let (mass, [forcing]) = Self::mass_matrix_and_forcing(p, t, s, i);
        [forcing / mass[(0, 0)]]
    }
    fn mass_matrix<T: Scalar>(p: &Self::Values<T>, _: T, s: &PendulumState<T>) -> SMatrix<T, 1, 1> {
        let slope = s.x / s.y;
        SMatrix::from_fn(|_, _| p.m * (T::from_f64(1.0) + slope * slope))
    }
    fn forcing<T: Scalar>(p: &Self::Values<T>, t: T, s: &PendulumState<T>, _: &[T; 0]) -> [T; 1] {
        let bias = Self::complement_bias(p, t, s);
        [s.x / s.y * p.m * (p.g + bias.dot_y)]
    }
    fn mass_matrix_and_forcing<T: Scalar>(
        p: &Self::Values<T>,
        t: T,
        s: &PendulumState<T>,
        i: &[T; 0],
    ) -> (SMatrix<T, 1, 1>, [T; 1]) {
        (Self::mass_matrix(p, t, s), Self::forcing(p, t, s, i))
    }
    fn coordinates<T: Scalar>(_: &Self::Values<T>, _: T, s: &PendulumState<T>) -> [T; 2] {
        [s.x, s.y]
    }
    fn velocities<T: Scalar>(_: &Self::Values<T>, _: T, s: &PendulumState<T>) -> PendulumVelocities<T> {
        PendulumVelocities { dot_x: s.dot_x, dot_y: -(s.x / s.y * s.dot_x) }
    }
    fn complement<T: Scalar>(_: &Self::Values<T>, _: T, s: &PendulumState<T>) -> SMatrix<T, 1, 2> {
        SMatrix::from_fn(|_, j| if j == 0 { T::from_f64(1.0) } else { -(s.x / s.y) })
    }
    fn complement_bias<T: Scalar>(p: &Self::Values<T>, t: T, s: &PendulumState<T>) -> PendulumVelocities<T> {
        let v = Self::velocities(p, t, s);
        PendulumVelocities { dot_x: T::default(), dot_y: -((v.dot_x * v.dot_x + v.dot_y * v.dot_y) / s.y) }
    }
    fn velocity_rates<T: Scalar>(p: &Self::Values<T>, t: T, s: &PendulumState<T>, i: &[T; 0]) -> PendulumVelocities<T> {
        let ([u], d, a) = (Self::accelerations(p, t, s, i), Self::complement(p, t, s), Self::complement_bias(p, t, s));
        PendulumVelocities { dot_x: u + a.dot_x, dot_y: d[(0, 1)] * u + a.dot_y }
    }
    fn multipliers<T: Scalar>(p: &Self::Values<T>, t: T, s: &PendulumState<T>, _: &[T; 0]) -> PendulumMultipliers<T> {
        let v = Self::velocities(p, t, s);
        let square = v.dot_x * v.dot_x + v.dot_y * v.dot_y;
        PendulumMultipliers { rod: -(p.m / (s.x * s.x + s.y * s.y) * (square - p.g * s.y)) }
    }
    fn guards<T: Scalar>(_: &Self::Values<T>, _: T, s: &PendulumState<T>) -> [T; 1] {
        [s.y]
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
        _: &PendulumVelocities<T>,
        _: &[T; 0],
    ) -> PendulumVelocities<T> {
        PendulumVelocities { dot_x: T::default(), dot_y: -(p.m * p.g) }
    }
    fn constraint_matrix<T: Scalar>(
        _: &Self::Values<T>,
        _: T,
        x: &[T; 2],
        _: &PendulumVelocities<T>,
    ) -> SMatrix<T, 1, 2> {
        SMatrix::from_fn(|_, j| x[j])
    }
    fn constraint_bias<T: Scalar>(_: &Self::Values<T>, _: T, _: &[T; 2], v: &PendulumVelocities<T>) -> [T; 1] {
        [v.dot_x * v.dot_x + v.dot_y * v.dot_y]
    }
    fn position_residual<T: Scalar>(p: &Self::Values<T>, _: T, x: &[T; 2]) -> [T; 1] {
        [T::from_f64(0.5) * (x[0] * x[0] + x[1] * x[1] - p.l * p.l)]
    }
    fn velocity_residual<T: Scalar>(_: &Self::Values<T>, _: T, x: &[T; 2], v: &PendulumVelocities<T>) -> [T; 1] {
        [x[0] * v.dot_x + x[1] * v.dot_y]
    }
    fn kinetic_energy<T: Scalar>(p: &Self::Values<T>, _: T, _: &[T; 2], v: &PendulumVelocities<T>) -> T {
        T::from_f64(0.5) * p.m * (v.dot_x * v.dot_x + v.dot_y * v.dot_y)
    }
    fn potential_energy<T: Scalar>(p: &Self::Values<T>, _: T, x: &[T; 2]) -> Option<T> {
        Some(p.m * p.g * x[1])
    }
    fn carried_velocities<T: Scalar>(
        _: &Self::Values<T>,
        _: T,
        _: &PendulumState<T>,
        w: &[T; 2],
    ) -> PendulumVelocities<T> {
        PendulumVelocities { dot_x: w[0], dot_y: w[1] }
    }
    fn carried_rates<T: Scalar>(_: &Self::Values<T>, _: T, _: &PendulumState<T>, w: &[T; 2]) -> [T; 2] {
        *w
    }
    fn chart_speeds<T: Scalar>(
        chart: usize,
        _: &Self::Values<T>,
        _: T,
        _: &PendulumState<T>,
        v: &PendulumVelocities<T>,
    ) -> [T; 1] {
        [if chart == 1 { v.dot_y } else { v.dot_x }]
    }
    fn chart_derivative<T: Scalar>(
        chart: usize,
        p: &Self::Values<T>,
        t: T,
        s: &PendulumState<T>,
        i: &[T; 0],
    ) -> (PendulumState<T>, [T; 1]) {
        if chart != 1 {
            return Self::derivative(p, t, s, i);
        }
        // The same with x and y exchanged: D = [−y/x, 1], a_u = [−v·v/x, 0].
        let v = Self::chart_velocities(1, p, t, s);
        let slope = s.y / s.x;
        let bias = -((v.dot_x * v.dot_x + v.dot_y * v.dot_y) / s.x);
        let rate = (slope * bias - p.g) / (T::from_f64(1.0) + slope * slope);
        (PendulumState { x: v.dot_x, y: v.dot_y, dot_x: rate }, [s.x])
    }
    fn chart_velocities<T: Scalar>(
        chart: usize,
        p: &Self::Values<T>,
        t: T,
        s: &PendulumState<T>,
    ) -> PendulumVelocities<T> {
        if chart != 1 {
            return Self::velocities(p, t, s);
        }
        PendulumVelocities { dot_x: -(s.y / s.x * s.dot_x), dot_y: s.dot_x }
    }
}
