//! Points, each one step away from another along the axes of one frame.

use super::{Geometry, Vector};
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::Triple;

/// A point, seen from another.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::model) struct Place {
    /// The point from which it is seen, before it in the list; the origin is seen from itself.
    pub from: usize,
    /// The frame along whose axes it lies.
    pub frame: usize,
    /// The way, over (x, t).
    pub offset: Triple,
}

impl Geometry {
    /// The place at the end of a vector: a known one where the steps are known.
    fn place(&mut self, vector: &Vector) -> usize {
        vector.parts.iter().fold(vector.from, |from, (frame, offset)| {
            let place = Place { from, frame: *frame, offset: *offset };
            // The origin is seen from itself, by no step.
            match self.places.iter().skip(1).position(|known| *known == place) {
                Some(at) => at + 1,
                None => {
                    self.places.push(place);
                    self.places.len() - 1
                }
            }
        })
    }
}

impl Vocabulary<'_> {
    /// The place at the end of a position. What vanishes identically is no part of the way.
    pub(super) fn place(&mut self, vector: &Vector) -> usize {
        let mut vector = vector.clone();
        for (_, components) in &mut vector.parts {
            for e in components.iter_mut() {
                if self.graph.vanishes(*e) {
                    *e = self.graph.zero();
                }
            }
        }
        vector.parts.retain(|(_, components)| components.iter().any(|e| !self.graph.is_zero(*e)));
        self.geometry.place(&vector)
    }
}
