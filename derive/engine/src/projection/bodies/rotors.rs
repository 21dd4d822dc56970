//! Rotors: a body whose inertia is the same however it is turned about its axis needs no axes that turn with it.

use super::spatial::Inertia;
use crate::model::mechanism::{Mechanism, Step};
use crate::symbolic::{Graph, Rotation, Triple};

/// Stops the axes of every such body that carries nothing: sines and cosines of its angle are in nothing that follows.
pub fn stop(graph: &mut Graph, mechanism: &mut Mechanism) {
    let identity: Rotation = std::array::from_fn(|i| graph.axis(i));
    for at in 1..mechanism.nodes.len() {
        if mechanism.nodes.iter().skip(1).any(|node| node.parent == at) {
            continue;
        }
        let Step::Turn { rotation, spin, .. } = mechanism.nodes[at].step.clone() else { continue };
        let same = |graph: &mut Graph, vector: &Triple| {
            let turned = graph.turned(&rotation, vector);
            turned.iter().zip(vector).all(|(a, b)| graph.identical(*a, *b))
        };
        let heavy = mechanism.masses.iter().filter(|mass| mass.node == at).all(|mass| match &mass.inertia {
            Some(tensor) => {
                let turned = graph.turned_tensor(&rotation, tensor);
                turned.iter().flatten().zip(tensor.iter().flatten()).all(|(a, b)| graph.identical(*a, *b))
            }
            None => true,
        });
        let loads = mechanism.loads.iter().filter(|load| load.node == at);
        let acting = loads.into_iter().all(|load| same(graph, &load.force) && same(graph, &load.torque));
        // About an axis that is fixed in both, the angular velocity has the same components in the parent's axes.
        if heavy
            && acting
            && same(graph, &spin)
            && let Step::Turn { rotation, stopped, .. } = &mut mechanism.nodes[at].step
        {
            (*rotation, *stopped) = (identity, true);
        }
    }
}

/// The masses at each node, about its point.
pub fn own_inertias(graph: &mut Graph, mechanism: &Mechanism) -> Vec<Inertia> {
    let mut own = vec![Inertia::none(graph); mechanism.nodes.len()];
    for mass in &mechanism.masses {
        let centred = Inertia {
            mass: mass.mass,
            moment: graph.no_vector(),
            tensor: mass.inertia.unwrap_or([graph.no_vector(); 3]),
        };
        own[mass.node] = own[mass.node].plus(&centred, graph);
    }
    own
}
