//! V of gravity, by first moments collected inwards.

use super::rotors::own_inertias;
use crate::model::mechanism::{Mechanism, Step};
use crate::symbolic::{Expr, Graph, Stage, Triple};

/// V as far as it is known.
pub struct Potential {
    /// What it is the sum of.
    pub terms: Vec<Expr>,
    /// Whether some force is known to have none.
    pub unknown: bool,
}

impl Potential {
    /// V; `None` where the model has none, or not for all of its weight.
    pub fn total(&self, graph: &mut Graph) -> Option<Expr> {
        (!self.unknown && !self.terms.is_empty()).then(|| graph.sum(&self.terms))
    }
}

/// -g · Σ m r, where gravity is the same everywhere and always.
pub fn potential(graph: &mut Graph, mechanism: &Mechanism) -> Potential {
    let mut potential = Potential { terms: Vec::new(), unknown: false };
    let Some(gravity) = mechanism.gravity else { return potential };
    if gravity.iter().any(|e| graph.stage(*e) > Stage::Parameter) {
        potential.unknown = true;
        return potential;
    }
    let own = own_inertias(graph, mechanism);
    let mut beyond: Vec<(Expr, Triple)> = own.iter().map(|inertia| (inertia.mass, inertia.moment)).collect();
    let mut total = graph.no_vector();
    for at in (1..mechanism.nodes.len()).rev() {
        let node = &mechanism.nodes[at];
        let (mass, moment) = beyond[at];
        let moment = match &node.step {
            Step::Turn { rotation, .. } => graph.turned(rotation, &moment),
            Step::Move { offset, .. } => {
                let moved = graph.times(mass, offset);
                graph.plus(&moment, &moved)
            }
            // Already in the axes of the inertial frame; the point's own way is still to come.
            Step::Carry { .. } => {
                total = graph.plus(&total, &moment);
                graph.no_vector()
            }
        };
        let (sum, moments) = beyond[node.parent];
        beyond[node.parent] = (graph.add(sum, mass), graph.plus(&moments, &moment));
    }
    let total = graph.plus(&total, &beyond[0].1);
    let work = graph.dot(&gravity, &total);
    potential.terms.push(graph.neg(work));
    potential
}
