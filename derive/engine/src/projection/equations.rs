//! The result of the projection: every quantity of the paper as expressions.

use super::outputs::Outputs;
use crate::model::Mechanism;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// What a run must watch about a guard.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum GuardKind {
    /// A pivot: must neither vanish nor change its sign.
    Pivot,
    /// A pivot of M_d: must stay above zero.
    Positive,
}

/// A quantity by which the emitted code divides.
#[derive(Clone, PartialEq, Debug)]
pub struct Guard {
    /// The quantity.
    pub expr: Expr,
    /// Its text, as a person would name it: `cos(theta)`.
    pub name: String,
    /// What must hold.
    pub kind: GuardKind,
    /// Where it comes from, in words.
    pub origin: String,
    /// The names of the constraints that it comes from.
    pub rows: Vec<String>,
    /// Its value at the start that the model names, closed; `None` where that is not known.
    pub start: Option<f64>,
}

/// What a row of C binds.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum Level {
    /// Coordinates: f(x, t) = 0.
    Position,
    /// Velocities: φ(v, x, t) = 0.
    Velocity,
    /// Accelerations alone: C v̇ + c0* = 0.
    Acceleration,
}

/// What is known of a row of C.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RowFacts {
    /// The constraint's name.
    pub name: String,
    /// What it binds.
    pub level: Level,
    /// Whether it is linear in that: nonlinear velocity rows are not.
    pub linear: bool,
    /// Whether it depends on other rows and stands here because the model says so.
    pub redundant: bool,
}

/// The motion in a chart beyond the first: the state's coordinates with other independent speeds.
#[derive(Clone, Debug)]
pub struct ChartEquations {
    /// u of this chart.
    pub speeds: Vec<Symbol>,
    /// Rates of the state's coordinates (5.7), (4.3).
    pub coordinate_rates: Vec<Expr>,
    /// u̇.
    pub accelerations: Vec<Expr>,
    /// v (5.3), (4.4).
    pub velocities: Vec<Expr>,
    /// Divisors that depend on the state.
    pub guards: Vec<Guard>,
}

impl ChartEquations {
    /// The functions of the state, guards apart.
    pub fn state_roots(&self) -> Vec<Expr> {
        [&self.coordinate_rates, &self.accelerations, &self.velocities].into_iter().flatten().copied().collect()
    }
}

/// The equations of motion and everything that goes with them.
///
/// n speeds v, m independent rows of C, k = n - m independent accelerations. Functions of the state know t, the state's
/// coordinates, u, inputs and parameters; functions of the initial system know t, x, v, inputs and parameters, and x and v need not
/// satisfy the constraints.
#[derive(Clone, Debug)]
pub struct Equations {
    /// The arena of all expressions.
    pub graph: Graph,
    /// t.
    pub time: Symbol,
    /// Parameters, in the order of the fields.
    pub parameters: Vec<Symbol>,
    /// Inputs.
    pub inputs: Vec<Symbol>,
    /// Coordinates of the state: q with a configuration (4.2), else x.
    pub state_coordinates: Vec<Symbol>,
    /// The speeds u of the state, which position rows and linear velocity rows leave.
    pub state_speeds: Vec<Symbol>,
    /// The speeds whose rates are the independent accelerations ν, k of them: all of the state's, unless there are rows
    /// that bind only u̇.
    pub reduced_speeds: Vec<Symbol>,
    /// x, the coordinates of the initial system.
    pub coordinates: Vec<Symbol>,
    /// v, the speeds of the initial system, n of them.
    pub speeds: Vec<Symbol>,

    /// Rates of the state's coordinates (5.7), (4.3).
    pub coordinate_rates: Vec<Expr>,
    /// u̇, solved for.
    pub accelerations: Vec<Expr>,
    /// M_d = D M Dᵀ, k x k (4.10); without entries where `momenta` tell M.
    pub mass_matrix: Matrix,
    /// h_u* = D (h* - M a_u), k (4.10), (5.6); empty where `momenta` tell M and rows tie the speeds.
    pub forcing: Vec<Expr>,
    /// x of the state (4.2).
    pub initial_coordinates: Vec<Expr>,
    /// v of the state: v = Dᵀ u + v_p (5.3), (4.4).
    pub velocities: Vec<Expr>,
    /// D, k x n: D Cᵀ = 0 (3.1), (4.9).
    pub complement: Matrix,
    /// a_u, n: v̇ = Dᵀ ν + a_u (4.5), (5.5).
    pub complement_bias: Vec<Expr>,
    /// v̇, n.
    pub velocity_rates: Vec<Expr>,
    /// λ, one for each name in `multiplier_names` (3.6); M v̇ = h* + Cᵀ λ.
    pub multipliers: Vec<Expr>,
    /// Divisors that depend on the state.
    pub guards: Vec<Guard>,
    /// Divisors that hold parameters only.
    pub parameter_guards: Vec<Guard>,
    /// The charts beyond the first.
    pub charts: Vec<ChartEquations>,
    /// u of every chart, the first included, as functions of v and the state's coordinates.
    pub chart_speeds: Vec<Vec<Expr>>,
    /// The relative pivot of every chart at the start that the model names; `None` where it is not known.
    pub relative_pivots: Vec<Option<f64>>,
    /// Whether some speeds of the state are combinations of the carriers.
    pub combined: bool,
    /// w, the carriers of the motion: v without a configuration, with one the rates of its coordinates.
    pub carriers: Vec<Symbol>,
    /// v as functions of w and the state's coordinates.
    pub carried_velocities: Vec<Expr>,
    /// The rates of the state's coordinates as functions of w and these coordinates.
    pub carried_rates: Vec<Expr>,

    /// A, n x n: ẋ = A v + a0 (2.1).
    pub kinematic_matrix: Matrix,
    /// a0, n (2.1).
    pub kinematic_bias: Vec<Expr>,
    /// M, n x n (2.3); without entries where a tree was eliminated joint by joint: `momenta` tell it then.
    pub inertia: Matrix,
    /// h*, n (2.3).
    pub forces: Vec<Expr>,
    /// C, m x n (2.5).
    pub constraint_matrix: Matrix,
    /// c0*, m: C v̇ + c0* = 0 (2.6), as corrected.
    pub constraint_bias: Vec<Expr>,
    /// f of every position row.
    pub position_residual: Vec<Expr>,
    /// How many of these, the last ones, hold norms of quaternions: identity is decided where they are zero, and so they must stay as
    /// they are.
    pub norms: usize,
    /// φ, or ḟ, of every row of C that binds velocities.
    pub velocity_residual: Vec<Expr>,
    /// M v, n, of a model of bodies whose speeds are those of its joints; else empty.
    pub momenta: Vec<Expr>,
    /// M v̇ - h*, n, of the same models, over `velocity_rate_symbols`.
    pub inverse_dynamics: Vec<Expr>,
    /// v̇, as symbols.
    pub velocity_rate_symbols: Vec<Symbol>,
    /// The bodies, where the model has any.
    pub mechanism: Option<Mechanism>,
    /// T, as the model gives it or vᵀ M v / 2.
    pub kinetic_energy: Expr,
    /// V, where the model gives it.
    pub potential_energy: Option<Expr>,

    /// What the model tells besides its motion.
    pub outputs: Outputs,

    /// The rows of C.
    pub rows: Vec<RowFacts>,
    /// Names of the position rows.
    pub position_names: Vec<String>,
    /// Names of the multipliers.
    pub multiplier_names: Vec<String>,
    /// The row of C that carries the multiplier; `None` for a merged row that repeats another row's reaction.
    pub multiplier_rows: Vec<Option<usize>>,
    /// Choices that were made, with their reasons.
    pub notes: Vec<String>,
}

impl Equations {
    /// Names of the rows of C.
    pub fn row_names(&self) -> Vec<String> {
        self.rows.iter().map(|row| row.name.clone()).collect()
    }

    /// Names of the rows of C that bind velocities.
    pub fn velocity_row_names(&self) -> Vec<String> {
        let bound = self.rows.iter().filter(|row| row.level != Level::Acceleration);
        bound.map(|row| row.name.clone()).collect()
    }

    /// Whether M is told by what it does alone.
    pub fn is_recursive(&self) -> bool {
        self.inertia.rows() < self.speeds.len()
    }

    /// Whether nothing ties the speeds: they stand in the state as they are, and D is the unit matrix.
    pub fn is_untied(&self) -> bool {
        self.state_speeds == self.speeds
    }

    /// Every expression of the result.
    pub fn roots(&self) -> Vec<Expr> {
        let mut equations = self.clone();
        let mut roots: Vec<Expr> = equations.groups().into_iter().flatten().map(|e| *e).collect();
        roots.extend(self.outputs.values.iter().chain(&self.outputs.carried));
        roots.extend(self.momenta.iter().chain(&self.inverse_dynamics));
        roots.extend(&self.position_residual[self.position_residual.len() - self.norms..]);
        roots
    }

    /// The functions of the state that a run needs, guards apart. Where rows bind accelerations alone, M_d, h_u* and D are
    /// not among them: they divide by pivots that the motion does not need.
    pub fn state_roots(&self) -> Vec<Expr> {
        let mut roots: Vec<Expr> = [
            &self.coordinate_rates,
            &self.accelerations,
            &self.multipliers,
            &self.initial_coordinates,
            &self.velocities,
            &self.velocity_rates,
        ]
        .into_iter()
        .flatten()
        .copied()
        .collect();
        if self.reduced_speeds == self.state_speeds {
            roots.extend(self.forcing.iter().chain(&self.complement_bias));
            roots.extend(self.mass_matrix.entries().iter().chain(self.complement.entries()));
        }
        roots
    }

    /// The expressions in groups that are computed together, to be replaced by cheaper ones in place. Outputs are not among
    /// them: they are made of these.
    pub fn groups(&mut self) -> Vec<Vec<&mut Expr>> {
        let guards = self.guards.iter_mut().map(|g| &mut g.expr);
        let positions = self.position_residual.len() - self.norms;
        let mut groups = vec![
            self.coordinate_rates.iter_mut().chain(&mut self.accelerations).chain(guards).collect(),
            self.mass_matrix.entries_mut().iter_mut().chain(&mut self.forcing).collect(),
            self.velocity_rates.iter_mut().collect(),
            self.multipliers.iter_mut().collect(),
            self.initial_coordinates.iter_mut().chain(&mut self.velocities).collect(),
            self.complement.entries_mut().iter_mut().chain(&mut self.complement_bias).collect(),
            self.kinematic_matrix.entries_mut().iter_mut().chain(&mut self.kinematic_bias).collect(),
            self.inertia.entries_mut().iter_mut().collect(),
            self.forces.iter_mut().collect(),
            self.constraint_matrix.entries_mut().iter_mut().chain(&mut self.constraint_bias).collect(),
            self.position_residual[..positions].iter_mut().chain(&mut self.velocity_residual).collect(),
            std::iter::once(&mut self.kinetic_energy).chain(self.potential_energy.as_mut()).collect(),
            self.carried_velocities.iter_mut().chain(&mut self.carried_rates).collect(),
            self.chart_speeds.iter_mut().flatten().collect(),
        ];
        for chart in &mut self.charts {
            let guards = chart.guards.iter_mut().map(|g| &mut g.expr);
            groups.push(chart.coordinate_rates.iter_mut().chain(&mut chart.accelerations).chain(guards).collect());
            groups.push(chart.velocities.iter_mut().collect());
        }
        groups
    }
}
