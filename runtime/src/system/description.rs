//! What is known about a model before it runs: names, guards, notes, equations.

/// The names and the facts of a model; emitted as a constant.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::Pendulum;
/// use holonomy::ConstrainedSystem;
///
/// assert_eq!(Pendulum::MODEL.state_speeds, ["dot_x"]);
/// for guard in Pendulum::MODEL.guards {
///     println!("{} must not vanish: {}", guard.name, guard.origin);
/// }
/// ```
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Description {
    /// The name of the struct.
    pub name: &'static str,
    /// x, the coordinates of the initial system.
    pub coordinates: &'static [&'static str],
    /// The coordinates in the state: x, or the independent q of a `configuration`.
    pub state_coordinates: &'static [&'static str],
    /// u, the speeds in the state. They are independent but for rows that only bind accelerations.
    pub state_speeds: &'static [&'static str],
    /// The speeds of the state whose rates are the independent accelerations ν of `mass_matrix` and `forcing`: all of them,
    /// unless there are nonlinear velocity rows or acceleration rows.
    pub reduced_speeds: &'static [&'static str],
    /// v, the velocities of the initial system.
    pub velocities: &'static [&'static str],
    /// The parameters.
    pub parameters: &'static [&'static str],
    /// The inputs.
    pub inputs: &'static [&'static str],
    /// The units of names, as they are declared or follow; none in a model that declares none.
    pub units: &'static [UnitInfo],
    /// The outputs.
    pub outputs: &'static [OutputInfo],
    /// The names of the defines. They have values at run time where they are outputs.
    pub defines: &'static [&'static str],
    /// The rows of C.
    pub rows: &'static [RowInfo],
    /// The rows of f.
    pub position_rows: &'static [&'static str],
    /// λ by name.
    pub multipliers: &'static [MultiplierInfo],
    /// The figures that `guards` and `derivative` return.
    pub guards: &'static [GuardInfo],
    /// The figures of the parameters alone that `values` checks.
    pub parameter_guards: &'static [GuardInfo],
    /// The charts, the state's own first.
    pub charts: &'static [ChartInfo],
    /// w, the carriers of the motion: v, or the rates of the state's coordinates where x = g(q, t) is given.
    pub carriers: &'static [&'static str],
    /// The choices that the derive made, and why.
    pub notes: &'static [&'static str],
    /// The derived equations as text.
    pub equations: &'static [Equation],
    /// What each emitted function costs.
    pub operations: &'static [FunctionCost],
}

impl Description {
    /// The rows of C that bind velocities, in the order of `velocity_residual`: all but acceleration rows.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::Pendulum;
    /// use holonomy::ConstrainedSystem;
    ///
    /// assert_eq!(Pendulum::MODEL.velocity_rows().next().unwrap().name, "rod");
    /// ```
    pub fn velocity_rows(&self) -> impl Iterator<Item = &'static RowInfo> + use<> {
        self.rows.iter().filter(|row| row.level != Level::Acceleration)
    }

    /// The unit of a name, if it is declared or follows: `m/s/s`, and `1` for pure numbers.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] {
    /// use holonomy::{ConstrainedSystem, UnitKind};
    ///
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(alpha)]
    /// #[frame(A = rotate(N, z, alpha))]
    /// #[particle(bob = { at: O - l*A.y, mass: m })]
    /// #[gravity(-g*N.y)]
    /// #[output(height = -l*cos(alpha))]
    /// struct Pendulum {
    ///     #[unit(kg)]
    ///     m: f64,
    ///     #[unit(m)]
    ///     l: f64,
    ///     g: f64,
    /// }
    ///
    /// assert_eq!(Pendulum::MODEL.unit(UnitKind::Parameter, "g"), Some("m/s/s"));
    /// assert_eq!(Pendulum::MODEL.unit(UnitKind::Speed, "dot_alpha"), Some("1/s"));
    /// assert_eq!(Pendulum::MODEL.unit(UnitKind::Output, "height"), Some("m"));
    /// # }
    /// ```
    pub fn unit(&self, kind: UnitKind, name: &str) -> Option<&'static str> {
        self.units.iter().find(|info| info.kind == kind && info.name == name).map(|info| info.unit)
    }
}

/// The unit of a name.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct UnitInfo {
    /// What has it: outputs and multipliers are namespaces of their own.
    pub kind: UnitKind,
    /// Its name.
    pub name: &'static str,
    /// The unit: `kg*m*m`, and `1` for pure numbers.
    pub unit: &'static str,
}

/// What has a unit.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum UnitKind {
    /// A parameter.
    Parameter,
    /// A coordinate, of the initial system or of the state.
    Coordinate,
    /// A velocity, of the initial system or of the state.
    Speed,
    /// An input.
    Input,
    /// An output.
    Output,
    /// λ of a constraint.
    Multiplier,
}

/// One row of C.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RowInfo {
    /// The constraint's name.
    pub name: &'static str,
    /// The level at which it was declared.
    pub level: Level,
    /// Whether it is linear in what it binds; position rows count by their derivative. A row that is not binds the velocities
    /// of the state, which is brought back onto φ = 0, and acts along ∂φ/∂v (Chetaev).
    pub linear: bool,
    /// Whether it depends on other rows and is kept, as the model asks; λ is then the one of least norm.
    pub redundant: bool,
}

/// The level at which a constraint binds, or an output depends on the motion.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum Level {
    /// f(x, t) = 0.
    Position,
    /// φ(v, x, t) = 0.
    Velocity,
    /// C v̇ + c0* = 0.
    Acceleration,
}

/// One multiplier.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MultiplierInfo {
    /// The constraint's name.
    pub name: &'static str,
    /// The row of C that carries it; merged rows carry several names.
    pub row: Option<usize>,
}

/// One output.
///
/// ```
/// # #[cfg(feature = "derive")] {
/// use holonomy::{ConstrainedSystem, Level};
///
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(x, y)]
/// #[inertia(diag(m, m))]
/// #[forces(0, -m*g)]
/// #[constraint(slope: y == x/2)]
/// #[constraint(drive: dot(x) == a*t)]
/// #[output(height = y, ratio = reaction(drive)/reaction(slope), steepness = dot(y)/dot(x))]
/// struct Lift {
///     m: f64,
///     g: f64,
///     a: f64,
/// }
///
/// let [height, ratio, steepness] = Lift::MODEL.outputs else { panic!("three outputs") };
/// assert_eq!((height.level, ratio.level), (Level::Position, Level::Acceleration));
/// assert!(!ratio.inputs && ratio.divisors.is_empty(), "{:?}", ratio.divisors);
/// assert_eq!(steepness.divisors, ["t"]);
/// # }
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutputInfo {
    /// Its name.
    pub name: &'static str,
    /// What it depends on: coordinates and time alone, velocities too, or accelerations and reactions.
    pub level: Level,
    /// Whether it depends on inputs.
    pub inputs: bool,
    /// What it divides by, other than guards and figures that cannot vanish. Where one of them is zero the output is not
    /// finite; a run does not stop there.
    pub divisors: &'static [&'static str],
}

/// A figure that tells whether a state, or a set of parameters, is a regular one.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GuardInfo {
    /// The expression, as text, or what it is. The figure may be the expression times parameters.
    pub name: &'static str,
    /// What the figure must satisfy.
    pub kind: GuardKind,
    /// Where it comes from.
    pub origin: &'static str,
    /// The constraints that it comes from, where it comes from some.
    pub rows: &'static [&'static str],
    /// Its value at the start that the model names, with the nominal parameters, to three digits: what a figure may be
    /// compared with. Position constraints are closed there first. `None` where the model does not say enough.
    ///
    /// A run compares a guard with the largest magnitude that it had so far, and ends, or leaves the chart, where it has
    /// changed its sign or is less than [`SINGULAR`](crate::simulate::SINGULAR) of that.
    pub start: Option<f64>,
}

/// A choice of independent speeds.
///
/// A model has a chart for each of its `independent` statements, and one if it has none. All charts have the coordinates of
/// the state; the entries for the speeds have another meaning in each.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::Pendulum;
/// use holonomy::ConstrainedSystem;
///
/// let [across, along] = Pendulum::MODEL.charts else { panic!("two charts") };
/// assert_eq!((across.speeds, along.speeds), (["dot_x"].as_slice(), ["dot_y"].as_slice()));
/// assert_eq!((across.guards[0].name, along.guards[0].name), ("y", "x"));
/// ```
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChartInfo {
    /// u of the chart.
    pub speeds: &'static [&'static str],
    /// What the chart divides by.
    pub guards: &'static [GuardInfo],
    /// The relative pivot of the chart at the start that the model names, to three digits: with the rows C of the constraints
    /// and u = L v + l0, |det \[C; L\]| over the volumes of the rows of C and of those of L. It is 1 where the independent
    /// speeds are at right angles to all that the constraints bind, and 0 where they do not determine the others. `None`
    /// where the model does not say enough, or gives D or v itself.
    ///
    /// Choices are made from the declarations alone; a run judges charts again at every step, in the kinetic metric.
    pub relative_pivot: Option<f64>,
}

/// What a guard must satisfy.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum GuardKind {
    /// It must neither vanish nor change its sign.
    Pivot,
    /// It must stay positive (pivots of a positive definite matrix).
    Positive,
}

/// A derived equation as text.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Equation {
    /// The symbol that it defines: `M_d`. Long equations are written over parts `e1`, `e2`, …, which stand before them.
    pub symbol: &'static str,
    /// The emitted function that computes it: `mass_matrix`; empty for a part of others.
    pub function: &'static str,
    /// The equation's number in the paper: `(4.10)`.
    pub source: &'static str,
    /// The equation.
    #[cfg_attr(feature = "serde", serde(flatten, serialize_with = "crate::equations::json::text_and_formula"))]
    pub text: &'static str,
}

/// What one emitted function costs, parameter-only work apart.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FunctionCost {
    /// The function's name: `derivative`.
    pub function: &'static str,
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
    /// Sine-cosine pairs, one per distinct angle.
    pub sincos: usize,
    /// Selections (`if`, `min`, `max`), signs and absolute values.
    pub selections: usize,
    /// Other function calls.
    pub others: usize,
}
