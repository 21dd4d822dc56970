//! The functions of a model: what they read, what they return and which law they express.

use crate::projection::Equations;
use crate::symbolic::{Expr, Matrix};

/// What a function reads besides the prepared values and the time.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum Arguments {
    /// The state.
    State,
    /// The state and the inputs.
    StateInputs,
    /// The initial coordinates x.
    Coordinates,
    /// x and the initial velocities v.
    CoordinatesVelocities,
    /// x, v and the inputs.
    CoordinatesVelocitiesInputs,
    /// x, v, v̇ and the inputs.
    CoordinatesVelocitiesRatesInputs,
    /// The state, of which the coordinates are read, and v.
    StateVelocities,
    /// The state, of which the coordinates are read, and the carriers.
    StateCarriers,
    /// The state, of which coordinates are read, and speeds where the model gives v by them; the carriers, their rates,
    /// the multipliers and the inputs.
    StateCarriersRates,
    /// The state in another chart: its speeds are those of this chart.
    Chart(usize),
    /// The same and the inputs.
    ChartInputs(usize),
    /// The parameters alone: the work of `prepare`.
    Parameters,
}

/// How a group of results is packed.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum Shape {
    /// The state's struct.
    State,
    /// The struct of the initial velocities.
    Velocities,
    /// The struct of the multipliers.
    Multipliers,
    /// The struct of the outputs.
    Outputs,
    /// An array.
    Array(usize),
    /// A matrix, row by row.
    Matrix(usize, usize),
    /// One number.
    Scalar,
    /// One number, or nothing where the model does not give it.
    Optional(bool),
}

/// A group of results.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Output {
    /// How it is packed.
    pub shape: Shape,
    /// The expressions, in order.
    pub roots: Vec<Expr>,
    /// A name for each of them.
    pub labels: Vec<String>,
}

/// One function of a model.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Entry {
    /// The function's name.
    pub name: String,
    /// What it reads.
    pub arguments: Arguments,
    /// What it returns: one group, or a tuple of groups.
    pub outputs: Vec<Output>,
    /// The law, with its number in the paper.
    pub law: &'static str,
}

impl Entry {
    /// All results in order.
    pub fn roots(&self) -> Vec<Expr> {
        self.outputs.iter().flat_map(|o| o.roots.iter().copied()).collect()
    }

    /// The names of all results in order, and whether a description says more: an entry of a matrix or a guard is
    /// only a place.
    pub fn labels(&self) -> Vec<(&str, bool)> {
        let weak =
            |o: &Output| matches!(o.shape, Shape::Matrix(..)) || o.labels.iter().all(|l| l.starts_with("guard_"));
        self.outputs.iter().flat_map(|o| o.labels.iter().map(move |l| (l.as_str(), weak(o)))).collect()
    }
}

/// Every function of the model, in the order of the trait.
pub fn entries(equations: &Equations) -> Vec<Entry> {
    let e = equations;
    let name = |s: &crate::symbolic::Symbol| e.graph.name(*s).to_owned();
    let state: Vec<String> = e.state_coordinates.iter().chain(&e.state_speeds).map(name).collect();
    let u: Vec<String> = e.state_speeds.iter().map(name).collect();
    let x: Vec<String> = e.coordinates.iter().map(name).collect();
    let v: Vec<String> = e.speeds.iter().map(name).collect();
    let prefixed = |prefix: &str, names: &[String]| -> Vec<String> {
        names.iter().map(|n| if prefix.is_empty() { n.clone() } else { format!("{prefix}_{n}") }).collect()
    };
    let array = |roots: &[Expr], labels: Vec<String>| Output {
        shape: Shape::Array(roots.len()),
        roots: roots.to_vec(),
        labels,
    };
    let rates: Vec<Expr> = e.coordinate_rates.iter().chain(&e.accelerations).copied().collect();
    let guards = || {
        let roots: Vec<Expr> = e.guards.iter().map(|g| g.expr).collect();
        let labels = (1..=roots.len()).map(|i| format!("guard_{i}")).collect();
        array(&roots, labels)
    };
    let mass = || matrix(&e.mass_matrix, "m");
    let forcing = || array(&e.forcing, prefixed("h", &e.reduced_speeds.iter().map(name).collect::<Vec<_>>()));
    let accelerations = || array(&e.accelerations, rates_of(&u));
    let velocities = |roots: &[Expr], labels| Output { shape: Shape::Velocities, roots: roots.to_vec(), labels };
    use Arguments::{
        Coordinates, CoordinatesVelocities, CoordinatesVelocitiesInputs, State, StateCarriers, StateInputs,
    };
    let one =
        |name: &str, arguments, law, output| Entry { name: name.to_owned(), arguments, law, outputs: vec![output] };
    let two = |name: &str, arguments, law, a, b| Entry { name: name.to_owned(), arguments, law, outputs: vec![a, b] };
    let multipliers = Output {
        shape: Shape::Multipliers,
        roots: e.multipliers.clone(),
        labels: prefixed("lambda", &e.multiplier_names),
    };
    let potential = Output {
        shape: Shape::Optional(e.potential_energy.is_some()),
        roots: e.potential_energy.into_iter().collect(),
        labels: e.potential_energy.iter().map(|_| "potential".to_owned()).collect(),
    };
    let kinetic = Output { shape: Shape::Scalar, roots: vec![e.kinetic_energy], labels: vec!["kinetic".to_owned()] };
    let derivative = Output { shape: Shape::State, roots: rates, labels: rates_of(&state) };
    let bodies = !e.momenta.is_empty();
    let mut all = vec![
        two(
            "derivative",
            StateInputs,
            "The state's rate: ẋ = A v + a0 (2.1), (5.7), then u̇ of (4.10), (5.6); and the guards.",
            derivative,
            guards(),
        ),
        one("accelerations", StateInputs, "u̇ of M v̇ = h* + Cᵀ λ (2.8), by (4.10) and (5.6).", accelerations()),
        one("mass_matrix", State, "M_d = D M Dᵀ (4.10).", mass()),
        one("forcing", StateInputs, "h_u* = D (h* − M a_u) (4.10), (5.6).", forcing()),
        two("mass_matrix_and_forcing", StateInputs, "M_d and h_u* of M_d ν = h_u* (4.10), (5.6).", mass(), forcing()),
        one("coordinates", State, "x of the state (4.2).", array(&e.initial_coordinates, x.clone())),
        one("velocities", State, "v = Dᵀ u + v_p of the state (4.4), (5.3).", velocities(&e.velocities, v.clone())),
        one("complement", State, "D, with D Cᵀ = 0 (3.1), (4.9).", matrix(&e.complement, "d")),
        one(
            "complement_bias",
            State,
            "a_u of v̇ = Dᵀ ν + a_u (4.5), (5.5).",
            velocities(&e.complement_bias, prefixed("a", &v)),
        ),
        one(
            VELOCITY_RATES,
            StateInputs,
            "v̇ = Dᵀ ν + a_u (4.5), (5.5), for all velocities.",
            velocities(&e.velocity_rates, rates_of(&v)),
        ),
        one("multipliers", StateInputs, "λ of M v̇ = h* + Cᵀ λ (2.8), (3.6), all constraints acting.", multipliers),
        one("guards", State, "The figures that must keep their sign for the state to be a regular one.", guards()),
        one("kinematic_matrix", Coordinates, "A of ẋ = A v + a0 (2.1).", matrix(&e.kinematic_matrix, "a")),
        one("kinematic_bias", Coordinates, "a0 of ẋ = A v + a0 (2.1).", array(&e.kinematic_bias, prefixed("a0", &x))),
        one("inertia", Coordinates, "M of M v̇ = h* (2.3).", matrix(&e.inertia, "m")),
        one("forces", CoordinatesVelocitiesInputs, "h* of M v̇ = h* (2.3).", velocities(&e.forces, prefixed("h", &v))),
        one("constraint_matrix", CoordinatesVelocities, "C of C v̇ + c0* = 0 (2.4).", matrix(&e.constraint_matrix, "c")),
        one(
            "constraint_bias",
            CoordinatesVelocities,
            "c0* of C v̇ + c0* = 0 (2.4), (2.6).",
            array(&e.constraint_bias, prefixed("c0", &e.row_names())),
        ),
        one(
            "position_residual",
            Coordinates,
            "f of the position constraints, left side minus right side.",
            array(&e.position_residual, prefixed("f", &e.position_names)),
        ),
        one(
            "velocity_residual",
            CoordinatesVelocities,
            "φ, or ḟ of a position constraint, for every row of C that binds velocities (2.5).",
            array(&e.velocity_residual, prefixed("phi", &e.velocity_row_names())),
        ),
        one(
            "kinetic_energy",
            CoordinatesVelocities,
            "The kinetic energy: as the model gives it, else ½ vᵀ M v.",
            kinetic,
        ),
        one("potential_energy", Coordinates, "The potential energy, where the model gives one.", potential),
        one(
            "carried_velocities",
            StateCarriers,
            "v of the carriers w, which the velocity constraints need not bind yet (4.4).",
            velocities(&e.carried_velocities, v),
        ),
        one(
            "carried_rates",
            StateCarriers,
            "The rates of the state's coordinates for the carriers w (2.1), (4.3).",
            array(&e.carried_rates, rates_of(&state[..e.state_coordinates.len()])),
        ),
    ];
    if e.is_recursive() {
        // Tied speeds have rates that the derivative does not tell.
        let told = |name: &str| !WITHOUT_MATRIX.contains(&name) || name == VELOCITY_RATES && !e.is_untied();
        all.retain(|entry| told(&entry.name));
    }
    if bodies {
        let law = "M v: the generalised momenta, along the tree of bodies.";
        let labels = prefixed("p", &e.speeds.iter().map(name).collect::<Vec<_>>());
        all.push(one(MOMENTA, CoordinatesVelocities, law, velocities(&e.momenta, labels)));
        let law = "M v̇ − h*: what further forces along v the rates v̇ need (2.3), along the tree of bodies.";
        let reads = Arguments::CoordinatesVelocitiesRatesInputs;
        let labels = prefixed("f", &e.speeds.iter().map(name).collect::<Vec<_>>());
        all.push(one(INVERSE_DYNAMICS, reads, law, velocities(&e.inverse_dynamics, labels)));
    }
    if !e.outputs.names.is_empty() {
        let outputs =
            |roots: &[Expr]| Output { shape: Shape::Outputs, roots: roots.to_vec(), labels: e.outputs.names.clone() };
        let law = "The outputs that the model declares, at a state.";
        all.push(one(OUTPUTS, StateInputs, law, outputs(&e.outputs.values)));
        let law = "The same for the carriers w, ẇ and λ, which need no independent speeds: v̇ = D1ᵀ ẇ + a_1 (4.5).";
        all.push(one(CARRIED_OUTPUTS, Arguments::StateCarriersRates, law, outputs(&e.outputs.carried)));
    }
    all
}

const VELOCITY_RATES: &str = "velocity_rates";
const MOMENTA: &str = "momenta";
const INVERSE_DYNAMICS: &str = "inverse_dynamics";
/// What is emitted in terms of other functions where M is told by what it does alone.
const WITHOUT_MATRIX: [&str; 6] =
    ["accelerations", VELOCITY_RATES, "mass_matrix", "forcing", "mass_matrix_and_forcing", "inertia"];
const OUTPUTS: &str = "outputs";
const CARRIED_OUTPUTS: &str = "carried_outputs";

/// Whether a function of that name computes outputs.
pub fn of_outputs(function: &str) -> bool {
    [OUTPUTS, CARRIED_OUTPUTS].contains(&function)
}

/// The functions of every chart, which the trait's functions choose from: `chart_1_derivative` and the like. Of the first
/// chart only the speeds: the others are the model's own functions.
pub fn chart_entries(equations: &Equations) -> Vec<Entry> {
    let e = equations;
    let name = |s: &crate::symbolic::Symbol| e.graph.name(*s).to_owned();
    let coordinates = e.state_coordinates.iter().map(name);
    let v: Vec<String> = e.speeds.iter().map(name).collect();
    let state: Vec<String> = coordinates.chain(e.state_speeds.iter().map(name)).collect();
    let mut entries = Vec::new();
    for (at, speeds) in e.chart_speeds.iter().enumerate() {
        let outputs = vec![Output {
            shape: Shape::Array(speeds.len()),
            roots: speeds.clone(),
            labels: (1..=speeds.len()).map(|i| format!("u_{i}")).collect(),
        }];
        let law = "u of this chart from v: the inverse of v = Dᵀ u + v_p (5.2).";
        entries.push(Entry { name: chart_function(at, "speeds"), arguments: Arguments::StateVelocities, outputs, law });
    }
    for (at, chart) in e.charts.iter().enumerate() {
        let at = at + 1;
        let mut guards: Vec<Expr> = chart.guards.iter().map(|g| g.expr).collect();
        guards.resize(chart_guards(e), e.graph.one());
        let rates = chart.coordinate_rates.iter().chain(&chart.accelerations).copied().collect();
        let outputs = vec![
            Output { shape: Shape::State, roots: rates, labels: rates_of(&state) },
            Output {
                shape: Shape::Array(guards.len()),
                labels: (1..=guards.len()).map(|i| format!("guard_{i}")).collect(),
                roots: guards,
            },
        ];
        let law = "The state's rate in this chart: ẋ = A v + a0 (2.1), (5.7), then u̇ from M_d u̇ = h_u* (4.10); and its guards.";
        let name = chart_function(at, "derivative");
        entries.push(Entry { name, arguments: Arguments::ChartInputs(at), outputs, law });
        let outputs = vec![Output { shape: Shape::Velocities, roots: chart.velocities.clone(), labels: v.clone() }];
        let law = "v = Dᵀ u + v_p of the state in this chart (4.4), (5.3).";
        entries.push(Entry { name: chart_function(at, "velocities"), arguments: Arguments::Chart(at), outputs, law });
    }
    entries
}

/// The name of one chart's function.
pub fn chart_function(chart: usize, what: &str) -> String {
    format!("chart_{chart}_{what}")
}

/// The length of the longest list of guards among the charts.
pub fn chart_guards(equations: &Equations) -> usize {
    let further = equations.charts.iter().map(|chart| chart.guards.len());
    further.fold(equations.guards.len(), usize::max)
}

fn rates_of(names: &[String]) -> Vec<String> {
    names.iter().map(|n| if n.starts_with("dot_") { format!("d{n}") } else { format!("dot_{n}") }).collect()
}

fn matrix(matrix: &Matrix, letter: &str) -> Output {
    let (rows, columns) = (matrix.rows(), matrix.columns());
    let wide = rows > 9 || columns > 9;
    let labels = (0..rows * columns)
        .map(|k| {
            let (i, j) = (k / columns + 1, k % columns + 1);
            if wide { format!("{letter}_{i}_{j}") } else { format!("{letter}_{i}{j}") }
        })
        .collect();
    Output { shape: Shape::Matrix(rows, columns), roots: matrix.entries().to_vec(), labels }
}
