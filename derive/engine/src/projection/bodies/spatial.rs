//! Inertias about points.

use crate::model::mechanism::Step;
use crate::symbolic::{Expr, Graph, Rational, Rotation, Triple};

/// The inertia of what is rigid together, about a point and in axes of its own.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// m.
    pub mass: Expr,
    /// m c, c from the point to the centre of mass.
    pub moment: Triple,
    /// The tensor about the point.
    pub tensor: Rotation,
}

/// A force and a torque about a node's point, in its axes.
#[derive(Clone, Debug)]
pub struct Wrench {
    /// What acts here, and beyond on the way out.
    pub force: Triple,
    /// The torque.
    pub torque: Triple,
    /// A force that points beyond took up in the axes of the inertial frame, in all axes from those to the node's: on its way back
    /// it need not be turned.
    passed: Vec<Triple>,
}

impl Wrench {
    /// A force and a torque.
    pub fn new(force: Triple, torque: Triple) -> Self {
        Wrench { force, torque, passed: Vec::new() }
    }

    /// Both together.
    pub fn plus(&self, other: &Wrench, graph: &mut Graph) -> Wrench {
        let (longer, shorter) = match self.passed.len() >= other.passed.len() {
            true => (self, other),
            false => (other, self),
        };
        let mut passed = longer.passed.clone();
        for (sum, more) in passed.iter_mut().zip(&shorter.passed) {
            *sum = graph.plus(sum, more);
        }
        Wrench { force: graph.plus(&self.force, &other.force), torque: graph.plus(&self.torque, &other.torque), passed }
    }

    /// This without the other one, which is no further inwards.
    pub fn less(&self, other: &Wrench, graph: &mut Graph) -> Wrench {
        let (force, torque) = (graph.minus(&self.force, &other.force), graph.minus(&self.torque, &other.torque));
        Wrench { force, torque, passed: self.passed.clone() }
    }

    /// Its components whole.
    pub fn whole(self, graph: &mut Graph) -> Wrench {
        let passed = self.passed.iter().map(|vector| graph.whole_vector(vector)).collect();
        Wrench { force: graph.whole_vector(&self.force), torque: graph.whole_vector(&self.torque), passed }
    }

    /// All of the force.
    fn total(&self, graph: &mut Graph) -> Triple {
        match self.passed.last() {
            Some(passed) => graph.plus(&self.force, passed),
            None => self.force,
        }
    }

    /// Its power in a linear and an angular velocity.
    pub fn felt(&self, linear: &Triple, angular: &Triple, graph: &mut Graph) -> Expr {
        let force = self.total(graph);
        let (a, b) = (graph.dot(linear, &force), graph.dot(angular, &self.torque));
        graph.add(a, b)
    }

    /// As the parent of a node sees it.
    pub fn inwards(&self, step: &Step, graph: &mut Graph) -> Wrench {
        match step {
            Step::Turn { rotation, .. } => {
                let mut force = graph.turned(rotation, &self.force);
                let mut passed = self.passed.clone();
                passed.pop();
                if let [last] = passed.as_slice() {
                    force = graph.plus(&force, last);
                    passed.clear();
                }
                Wrench { force, torque: graph.turned(rotation, &self.torque), passed }
            }
            Step::Move { offset, .. } => {
                let force = self.total(graph);
                let lever = graph.cross(offset, &force);
                Wrench { torque: graph.plus(&self.torque, &lever), ..self.clone() }
            }
            Step::Carry { rotations } => {
                let mut force = self.total(graph);
                let mut passed = vec![force];
                for rotation in rotations.iter().rev() {
                    force = graph.turned_back(rotation, &force);
                    passed.push(force);
                }
                Wrench { force: graph.no_vector(), torque: graph.no_vector(), passed }
            }
        }
    }
}

impl Inertia {
    /// Nothing.
    pub fn none(graph: &Graph) -> Self {
        Inertia { mass: graph.zero(), moment: graph.no_vector(), tensor: [graph.no_vector(); 3] }
    }

    /// Whether there is nothing.
    pub fn is_none(&self, graph: &Graph) -> bool {
        let entries = self.tensor.iter().flatten().chain(&self.moment).chain([&self.mass]);
        entries.into_iter().all(|e| graph.is_zero(*e))
    }

    /// Both together.
    pub fn plus(&self, other: &Inertia, graph: &mut Graph) -> Inertia {
        Inertia {
            mass: graph.add(self.mass, other.mass),
            moment: graph.plus(&self.moment, &other.moment),
            tensor: std::array::from_fn(|i| graph.plus(&self.tensor[i], &other.tensor[i])),
        }
    }

    /// The force and the torque about the point that a linear and an angular acceleration need.
    pub fn of(&self, linear: &Triple, angular: &Triple, graph: &mut Graph) -> (Triple, Triple) {
        // F = m a + α × m c, T = m c × a + I α.
        let (push, carried) = (graph.times(self.mass, linear), graph.cross(angular, &self.moment));
        let (lever, own) = (graph.cross(&self.moment, linear), graph.turned(&self.tensor, angular));
        (graph.plus(&push, &carried), graph.plus(&lever, &own))
    }

    /// As the parent of a node sees it.
    pub fn inwards(&self, step: &Step, graph: &mut Graph) -> Inertia {
        match step {
            Step::Turn { rotation, .. } => Inertia {
                mass: self.mass,
                moment: graph.turned(rotation, &self.moment),
                tensor: graph.turned_tensor(rotation, &self.tensor),
            },
            Step::Move { offset: r, .. } => {
                // I + (2 r·h + m r²) 1 - (r hᵀ + h rᵀ + m r rᵀ), h = m c.
                let heavy = graph.times(self.mass, r);
                let two = graph.integer(2);
                let twice = graph.times(two, &self.moment);
                let both = graph.plus(&twice, &heavy);
                let square = graph.dot(r, &both);
                let tensor = std::array::from_fn(|i| {
                    std::array::from_fn(|j| {
                        let terms = [(r[i], self.moment[j]), (self.moment[i], r[j]), (heavy[i], r[j])];
                        let products = terms.map(|(a, b)| graph.mul(a, b));
                        let outer = graph.sum(&products);
                        let moved = if i == j { graph.sub(square, outer) } else { graph.neg(outer) };
                        graph.add(self.tensor[i][j], moved)
                    })
                });
                Inertia { mass: self.mass, moment: graph.plus(&self.moment, &heavy), tensor }
            }
            // Nothing turns there.
            Step::Carry { .. } => Inertia { mass: self.mass, ..Inertia::none(graph) },
        }
    }

    /// (m v² + 2 v·(ω × m c) + ω·I ω)/2
    pub fn energy(&self, velocity: &Triple, omega: &Triple, graph: &mut Graph) -> Expr {
        let (force, torque) = self.of(velocity, omega, graph);
        let (linear, angular) = (graph.dot(velocity, &force), graph.dot(omega, &torque));
        let twice = graph.add(linear, angular);
        graph.scale(Rational::Small(1, 2), twice)
    }
}
