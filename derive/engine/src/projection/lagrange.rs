//! From the kinetic energy to h*: Lagrange's equations in the base of v, whatever v is.
//!
//! With T(v, x, t) and v = B ẋ + b0 (2.2), Lagrange's equations in ẋ, multiplied by Aᵀ from the left, are
//!
//! ```text
//!     d/dt p − Aᵀ ∂T/∂x + Σ_i p_i Γⁱ (v, 1) = Q − Aᵀ ∂V/∂x,      p = ∂T/∂v = M v + p0
//! ```
//!
//! where ∂T/∂x is taken at fixed v. The antisymmetric Γⁱ are the coefficients of Boltzmann and Hamel: the curl of the i-th
//! row of (B, b0) over (x, t), with respect to the columns of (A, a0; 0, 1). They vanish exactly where that row is a
//! total derivative. What is left of d/dt p beside M v̇ goes to the right, so that (2.3) stands there, M v̇ = h*.
//! No inverse is formed and nothing is differentiated twice but T.

use super::Simplifier;
use super::constraints::motion;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// Makes the listed forces all of h*, if the model gives a kinetic energy; the potential energy's forces are added too.
pub fn complete(system: &mut InitialSystem, simplifier: &mut dyn Simplifier) {
    let Some(kinetic) = system.kinetic else { return };
    let motion = motion(system);
    let graph = &mut system.graph;
    let n = system.speeds.len();
    let inertia: Vec<Expr> = system.inertia.entries().iter().map(|e| simplifier.one(graph, *e)).collect();
    system.inertia = Matrix::from_fn(n, n, |i, j| inertia[i.min(j) * n + i.max(j)]);
    let momenta: Vec<Expr> =
        graph.jacobian(&[kinetic], &system.speeds).row(0).iter().map(|e| simplifier.one(graph, *e)).collect();
    let rates = graph.along(&momenta, &motion);
    // Aᵀ ∂(T - V)/∂x
    let lagrangian = match system.potential {
        Some(potential) => graph.sub(kinetic, potential),
        None => kinetic,
    };
    let slopes = graph.jacobian(&[lagrangian], &system.coordinates);
    let slopes: Vec<Expr> = slopes.row(0).iter().map(|e| simplifier.one(graph, *e)).collect();
    let driven = system.kinematics.a.transpose().mul_vec(graph, &slopes);
    let mut velocities = graph.vars(&system.speeds);
    velocities.push(graph.one());
    let turning = turning(system, simplifier);
    let graph = &mut system.graph;
    for a in 0..n {
        let mut terms = vec![system.forces[a], driven[a]];
        let mut against = vec![rates[a]];
        for (momentum, coefficients) in momenta.iter().zip(&turning) {
            let Some(coefficients) = coefficients else { continue };
            let products: Vec<Expr> =
                coefficients.row(a).iter().zip(&velocities).map(|(c, v)| graph.mul(*c, *v)).collect();
            let sum = graph.sum(&products);
            against.push(graph.mul(*momentum, sum));
        }
        let against = graph.sum(&against);
        terms.push(graph.neg(against));
        let force = graph.sum(&terms);
        system.forces[a] = simplifier.one(graph, force);
    }
}

/// Γⁱ for each speed, (n + 1) x (n + 1), time last; `None` where it vanishes.
fn turning(system: &mut InitialSystem, simplifier: &mut dyn Simplifier) -> Vec<Option<Matrix>> {
    let n = system.speeds.len();
    let kinematics = &system.kinematics;
    let graph = &mut system.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let frame = Matrix::from_fn(n + 1, n + 1, |k, a| match (k < n, a < n) {
        (true, true) => kinematics.a.get(k, a),
        (true, false) => kinematics.a0[k],
        (false, true) => zero,
        (false, false) => one,
    });
    let forms = Matrix::from_fn(n, n + 1, |i, k| if k < n { kinematics.b.get(i, k) } else { kinematics.b0[i] });
    let mut places = system.coordinates.clone();
    places.push(system.time);
    // The direction that was written down is the simpler one, and has the simpler derivatives.
    if graph.reachable(forms.entries()).len() <= graph.reachable(frame.entries()).len() {
        (0..n).map(|i| by_curl(graph, simplifier, forms.row(i), &frame, &places)).collect()
    } else {
        by_brackets(graph, simplifier, &forms, &frame, &places)
    }
}

/// Eᵀ K E with the curl K of a row β: K_kj = ∂β_k/∂x_j − ∂β_j/∂x_k.
fn by_curl(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    form: &[Expr],
    frame: &Matrix,
    places: &[Symbol],
) -> Option<Matrix> {
    let slopes = graph.jacobian(form, places);
    let curl = antisymmetric(graph, simplifier, places.len(), |graph, k, j| {
        let (a, b) = (slopes.get(k, j), slopes.get(j, k));
        graph.sub(a, b)
    })?;
    let half = curl.mul(graph, frame);
    antisymmetric(graph, simplifier, places.len(), |graph, a, b| {
        let terms: Vec<Expr> = (0..places.len()).map(|k| graph.mul(frame.get(k, a), half.get(k, b))).collect();
        graph.sum(&terms)
    })
}

/// The same by the brackets of the columns: Γⁱ_ab = Σ_k β_ik (e_a(e_b)_k − e_b(e_a)_k).
fn by_brackets(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    forms: &Matrix,
    frame: &Matrix,
    places: &[Symbol],
) -> Vec<Option<Matrix>> {
    let width = places.len();
    let columns = frame.transpose();
    // moved[a] holds the derivatives of all columns along e_a.
    let moved: Vec<Matrix> = (0..width)
        .map(|a| {
            let tangent: Vec<(Symbol, Expr)> = places.iter().copied().zip(columns.row(a).iter().copied()).collect();
            columns.map(|entries| graph.along(entries, &tangent))
        })
        .collect();
    // The last component is that of time, which every bracket leaves.
    let brackets: Vec<Option<Matrix>> = (0..width - 1)
        .map(|k| {
            antisymmetric(graph, simplifier, width, |graph, a, b| graph.sub(moved[a].get(b, k), moved[b].get(a, k)))
        })
        .collect();
    (0..forms.rows())
        .map(|i| {
            antisymmetric(graph, simplifier, width, |graph, a, b| {
                let terms: Vec<Expr> = brackets
                    .iter()
                    .enumerate()
                    .filter_map(|(k, bracket)| bracket.as_ref().map(|bracket| (k, bracket.get(a, b))))
                    .map(|(k, entry)| graph.mul(forms.get(i, k), entry))
                    .collect();
                graph.sum(&terms)
            })
        })
        .collect()
}

/// The antisymmetric matrix with these entries above the diagonal, what vanishes zero; `None` where all of it is.
fn antisymmetric(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    width: usize,
    mut entry: impl FnMut(&mut Graph, usize, usize) -> Expr,
) -> Option<Matrix> {
    let mut matrix = Matrix::zeros(graph, width, width);
    let mut filled = false;
    for (a, b) in (0..width).flat_map(|a| (a + 1..width).map(move |b| (a, b))) {
        let value = entry(graph, a, b);
        if !graph.vanishes(value) {
            let value = simplifier.one(graph, value);
            let opposite = graph.neg(value);
            matrix.set(a, b, value);
            matrix.set(b, a, opposite);
            filled = true;
        }
    }
    filled.then_some(matrix)
}

#[cfg(test)]
mod tests;
