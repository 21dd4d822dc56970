//! The rates u̇ of the state's speeds.
//!
//! Where no row binds them alone, and where the pivots of such rows cannot vanish, M_d ν = h_u* (4.10) gives them. Where
//! the pivots might vanish in a state in which the rows are still independent, the orthogonal projection (3.6) in the
//! space of the speeds is used instead: M_w u̇ = h_w + C̃ᵀ λ with λ = -M_c⁻¹ (c̃0 + C̃ M_w⁻¹ h_w) and M_c = C̃ M_w⁻¹ C̃ᵀ,
//! whose pivots vanish exactly where the rows depend on each other.

use super::Simplifier;
use super::acceleration::Bound;
use super::dynamics::Dynamics;
use super::factorisation::{Factorisation, factorise};
use super::guards::Guards;
use super::messages;
use super::swept::InState;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix};
use crate::syntax::Diagnostics;

/// The rates, and what came with them.
#[derive(Clone, Debug)]
pub struct Solution {
    /// u̇.
    pub accelerations: Vec<Expr>,
    /// λ of the rows that bind u̇ alone, where it was needed to find u̇.
    pub multipliers: Option<Vec<Expr>>,
    /// v̇ and λ of all rows, where they were found joint by joint.
    pub swept: Option<InState>,
}

/// Solves for u̇; `names` are those of the rows that bind u̇ alone.
pub fn solve(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    (tangent, bound): (&Tangent, &Bound),
    dynamics: &Dynamics,
    (guards, names): (&mut Guards, &[String]),
    errors: &mut Diagnostics,
) -> Option<Solution> {
    if bound.unguarded
        && let Some(solution) = by_projection(&mut system.graph, simplifier, (tangent, bound), dynamics, guards, names)
    {
        return Some(solution);
    }
    if bound.unguarded {
        // M is not definite on all motions of the state: only D3 is left.
        if let Some(elimination) = &bound.elimination {
            for (pivot, called) in elimination.values.iter().zip(elimination.pivot_names(names)) {
                let origin = "the constraints do not determine the accelerations by it";
                guards.pivot(&system.graph, *pivot, &called, origin, names);
            }
        }
    }
    let name = |system: &InitialSystem, i: usize| system.graph.name(bound.speeds[i]).to_owned();
    let span = system.places.inertia;
    let factors = match factorise(&mut system.graph, simplifier, &dynamics.mass_matrix) {
        Ok(factors) => factors,
        Err(i) => {
            errors.report(span, messages::singular_inertia(&name(system, i)));
            return None;
        }
    };
    for (p, pivot) in factors.order.iter().zip(&factors.pivots) {
        let called = format!("pivot of D M D\u{1d40} for {}", name(system, *p));
        if let Err(text) = guards.positive(&mut system.graph, *pivot, &called, INERTIA_PIVOT, &[]) {
            errors.report(span, messages::negative_inertia(&name(system, *p), &text));
        }
    }
    let graph = &mut system.graph;
    let independent = factors.solve(graph, simplifier, &dynamics.forcing);
    let accelerations = if bound.speeds.len() == tangent.speeds.len() {
        independent
    } else {
        let linear = bound.complement.transpose().mul_vec(graph, &independent);
        linear.into_iter().zip(&bound.offset).map(|(a, b)| graph.add(a, *b)).collect()
    };
    let accelerations = accelerations.into_iter().map(|e| simplifier.one(graph, e)).collect();
    Some(Solution { accelerations, multipliers: None, swept: None })
}

/// The origin of a guard that is a pivot of the mass matrix.
pub const INERTIA_PIVOT: &str = "a pivot of D M D\u{1d40} (4.10)";

/// The origin of a guard that is a pivot of M_c = C̃ M_w⁻¹ C̃ᵀ.
pub const COMPLIANCE_PIVOT: &str = "the constraints depend on each other where it vanishes (3.6)";

/// By (3.6) in the space of the state's speeds; `None` where M is not definite there.
fn by_projection(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    (tangent, bound): (&Tangent, &Bound),
    dynamics: &Dynamics,
    guards: &mut Guards,
    names: &[String],
) -> Option<Solution> {
    let speeds = &tangent.speeds;
    let mut found = guards.clone();
    let inertia = factorise(graph, simplifier, &dynamics.speed_inertia).ok()?;
    for (p, pivot) in inertia.order.iter().zip(&inertia.pivots) {
        let called = format!("pivot of D M D\u{1d40} for {}", graph.name(speeds[*p]));
        found.positive(graph, *pivot, &called, INERTIA_PIVOT, &[]).ok()?;
    }
    let free = inertia.solve(graph, simplifier, &dynamics.speed_forces);
    let compliance = columns(graph, simplifier, &inertia, &bound.gradients);
    let metric = bound.gradients.mul(graph, &compliance);
    let metric = metric.map(|entries| entries.iter().map(|e| simplifier.one(graph, *e)).collect());
    let factors = factorise(graph, simplifier, &metric).ok()?;
    for (p, pivot) in factors.order.iter().zip(&factors.pivots) {
        let called = format!("pivot of M_c for {}", names[*p]);
        found.positive(graph, *pivot, &called, COMPLIANCE_PIVOT, names).ok()?;
    }
    let mut right = bound.gradients.mul_vec(graph, &free);
    for (value, bias) in right.iter_mut().zip(&bound.bias) {
        let sum = graph.add(*value, *bias);
        let negative = graph.neg(sum);
        *value = simplifier.one(graph, negative);
    }
    let multipliers = factors.solve(graph, simplifier, &right);
    let multipliers: Vec<Expr> = multipliers.into_iter().map(|e| simplifier.one(graph, e)).collect();
    let constrained = compliance.mul_vec(graph, &multipliers);
    let accelerations = free
        .into_iter()
        .zip(constrained)
        .map(|(a, b)| {
            let sum = graph.add(a, b);
            simplifier.one(graph, sum)
        })
        .collect();
    *guards = found;
    Some(Solution { accelerations, multipliers: Some(multipliers), swept: None })
}

/// M⁻¹ Cᵀ, one column a row of C.
fn columns(graph: &mut Graph, simplifier: &mut dyn Simplifier, inertia: &Factorisation, c: &Matrix) -> Matrix {
    let rows = (0..c.rows()).map(|i| inertia.solve(graph, simplifier, c.row(i))).collect();
    Matrix::from_rows(rows, c.columns()).transpose()
}
