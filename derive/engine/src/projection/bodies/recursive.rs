//! Composite inertias and forces collected inwards, where v are the rates of the coordinates or angular velocities at joints.
//!
//! A column of M is the force that the composite body beyond a joint needs to be accelerated by that joint alone, felt at
//! every joint on its way inwards; h* is what is left of all forces for v̇ = 0 (Featherstone, Rigid Body Dynamics Algorithms,
//! chapters 5 and 6). In a chain of n bodies that is O(n²) for M and O(n) for h*.

use super::partial::Column;
use super::spatial::{Inertia, Wrench};
use crate::model::mechanism::Mechanism;
use crate::symbolic::{Expr, Graph, Matrix};

/// M of the bodies.
pub fn inertia(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    own: &[Inertia],
    speeds: usize,
) -> Matrix {
    let mut composite = own.to_vec();
    let mut inertia: Vec<Vec<Vec<Expr>>> = vec![vec![Vec::new(); speeds]; speeds];
    for at in (1..mechanism.nodes.len()).rev() {
        if !columns[at].is_empty() && !composite[at].is_none(graph) {
            of_joint(graph, mechanism, columns, at, &composite[at], &mut inertia);
        }
        let node = &mechanism.nodes[at];
        let moved = composite[at].inwards(&node.step, graph);
        composite[node.parent] = composite[node.parent].plus(&moved, graph);
    }
    Matrix::from_fn(speeds, speeds, |i, j| graph.sum(&inertia[i][j]))
}

/// What wrenches at the nodes do along the speeds: Jᵀ of them.
pub fn collected(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    mut wrenches: Vec<Wrench>,
    speeds: usize,
) -> Vec<Expr> {
    let mut forces: Vec<Vec<Expr>> = vec![Vec::new(); speeds];
    for at in (1..mechanism.nodes.len()).rev() {
        for Column { speed, linear, angular } in &columns[at] {
            forces[*speed].push(wrenches[at].felt(linear, angular, graph));
        }
        let node = &mechanism.nodes[at];
        let wrench = wrenches[at].inwards(&node.step, graph);
        let sum = wrenches[node.parent].plus(&wrench, graph);
        wrenches[node.parent] = if mechanism.whole { sum.whole(graph) } else { sum };
    }
    forces.into_iter().map(|terms| graph.sum(&terms)).collect()
}

/// What the joint at a node adds to M, with every joint between it and the ground.
fn of_joint(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    joint: usize,
    composite: &Inertia,
    inertia: &mut [Vec<Vec<Expr>>],
) {
    for Column { speed: j, linear, angular } in &columns[joint] {
        let (force, torque) = composite.of(linear, angular, graph);
        let mut wrench = Wrench::new(force, torque);
        let mut at = joint;
        while at != 0 {
            for Column { speed: i, linear, angular } in &columns[at] {
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
