//! The motion of a tree that was eliminated joint by joint, in terms of a chart's state.
//!
//! v̇ and λ are known over (x, v) for all charts at once. A chart puts its v = v(u, x, t) into them, and its u̇ are the rates of its
//! speeds among v̇: components, or the rates of the combinations that they are. No D and no M_d is needed for that.

use super::constraints::motion_of_norm;
use super::guards::Guards;
use super::messages;
use super::motion::{COMPLIANCE_PIVOT, INERTIA_PIVOT, Solution};
use super::tangent::Tangent;
use crate::model::{InitialSystem, Swept};
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Diagnostics;

/// v̇ and λ in terms of the state.
#[derive(Clone, Debug)]
pub struct InState {
    /// v̇, n.
    pub rates: Vec<Expr>,
    /// λ of the independent rows.
    pub multipliers: Vec<Expr>,
}

/// The origin of a guard that is a pivot of M.
pub const TREE_PIVOT: &str = "a pivot of M, joint by joint from the leaves (2.3)";

/// The motion in a chart; `names` are those of the independent rows.
pub fn solution(
    system: &mut InitialSystem,
    swept: &Swept,
    tangent: &Tangent,
    names: &[String],
    guards: &mut Guards,
    errors: &mut Diagnostics,
) -> Solution {
    let untied = tangent.speeds == system.speeds;
    let (matrix, origin) = if untied { ("D M D\u{1d40}", INERTIA_PIVOT) } else { ("M", TREE_PIVOT) };
    for (speed, pivot) in &swept.pivots {
        let name = system.graph.name(system.speeds[*speed]).to_owned();
        let called = format!("pivot of {matrix} for {name}");
        if let Err(text) = guards.positive(&mut system.graph, *pivot, &called, origin, &[]) {
            errors.report(system.places.inertia, messages::negative_inertia(&name, &text));
        }
    }
    for (row, pivot) in &swept.compliances {
        let called = format!("pivot of C M\u{207b}\u{b9} C\u{1d40} for {}", names[*row]);
        // As positive as M is, for rows that are independent.
        guards.positive(&mut system.graph, *pivot, &called, COMPLIANCE_PIVOT, names).ok();
    }
    let mut accelerations = rates_of_speeds(system, swept, tangent);
    let graph = &mut system.graph;
    let velocities: Vec<(Symbol, Expr)> = tangent.map.iter().map(|(v, value)| (*v, graph.whole(*value))).collect();
    let k = accelerations.len();
    accelerations.extend(swept.rates.iter().chain(&swept.multipliers));
    let mut accelerations = graph.substitute(&accelerations, &velocities);
    let mut rates = accelerations.split_off(k);
    let multipliers = rates.split_off(swept.rates.len());
    Solution { accelerations, multipliers: None, swept: Some(InState { rates, multipliers }) }
}

/// u̇ over (x, v).
fn rates_of_speeds(system: &mut InitialSystem, swept: &Swept, tangent: &Tangent) -> Vec<Expr> {
    let Some(readings) = &tangent.readings else {
        let place = |speed: &Symbol| system.speeds.iter().position(|v| v == speed);
        return tangent.speeds.iter().filter_map(place).map(|at| swept.rates[at]).collect();
    };
    let mut motion = motion_of_norm(system);
    motion.extend(system.speeds.iter().copied().zip(swept.rates.iter().copied()));
    system.graph.along(readings, &motion)
}
