//! A mechanism of bodies: what the geometry of a model comes to.
//!
//! Bodies, and points at which something acts, are nodes of a tree of twists: each node has a point and axes, and moves
//! against its parent by one step, so that velocities are found outwards and forces are collected inwards, node by node in
//! axes of their own. Nothing is ever written out in the axes of the inertial frame.

use crate::symbolic::{Expr, Matrix, Rotation, Symbol, Triple};

/// A tree of twists, with what is heavy and what acts.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// The nodes, parents first; the first is the inertial frame at its origin.
    pub nodes: Vec<Node>,
    /// What is heavy.
    pub masses: Vec<Mass>,
    /// What acts at nodes.
    pub loads: Vec<Load>,
    /// The acceleration of gravity in the axes of the inertial frame.
    pub gravity: Option<Triple>,
    /// Scalars of the configuration with springs, dampers or inertia of their own.
    pub lines: Vec<Line>,
    /// Further generalised forces, one for each v.
    pub generalized: Vec<Expr>,
    /// What is let go along coordinates that stay zero, to tell the reactions of what holds it.
    pub releases: Vec<Release>,
    /// What acts along the speeds and is no body's; `None` until the projection has found it.
    pub along: Option<Along>,
    /// Whether what passes from node to node is not written out again at every node: then it cannot be simplified further.
    pub whole: bool,
}

/// Inertias and forces along the speeds, those of what is released behind the others.
#[derive(Clone, Debug)]
pub struct Along {
    /// What they add to M.
    pub inertia: Matrix,
    /// What they add to h*.
    pub forces: Vec<Expr>,
    /// The rates of (x, t) of the model, norms of quaternions held.
    pub motion: Vec<(Symbol, Expr)>,
}

/// A coordinate that stays zero.
#[derive(Clone, Debug)]
pub struct Release {
    /// The name of its reaction.
    pub name: String,
    /// ε.
    pub coordinate: Symbol,
    /// ε̇.
    pub rate: Symbol,
}

/// A point and axes, which move against those of the parent.
#[derive(Clone, Debug)]
pub struct Node {
    /// The node's parent, before it in the list; the first node's is itself.
    pub parent: usize,
    /// How it moves.
    pub step: Step,
}

/// What lies between a node and its parent.
#[derive(Clone, Debug)]
pub enum Step {
    /// The same point, other axes.
    Turn {
        /// From components in the node's axes to those in the parent's.
        rotation: Rotation,
        /// The angular velocity against the parent, over (v, x, t), in the node's axes.
        spin: Triple,
        /// Whether the axes stay those of the parent though what is fixed to the node turns: its inertia is the same all the
        /// while.
        stopped: bool,
    },
    /// The same axes, another point.
    Move {
        /// From the parent's point to the node's, over (x, t).
        offset: Triple,
        /// The rate of these components, over (v, x, t).
        rate: Triple,
    },
    /// The same point in the axes of the inertial frame, though other axes carry it: no angular velocity passes.
    Carry {
        /// From the parent's axes to the inertial frame, one after another.
        rotations: Vec<Rotation>,
    },
}

/// A rigid body or a particle.
#[derive(Clone, Debug)]
pub struct Mass {
    /// The node of its centre of mass; its axes are those of the body.
    pub node: usize,
    /// Its mass.
    pub mass: Expr,
    /// Its inertia about the centre of mass; `None` for a particle.
    pub inertia: Option<Rotation>,
}

/// A force at a node's point and a torque on its axes, in these axes.
#[derive(Clone, Debug)]
pub struct Load {
    /// The node.
    pub node: usize,
    /// The force, over (v, x, t) and inputs.
    pub force: Triple,
    /// The torque.
    pub torque: Triple,
}

/// A scalar s(x, t) with what goes with it.
#[derive(Clone, Debug)]
pub struct Line {
    /// s.
    pub length: Expr,
    /// ds/dt over (v, x, t).
    pub rate: Expr,
    /// What it is.
    pub kind: LineKind,
}

/// What goes with a scalar.
#[derive(Clone, Debug)]
pub enum LineKind {
    /// V = k (s - s0)²/2.
    Spring {
        /// k.
        stiffness: Expr,
        /// s0.
        rest: Expr,
    },
    /// The force -c ds/dt along s.
    Damper {
        /// c.
        coefficient: Expr,
    },
    /// T = j (ds/dt)²/2.
    Armature {
        /// j.
        inertia: Expr,
    },
}

impl Mechanism {
    /// Every expression that may mention coordinates or rates, to be reexpressions in place.
    pub fn expressions(&mut self) -> Vec<&mut Expr> {
        let mut expressions: Vec<&mut Expr> = Vec::new();
        for node in &mut self.nodes {
            match &mut node.step {
                Step::Turn { rotation, spin, .. } => expressions.extend(rotation.iter_mut().flatten().chain(spin)),
                Step::Move { offset, rate } => expressions.extend(offset.iter_mut().chain(rate)),
                Step::Carry { rotations } => expressions.extend(rotations.iter_mut().flatten().flatten()),
            }
        }
        for load in &mut self.loads {
            expressions.extend(load.force.iter_mut().chain(&mut load.torque));
        }
        for line in &mut self.lines {
            expressions.extend([&mut line.length, &mut line.rate]);
        }
        expressions.extend(self.gravity.iter_mut().flatten());
        expressions.extend(&mut self.generalized);
        expressions
    }
}
