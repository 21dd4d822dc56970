//! Frames, points and bodies: vectors as components along the axes of frames, and the tree of what moves.
//!
//! | file | idea |
//! |---|---|
//! | `vector` | vectors over several frames, products, rates |
//! | `frames` | frames that turn against others |
//! | `quaternions` | frames by unit quaternions |
//! | `joints` | joints in short |
//! | `places` | points, each a step away from another |
//! | `releases` | what is let go, to tell its reaction |
//! | `calls` | the functions of vectors |
//! | `momentum` | momenta of bodies |
//! | `tree` | nodes that are a point and axes |
//! | `shapes` | inertias of bodies |
//! | `possible` | inertias that no body has |
//! | `bodies` | bodies, loads and springs at these nodes |
//! | `order` | defines, frames, points and bodies in the order of their dependence |
//! | `equations` | vector equations as rows |

mod bodies;
mod calls;
pub(super) mod equations;
mod frames;
pub(super) mod joints;
mod momentum;
pub(super) mod order;
mod places;
mod possible;
mod quaternions;
mod releases;
mod shapes;
mod tree;
mod vector;

pub(super) use bodies::mechanism;
pub(super) use calls::{VECTOR_FUNCTIONS, VectorCall, names_a_body};
pub(super) use frames::Frame;
pub(super) use places::Place;
pub(super) use quaternions::Turning;
pub(super) use releases::Released;
pub(super) use vector::Vector;

use super::names::Mentions;

/// The geometry as far as it is lowered.
pub(super) struct Geometry {
    /// The frames, bases first; the first is the inertial frame.
    pub frames: Vec<Frame>,
    /// The places, each after the one from which it is seen; the first is the origin.
    pub places: Vec<Place>,
    /// The frames of the model's names; `None` before one is lowered, and where that failed.
    pub named_frames: Vec<Option<usize>>,
    /// The same for points, with what they mention.
    pub named_points: Vec<Option<(usize, Mentions)>>,
    /// The same for bodies and particles: frame and centre.
    pub named_bodies: Vec<Option<Rigid>>,
}

/// A body as a frame and a point in it.
#[derive(Clone, Copy)]
pub(super) struct Rigid {
    pub frame: usize,
    pub center: usize,
    pub mentions: Mentions,
}
