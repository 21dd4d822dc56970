//! The orthogonal projection: λ for all rows, once, in the initial space.
//!
//! With v̇ known, M v̇ - h* = Cᵀ λ (2.8a) has a solution, and the rows of C at its pivots give it without M⁻¹ and
//! without M_c: λ = C_d⁻ᵀ (M v̇ - h*)_d. It equals (3.6) wherever M is regular, and holds where M is not. Where the
//! pivots of C would need guards of their own, (C Cᵀ) λ = C (M v̇ - h*) is solved instead. With a configuration the rows
//! that bind its rates come first, in the carriers' space; the rows that it satisfies carry what is left. Before all come
//! the rows that bind accelerations alone, in the space of the state's speeds. A motion that was found joint by joint has λ with it.

use super::Simplifier;
use super::acceleration::Bound;
use super::carriers::Carriers;
use super::constraints::DifferentiatedRow;
use super::dependence::Sorted;
use super::dynamics::{Dynamics, to_state};
use super::elimination::{Choice, eliminate};
use super::factorisation::factorise;
use super::messages;
use super::motion::Solution;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix};
use crate::syntax::Diagnostics;

/// The multipliers of the rows of C.
#[derive(Clone, Debug)]
pub struct Reactions {
    /// λ, in the order of the rows.
    pub multipliers: Vec<Expr>,
    /// Pivots of C Cᵀ where it was needed.
    pub pivots: Vec<Expr>,
}

/// What the reactions are computed from.
#[derive(Copy, Clone)]
pub struct Motion<'a> {
    /// The first stage.
    pub carriers: &'a Carriers,
    /// The second stage.
    pub tangent: &'a Tangent,
    /// The third stage.
    pub bound: &'a Bound,
    /// Whether further rows bind the carriers, but repeat those of the second stage there.
    pub overlapping: bool,
    /// The reduced system.
    pub dynamics: &'a Dynamics,
    /// u̇, and what came with it.
    pub solution: &'a Solution,
}

/// λ of all kept rows.
pub fn reactions(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    motion: Motion<'_>,
    errors: &mut Diagnostics,
) -> Option<Reactions> {
    let Motion { carriers, tangent, bound, dynamics, solution, overlapping } = motion;
    if let Some(swept) = &solution.swept {
        return Some(Reactions { multipliers: swept.multipliers.clone(), pivots: Vec::new() });
    }
    let (n, m, k) = (system.speeds.len(), kept.len(), bound.speeds.len());
    let binding: Vec<usize> = tangent.rows.iter().chain(&bound.rows).copied().collect();
    if m < n - k && binding.len() < m {
        // The configuration has reactions of its own that no row states.
        for (_, i) in kept.iter().enumerate().filter(|(position, _)| !binding.contains(position)) {
            errors.report(rows[*i].span, messages::reaction_undetermined(&rows[*i].name, n - k - m));
        }
        return None;
    }
    let graph = &mut system.graph;
    let c = |graph: &mut Graph, simplifier: &mut dyn Simplifier, list: &[usize]| {
        let gradients = list.iter().map(|p| to_state(graph, carriers, tangent, &rows[kept[*p]].gradient)).collect();
        Matrix::from_rows(gradients, n).map(|entries| entries.iter().map(|e| simplifier.one(graph, *e)).collect())
    };
    let all: Vec<usize> = (0..m).collect();
    let net = |graph: &mut Graph| -> Vec<Expr> {
        let rate = rates(graph, &dynamics.speed_complement, &solution.accelerations, &dynamics.speed_bias);
        (0..n).map(|i| residual(graph, &dynamics.inertia, &dynamics.forces, &rate, i)).collect()
    };
    if overlapping || bound.overlapping {
        let c = c(graph, simplifier, &all);
        let r = net(graph);
        return Some(solve(graph, simplifier, &c, &r));
    }
    // Rows that bind u̇ alone come first: in the space of the speeds the others do no work and drop out.
    let third = match &solution.multipliers {
        Some(multipliers) => multipliers.clone(),
        None => among_speeds(graph, simplifier, motion),
    };
    let of_third = c(graph, simplifier, &bound.rows).transpose().mul_vec(graph, &third);
    // Then the rows that bind the carriers: the configuration's own reactions do no work there.
    let mut found = among_carriers(graph, simplifier, motion, &of_third);
    let absorbed: Vec<usize> = all.into_iter().filter(|p| !binding.contains(p)).collect();
    let mut multipliers = vec![graph.zero(); m];
    tangent.rows.iter().zip(&found.multipliers).for_each(|(p, lambda)| multipliers[*p] = *lambda);
    bound.rows.iter().zip(&third).for_each(|(p, lambda)| multipliers[*p] = *lambda);
    if !absorbed.is_empty() {
        // Rows that the configuration satisfies carry what is left in the initial space.
        let carried = c(graph, simplifier, &tangent.rows).transpose().mul_vec(graph, &found.multipliers);
        let r = net(graph);
        let r: Vec<Expr> = (0..n)
            .map(|i| {
                let others = graph.add(carried[i], of_third[i]);
                graph.sub(r[i], others)
            })
            .collect();
        let c = c(graph, simplifier, &absorbed);
        let rest = solve(graph, simplifier, &c, &r);
        absorbed.iter().zip(&rest.multipliers).for_each(|(p, lambda)| multipliers[*p] = *lambda);
        found.pivots.extend(rest.pivots);
    }
    Some(Reactions { multipliers, pivots: found.pivots })
}

/// λ of all rows of C, in their order, from those of the independent rows.
///
/// Rows C_r = R C_b that depend on others share in the reaction C_bᵀ μ: λ = W (Wᵀ W)⁻¹ μ with W = [1; R] is the one of
/// least norm, so that λ_r = (1 + R Rᵀ)⁻¹ R μ and λ_b = μ - Rᵀ λ_r. Also gives the entries of R.
pub fn shared(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    sorted: &Sorted,
    independent: Vec<Expr>,
    on_motions: impl Fn(&mut Graph, Expr) -> Expr,
) -> (Vec<Expr>, Vec<Expr>) {
    if sorted.redundant.is_empty() {
        return (independent, Vec::new());
    }
    let (m, zero) = (independent.len(), graph.zero());
    let mut weights = Vec::with_capacity(sorted.redundant.len());
    for redundant in &sorted.redundant {
        let mut row = vec![zero; m];
        for (j, coefficient) in redundant.combination.iter().flatten() {
            if let Some(position) = sorted.kept.iter().position(|kept| kept == j) {
                let coefficient = on_motions(graph, *coefficient);
                row[position] = simplifier.one(graph, coefficient);
            }
        }
        weights.push(row);
    }
    let weights = Matrix::from_rows(weights, m);
    let transposed = weights.transpose();
    let mut normal = weights.mul(graph, &transposed);
    for i in 0..normal.rows() {
        let (one, entry) = (graph.one(), normal.get(i, i));
        let entry = graph.add(entry, one);
        normal.set(i, i, entry);
    }
    let normal = normal.map(|entries| entries.iter().map(|e| simplifier.one(graph, *e)).collect());
    let right = weights.mul_vec(graph, &independent);
    // 1 + R Rᵀ is never singular, so that its pivots need no guards.
    let factors = factorise(graph, simplifier, &normal);
    let found = factors.map_or(right.clone(), |factors| factors.solve(graph, simplifier, &right));
    let taken = transposed.mul_vec(graph, &found);
    let rest: Vec<Expr> = independent.iter().zip(taken).map(|(mu, part)| graph.sub(*mu, part)).collect();
    let of_row = |i: &usize| {
        let kept = sorted.kept.iter().position(|j| j == i).map(|position| rest[position]);
        kept.or_else(|| sorted.redundant.iter().position(|r| r.row == *i).map(|position| found[position]))
    };
    (sorted.rows().iter().filter_map(of_row).collect(), weights.entries().to_vec())
}

/// λ of the rows that bind u̇ alone, from M_w u̇ - h_w = C̃ᵀ λ, at the pivots of C̃.
fn among_speeds(graph: &mut Graph, simplifier: &mut dyn Simplifier, motion: Motion<'_>) -> Vec<Expr> {
    let Motion { bound, dynamics, solution, .. } = motion;
    let Some(elimination) = &bound.elimination else { return Vec::new() };
    let mut at_pivots = Vec::with_capacity(elimination.pivots.len());
    for j in &elimination.pivots {
        let r = residual(graph, &dynamics.speed_inertia, &dynamics.speed_forces, &solution.accelerations, *j);
        at_pivots.push(simplifier.one(graph, r));
    }
    let multipliers = elimination.solve_transposed(graph, simplifier, &at_pivots);
    multipliers.into_iter().map(|e| simplifier.one(graph, e)).collect()
}

/// λ of the rows that bind the carriers, from M1 ẇ - h1 = C2ᵀ λ + what the rows that bind u̇ alone exert.
fn among_carriers(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    motion: Motion<'_>,
    of_third: &[Expr],
) -> Reactions {
    let Motion { carriers, tangent, dynamics, solution, .. } = motion;
    let rate = rates(graph, &tangent.complement, &solution.accelerations, &tangent.bias);
    let (inertia, forces) = (&dynamics.carrier_inertia, &dynamics.carrier_forces);
    let of_third = match &carriers.partial_velocities {
        None => of_third.to_vec(),
        Some(partial) => partial.transpose().mul_vec(graph, of_third),
    };
    let net = |graph: &mut Graph, j: usize| {
        let total = residual(graph, inertia, forces, &rate, j);
        graph.sub(total, of_third[j])
    };
    let Some(elimination) = &tangent.elimination else {
        let c = tangent.gradients.map(|entries| to_state(graph, carriers, tangent, entries));
        let r: Vec<Expr> = (0..c.columns()).map(|i| net(graph, i)).collect();
        return solve(graph, simplifier, &c, &r);
    };
    // Below the rows of C there may be those of L, on which no force acts: with E = [C; L], r = Cᵀ λ = Eᵀ [λ; 0].
    let (inverse, m) = (&elimination.inverse, tangent.rows.len());
    let mut at_pivots = Vec::with_capacity(elimination.pivots.len());
    for (row, j) in elimination.pivots.iter().enumerate() {
        let needed = inverse.row(row)[..m].iter().any(|e| !graph.is_zero(*e));
        let r = if needed { net(graph, *j) } else { graph.zero() };
        at_pivots.push(simplifier.one(graph, r));
    }
    let multipliers = elimination.solve_transposed(graph, simplifier, &at_pivots);
    Reactions { multipliers: to_state(graph, carriers, tangent, &multipliers[..m]), pivots: Vec::new() }
}

/// Dᵀ u̇ + a.
pub fn rates(graph: &mut Graph, d: &Matrix, accelerations: &[Expr], bias: &[Expr]) -> Vec<Expr> {
    let linear = d.transpose().mul_vec(graph, accelerations);
    linear.into_iter().zip(bias).map(|(a, b)| graph.add(a, *b)).collect()
}

/// The i-th component of M v̇ - h*.
fn residual(graph: &mut Graph, inertia: &Matrix, forces: &[Expr], rate: &[Expr], i: usize) -> Expr {
    let terms: Vec<Expr> = inertia.row(i).iter().zip(rate).map(|(m, a)| graph.mul(*m, *a)).collect();
    let inertial = graph.sum(&terms);
    graph.sub(inertial, forces[i])
}

/// λ from Cᵀ λ = r, which has a solution.
fn solve(graph: &mut Graph, simplifier: &mut dyn Simplifier, c: &Matrix, r: &[Expr]) -> Reactions {
    let choice = Choice { columns: vec![true; c.columns()], new_guards: false };
    if let Ok(elimination) = eliminate(graph, simplifier, c, &choice) {
        let at_pivots: Vec<Expr> = elimination.pivots.iter().map(|j| r[*j]).collect();
        let multipliers = elimination.solve_transposed(graph, simplifier, &at_pivots);
        return Reactions { multipliers, pivots: Vec::new() };
    }
    let transposed = c.transpose();
    let normal = c.mul(graph, &transposed).map(|e| e.iter().map(|e| simplifier.one(graph, *e)).collect());
    let right = c.mul_vec(graph, r);
    match factorise(graph, simplifier, &normal) {
        Ok(factors) => {
            let multipliers = factors.solve(graph, simplifier, &right);
            Reactions { multipliers, pivots: factors.pivots }
        }
        // C has full row rank here, so C Cᵀ is regular; kept as a value rather than a panic.
        Err(_) => Reactions { multipliers: right, pivots: vec![graph.zero()] },
    }
}
