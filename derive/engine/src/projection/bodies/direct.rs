//! Body by body, where v are speeds of the model's own: partial velocities are read off the twists once these are reduced.

use super::Sums;
use super::rotors::own_inertias;
use super::sweep::{along, twists, weights};
use crate::model::mechanism::Mechanism;
use crate::projection::Simplifier;
use crate::symbolic::{Expr, Graph, Matrix, Symbol, Triple};

/// M, h* and T of the bodies.
pub fn equations(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    mechanism: &Mechanism,
    speeds: &[Symbol],
    motion: &[(Symbol, Expr)],
) -> Sums {
    let n = speeds.len();
    let twists = twists(graph, mechanism);
    let weights = weights(graph, mechanism);
    let own = own_inertias(graph, mechanism);
    let mut inertia: Vec<Vec<Vec<Expr>>> = vec![vec![Vec::new(); n]; n];
    let mut forces: Vec<Vec<Expr>> = vec![Vec::new(); n];
    let mut kinetic = Vec::new();
    for at in 0..mechanism.nodes.len() {
        let loads: Vec<_> = mechanism.loads.iter().filter(|load| load.node == at).collect();
        let body = &own[at];
        let heavy = !body.is_none(graph);
        if !heavy && loads.is_empty() {
            continue;
        }
        let mut reduced = |graph: &mut Graph, vector: Triple| vector.map(|e| simplifier.one(graph, e));
        let velocity = reduced(graph, twists[at].velocity);
        let omega = reduced(graph, twists[at].omega);
        let axes = reduced(graph, twists[at].axes);
        let partial: [Matrix; 2] = [velocity, omega].map(|vector| graph.jacobian(&vector, speeds));
        let column = |matrix: &Matrix, j: usize| -> Triple { std::array::from_fn(|i| matrix.get(i, j)) };
        let columns: Vec<(Triple, Triple)> = (0..n).map(|j| (column(&partial[0], j), column(&partial[1], j))).collect();
        let (mut force, mut torque) = (graph.no_vector(), graph.no_vector());
        for load in loads {
            force = graph.plus(&force, &load.force);
            torque = graph.plus(&torque, &load.torque);
        }
        if heavy {
            // The rate of components, and what turns with the axes.
            let rate = |graph: &mut Graph, vector: &Triple| {
                let (own, turned) = (along(graph, vector, motion), graph.cross(&axes, vector));
                graph.plus(&own, &turned)
            };
            let (mut linear, angular) = (rate(graph, &velocity), rate(graph, &omega));
            if let Some(weights) = &weights {
                linear = graph.plus(&linear, &weights[at]);
            }
            let (push, twist) = body.of(&linear, &angular, graph);
            let spun = graph.turned(&body.tensor, &omega);
            let gyroscopic = graph.cross(&omega, &spun);
            let twist = graph.plus(&twist, &gyroscopic);
            force = graph.minus(&force, &push);
            torque = graph.minus(&torque, &twist);
            kinetic.push(body.energy(&velocity, &omega, graph));
            for (j, (linear, angular)) in columns.iter().enumerate() {
                let (push, twist) = body.of(linear, angular, graph);
                for (i, (linear, angular)) in columns.iter().enumerate().skip(j) {
                    let (a, b) = (graph.dot(linear, &push), graph.dot(angular, &twist));
                    inertia[i][j].push(graph.add(a, b));
                }
            }
        }
        for (i, (linear, angular)) in columns.iter().enumerate() {
            let (a, b) = (graph.dot(linear, &force), graph.dot(angular, &torque));
            forces[i].push(graph.add(a, b));
        }
    }
    let inertia = Matrix::from_fn(n, n, |i, j| graph.sum(&inertia[i.max(j)][i.min(j)]));
    let forces = forces.into_iter().map(|terms| graph.sum(&terms)).collect();
    Sums { inertia, forces, kinetic: graph.sum(&kinetic) }
}
