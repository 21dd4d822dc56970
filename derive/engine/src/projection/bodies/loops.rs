//! Loops closed on top of a tree: λ of all rows and v̇ of all joints, M⁻¹ applied joint by joint.
//!
//! M v̇ = h* + Cᵀ λ and C v̇ + c0* = 0 (2.4), (2.8) with M⁻¹ = Wᵀ D⁻¹ W of the tree ([`articulated`](super::articulated)) are
//!
//! ```text
//!     s_h = W h*,   s_i = W c_i,      Λ_ij = s_iᵀ D⁻¹ s_j,   Λ λ = −(c0* + s_iᵀ D⁻¹ s_h),      v̇ = Wᵀ D⁻¹ (s_h + Σ s_i λ_i)
//! ```
//!
//! for the independent rows c_i of C: Λ = C M⁻¹ Cᵀ is M_c of (3.6) in the space of the tree's speeds (Featherstone, Rigid Body Dynamics
//! Algorithms, chapter 8). s_i is zero but on the ways from the row's joints to the ground, and Λ_ij where the ways of two rows have
//! no joint in common. That is one way inwards for each row, and one way outwards for all of them.

use super::articulated::Joints;
use super::spatial::Wrench;
use crate::model::Swept;
use crate::model::mechanism::Mechanism;
use crate::projection::AsIs;
use crate::projection::constraints::DifferentiatedRow;
use crate::projection::factorisation::factorise;
use crate::symbolic::{Expr, Graph, Matrix};

/// A tree whose joints are eliminated.
pub struct Tree {
    /// The joints.
    pub joints: Joints,
    /// s_h of all that acts, for v̇ = 0.
    pub acting: Vec<Expr>,
}

impl Tree {
    /// The motion with these rows, which are independent; `None` where no force along the speeds could hold them.
    pub fn closed(self, graph: &mut Graph, mechanism: &Mechanism, rows: &[&DifferentiatedRow]) -> Option<Swept> {
        let Tree { joints, acting } = self;
        // What holds the norm of a quaternion is no force.
        let held: Vec<usize> = (0..rows.len()).filter(|i| rows[*i].reaction).collect();
        let mut felt: Vec<Vec<Expr>> = Vec::with_capacity(held.len());
        for i in &held {
            let still = Wrench::new(graph.no_vector(), graph.no_vector());
            let forces: Vec<Expr> = rows[*i].gradient.iter().map(|entry| graph.whole(*entry)).collect();
            felt.push(joints.acting(graph, mechanism, vec![still; mechanism.nodes.len()], &forces));
        }
        let m = held.len();
        let mut metric = Matrix::zeros(graph, m, m);
        let mut right = Vec::with_capacity(m);
        for i in 0..m {
            for j in 0..=i {
                let entry = joints.product(graph, &felt[i], &felt[j]);
                let entry = graph.whole(entry);
                metric.set(i, j, entry);
                metric.set(j, i, entry);
            }
            let free = joints.product(graph, &felt[i], &acting);
            let sum = graph.add(rows[held[i]].bias, free);
            let negative = graph.neg(sum);
            right.push(graph.whole(negative));
        }
        let factors = factorise(graph, &mut AsIs, &metric).ok()?;
        let found = factors.solve(graph, &mut AsIs, &right);
        let found: Vec<Expr> = found.into_iter().map(|lambda| graph.whole(lambda)).collect();
        let acting: Vec<Expr> = (0..acting.len())
            .map(|speed| {
                let mut terms = vec![acting[speed]];
                terms.extend(felt.iter().zip(&found).map(|(felt, lambda)| graph.mul(felt[speed], *lambda)));
                let sum = graph.sum(&terms);
                graph.whole(sum)
            })
            .collect();
        let rates = joints.rates(graph, mechanism, &acting);
        let mut multipliers = vec![graph.zero(); rows.len()];
        held.iter().zip(&found).for_each(|(i, lambda)| multipliers[*i] = *lambda);
        let compliances = factors.order.iter().map(|i| held[*i]).zip(factors.pivots).collect();
        Some(Swept { rates, multipliers, pivots: joints.pivots, compliances })
    }
}
