//! A chart: a choice of independent speeds, and the motion in terms of them.
//!
//! The first chart names the state's speeds. Every further `independent` is a chart of its own, regular elsewhere: the
//! same coordinates with other speeds, so that a state has the same length in all of them. Nothing that one chart divides
//! by is taken for granted in another.

use super::acceleration::{Bound, bound};
use super::carriers::{CarriedRow, Carriers};
use super::constraints::DifferentiatedRow;
use super::dynamics::{Dynamics, reduce, to_state};
use super::equations::{ChartEquations, Guard};
use super::guards::Guards;
use super::motion::{Solution, solve};
use super::swept::solution;
use super::tangent::{Tangent, tangent};
use super::{Simplifier, TANGENT_PIVOT, messages};
use crate::model::{Independent, InitialSystem};
use crate::symbolic::{Assumptions, Expr};
use crate::syntax::Diagnostics;

/// The motion in one chart, in terms of the state's coordinates and the chart's speeds.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The chart's speeds and the carriers in terms of them.
    pub tangent: Tangent,
    /// The rows that bind u̇ alone.
    pub bound: Bound,
    /// M_d, h_u* and D.
    pub dynamics: Dynamics,
    /// u̇.
    pub solution: Solution,
    /// What the chart divides by.
    pub guards: Guards,
}

impl Chart {
    /// Rates of the state's coordinates (5.7), (4.3).
    pub fn coordinate_rates(
        &self,
        system: &mut InitialSystem,
        simplifier: &mut dyn Simplifier,
        carriers: &Carriers,
    ) -> Vec<Expr> {
        let rates: Vec<Expr> = carriers.motion.iter().map(|(_, rate)| *rate).collect();
        let rates = to_state(&mut system.graph, carriers, &self.tangent, &rates[..carriers.coordinates.len()]);
        rates.into_iter().map(|e| simplifier.one(&mut system.graph, e)).collect()
    }

    /// v (5.3), (4.4).
    pub fn velocities(
        &self,
        system: &mut InitialSystem,
        simplifier: &mut dyn Simplifier,
        carriers: &Carriers,
    ) -> Vec<Expr> {
        let v = system.graph.vars(&system.speeds);
        let velocities = to_state(&mut system.graph, carriers, &self.tangent, &v);
        velocities.into_iter().map(|e| simplifier.one(&mut system.graph, e)).collect()
    }
}

/// Reduces the system to the speeds of one chart.
pub fn chart(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carriers: &Carriers,
    tangent: Tangent,
    errors: &mut Diagnostics,
) -> Option<Chart> {
    let bound = bound(system, simplifier, rows, kept, carriers, &tangent, errors)?;
    let names = |list: &[usize]| -> Vec<String> { list.iter().map(|p| rows[kept[*p]].name.clone()).collect() };
    let mut guards = Guards::default();
    for pivot in system.kinematics.pivots.clone() {
        let pivot = to_state(&mut system.graph, carriers, &tangent, &[pivot])[0];
        let origin = "the kinematics are not invertible where it vanishes (2.2)";
        guards.pivot(&system.graph, pivot, "determinant of the kinematics", origin, &[]);
    }
    let quasi = system.configuration.as_ref().map_or(Vec::new(), |given| given.kinematics.pivots.clone());
    for pivot in quasi {
        let pivot = to_state(&mut system.graph, carriers, &tangent, &[pivot])[0];
        let origin = "the configuration's speeds are not invertible where it vanishes (4.3)";
        guards.pivot(&system.graph, pivot, "determinant of the configuration's speeds", origin, &[]);
    }
    let by_second = names(&tangent.rows);
    for (pivot, called) in tangent.pivots.iter().zip(tangent.pivot_names(&system.graph, &by_second)) {
        guards.pivot(&system.graph, *pivot, &called, TANGENT_PIVOT, &by_second);
    }
    let dynamics = reduce(system, simplifier, carriers, &tangent, &bound);
    let solution = match system.swept.clone() {
        Some(swept) => {
            let all = names(&(0..kept.len()).collect::<Vec<_>>());
            solution(system, &swept, &tangent, &all, &mut guards, errors)
        }
        None => {
            let by_third = names(&bound.rows);
            let watched = (&mut guards, by_third.as_slice());
            solve(system, simplifier, (&tangent, &bound), &dynamics, watched, errors)?
        }
    };
    Some(Chart { tangent, bound, dynamics, solution, guards })
}

/// The charts beyond the first; they take for granted only what held `before` the first.
#[allow(clippy::too_many_arguments)]
pub fn further_charts(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carried: &[CarriedRow],
    carriers: &Carriers,
    before: &Assumptions,
    errors: &mut Diagnostics,
) -> Further {
    let mut further = Further::default();
    for (at, choice) in system.independent.clone().iter().enumerate().skip(1) {
        if let Some(earlier) = system.independent[..at].iter().position(|other| same(choice, other)) {
            errors.report(choice.span, messages::chart_twice(earlier == 0));
            continue;
        }
        let own = system.graph.assume_only(before.clone());
        let tangent = tangent(system, simplifier, rows, kept, carried, carriers, at, errors);
        let found = tangent.and_then(|t| chart(system, simplifier, rows, kept, carriers, t, errors));
        if let Some(chart) = found {
            further.equations.push(ChartEquations {
                speeds: chart.tangent.speeds.clone(),
                coordinate_rates: chart.coordinate_rates(system, simplifier, carriers),
                accelerations: chart.solution.accelerations.clone(),
                velocities: chart.velocities(system, simplifier, carriers),
                guards: chart.guards.state,
            });
            further.notes.extend(chart.tangent.note.iter().map(|note| format!("chart {at}: {note}")));
            further.parameter_guards.extend(chart.guards.parameters);
            further.tangents.push(chart.tangent);
        }
        system.graph.assume_only(own);
    }
    further
}

/// What the charts beyond the first give.
#[derive(Clone, Debug, Default)]
pub struct Further {
    /// The motion in each of them.
    pub equations: Vec<ChartEquations>,
    /// Their speeds.
    pub tangents: Vec<Tangent>,
    /// What they divide by that holds parameters only.
    pub parameter_guards: Vec<Guard>,
    /// How they were found.
    pub notes: Vec<String>,
}

/// Whether two choices of as many speeds name the same ones, in whatever order.
fn same(a: &Independent, b: &Independent) -> bool {
    a.speeds.iter().all(|s| b.speeds.iter().any(|t| t.expr == s.expr))
}
