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
pub struct Description {
    /// The name of the struct.
    pub name: &'static str,
    /// x, the coordinates of the initial system.
    pub coordinates: &'static [&'static str],
    /// The coordinates in the state: x, or the independent q of a `configuration`.
    pub state_coordinates: &'static [&'static str],
    /// u, the independent speeds in the state.
    pub state_speeds: &'static [&'static str],
    /// v, the velocities of the initial system.
    pub velocities: &'static [&'static str],
    /// The parameters.
    pub parameters: &'static [&'static str],
    /// The inputs.
    pub inputs: &'static [&'static str],
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
    /// The choices that the derive made, and why.
    pub notes: &'static [&'static str],
    /// The derived equations as text.
    pub equations: &'static [Equation],
    /// What each emitted function costs.
    pub operations: &'static [FunctionCost],
}

/// One row of C.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct RowInfo {
    /// The constraint's name.
    pub name: &'static str,
    /// The level at which it was declared.
    pub level: Level,
}

/// The level at which a constraint binds.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Level {
    /// f(x, t) = 0.
    Position,
    /// φ(v, x, t) = 0.
    Velocity,
}

/// One multiplier.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct MultiplierInfo {
    /// The constraint's name.
    pub name: &'static str,
    /// The row of C that carries it; merged rows carry several names.
    pub row: Option<usize>,
}

/// A figure that tells whether a state, or a set of parameters, is a regular one.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct GuardInfo {
    /// The expression, as text.
    pub name: &'static str,
    /// What the figure must satisfy.
    pub kind: GuardKind,
    /// Where it comes from.
    pub origin: &'static str,
}

/// What a guard must satisfy.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum GuardKind {
    /// It must neither vanish nor change its sign.
    Pivot,
    /// It must stay positive (pivots of a positive definite matrix).
    Positive,
}

/// A derived equation as text.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// The symbol that it defines: `M_d`.
    pub symbol: &'static str,
    /// The equation's number in the paper: `(4.10)`.
    pub source: &'static str,
    /// The equation.
    pub text: &'static str,
}

/// What one emitted function costs, parameter-only work apart.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
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
    /// Other function calls.
    pub others: usize,
}
