//! Composite inertias and forces collected inwards, where v are the rates of the coordinates or angular velocities at joints.
//!
//! A column of M is the force that the composite body beyond a joint needs to be accelerated by that joint alone, felt at
//! every joint on its way inwards; h* is what is left of all forces for v̇ = 0 (Featherstone, Rigid Body Dynamics Algorithms,
//! chapters 5 and 6). In a chain of n bodies that is O(n²) for M and O(n) for h*.

use super::Sums;
use super::rotors::own_inertias;
use super::spatial::{Inertia, Wrench};
use super::sweep::{Twist, biases, twists};
use crate::model::mechanism::{Mechanism, Step};
use crate::symbolic::{Expr, Graph, Matrix, Symbol, Triple};

/// The partial velocities of a step: a speed's position, linear and angular part.
type Column = (usize, Triple, Triple);

/// M, h* and T of the bodies.
pub fn equations(graph: &mut Graph, mechanism: &Mechanism, speeds: &[Symbol], motion: &[(Symbol, Expr)]) -> Sums {
    let twists = twists(graph, mechanism);
    let biases = biases(graph, mechanism, &twists, motion);
    let own = own_inertias(graph, mechanism);
    let columns: Vec<Vec<Column>> = mechanism.nodes.iter().map(|node| columns(graph, &node.step, speeds)).collect();
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
    let mut composite = own;
    let mut inertia: Vec<Vec<Vec<Expr>>> = vec![vec![Vec::new(); speeds.len()]; speeds.len()];
    let mut forces: Vec<Vec<Expr>> = vec![Vec::new(); speeds.len()];
    for at in (1..mechanism.nodes.len()).rev() {
        for (i, linear, angular) in &columns[at] {
            forces[*i].push(wrenches[at].felt(linear, angular, graph));
        }
        if !columns[at].is_empty() && !composite[at].is_none(graph) {
            inertia_of(graph, mechanism, &columns, at, &composite[at], &mut inertia);
        }
        let node = &mechanism.nodes[at];
        let wrench = wrenches[at].inwards(&node.step, graph);
        wrenches[node.parent] = wrenches[node.parent].plus(&wrench, graph);
        let moved = composite[at].inwards(&node.step, graph);
        composite[node.parent] = composite[node.parent].plus(&moved, graph);
    }
    let inertia = Matrix::from_fn(speeds.len(), speeds.len(), |i, j| graph.sum(&inertia[i][j]));
    let forces = forces.into_iter().map(|terms| graph.sum(&terms)).collect();
    Sums { inertia, forces, kinetic: graph.sum(&kinetic) }
}

/// What the joint at a node adds to M, with every joint between it and the ground.
fn inertia_of(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    joint: usize,
    composite: &Inertia,
    inertia: &mut [Vec<Vec<Expr>>],
) {
    for (j, linear, angular) in &columns[joint] {
        let (force, torque) = composite.of(linear, angular, graph);
        let mut wrench = Wrench::new(force, torque);
        let mut at = joint;
        while at != 0 {
            for (i, linear, angular) in &columns[at] {
                let entry = wrench.felt(linear, angular, graph);
                inertia[*i][*j].push(entry);
                // The other joint's acceleration is felt here as well.
                if at != joint {
                    inertia[*j][*i].push(entry);
                }
            }
            wrench = wrench.inwards(&mechanism.nodes[at].step, graph);
            at = mechanism.nodes[at].parent;
        }
    }
}

fn columns(graph: &mut Graph, step: &Step, speeds: &[Symbol]) -> Vec<Column> {
    let (rate, turns) = match step {
        Step::Turn { spin, .. } => (spin, true),
        Step::Move { rate, .. } => (rate, false),
        Step::Carry { .. } => return Vec::new(),
    };
    let gradient = graph.jacobian(rate, speeds);
    let still = graph.no_vector();
    (0..speeds.len())
        .filter_map(|j| {
            let column: Triple = std::array::from_fn(|i| gradient.get(i, j));
            let moves = column.iter().any(|e| !graph.is_zero(*e));
            moves.then_some(if turns { (j, still, column) } else { (j, column, still) })
        })
        .collect()
}
