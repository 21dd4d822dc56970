//! Velocities and accelerations, outwards along the tree.

use crate::model::mechanism::{Mechanism, Step};
use crate::symbolic::{Expr, Graph, Rotation, Symbol, Triple};

/// The motion of a node, in its axes.
#[derive(Clone, Copy, Debug)]
pub struct Twist {
    /// The velocity of its point.
    pub velocity: Triple,
    /// The angular velocity of what is fixed to it.
    pub omega: Triple,
    /// The angular velocity of the axes, which differs for a stopped rotor.
    pub axes: Triple,
    since: Since,
}

/// The acceleration of a node for v̇ = 0, in its axes.
#[derive(Clone, Copy, Debug)]
pub struct Bias {
    /// Of its point, gravity's taken off.
    pub linear: Triple,
    /// The angular acceleration.
    pub angular: Triple,
    since: Since,
}

/// What a linear quantity has more than at the last node outwards with the axes of the inertial frame: going back to these axes,
/// only that is turned.
#[derive(Clone, Copy, Debug)]
pub struct Since {
    /// That node.
    pub node: usize,
    more: Triple,
}

impl Since {
    /// From a node outwards.
    pub fn new(node: usize, more: Triple) -> Self {
        Since { node, more }
    }

    /// In the axes of a node that turns.
    pub fn turned_back(self, graph: &mut Graph, rotation: &Rotation) -> Since {
        Since { more: graph.turned_back(rotation, &self.more), ..self }
    }

    /// With what a step adds.
    pub fn plus(self, graph: &mut Graph, more: &Triple) -> Since {
        Since { more: graph.plus(&self.more, more), ..self }
    }

    /// In the axes of the inertial frame, from what that node has.
    pub fn carried(self, graph: &mut Graph, rotations: &[Rotation], there: &Triple) -> Triple {
        let turned = rotations.iter().fold(self.more, |vector, rotation| graph.turned(rotation, &vector));
        graph.plus(there, &turned)
    }
}

/// The twists of all nodes.
pub fn twists(graph: &mut Graph, mechanism: &Mechanism) -> Vec<Twist> {
    let still = graph.no_vector();
    let mut twists: Vec<Twist> = Vec::with_capacity(mechanism.nodes.len());
    for (at, node) in mechanism.nodes.iter().enumerate() {
        if at == 0 {
            twists.push(Twist { velocity: still, omega: still, axes: still, since: Since { node: 0, more: still } });
            continue;
        }
        let parent = twists[node.parent];
        twists.push(match &node.step {
            Step::Turn { rotation, spin, stopped, .. } => {
                let carried = graph.turned_back(rotation, &parent.omega);
                let omega = graph.plus(&carried, spin);
                let axes = if *stopped { graph.turned_back(rotation, &parent.axes) } else { omega };
                let since = parent.since.turned_back(graph, rotation);
                Twist { velocity: graph.turned_back(rotation, &parent.velocity), omega, axes, since }
            }
            Step::Move { offset, rate } => {
                let carried = graph.cross(&parent.omega, offset);
                let more = graph.plus(&carried, rate);
                let since = parent.since.plus(graph, &more);
                Twist { velocity: graph.plus(&parent.velocity, &more), since, ..parent }
            }
            Step::Carry { rotations } => {
                let there = twists[parent.since.node].velocity;
                let velocity = parent.since.carried(graph, rotations, &there);
                Twist { velocity, omega: still, axes: still, since: Since { node: at, more: still } }
            }
        });
        if mechanism.whole {
            let twist = &mut twists[at];
            (twist.velocity, twist.omega) = (graph.whole_vector(&twist.velocity), graph.whole_vector(&twist.omega));
        }
    }
    twists
}

/// The accelerations of all nodes for v̇ = 0, from those of their parents; `motion` are the rates of (x, t).
pub fn biases(graph: &mut Graph, mechanism: &Mechanism, twists: &[Twist], motion: &[(Symbol, Expr)]) -> Vec<Bias> {
    let still = graph.no_vector();
    let mut biases: Vec<Bias> = Vec::with_capacity(mechanism.nodes.len());
    for (at, node) in mechanism.nodes.iter().enumerate() {
        if at == 0 {
            // What falls freely has no weight: the ground is accelerated upwards.
            let linear = mechanism.gravity.map_or(still, |gravity| graph.minus(&still, &gravity));
            biases.push(Bias { linear, angular: still, since: Since { node: 0, more: still } });
            continue;
        }
        let (parent, twist) = (biases[node.parent], twists[node.parent]);
        biases.push(match &node.step {
            Step::Turn { rotation, spin, .. } => {
                // d/dt (Rᵀ ω + s) = Rᵀ α + Rᵀ ω × s + ṡ
                let (alpha, omega) =
                    (graph.turned_back(rotation, &parent.angular), graph.turned_back(rotation, &twist.omega));
                let turning = graph.cross(&omega, spin);
                let growing = along(graph, spin, motion);
                let sum = graph.plus(&alpha, &turning);
                let since = parent.since.turned_back(graph, rotation);
                let linear = graph.turned_back(rotation, &parent.linear);
                Bias { linear, angular: graph.plus(&sum, &growing), since }
            }
            Step::Move { offset, rate } => {
                // a + α × r + ω × (ω × r + 2 ṙ) + r̈
                let tangential = graph.cross(&parent.angular, offset);
                let two = graph.integer(2);
                let (swept, twice) = (graph.cross(&twist.omega, offset), graph.times(two, rate));
                let inner = graph.plus(&swept, &twice);
                let centripetal = graph.cross(&twist.omega, &inner);
                let growing = along(graph, rate, motion);
                let sum = graph.plus(&tangential, &centripetal);
                let more = graph.plus(&sum, &growing);
                let since = parent.since.plus(graph, &more);
                Bias { linear: graph.plus(&parent.linear, &more), since, ..parent }
            }
            Step::Carry { rotations } => {
                let there = biases[parent.since.node].linear;
                let linear = parent.since.carried(graph, rotations, &there);
                Bias { linear, angular: still, since: Since { node: at, more: still } }
            }
        });
        if mechanism.whole {
            let bias = &mut biases[at];
            (bias.linear, bias.angular) = (graph.whole_vector(&bias.linear), graph.whole_vector(&bias.angular));
        }
    }
    biases
}

/// The weight's acceleration at all nodes, in their axes, with the sign of an acceleration upwards.
pub fn weights(graph: &mut Graph, mechanism: &Mechanism) -> Option<Vec<Triple>> {
    let gravity = mechanism.gravity?;
    let still = graph.no_vector();
    let mut weights: Vec<Triple> = vec![graph.minus(&still, &gravity)];
    for node in mechanism.nodes.iter().skip(1) {
        let parent = weights[node.parent];
        weights.push(match &node.step {
            Step::Turn { rotation, .. } => graph.turned_back(rotation, &parent),
            Step::Move { .. } => parent,
            // In the inertial frame it is the same everywhere.
            Step::Carry { .. } => weights[0],
        });
    }
    Some(weights)
}

/// The rates of components.
pub fn along(graph: &mut Graph, components: &Triple, motion: &[(Symbol, Expr)]) -> Triple {
    let rates = graph.along(components, motion);
    [rates[0], rates[1], rates[2]]
}
