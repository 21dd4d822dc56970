//! The tangent projection: M_d u̇ = h_u* with M_d = D M Dᵀ and h_u* = D (h* - M a_u), (4.10) for every kind of row.

use super::Simplifier;
use super::carriers::Carriers;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix};

/// The reduced system and its parts, all in terms of the state.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// M, n x n.
    pub inertia: Matrix,
    /// h*, n.
    pub forces: Vec<Expr>,
    /// M of the carriers, D1 M D1ᵀ.
    pub carrier_inertia: Matrix,
    /// h* of the carriers, D1 (h* - M a_1).
    pub carrier_forces: Vec<Expr>,
    /// M_d, k x k.
    pub mass_matrix: Matrix,
    /// h_u*, k.
    pub forcing: Vec<Expr>,
    /// D, k x n.
    pub complement: Matrix,
    /// a_u, n.
    pub bias: Vec<Expr>,
}

/// Expressions over (x, v) or the carriers, in terms of the state.
pub fn to_state(graph: &mut Graph, carriers: &Carriers, tangent: &Tangent, expressions: &[Expr]) -> Vec<Expr> {
    let in_carriers = graph.substitute(expressions, &carriers.map);
    graph.substitute(&in_carriers, &tangent.map)
}

/// Projects the initial system.
pub fn reduce(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    carriers: &Carriers,
    tangent: &Tangent,
) -> Dynamics {
    let graph = &mut system.graph;
    let inertia = system.inertia.map(|entries| to_state(graph, carriers, tangent, entries));
    let forces = to_state(graph, carriers, tangent, &system.forces);
    let first = to_state(graph, carriers, tangent, &carriers.bias);
    let (carrier_inertia, carrier_forces) = match &carriers.partial_velocities {
        None => (inertia.clone(), forces.clone()),
        Some(partial) => project(graph, simplifier, &partial.transpose(), &inertia, &forces, &first),
    };
    let (mut mass_matrix, mut forcing) =
        project(graph, simplifier, &tangent.complement, &carrier_inertia, &carrier_forces, &tangent.bias);
    let k = mass_matrix.rows();
    let mut roots: Vec<Expr> =
        (0..k).flat_map(|i| (0..=i).map(move |j| (i, j))).map(|(i, j)| mass_matrix.get(i, j)).collect();
    roots.extend(&forcing);
    let roots = simplifier.all(graph, &roots);
    let mut next = roots.into_iter();
    for i in 0..k {
        for j in 0..=i {
            let entry = next.next().expect("as many roots as went in");
            mass_matrix.set(i, j, entry);
            mass_matrix.set(j, i, entry);
        }
    }
    forcing.iter_mut().for_each(|entry| *entry = next.next().expect("as many roots as went in"));
    let (complement, bias) = match &carriers.partial_velocities {
        None => (tangent.complement.clone(), tangent.bias.clone()),
        Some(partial) => {
            let complement = tangent.complement.mul(graph, &partial.transpose());
            let second = partial.mul_vec(graph, &tangent.bias);
            let bias: Vec<Expr> = second.into_iter().zip(&first).map(|(a, b)| graph.add(a, *b)).collect();
            let complement = complement.map(|entries| entries.iter().map(|e| simplifier.one(graph, *e)).collect());
            (complement, bias.into_iter().map(|e| simplifier.one(graph, e)).collect())
        }
    };
    Dynamics { inertia, forces, carrier_inertia, carrier_forces, mass_matrix, forcing, complement, bias }
}

/// D M Dᵀ and D (h* - M a).
fn project(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    d: &Matrix,
    inertia: &Matrix,
    forces: &[Expr],
    bias: &[Expr],
) -> (Matrix, Vec<Expr>) {
    let transposed = d.transpose();
    let half = inertia.mul(graph, &transposed);
    let mut projected = d.mul(graph, &half);
    for i in 0..projected.rows() {
        for j in 0..=i {
            let entry = simplifier.one(graph, projected.get(i, j));
            projected.set(i, j, entry);
            projected.set(j, i, entry);
        }
    }
    let inertial = inertia.mul_vec(graph, bias);
    let net: Vec<Expr> = forces.iter().zip(inertial).map(|(h, m)| graph.sub(*h, m)).collect();
    let projected_forces = d.mul_vec(graph, &net);
    (projected, projected_forces.into_iter().map(|e| simplifier.one(graph, e)).collect())
}
