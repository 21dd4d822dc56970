//! D as the user gives it.

use super::Simplifier;
use super::carriers::{CarriedRow, Carriers};
use super::constraints::DifferentiatedRow;
use super::dependence::independent;
use super::elimination::{Choice, eliminate};
use super::factorisation::factorise;
use super::messages;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Kind, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// D Cᵀ ≡ 0 decided, its rank checked, a_u by differentiation along the motion.
pub fn given(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carried: &[CarriedRow],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> Option<Tangent> {
    let declared = system.complement.clone()?;
    let graph = &mut system.graph;
    let width = carriers.speeds.len();
    let span = system.places.complement;
    for d in &declared {
        for row in carried {
            let terms: Vec<Expr> = d.entries.iter().zip(&row.gradient).map(|(a, b)| graph.mul(*a, *b)).collect();
            let product = graph.sum(&terms);
            if !graph.vanishes(product) {
                let product = simplifier.one(graph, product);
                let text = graph.display(product);
                errors.report(d.span, messages::not_a_complement(&d.name, &rows[kept[row.row]].name, &text));
            }
        }
    }
    if declared.len() + carried.len() != width {
        errors.report(span, messages::wrong_number_complement(declared.len(), width, carried.len()));
    }
    let entries: Vec<Vec<Expr>> = declared.iter().map(|row| row.entries.clone()).collect();
    let order: Vec<usize> = (0..declared.len()).collect();
    let independent = independent(graph, &entries, &order);
    for i in order.iter().filter(|i| !independent.contains(i)) {
        errors.report(declared[*i].span, messages::complement_dependent(&declared[*i].name));
    }
    if !errors.is_empty() {
        return None;
    }
    let speeds: Vec<Symbol> = declared.iter().map(|row| graph.symbol(&row.name, Kind::Speed)).collect();
    let complement = Matrix::from_rows(entries, width);
    let u = graph.vars(&speeds);
    let mut w = complement.transpose().mul_vec(graph, &u);
    let mut pivots = Vec::new();
    if !carried.iter().all(|row| graph.vanishes(row.offset)) {
        let (particular, divisors) = particular(graph, simplifier, carried, width);
        pivots = divisors;
        let particular = beside_named(graph, carriers, &speeds, &complement, particular);
        w.iter_mut().zip(particular).for_each(|(w, p)| *w = graph.add(*w, p));
    }
    let map: Vec<(Symbol, Expr)> = carriers.speeds.iter().copied().zip(w.iter().copied()).collect();
    let rates: Vec<Expr> = carriers.motion.iter().map(|(_, rate)| *rate).collect();
    let rates = graph.substitute(&rates, &map);
    let motion: Vec<(Symbol, Expr)> = carriers.motion.iter().map(|(s, _)| *s).zip(rates).collect();
    let bias = graph.along(&w, &motion);
    let bias = bias.into_iter().map(|e| simplifier.one(graph, e)).collect();
    let gradients = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let rows = carried.iter().map(|row| row.row).collect();
    Some(Tangent {
        speeds,
        complement,
        map,
        bias,
        rows,
        gradients,
        elimination: None,
        readings: None,
        pivots,
        note: None,
    })
}

/// The particular solution that leaves alone the carriers whose names rows of D have: D's columns for these are unit
/// vectors, and with w_p = 0 there each is the speed that it is called.
fn beside_named(
    graph: &mut Graph,
    carriers: &Carriers,
    speeds: &[Symbol],
    complement: &Matrix,
    mut particular: Vec<Expr>,
) -> Vec<Expr> {
    for (i, speed) in speeds.iter().enumerate() {
        let column = carriers.speeds.iter().position(|w| graph.name(*w) == graph.name(*speed));
        let Some(part) = column.map(|j| particular[j]).filter(|part| !graph.is_zero(*part)) else { continue };
        for (j, entry) in complement.row(i).iter().enumerate() {
            let moved = graph.mul(*entry, part);
            particular[j] = graph.sub(particular[j], moved);
        }
    }
    particular
}

/// A particular solution of C v_p = -η, and what it divides by: with the pivots of C where they need no new guard, else
/// the one of least norm, -Cᵀ (C Cᵀ)⁻¹ η, which is regular wherever the rows are independent.
fn particular(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    carried: &[CarriedRow],
    width: usize,
) -> (Vec<Expr>, Vec<Expr>) {
    let c = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let offsets: Vec<Expr> = carried.iter().map(|row| graph.neg(row.offset)).collect();
    let mut solution = vec![graph.zero(); width];
    let choice = Choice { columns: vec![true; width], new_guards: false };
    if let Ok(elimination) = eliminate(graph, simplifier, &c, &choice) {
        let at_pivots = elimination.solve(graph, simplifier, &offsets);
        elimination.pivots.iter().zip(at_pivots).for_each(|(j, value)| solution[*j] = value);
        return (solution, Vec::new());
    }
    let transposed = c.transpose();
    let normal = c.mul(graph, &transposed).map(|e| e.iter().map(|e| simplifier.one(graph, *e)).collect());
    match factorise(graph, simplifier, &normal) {
        Ok(factors) => {
            let weights = factors.solve(graph, simplifier, &offsets);
            (transposed.mul_vec(graph, &weights), factors.pivots)
        }
        // Independent rows have a regular C Cᵀ; as a value, the zero pivot stops every run.
        Err(_) => (solution, vec![graph.zero()]),
    }
}
