//! What acts at the nodes for v̇ = 0: loads, weights and inertia forces.

use super::rotors::own_inertias;
use super::spatial::{Inertia, Wrench};
use super::sweep::{Twist, biases, twists};
use crate::model::mechanism::Mechanism;
use crate::symbolic::{Expr, Graph, Symbol};

/// The bodies at their nodes.
pub struct Acting {
    /// The inertia of what is fixed to each node.
    pub own: Vec<Inertia>,
    /// What acts there.
    pub wrenches: Vec<Wrench>,
    /// T.
    pub kinetic: Expr,
}

/// Velocities and accelerations outwards, then F − 𝓜 γ − Ω × 𝓜 V node by node.
pub fn acting(graph: &mut Graph, mechanism: &Mechanism, motion: &[(Symbol, Expr)]) -> Acting {
    let twists = twists(graph, mechanism);
    let biases = biases(graph, mechanism, &twists, motion);
    let own = own_inertias(graph, mechanism);
    let mut wrenches: Vec<Wrench> = Vec::with_capacity(own.len());
    let mut kinetic = Vec::new();
    for (at, inertia) in own.iter().enumerate() {
        let mut wrench = Wrench::new(graph.no_vector(), graph.no_vector());
        if !inertia.is_none(graph) {
            let Twist { velocity, omega, .. } = twists[at];
            let (force, torque) = inertia.of(&biases[at].linear, &biases[at].angular, graph);
            // The centre of mass is the node's point.
            let spun = graph.turned(&inertia.tensor, &omega);
            let gyroscopic = graph.cross(&omega, &spun);
            let torque = graph.plus(&torque, &gyroscopic);
            let still = graph.no_vector();
            wrench = Wrench::new(graph.minus(&still, &force), graph.minus(&still, &torque));
            kinetic.push(inertia.energy(&velocity, &omega, graph));
        }
        wrenches.push(wrench);
    }
    for load in &mechanism.loads {
        wrenches[load.node] = wrenches[load.node].plus(&Wrench::new(load.force, load.torque), graph);
    }
    Acting { own, wrenches, kinetic: graph.sum(&kinetic) }
}
