//! The third stage: rows that bind nothing but the rates of the state's speeds.
//!
//! These are nonlinear velocity rows, by their gradient ∂φ/∂v (Chetaev's rule), and acceleration rows as they are given.
//! With v̇ = D1ᵀ (D2ᵀ u̇ + a_2) + a_1 of the first two stages, C v̇ + c0* = 0 (2.4) becomes C̃ u̇ + c̃0 = 0. Pivots leave
//! u̇ = D3ᵀ ν + a_3, with a unit block in D3 and the independent accelerations ν. The state keeps all its speeds.

use super::Simplifier;
use super::carriers::Carriers;
use super::constraints::DifferentiatedRow;
use super::dependence::{combination, independent};
use super::dynamics::to_state;
use super::elimination::{Choice, Elimination, eliminate};
use super::messages;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// The third stage: the independent accelerations among the rates of the state's speeds.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The rows (positions in C) that bind these rates.
    pub rows: Vec<usize>,
    /// C̃, one column a speed of the state.
    pub gradients: Matrix,
    /// c̃0.
    pub bias: Vec<Expr>,
    /// The speeds whose rates are ν.
    pub speeds: Vec<Symbol>,
    /// D3, k x dim u.
    pub complement: Matrix,
    /// a_3, dim u.
    pub offset: Vec<Expr>,
    /// How C̃ was eliminated; `None` where there are no rows.
    pub elimination: Option<Elimination>,
    /// Whether the pivots may vanish though the rows are independent there. The motion is then found without D3, which
    /// serves only those who ask for M_d, h_u* and D.
    pub unguarded: bool,
    /// Whether further rows bind the rates, but repeat others once a configuration has taken its share.
    pub overlapping: bool,
}

/// A row in terms of the state.
struct StateRow {
    /// Its position in C.
    row: usize,
    gradient: Vec<Expr>,
    bias: Expr,
}

/// The third stage.
pub fn bound(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carriers: &Carriers,
    tangent: &Tangent,
    errors: &mut Diagnostics,
) -> Option<Bound> {
    let configured = carriers.partial_velocities.is_some();
    let mut found = Vec::new();
    let mut overlapping = false;
    // Rows that given velocities satisfy bind nothing further.
    let satisfied = |row: &DifferentiatedRow| system.velocities.is_some() && row.velocity.is_some();
    let open = |i: usize| !rows[i].binds_speeds() && !satisfied(&rows[i]);
    let open: Vec<(usize, &usize)> = kept.iter().enumerate().filter(|(_, i)| open(**i)).collect();
    for (position, i) in open {
        let row = &rows[*i];
        let graph = &mut system.graph;
        let (among_carriers, gradient, bias) = in_state(graph, simplifier, row, carriers, tangent);
        if gradient.iter().any(|e| !graph.is_zero(*e)) {
            found.push(StateRow { row: position, gradient, bias });
        } else if !graph.vanishes(bias) {
            errors.report(row.span, messages::excluded_on_motions(&row.name, &graph.display(bias)));
        } else if !configured {
            errors.report(row.span, messages::dependent_on_motions(&row.name));
        } else {
            // The configuration satisfies it, or leaves it to repeat other rows.
            overlapping |= among_carriers;
        }
    }
    let gradients: Vec<Vec<Expr>> = found.iter().map(|row| row.gradient.clone()).collect();
    let order: Vec<usize> = (0..found.len()).collect();
    let keep = independent(&system.graph, &gradients, &order);
    if keep.len() < found.len() {
        overlapping = true;
        let repeated = order.iter().filter(|i| !keep.contains(i)).map(|i| &found[*i]);
        let basis: Vec<&StateRow> = keep.iter().map(|i| &found[*i]).collect();
        check_repeated(system, simplifier, &basis, repeated, configured, |p| &rows[kept[p]], errors);
    }
    if !errors.is_empty() {
        return None;
    }
    let mut position = 0..found.len();
    found.retain(|_| position.next().is_some_and(|i| keep.contains(&i)));
    Some(Bound { overlapping, ..solved(&mut system.graph, simplifier, &found, tangent) })
}

/// C̃ and c̃0 of a row, and whether it binds the carriers.
fn in_state(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    row: &DifferentiatedRow,
    carriers: &Carriers,
    tangent: &Tangent,
) -> (bool, Vec<Expr>, Expr) {
    let mut parts = row.gradient.clone();
    parts.push(row.bias);
    let mut gradient = to_state(graph, carriers, tangent, &parts);
    let own = gradient.pop().unwrap_or(graph.zero());
    let mut terms = vec![own];
    if let Some(partial) = &carriers.partial_velocities {
        let first = to_state(graph, carriers, tangent, &carriers.bias);
        terms.extend(gradient.iter().zip(first).map(|(c, a)| graph.mul(*c, a)).collect::<Vec<_>>());
        gradient = partial.transpose().mul_vec(graph, &gradient);
    }
    let binds = gradient.iter().any(|e| !graph.vanishes(*e));
    terms.extend(gradient.iter().zip(&tangent.bias).map(|(c, a)| graph.mul(*c, *a)).collect::<Vec<_>>());
    let bias = graph.sum(&terms);
    let reduced = tangent.complement.mul_vec(graph, &gradient);
    let reduced =
        reduced.into_iter().map(|e| if graph.vanishes(e) { graph.zero() } else { simplifier.one(graph, e) }).collect();
    (binds, reduced, simplifier.one(graph, bias))
}

/// Rows that repeat others on the motions: an error, unless it is the configuration's doing and they say the same.
fn check_repeated<'a>(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    basis: &[&StateRow],
    repeated: impl Iterator<Item = &'a StateRow>,
    configured: bool,
    declared: impl Fn(usize) -> &'a DifferentiatedRow,
    errors: &mut Diagnostics,
) {
    let width = basis.first().map_or(0, |row| row.gradient.len());
    let c = Matrix::from_rows(basis.iter().map(|row| row.gradient.clone()).collect(), width);
    system.graph.without_new_assumptions(|graph| {
        let choice = Choice { columns: vec![true; width], new_guards: true };
        let Ok(elimination) = eliminate(graph, simplifier, &c, &choice) else { return };
        for row in repeated {
            let coefficients = combination(graph, simplifier, &elimination, &row.gradient);
            let terms: Vec<Expr> = coefficients.iter().zip(basis).map(|(c, other)| graph.mul(*c, other.bias)).collect();
            let total = graph.sum(&terms);
            let excess = graph.sub(row.bias, total);
            let DifferentiatedRow { name, span, .. } = declared(row.row);
            if !graph.vanishes(excess) {
                let excess = simplifier.one(graph, excess);
                errors.report(*span, messages::excluded_on_motions(name, &graph.display(excess)));
            } else if !configured {
                errors.report(*span, messages::dependent_on_motions(name));
            }
        }
    });
}

/// u̇ = D3ᵀ ν + a_3 of independent rows.
fn solved(graph: &mut Graph, simplifier: &mut dyn Simplifier, found: &[StateRow], tangent: &Tangent) -> Bound {
    let width = tangent.speeds.len();
    let gradients = Matrix::from_rows(found.iter().map(|row| row.gradient.clone()).collect(), width);
    let bias: Vec<Expr> = found.iter().map(|row| row.bias).collect();
    let none = Bound {
        rows: found.iter().map(|row| row.row).collect(),
        gradients,
        bias,
        speeds: tangent.speeds.clone(),
        complement: Matrix::identity(graph, width),
        offset: vec![graph.zero(); width],
        elimination: None,
        unguarded: false,
        overlapping: false,
    };
    if found.is_empty() {
        return none;
    }
    let choice = |new_guards| Choice { columns: vec![true; width], new_guards };
    let (elimination, unguarded) = match eliminate(graph, simplifier, &none.gradients, &choice(false)) {
        Ok(elimination) => (Some(elimination), false),
        Err(_) => {
            let eliminated = graph
                .without_new_assumptions(|graph| eliminate(graph, simplifier, &none.gradients, &choice(true)).ok());
            (eliminated, true)
        }
    };
    let Some(elimination) = elimination else { return none };
    let free: Vec<usize> = (0..width).filter(|j| !elimination.pivots.contains(j)).collect();
    let mut complement = Matrix::zeros(graph, free.len(), width);
    for (i, j) in free.iter().enumerate() {
        complement.set(i, *j, graph.one());
        for (row, pivot) in elimination.pivots.iter().enumerate() {
            let entry = graph.neg(elimination.reduced.get(row, *j));
            complement.set(i, *pivot, entry);
        }
    }
    let mut offset = none.offset.clone();
    for (pivot, value) in elimination.pivots.iter().zip(elimination.solve(graph, simplifier, &none.bias)) {
        let value = graph.neg(value);
        offset[*pivot] = simplifier.one(graph, value);
    }
    let speeds = free.iter().map(|j| tangent.speeds[*j]).collect();
    Bound { speeds, complement, offset, elimination: Some(elimination), unguarded, ..none }
}

/// The state class, told to a person.
pub fn notes(
    graph: &Graph,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    tangent: &Tangent,
    bound: &Bound,
) -> Vec<String> {
    let quoted = |linear: bool| {
        let names = kept.iter().map(|i| &rows[*i]).filter(|row| !row.binds_speeds() && row.linear == linear);
        names.map(|row| format!("`{}`", row.name)).collect::<Vec<_>>().join(", ")
    };
    let (given, nonlinear) = (quoted(true), quoted(false));
    if given.is_empty() && nonlinear.is_empty() {
        return Vec::new();
    }
    let mut why = Vec::new();
    if !nonlinear.is_empty() {
        why.push(format!(
            "{nonlinear} is not linear in the velocities, which it therefore binds as phi = 0 without being solved for them"
        ));
    }
    if !given.is_empty() {
        why.push(format!("{given} binds accelerations and no velocity"));
    }
    let names =
        |speeds: &[Symbol]| speeds.iter().map(|s| format!("`{}`", graph.name(*s))).collect::<Vec<_>>().join(", ");
    let mut notes = vec![format!("the state keeps the speeds {}: {}", names(&tangent.speeds), why.join("; "))];
    if let Some(elimination) = &bound.elimination {
        let pivots: Vec<String> = elimination.values.iter().map(|e| graph.display(*e)).collect();
        let mut note = format!(
            "M_d, h_u* and D stand for the rates of {}, chosen by the cheapest pivots: {}",
            if bound.speeds.is_empty() { "no speed".to_owned() } else { names(&bound.speeds) },
            pivots.join(", ")
        );
        if bound.unguarded {
            note.push_str("; the accelerations and reactions are found without these pivots, which may vanish");
        }
        notes.push(note);
    }
    notes
}
