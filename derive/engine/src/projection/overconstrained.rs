//! Rows that depend on others only where the constraints hold, as in an overconstrained loop.
//!
//! Bricard's mechanism moves although its joints count one too many: its rows are independent at a generic point and dependent
//! wherever the loop is closed. No identity tells that. So rows that may depend on others, as the model says, are judged at the
//! start, closed, and at configurations near it that the independent ones of the rows leave: where the others hold at all of them,
//! and bind nothing there that is not bound, they follow from the independent ones on this part of the manifold. At a start that
//! happens to be singular this fails beside it.
//!
//! What a dependent row is of the others, R in C_r = R C_b, then needs no identity either: it is read at the pivots of C_b.

use super::Simplifier;
use super::carriers::{CarriedRow, Carriers};
use super::constraints::DifferentiatedRow;
use super::dependence::{Redundant, Sorted, combination};
use super::elimination::{Choice, eliminate};
use super::judge::{DEPENDS, numbers};
use super::start::{Start, dot};
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// Configurations beside the start at which dependence is looked at.
pub const BESIDE: usize = 3;

/// A row with at least this part of the most that is left of any is taken before later ones.
const ENOUGH: f64 = 0.3;

/// Below this fraction of its terms, here or where the others are open, a row counts as met by these: they are closed as far, and
/// no further.
const MET: f64 = 1e-8;

/// Takes rows that depend on others at the start and beside it out of those that are kept, if they may depend on them.
///
/// Rows that repeat others identically do so by pivots that may vanish where all rows hold: where the rows that are left say less
/// there than all did, such rows are kept in their place.
pub fn take_out(system: &InitialSystem, rows: &[DifferentiatedRow], carriers: &Carriers, sorted: &mut Sorted) {
    let judged = |i: &usize| rows[*i].binds_speeds();
    let (marked, firm): (Vec<usize>, Vec<usize>) =
        sorted.kept.iter().copied().filter(judged).partition(|i| rows[*i].redundant);
    if marked.is_empty() || system.start.is_empty() || carriers.partial_velocities.is_some() {
        return;
    }
    let mut start = Start::of(system);
    if start.close(system, rows, carriers).is_err() {
        return;
    }
    let repeated: Vec<usize> = sorted.redundant.iter().map(|redundant| redundant.row).filter(judged).collect();
    let Some((left, added)) = dependent(&start, &system.graph, rows, &firm, (&marked, &repeated)) else { return };
    let kept: Vec<usize> = sorted.kept.iter().chain(&added).copied().collect();
    if left.is_empty() || !repeat(system, rows, carriers, &start, (&kept, &left)) {
        return;
    }
    sorted.kept = kept;
    sorted.kept.retain(|i| !left.contains(i));
    sorted.kept.sort_unstable();
    sorted.redundant.retain(|redundant| !added.contains(&redundant.row));
    let excess = system.graph.zero();
    sorted.redundant.extend(left.into_iter().map(|row| Redundant {
        row,
        combination: None,
        on_manifold: true,
        excess,
    }));
    // Combinations that hold identically were found by pivots of the rows that have just left, which vanish where all rows hold.
    sorted.redundant.iter_mut().for_each(|redundant| redundant.combination = None);
}

/// The marked rows of which nothing is left beside the firm ones and the best of the marked ones, and the repeated ones of which
/// something is; `None` where they have no numbers.
fn dependent(
    start: &Start,
    graph: &Graph,
    rows: &[DifferentiatedRow],
    firm: &[usize],
    (marked, repeated): (&[usize], &[usize]),
) -> Option<(Vec<usize>, Vec<usize>)> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for i in firm {
        let row = rest(&numbers(start, graph, &rows[*i].gradient)?, &basis);
        extend(&mut basis, row);
    }
    let with_numbers = |i: &usize| Some((*i, numbers(start, graph, &rows[*i].gradient)?));
    let (_, left) = best(marked.iter().map(with_numbers).collect::<Option<_>>()?, &mut basis)?;
    let (added, _) = best(repeated.iter().map(with_numbers).collect::<Option<_>>()?, &mut basis)?;
    Some((left, added))
}

/// Adds the best of the rows to the basis until nothing is left of any; those that are in it, and those that are not.
fn best(mut open: Vec<(usize, Vec<f64>)>, basis: &mut Vec<Vec<f64>>) -> Option<(Vec<usize>, Vec<usize>)> {
    let mut taken = Vec::new();
    loop {
        // the part of a row without length is no number, and less than any
        let parts: Vec<f64> = open.iter().map(|(_, row)| length(&rest(row, basis)) / length(row)).collect();
        let most = parts.iter().copied().fold(0.0, f64::max);
        if most <= DEPENDS {
            return Some((taken, open.into_iter().map(|(i, _)| i).collect()));
        }
        let at = parts.iter().position(|part| *part >= ENOUGH * most)?;
        let (i, row) = open.remove(at);
        let row = rest(&row, basis);
        extend(basis, row);
        taken.push(i);
    }
}

/// Whether rows say nothing that the others of those kept do not say, beside the start: there the others are closed alone.
pub fn repeat(
    system: &InitialSystem,
    rows: &[DifferentiatedRow],
    carriers: &Carriers,
    start: &Start,
    (kept, left): (&[usize], &[usize]),
) -> bool {
    let others: Vec<usize> = kept.iter().copied().filter(|i| !left.contains(i) && rows[*i].binds_speeds()).collect();
    let closing: Vec<DifferentiatedRow> = others.iter().map(|i| rows[*i].clone()).collect();
    // what a row says of v = 0 is the same combination as its gradient
    let mut graph = system.graph.clone();
    let zero = graph.zero();
    let still: Vec<(Symbol, Expr)> = system.speeds.iter().map(|v| (*v, zero)).collect();
    let values: Vec<Option<Expr>> =
        rows.iter().map(|row| row.velocity.map(|phi| graph.substitute(&[phi], &still)[0])).collect();
    let with_value = |near: &Start, i: &usize| -> Option<Vec<f64>> {
        let mut row = numbers(near, &graph, &rows[*i].gradient)?;
        row.push(numbers(near, &graph, &[values[*i].unwrap_or(zero)])?[0]);
        Some(row)
    };
    let holds = |near: &Start, open: &Start| -> Option<bool> {
        let mut basis = Vec::new();
        for i in &others {
            let row = rest(&with_value(near, i)?, &basis);
            extend(&mut basis, row);
        }
        for i in left {
            let row = with_value(near, i)?;
            let met = rows[*i].position.is_none_or(|f| {
                let ((value, size), (_, before)) = (near.value(&graph, f), open.value(&graph, f));
                value.abs() <= MET * size.max(before)
            });
            if !met || length(&rest(&row, &basis)) > DEPENDS * length(&row) {
                return Some(false);
            }
        }
        Some(true)
    };
    (1..=BESIDE).all(|at| {
        let open = start.beside(system, at);
        let mut near = open.clone();
        near.close(system, &closing, carriers).is_ok() && holds(&near, &open) == Some(true)
    })
}

/// R of the rows that have none yet, at the pivots of the tangent basis, or at pivots of its own where that has none.
pub fn relate(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    carried: &[CarriedRow],
    tangent: &Tangent,
    sorted: &mut Sorted,
) {
    if sorted.redundant.iter().all(|redundant| redundant.combination.is_some()) {
        return;
    }
    let graph = &mut system.graph;
    let own = match &tangent.elimination {
        Some(_) => None,
        None => {
            let width = system.speeds.len();
            let c = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
            eliminate(graph, simplifier, &c, &Choice { columns: vec![true; width], new_guards: true }).ok()
        }
    };
    let Some(elimination) = tangent.elimination.as_ref().or(own.as_ref()) else { return };
    for redundant in sorted.redundant.iter_mut().filter(|redundant| redundant.combination.is_none()) {
        let coefficients = combination(graph, simplifier, elimination, &rows[redundant.row].gradient);
        let of = carried.iter().zip(coefficients).map(|(row, c)| (sorted.kept[row.row], c));
        redundant.combination = Some(of.filter(|(_, c)| !graph.is_zero(*c)).collect());
    }
}

/// What is left of a row beside orthonormal ones.
fn rest(row: &[f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let mut rest = row.to_vec();
    // Twice is enough.
    for _ in 0..2 {
        for direction in basis {
            let along = dot(&rest, direction);
            rest.iter_mut().zip(direction).for_each(|(r, d)| *r -= along * d);
        }
    }
    rest
}

fn extend(basis: &mut Vec<Vec<f64>>, rest: Vec<f64>) {
    let length = length(&rest);
    if length > 0.0 {
        basis.push(rest.into_iter().map(|r| r / length).collect());
    }
}

fn length(row: &[f64]) -> f64 {
    dot(row, row).sqrt()
}
