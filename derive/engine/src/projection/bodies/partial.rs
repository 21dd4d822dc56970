//! Partial velocities: what each speed moves at its own step, and what moves with all of them outwards.

use super::sweep::Since;
use crate::model::mechanism::{Mechanism, Step};
use crate::projection::Equations;
use crate::symbolic::{Expr, Graph, Symbol, Triple};

/// What one speed moves at a step, in the axes of the step's node.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// The speed's position.
    pub speed: usize,
    /// The partial velocity of the point.
    pub linear: Triple,
    /// The partial angular velocity.
    pub angular: Triple,
}

/// The columns of every node's step.
pub fn columns(graph: &mut Graph, mechanism: &Mechanism, speeds: &[Symbol]) -> Vec<Vec<Column>> {
    mechanism.nodes.iter().map(|node| of_step(graph, &node.step, speeds)).collect()
}

/// The other speeds that each speed of a mechanism has on its way inwards.
pub fn ways(equations: &Equations) -> Vec<Vec<usize>> {
    let mut inwards = vec![Vec::new(); equations.speeds.len()];
    let Some(mechanism) = &equations.mechanism else { return inwards };
    let columns = columns(&mut equations.graph.clone(), mechanism, &equations.speeds);
    let mut beyond: Vec<Vec<usize>> = Vec::with_capacity(columns.len());
    for (at, own) in columns.iter().enumerate() {
        let mut way = if at == 0 { Vec::new() } else { beyond[mechanism.nodes[at].parent].clone() };
        for column in own {
            inwards[column.speed].clone_from(&way);
            way.push(column.speed);
        }
        beyond.push(way);
    }
    inwards
}

fn of_step(graph: &mut Graph, step: &Step, speeds: &[Symbol]) -> Vec<Column> {
    let (rate, turns) = match step {
        Step::Turn { spin, .. } => (spin, true),
        Step::Move { rate, .. } => (rate, false),
        Step::Carry { .. } => return Vec::new(),
    };
    let gradient = graph.jacobian(rate, speeds);
    let still = graph.no_vector();
    (0..speeds.len())
        .filter_map(|speed| {
            let column: Triple = std::array::from_fn(|i| gradient.get(i, speed));
            let moves = column.iter().any(|e| !graph.is_zero(*e));
            let (linear, angular) = if turns { (still, column) } else { (column, still) };
            moves.then_some(Column { speed, linear, angular })
        })
        .collect()
}

/// What a node's point and axes do with the speeds alone: J w of them, for velocities and accelerations alike.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// Of the point.
    pub linear: Triple,
    /// Of what is fixed to the node.
    pub angular: Triple,
    since: Since,
}

/// J w outwards. The rate of a column may depend on what the columns inwards of it have moved so far.
pub fn moved(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    mut rate: impl FnMut(&mut Graph, usize, usize, &Moved) -> Expr,
) -> Vec<Moved> {
    let still = graph.no_vector();
    let mut all: Vec<Moved> = Vec::with_capacity(mechanism.nodes.len());
    for (at, node) in mechanism.nodes.iter().enumerate() {
        if at == 0 {
            all.push(Moved { linear: still, angular: still, since: Since::new(0, still) });
            continue;
        }
        let parent = all[node.parent];
        let mut own = match &node.step {
            Step::Turn { rotation, .. } => Moved {
                linear: graph.turned_back(rotation, &parent.linear),
                angular: graph.turned_back(rotation, &parent.angular),
                since: parent.since.turned_back(graph, rotation),
            },
            Step::Move { offset, .. } => {
                let more = graph.cross(&parent.angular, offset);
                let since = parent.since.plus(graph, &more);
                Moved { linear: graph.plus(&parent.linear, &more), since, ..parent }
            }
            Step::Carry { rotations } => {
                let there = all[parent.since.node].linear;
                let linear = parent.since.carried(graph, rotations, &there);
                Moved { linear, angular: still, since: Since::new(at, still) }
            }
        };
        for (place, column) in columns[at].iter().enumerate() {
            let w = rate(graph, at, place, &own);
            let (linear, angular) = (graph.times(w, &column.linear), graph.times(w, &column.angular));
            own.linear = graph.plus(&own.linear, &linear);
            own.angular = graph.plus(&own.angular, &angular);
            own.since = own.since.plus(graph, &linear);
        }
        own.linear = graph.whole_vector(&own.linear);
        own.angular = graph.whole_vector(&own.angular);
        all.push(own);
    }
    all
}
