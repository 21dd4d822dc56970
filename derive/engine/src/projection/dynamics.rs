//! The tangent projection: M_d u̇ = h_u* with M_d = D M Dᵀ and h_u* = D (h* - M a_u), (4.10) for every kind of row.

use super::Simplifier;
use super::acceleration::Bound;
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
    /// M of the state's speeds: M_d before rows bind their rates alone.
    pub speed_inertia: Matrix,
    /// h* of the state's speeds.
    pub speed_forces: Vec<Expr>,
    /// ∂v/∂u transposed, dim u x n: v̇ = this ᵀ u̇ + `speed_bias`.
    pub speed_complement: Matrix,
    /// The part of v̇ that does not depend on u̇, n.
    pub speed_bias: Vec<Expr>,
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
    bound: &Bound,
) -> Dynamics {
    let graph = &mut system.graph;
    let inertia = system.inertia.map(|entries| to_state(graph, carriers, tangent, entries));
    let forces = to_state(graph, carriers, tangent, &system.forces);
    let first = to_state(graph, carriers, tangent, &carriers.bias);
    if system.swept.is_some() {
        let untied = tangent.speeds == system.speeds;
        return without_matrix(if untied { forces } else { Vec::new() }, tangent);
    }
    let (carrier_inertia, carrier_forces) = match &carriers.partial_velocities {
        None => (inertia.clone(), forces.clone()),
        Some(partial) => project(graph, simplifier, &partial.transpose(), &inertia, &forces, &first),
    };
    let (speed_inertia, speed_forces) =
        project_well(graph, simplifier, &tangent.complement, &carrier_inertia, &carrier_forces, &tangent.bias);
    let (speed_complement, speed_bias) = match &carriers.partial_velocities {
        None => (tangent.complement.clone(), tangent.bias.clone()),
        Some(partial) => {
            composed(graph, simplifier, (&tangent.complement, &tangent.bias), &partial.transpose(), &first)
        }
    };
    let (mass_matrix, forcing, complement, bias) = if bound.elimination.is_none() {
        (speed_inertia.clone(), speed_forces.clone(), speed_complement.clone(), speed_bias.clone())
    } else {
        let (d, a) = (&bound.complement, &bound.offset);
        let (mass_matrix, forcing) = project_well(graph, simplifier, d, &speed_inertia, &speed_forces, a);
        let (complement, bias) = composed(graph, simplifier, (d, a), &speed_complement, &speed_bias);
        (mass_matrix, forcing, complement, bias)
    };
    Dynamics {
        inertia,
        forces,
        carrier_inertia,
        carrier_forces,
        speed_inertia,
        speed_forces,
        speed_complement,
        speed_bias,
        mass_matrix,
        forcing,
        complement,
        bias,
    }
}

/// Where v̇ is found joint by joint: M is not needed, and h_u* is h* where nothing ties the speeds.
fn without_matrix(forces: Vec<Expr>, tangent: &Tangent) -> Dynamics {
    let none = || Matrix::from_rows(Vec::new(), 0);
    Dynamics {
        inertia: none(),
        forces: forces.clone(),
        carrier_inertia: none(),
        carrier_forces: forces.clone(),
        speed_inertia: none(),
        speed_forces: forces.clone(),
        speed_complement: tangent.complement.clone(),
        speed_bias: tangent.bias.clone(),
        mass_matrix: none(),
        forcing: forces,
        complement: tangent.complement.clone(),
        bias: tangent.bias.clone(),
    }
}

/// One stage after another: with ẇ = D2ᵀ u̇ + a_2 and v̇ = D1ᵀ ẇ + a_1, D2 D1 and D1ᵀ a_2 + a_1.
fn composed(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    (second, second_bias): (&Matrix, &[Expr]),
    first: &Matrix,
    first_bias: &[Expr],
) -> (Matrix, Vec<Expr>) {
    let complement = second.mul(graph, first);
    let moved = first.transpose().mul_vec(graph, second_bias);
    let bias: Vec<Expr> = moved.into_iter().zip(first_bias).map(|(a, b)| graph.add(a, *b)).collect();
    let complement = complement.map(|entries| entries.iter().map(|e| simplifier.one(graph, *e)).collect());
    (complement, bias.into_iter().map(|e| simplifier.one(graph, e)).collect())
}

/// [`project`] with the cheapest forms that can be found for the result as a whole.
fn project_well(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    d: &Matrix,
    inertia: &Matrix,
    forces: &[Expr],
    bias: &[Expr],
) -> (Matrix, Vec<Expr>) {
    let (mut mass_matrix, mut forcing) = project(graph, simplifier, d, inertia, forces, bias);
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
    (mass_matrix, forcing)
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
