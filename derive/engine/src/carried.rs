//! Dependent coordinates: carried as states, and why.
//!
//! What position rows bind could as well be found in every evaluation, by Newton's method from where the last one left it, or in closed
//! form. Both are as exact as coordinates that are carried and brought back onto f = 0 after each step. But carried they cost nothing in
//! an evaluation, since their rates are velocities that the motion needs anyway, and the way back takes an iteration or two a step,
//! where each of its evaluations, six to twelve, would take as many. The closed form of two bars on one pin saves two sines and cosines
//! of the four-bar's three, and waits for a root and a quotient before anything else can begin; derived from `configuration` the four-bar
//! then takes 250 cycles instead of 150.

use crate::program::{Count, count};
use crate::projection::{Equations, Level, messages};

/// Tells what the other way would add, where position rows bind coordinates of the state.
pub fn tell(equations: &mut Equations) {
    let binding = &equations.position_residual[..equations.position_residual.len() - equations.norms];
    if binding.is_empty() || equations.state_coordinates != equations.coordinates {
        return;
    }
    let binding = binding.to_vec();
    // What repeats other rows binds nothing more.
    let repeated = equations.rows.iter().filter(|row| row.redundant && row.level == Level::Position).count();
    let cost: Count = count(&mut equations.graph, &binding);
    equations.notes.push(messages::carried(
        binding.len() - repeated,
        cost.operations() + cost.selections,
        cost.sincos + cost.others,
    ));
}
