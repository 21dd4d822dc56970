//! The steps in order.

use super::acceleration;
use super::back::{carriers_of_velocities, speeds_of_carriers};
use super::binding::{Binding, binding};
use super::chart::{Chart, chart, further_charts};
use super::dependence::{self, Sorted, check_redundant};
use super::dynamics::to_state;
use super::equations::Equations;
use super::judge::{Judged, figure, judge, relative_pivot};
use super::outputs::{bind, outputs};
use super::overconstrained::relate;
use super::reactions::{Motion, rates as rates_of, reactions, shared};
use super::tangent::tangent;
use super::{Simplifier, constraints::DifferentiatedRow, messages};
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix, Rational, Stage};
use crate::syntax::Diagnostics;

/// The origin of a guard that is a pivot of the tangent basis.
pub const TANGENT_PIVOT: &str =
    "the others do not follow from the independent speeds, by these pivots, where it vanishes (3.1)";

/// Projects the initial system onto the motions that its constraints leave, or says why it cannot.
pub fn project(mut system: InitialSystem, simplifier: &mut dyn Simplifier) -> Result<Equations, Diagnostics> {
    let mut errors = Diagnostics::new();
    let Some(binding) = binding(&mut system, simplifier, &mut errors) else { return Err(errors) };
    let Binding { rows, mut sorted, carriers, carried, overlapping, second_stage } = binding;
    let n = system.speeds.len();
    let before = system.graph.assumptions();
    let tangent = tangent(&mut system, simplifier, &rows, &sorted.kept, &carried, &carriers, 0, &mut errors);
    let Some(tangent) = tangent else { return Err(errors) };
    let judged = Judged { rows: &rows, kept: &sorted.kept, carried: &carried, carriers: &carriers };
    let start = judge(&mut system, simplifier, judged, &tangent, &before, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }
    if tangent.speeds.is_empty()
        && system.mechanism.is_some()
        && let Some(last) = immovable(&system, &rows, &sorted.kept)
    {
        errors.report(rows[last].span, messages::immovable(system.speeds.len()));
        return Err(errors);
    }
    relate(&mut system, simplifier, &rows, &carried, &tangent, &mut sorted);
    let on_motions = |graph: &mut Graph, e: Expr| to_state(graph, &carriers, &tangent, &[e])[0];
    check_redundant(&mut system.graph, simplifier, &rows, &sorted, on_motions, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }
    let chart = chart(&mut system, simplifier, &rows, &sorted.kept, &carriers, tangent, &mut errors);
    let Some(chart) = chart else { return Err(errors) };
    let mut further =
        further_charts(&mut system, simplifier, &rows, &sorted.kept, &carried, &carriers, &before, &mut errors);
    let coordinate_rates = chart.coordinate_rates(&mut system, simplifier, &carriers);
    let velocities = chart.velocities(&mut system, simplifier, &carriers);
    let Chart { tangent, bound, dynamics, solution, mut guards } = chart;
    guards.of_parameters(&system.graph, further.parameter_guards);
    let motion = Motion {
        carriers: &carriers,
        tangent: &tangent,
        bound: &bound,
        dynamics: &dynamics,
        solution: &solution,
        overlapping,
    };
    let Some(reactions) = reactions(&mut system, simplifier, &rows, &sorted.kept, motion, &mut errors) else {
        return Err(errors);
    };
    let names: Vec<String> = sorted.kept.iter().map(|i| rows[*i].name.clone()).collect();
    for pivot in &reactions.pivots {
        let origin = "the reactions are not determined where it vanishes (3.6)";
        let called = format!("pivot of C C\u{1d40} of {}", names.join(", "));
        guards.positive(&mut system.graph, *pivot, &called, origin, &names).ok();
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let on_motions = |graph: &mut Graph, e: Expr| to_state(graph, &carriers, &tangent, &[e])[0];
    let (multipliers, weights) = shared(&mut system.graph, simplifier, &sorted, reactions.multipliers, on_motions);
    let origin = "the redundant rows have no finite share of it where it vanishes";
    guards.divisors(&system.graph, &weights, "divisor of the redundant rows' shares", origin, &names);
    let multipliers: Vec<Expr> = match &solution.swept {
        // What was handed on whole has the form that it will keep.
        Some(_) => multipliers,
        None => multipliers.into_iter().map(|e| simplifier.one(&mut system.graph, e)).collect(),
    };
    let names = name_multipliers(&mut system, &rows, &sorted, &multipliers);
    let x = system.graph.vars(&system.coordinates);
    let initial_coordinates = to_state(&mut system.graph, &carriers, &tangent, &x);
    let of = |name: &str| names.carried_by(name);
    let outputs = outputs(&mut system, &carriers, &tangent, &coordinate_rates, &names.names, &of, &mut errors);
    errors.result(())?;
    let w = carriers_of_velocities(&mut system, simplifier, &carriers);
    let mut chart_speeds = Vec::new();
    for tangent in std::iter::once(&tangent).chain(&further.tangents) {
        chart_speeds.push(speeds_of_carriers(&mut system, simplifier, &carriers, tangent, &w));
    }
    let v = system.graph.vars(&system.speeds);
    let velocity_rates = match &solution.swept {
        Some(swept) => swept.rates.clone(),
        None => {
            let graph = &mut system.graph;
            let rates = rates_of(graph, &dynamics.speed_complement, &solution.accelerations, &dynamics.speed_bias);
            rates.into_iter().map(|e| simplifier.one(graph, e)).collect()
        }
    };
    let carried_velocities = system.graph.substitute(&v, &carriers.map);
    let carried_rates = carriers.motion.iter().map(|(_, rate)| *rate).take(carriers.coordinates.len()).collect();
    let kinetic_energy = kinetic_energy(&mut system);
    let all = sorted.rows();
    let gradients = all.iter().map(|i| rows[*i].gradient.clone()).collect();
    let positions: Vec<&DifferentiatedRow> = rows.iter().filter(|row| row.position.is_some()).collect();
    let charts = std::iter::once(&tangent).chain(&further.tangents);
    let relative_pivots: Vec<Option<f64>> =
        charts.enumerate().map(|chart| relative_pivot(&system, &start, &carried, &carriers, chart)).collect();
    let guarded = std::iter::once(&mut guards.state).chain(further.equations.iter_mut().map(|chart| &mut chart.guards));
    for guard in guarded.flatten() {
        guard.start = figure(&start, &system.graph, guard.expr);
    }
    for guard in &mut guards.parameters {
        guard.start = figure(&start, &system.graph, guard.expr);
    }
    let mut notes: Vec<String> = tangent.note.iter().cloned().collect();
    notes.extend(relative_pivots.iter().enumerate().filter_map(|(at, pivot)| Some(messages::judged(at, (*pivot)?))));
    notes.extend(acceleration::notes(&system.graph, &rows, &sorted.kept, &tangent, &bound));
    notes.extend(dependence::notes(&system.graph, &rows, &sorted));
    notes.extend(further.notes);
    notes.extend(second_stage);
    notes.extend(names.notes);
    let mut equations = Equations {
        time: system.time,
        state_coordinates: carriers.coordinates.clone(),
        state_speeds: tangent.speeds.clone(),
        reduced_speeds: bound.speeds.clone(),
        coordinate_rates,
        accelerations: solution.accelerations,
        mass_matrix: dynamics.mass_matrix,
        forcing: dynamics.forcing,
        initial_coordinates,
        velocities,
        complement: dynamics.complement,
        complement_bias: dynamics.bias,
        velocity_rates,
        multipliers: names.multipliers,
        guards: guards.state,
        parameter_guards: guards.parameters,
        charts: further.equations,
        chart_speeds,
        relative_pivots,
        combined: tangent.readings.is_some(),
        carriers: carriers.speeds,
        carried_velocities,
        carried_rates,
        kinematic_matrix: system.kinematics.a,
        kinematic_bias: system.kinematics.a0,
        inertia: system.inertia,
        forces: system.forces,
        constraint_matrix: Matrix::from_rows(gradients, n),
        constraint_bias: all.iter().map(|i| rows[*i].bias).collect(),
        position_residual: positions.iter().filter_map(|row| row.position).collect(),
        norms: rows.iter().filter(|row| !row.reaction).count(),
        velocity_residual: all.iter().filter_map(|i| rows[*i].velocity).collect(),
        momenta: Vec::new(),
        inverse_dynamics: Vec::new(),
        velocity_rate_symbols: system.outputs.accelerations.clone(),
        mechanism: system.mechanism,
        kinetic_energy,
        potential_energy: system.potential,
        outputs,
        rows: all.iter().map(|i| rows[*i].facts(!sorted.kept.contains(i))).collect(),
        position_names: positions.iter().map(|row| row.name.clone()).collect(),
        multiplier_names: names.names,
        multiplier_rows: names.rows,
        notes,
        parameters: system.parameters,
        inputs: system.inputs,
        coordinates: system.coordinates,
        speeds: system.speeds,
        graph: system.graph,
    };
    bind(&mut equations);
    Ok(equations)
}

/// The last row of a mechanism that nothing moves; `None` where time does.
fn immovable(system: &InitialSystem, rows: &[DifferentiatedRow], kept: &[usize]) -> Option<usize> {
    let moved =
        |i: &usize| rows[*i].position.or(rows[*i].velocity).is_some_and(|e| system.graph.contains(e, &[system.time]));
    if kept.iter().any(moved) { None } else { kept.iter().max().copied() }
}

/// T as the model gives it, else vᵀ M v / 2.
fn kinetic_energy(system: &mut InitialSystem) -> Expr {
    if let Some(kinetic) = system.kinetic {
        return kinetic;
    }
    let graph = &mut system.graph;
    let v = graph.vars(&system.speeds);
    let momenta = system.inertia.mul_vec(graph, &v);
    let terms: Vec<Expr> = momenta.into_iter().zip(v).map(|(p, v)| graph.mul(p, v)).collect();
    let twice = graph.sum(&terms);
    graph.scale(Rational::Small(1, 2), twice)
}

/// The multipliers under the names of their constraints, in the order of declaration.
#[derive(Default)]
struct NamedMultipliers {
    names: Vec<String>,
    rows: Vec<Option<usize>>,
    multipliers: Vec<Expr>,
    notes: Vec<String>,
    /// The rows that carry the derivative of a merged row which has no multiplier.
    shared: Vec<(String, Vec<String>)>,
}

impl NamedMultipliers {
    fn carried_by(&self, name: &str) -> Vec<String> {
        self.shared.iter().find(|(row, _)| row == name).map_or(Vec::new(), |(_, carriers)| carriers.clone())
    }
}

/// A merged position row that repeats one velocity row shares its reaction: C_f = s C_φ, so λ_f = λ_φ / s.
fn name_multipliers(
    system: &mut InitialSystem,
    rows: &[DifferentiatedRow],
    sorted: &Sorted,
    multipliers: &[Expr],
) -> NamedMultipliers {
    let graph = &mut system.graph;
    let all = sorted.rows();
    let mut named = NamedMultipliers::default();
    for (i, row) in rows.iter().enumerate().filter(|(_, row)| row.reaction) {
        if let Some(position) = all.iter().position(|j| *j == i) {
            named.names.push(row.name.clone());
            named.rows.push(Some(position));
            named.multipliers.push(multipliers[position]);
        } else if let Some(merged) = sorted.merged.iter().find(|merged| merged.row == i) {
            let carriers: Vec<&str> = merged.combination.iter().map(|(j, _)| rows[*j].name.as_str()).collect();
            let mut note = format!("the derivative of `{}` is carried by `{}`", row.name, carriers.join("`, `"));
            if let [(j, s)] = merged.combination.as_slice()
                && graph.stage(*s) <= Stage::Parameter
                && let Some(position) = all.iter().position(|kept| kept == j)
            {
                named.names.push(row.name.clone());
                named.rows.push(None);
                named.multipliers.push(graph.div(multipliers[position], *s));
                note.push_str("; both names give the one reaction");
            } else {
                let carriers = carriers.iter().map(|name| (*name).to_owned()).collect();
                named.shared.push((row.name.clone(), carriers));
            }
            named.notes.push(note);
        }
    }
    named
}
