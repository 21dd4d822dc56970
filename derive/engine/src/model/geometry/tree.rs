//! The tree of twists: a node is a point and axes.
//!
//! A node is peeled step by step. Where its point lies along its own axes, its parent is the point from which it is seen, in the
//! same axes; otherwise its parent is the same point in the axes of the frame's base. In the inertial frame there is no angular
//! velocity any more, and the point is taken up in the axes along which it lies.

use super::{Frame, Geometry};
use crate::model::mechanism::{Node, Step};
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::Rotation;
use std::collections::BTreeMap;

/// The nodes so far.
pub(super) struct Tree {
    pub nodes: Vec<Node>,
    known: BTreeMap<(usize, usize), usize>,
}

impl Tree {
    /// The inertial frame at its origin.
    pub fn new(vocabulary: &Vocabulary<'_>) -> Self {
        let still = vocabulary.graph.no_vector();
        let ground = Node { parent: 0, step: Step::Move { offset: still, rate: still } };
        Tree { nodes: vec![ground], known: BTreeMap::from([((0, 0), 0)]) }
    }

    /// The node of a place in the axes of a frame.
    pub fn node(&mut self, place: usize, frame: usize, vocabulary: &mut Vocabulary<'_>) -> usize {
        // Outwards until a node is known, then back.
        let mut way = vec![(place, frame)];
        while let Some(at) = way.last().filter(|at| !self.known.contains_key(at)) {
            way.push(before(*at, &vocabulary.geometry));
        }
        let mut node = way.pop().and_then(|at| self.known.get(&at).copied()).unwrap_or_default();
        while let Some(at) = way.pop() {
            let step = step(at, vocabulary);
            self.nodes.push(Node { parent: node, step });
            node = self.nodes.len() - 1;
            self.known.insert(at, node);
        }
        node
    }
}

/// The parent of a place in the axes of a frame.
fn before((place, frame): (usize, usize), geometry: &Geometry) -> (usize, usize) {
    let seen = &geometry.places[place];
    match () {
        () if place != 0 && seen.frame == frame => (seen.from, frame),
        () if frame != 0 => (place, geometry.frames[frame].base),
        () => (place, seen.frame),
    }
}

fn step((place, frame): (usize, usize), vocabulary: &mut Vocabulary<'_>) -> Step {
    let motion = vocabulary.motion();
    let (geometry, graph) = (&vocabulary.geometry, &mut vocabulary.graph);
    let seen = &geometry.places[place];
    if place != 0 && seen.frame == frame {
        let rate = graph.along(&seen.offset, &motion);
        return Step::Move { offset: seen.offset, rate: [rate[0], rate[1], rate[2]] };
    }
    if frame != 0 {
        let Frame { rotation, spin, .. } = geometry.frames[frame];
        return Step::Turn { rotation, spin, stopped: false };
    }
    let mut rotations: Vec<Rotation> = Vec::new();
    let mut at = seen.frame;
    while at != 0 {
        rotations.push(geometry.frames[at].rotation);
        at = geometry.frames[at].base;
    }
    Step::Carry { rotations }
}
