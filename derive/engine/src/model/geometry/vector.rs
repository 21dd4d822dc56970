//! Vectors: components along the axes of several frames, as they were written.
//!
//! `l*A.x + r*B.y` keeps both parts apart. They meet only in products, in the axes of one of the frames, reached from the
//! others by one rotation after another.

use super::Geometry;
use super::frames::Frame;
use crate::symbolic::{Expr, Graph, Rational, Rotation, Symbol, Triple};

/// A vector; a point stands for its position from the origin.
#[derive(Clone, Debug, Default)]
pub(in crate::model) struct Vector {
    /// The place from which the parts lead; 0 for the origin, and for vectors that are no positions.
    pub from: usize,
    /// Components along the axes of frames, in the order of the frames, none twice.
    pub parts: Vec<(usize, Triple)>,
}

impl Vector {
    /// One part.
    pub fn along(frame: usize, components: Triple) -> Self {
        Vector { from: 0, parts: vec![(frame, components)] }
    }

    fn of_parts(graph: &mut Graph, parts: impl IntoIterator<Item = (usize, Triple)>) -> Self {
        let mut found: Vec<(usize, Triple)> = Vec::new();
        for (frame, components) in parts {
            match found.iter_mut().find(|(other, _)| *other == frame) {
                Some((_, sum)) => *sum = graph.plus(sum, &components),
                None => found.push((frame, components)),
            }
        }
        found.retain(|(_, components)| components.iter().any(|e| !graph.is_zero(*e)));
        found.sort_by_key(|(frame, _)| *frame);
        Vector { from: 0, parts: found }
    }

    pub fn plus(&self, other: &Vector, graph: &mut Graph, geometry: &Geometry) -> Vector {
        // One of two positions stays a step from a known place.
        let (first, second) = if self.from == 0 { (other, self) } else { (self, other) };
        let second = second.flattened(graph, geometry);
        let sum = Vector::of_parts(graph, first.parts.iter().chain(&second.parts).copied().collect::<Vec<_>>());
        Vector { from: first.from, ..sum }
    }

    pub fn times(&self, scalar: Expr, graph: &mut Graph, geometry: &Geometry) -> Vector {
        let free = self.flattened(graph, geometry);
        let parts: Vec<(usize, Triple)> =
            free.parts.iter().map(|(frame, components)| (*frame, graph.times(scalar, components))).collect();
        Vector::of_parts(graph, parts)
    }

    pub fn negative(&self, graph: &mut Graph, geometry: &Geometry) -> Vector {
        let minus = graph.integer(-1);
        self.times(minus, graph, geometry)
    }

    /// The same with all parts from the origin.
    pub fn flattened(&self, graph: &mut Graph, geometry: &Geometry) -> Vector {
        if self.from == 0 {
            return self.clone();
        }
        let mut parts = self.parts.clone();
        let mut place = self.from;
        while place != 0 {
            let step = &geometry.places[place];
            parts.push((step.frame, step.offset));
            place = step.from;
        }
        Vector::of_parts(graph, parts)
    }

    /// Components in the axes of one frame.
    pub fn expressed(&self, frame: usize, graph: &mut Graph, geometry: &Geometry) -> Triple {
        let free = self.flattened(graph, geometry);
        let frames = &geometry.frames;
        let mut at: Vec<Option<Triple>> = vec![None; frames.len()];
        for (of, components) in &free.parts {
            at[*of] = Some(*components);
        }
        let add = |graph: &mut Graph, slot: &mut Option<Triple>, moved: Triple| {
            *slot = Some(slot.map_or(moved, |sum| graph.plus(&sum, &moved)));
        };
        let path = path(frames, frame);
        // Towards the inertial frame until the way to `frame` is met, then along that way.
        for of in (1..frames.len()).rev().filter(|of| !path.contains(of)) {
            if let Some(components) = at[of].take() {
                let (base, rotation) = inwards(frames, of, &path, graph);
                let moved = graph.turned(&rotation, &components);
                add(graph, &mut at[base], moved);
            }
        }
        for of in path.into_iter().filter(|of| *of != 0) {
            if let Some(components) = at[frames[of].base].take() {
                let moved = graph.turned_back(&frames[of].rotation, &components);
                add(graph, &mut at[of], moved);
            }
        }
        at[frame].unwrap_or_else(|| graph.no_vector())
    }

    pub fn dot(&self, other: &Vector, graph: &mut Graph, geometry: &Geometry) -> Expr {
        let (a, b) = (self.flattened(graph, geometry), other.flattened(graph, geometry));
        if a.parts == b.parts {
            return a.square(graph, geometry);
        }
        let (few, many) = if a.parts.len() <= b.parts.len() { (&a, &b) } else { (&b, &a) };
        let terms: Vec<Expr> = few
            .parts
            .iter()
            .map(|(frame, components)| {
                let there = many.expressed(*frame, graph, geometry);
                graph.dot(components, &there)
            })
            .collect();
        graph.sum(&terms)
    }

    /// a · a for parts from the origin, by the law of cosines: each pair of parts meets once, and counts twice.
    fn square(&self, graph: &mut Graph, geometry: &Geometry) -> Expr {
        let mut terms = Vec::new();
        for (at, (frame, components)) in self.parts.iter().enumerate() {
            terms.push(graph.dot(components, components));
            let others = Vector { from: 0, parts: self.parts[at + 1..].to_vec() };
            let there = others.expressed(*frame, graph, geometry);
            let product = graph.dot(components, &there);
            terms.push(graph.scale(Rational::integer(2), product));
        }
        graph.sum(&terms)
    }

    pub fn cross(&self, other: &Vector, graph: &mut Graph, geometry: &Geometry) -> Vector {
        let (a, b) = (self.flattened(graph, geometry), other.flattened(graph, geometry));
        let parts: Vec<(usize, Triple)> = a
            .parts
            .iter()
            .map(|(frame, components)| {
                let there = b.expressed(*frame, graph, geometry);
                (*frame, graph.cross(components, &there))
            })
            .collect();
        Vector::of_parts(graph, parts)
    }

    /// |a|.
    pub fn norm(&self, graph: &mut Graph, geometry: &Geometry) -> Expr {
        let square = self.dot(self, graph, geometry);
        graph.sqrt(square)
    }

    /// The rate in the inertial frame: that of the components, and ω × for each frame. `motion` gives the rates of symbols.
    pub fn rate(&self, motion: &[(Symbol, Expr)], graph: &mut Graph, geometry: &Geometry) -> Vector {
        let free = self.flattened(graph, geometry);
        let parts: Vec<(usize, Triple)> = free
            .parts
            .iter()
            .map(|(frame, components)| {
                let own = graph.along(components, motion);
                let carried = graph.cross(&geometry.frames[*frame].omega, components);
                (*frame, graph.plus(&[own[0], own[1], own[2]], &carried))
            })
            .collect();
        Vector::of_parts(graph, parts)
    }
}

/// The next frame towards the inertial one, and the rotation to its axes: over all frames that turn about one axis at once, their
/// angles added, so that what meets in it has functions of sums and not sums of products.
fn inwards(frames: &[Frame], of: usize, path: &[usize], graph: &mut Graph) -> (usize, Rotation) {
    let Frame { mut base, rotation, turn, .. } = frames[of];
    let Some((axis, mut angle)) = turn else { return (base, rotation) };
    let mut several = false;
    while !path.contains(&base)
        && let Some((same, more)) = frames[base].turn
        && same == axis
    {
        (base, angle, several) = (frames[base].base, graph.add(angle, more), true);
    }
    (base, if several { graph.rotation(&axis, angle) } else { rotation })
}

/// The frames from the inertial one to this one.
pub(super) fn path(frames: &[Frame], frame: usize) -> Vec<usize> {
    let mut path = vec![frame];
    let mut at = frame;
    while at != 0 {
        at = frames[at].base;
        path.push(at);
    }
    path.reverse();
    path
}
