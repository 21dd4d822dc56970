//! Articulated inertias: the accelerations of a tree in O(n), joint by joint from the leaves.
//!
//! What hangs on a joint answers to an acceleration of the joint's inner side as one body whose inertia is smaller by what the
//! joint gives way: with the partial velocities S of the joint, U = I S, D = Sᵀ U, the force f that acts beyond it and the force τ
//! along its speed, s = Sᵀ f + τ,
//!
//! ```text
//!     I ← I − U D⁻¹ Uᵀ,      f ← f − U D⁻¹ s,      v̇ = D⁻¹ (s − Uᵀ a)
//! ```
//!
//! with the acceleration a of the inner side, found outwards (Featherstone, Rigid Body Dynamics Algorithms, chapter 7). It is the
//! paper's chain of projections (4.10), one joint a stage: D are the pivots of M, eliminated from the leaves inwards. The way
//! inwards is s = W h for forces h along the speeds, the way outwards v̇ = Wᵀ D⁻¹ s: M⁻¹ = Wᵀ D⁻¹ W.

use super::partial::{Column, moved};
use super::spatial::{Inertia, Wrench};
use crate::model::mechanism::{Mechanism, Step};
use crate::symbolic::{Expr, Graph, Matrix, Rotation, Triple};

/// The joints of a tree, eliminated.
pub struct Joints {
    /// What each speed moves at its step.
    columns: Vec<Vec<Column>>,
    /// The joint of each speed; `None` where it moves nothing, as the rate of a norm.
    joints: Vec<Option<Joint>>,
    /// The position of each speed with its pivot D, from the leaves inwards.
    pub pivots: Vec<(usize, Expr)>,
}

/// A joint of one speed, eliminated.
#[derive(Clone, Copy)]
struct Joint {
    /// U.
    force: Triple,
    torque: Triple,
    /// 1/D.
    reciprocal: Expr,
}

impl Joints {
    /// The joints of bodies and of further inertias along the speeds; `None` where some speed is not of one joint alone, or moves
    /// nothing. Those that are `idle` move nothing, and need not.
    pub fn eliminated(
        graph: &mut Graph,
        mechanism: &Mechanism,
        columns: Vec<Vec<Column>>,
        own: &[Inertia],
        further: &Matrix,
        idle: &[bool],
    ) -> Option<Joints> {
        let n = idle.len();
        let mut joints_of = vec![0; n];
        for column in columns.iter().flatten().filter(|column| column.speed < n) {
            joints_of[column.speed] += 1;
        }
        let coupled = (0..n).any(|i| (0..i).any(|j| !graph.is_zero(further.get(i, j))));
        if coupled || joints_of.iter().zip(idle).any(|(joints, idle)| *joints != usize::from(!idle)) {
            return None;
        }
        let mut inertias: Vec<Articulated> = own.iter().map(|inertia| Articulated::of_body(graph, inertia)).collect();
        let mut joints = vec![None; n];
        let mut pivots = Vec::with_capacity(n);
        for at in (1..mechanism.nodes.len()).rev() {
            for column in columns[at].iter().rev().filter(|column| column.speed < n) {
                let (force, torque) = inertias[at].of(&column.linear, &column.angular, graph);
                let terms = [
                    graph.dot(&column.linear, &force),
                    graph.dot(&column.angular, &torque),
                    further.get(column.speed, column.speed),
                ];
                let pivot = graph.sum(&terms);
                if graph.vanishes(pivot) {
                    return None;
                }
                graph.assume_nonzero(pivot);
                pivots.push((column.speed, pivot));
                let reciprocal = graph.powi(pivot, -1);
                inertias[at].give_way(&force, &torque, reciprocal, graph);
                joints[column.speed] = Some(Joint { force, torque, reciprocal });
            }
            let node = &mechanism.nodes[at];
            let inertia = inertias[at].inwards(&node.step, graph);
            inertias[node.parent] = inertias[node.parent].plus(&inertia, graph);
        }
        Some(Joints { columns, joints, pivots })
    }

    /// s = W h of wrenches at the nodes and forces along the speeds, inwards.
    pub fn acting(
        &self,
        graph: &mut Graph,
        mechanism: &Mechanism,
        mut wrenches: Vec<Wrench>,
        forces: &[Expr],
    ) -> Vec<Expr> {
        let mut found = vec![graph.zero(); self.joints.len()];
        for at in (1..mechanism.nodes.len()).rev() {
            for column in self.columns[at].iter().rev() {
                let Some(Joint { force, torque, reciprocal }) = self.joint(column) else { continue };
                let felt = wrenches[at].felt(&column.linear, &column.angular, graph);
                let acting = graph.add(felt, forces[column.speed]);
                let acting = graph.whole(acting);
                let share = graph.mul(acting, reciprocal);
                let taken = graph.neg(share);
                let taken = Wrench::new(graph.times(taken, &force), graph.times(taken, &torque));
                wrenches[at] = wrenches[at].plus(&taken, graph);
                found[column.speed] = acting;
            }
            let node = &mechanism.nodes[at];
            let wrench = wrenches[at].inwards(&node.step, graph);
            wrenches[node.parent] = wrenches[node.parent].plus(&wrench, graph).whole(graph);
        }
        found
    }

    /// v̇ = Wᵀ D⁻¹ s, outwards.
    pub fn rates(&self, graph: &mut Graph, mechanism: &Mechanism, acting: &[Expr]) -> Vec<Expr> {
        let mut rates = vec![graph.zero(); self.joints.len()];
        moved(graph, mechanism, &self.columns, |graph, at, place, inner| {
            let column = &self.columns[at][place];
            let Some(Joint { force, torque, reciprocal }) = self.joint(column) else { return graph.zero() };
            let (linear, angular) = (graph.dot(&force, &inner.linear), graph.dot(&torque, &inner.angular));
            let carried = graph.add(linear, angular);
            let left = graph.sub(acting[column.speed], carried);
            let rate = graph.mul(left, reciprocal);
            rates[column.speed] = rate;
            rate
        });
        rates
    }

    /// aᵀ D⁻¹ b.
    pub fn product(&self, graph: &mut Graph, a: &[Expr], b: &[Expr]) -> Expr {
        let both = self.joints.iter().zip(a.iter().zip(b));
        let terms: Vec<Expr> =
            both.filter_map(|(joint, (a, b))| joint.map(|joint| graph.product(&[*a, *b, joint.reciprocal]))).collect();
        graph.sum(&terms)
    }

    /// The joint that a column belongs to; what is released has none.
    fn joint(&self, column: &Column) -> Option<Joint> {
        self.joints.get(column.speed).copied().flatten()
    }
}

/// The inertia of what hangs on a node, about its point and in its axes: F = (m + A) a + B α, T = Bᵀ a + C α.
#[derive(Clone, Copy, Debug)]
struct Articulated {
    /// m, which is the same in all axes.
    mass: Expr,
    /// A.
    linear: Rotation,
    /// B.
    coupling: Rotation,
    /// C.
    angular: Rotation,
}

impl Articulated {
    /// With A = 0 and B = -[m c]×.
    fn of_body(graph: &mut Graph, body: &Inertia) -> Self {
        let none = graph.no_vector();
        let coupling = std::array::from_fn(|j| graph.cross(&graph.axis(j), &body.moment));
        Articulated { mass: body.mass, linear: [none; 3], coupling: transposed(&coupling), angular: body.tensor }
    }

    /// The force and the torque that an acceleration needs.
    fn of(&self, linear: &Triple, angular: &Triple, graph: &mut Graph) -> (Triple, Triple) {
        let (push, own) = (graph.times(self.mass, linear), graph.turned(&self.linear, linear));
        let carried = graph.turned(&self.coupling, angular);
        let (lever, spun) = (graph.turned_back(&self.coupling, linear), graph.turned(&self.angular, angular));
        let force = graph.plus(&push, &own);
        (graph.plus(&force, &carried), graph.plus(&lever, &spun))
    }

    /// Less what a joint gives way: U D⁻¹ Uᵀ with U = (force, torque).
    fn give_way(&mut self, force: &Triple, torque: &Triple, reciprocal: Expr, graph: &mut Graph) {
        let mut less = |tensor: &mut Rotation, a: &Triple, b: &Triple| {
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let product = graph.product(&[a[i], b[j], reciprocal]);
                tensor[i][j] = graph.sub(tensor[i][j], product);
            }
        };
        less(&mut self.linear, force, force);
        less(&mut self.coupling, force, torque);
        less(&mut self.angular, torque, torque);
    }

    fn plus(&self, other: &Articulated, graph: &mut Graph) -> Articulated {
        let mut both = |a: &Rotation, b: &Rotation| std::array::from_fn(|i| graph.plus(&a[i], &b[i]));
        let linear = both(&self.linear, &other.linear);
        let coupling = both(&self.coupling, &other.coupling);
        let angular = both(&self.angular, &other.angular);
        let mass = graph.add(self.mass, other.mass);
        Articulated { mass, linear, coupling, angular }.whole(graph)
    }

    /// As the parent of a node sees it.
    fn inwards(&self, step: &Step, graph: &mut Graph) -> Articulated {
        match step {
            Step::Turn { rotation, .. } => self.turned(rotation, graph),
            Step::Move { offset, .. } => self.moved(offset, graph),
            Step::Carry { rotations } => {
                let none = [graph.no_vector(); 3];
                let carried = Articulated { coupling: none, angular: none, ..*self };
                // The rotations lead outwards.
                rotations.iter().rev().fold(carried, |inertia, rotation| inertia.turned(&transposed(rotation), graph))
            }
        }
    }

    /// In other axes: R · Rᵀ of all parts. What is a multiple of one stays as it is.
    fn turned(&self, rotation: &Rotation, graph: &mut Graph) -> Articulated {
        let coupling = graph.turned_both(rotation, &self.coupling);
        let (linear, more) = symmetric(rotation, &self.linear, graph);
        let (mut angular, rest) = symmetric(rotation, &self.angular, graph);
        for (i, row) in angular.iter_mut().enumerate() {
            row[i] = graph.add(row[i], rest);
        }
        Articulated { mass: graph.add(self.mass, more), linear, coupling, angular }
    }

    /// About a point further inwards, from where it answers to α with the acceleration α × r here: B − (m + A) [r]×, and what the
    /// force adds to the torque by its lever.
    fn moved(&self, r: &Triple, graph: &mut Graph) -> Articulated {
        // Column by column: what a unit angular acceleration of the inner point needs.
        let units: [Triple; 3] = std::array::from_fn(|j| graph.axis(j));
        let answers = units.map(|unit| {
            let carried = graph.cross(&unit, r);
            self.of(&carried, &unit, graph)
        });
        let coupling = transposed(&answers.map(|(force, _)| force));
        let mut angular = transposed(&answers.map(|(force, torque)| {
            let lever = graph.cross(r, &force);
            graph.plus(&torque, &lever)
        }));
        // It is symmetric, whatever forms its entries came in.
        for (i, j) in [(1, 0), (2, 0), (2, 1)] {
            angular[j][i] = angular[i][j];
        }
        Articulated { coupling, angular, ..*self }
    }

    fn whole(self, graph: &mut Graph) -> Articulated {
        let mut whole = |tensor: &Rotation| tensor.map(|row| graph.whole_vector(&row));
        let (linear, coupling, angular) = (whole(&self.linear), whole(&self.coupling), whole(&self.angular));
        Articulated { linear, coupling, angular, ..self }
    }
}

/// R S Rᵀ of a symmetric tensor, and what multiple of one is to be added to it.
fn symmetric(rotation: &Rotation, tensor: &Rotation, graph: &mut Graph) -> (Rotation, Expr) {
    if let Some(turned) = graph.turned_about_axis(rotation, tensor) {
        return (turned, graph.zero());
    }
    let shift = tensor[2][2];
    let mut rest = *tensor;
    for (i, row) in rest.iter_mut().enumerate() {
        row[i] = graph.sub(row[i], shift);
    }
    (graph.turned_tensor(rotation, &rest), shift)
}

fn transposed(tensor: &Rotation) -> Rotation {
    std::array::from_fn(|i| std::array::from_fn(|j| tensor[j][i]))
}
