//! The choice of independent speeds, judged at the start that the model names.
//!
//! A choice is made from the declarations alone, because it names the fields of the state. Where `start` and `nominal`
//! give numbers for everything that a pivot depends on, a pivot that vanishes there is an error with the line that
//! mends it. The numbers never enter the equations.

use super::carriers::Carriers;
use super::constraints::DifferentiatedRow;
use super::messages;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Diagnostics;

/// Below this fraction of its terms a figure is zero.
const VANISHES: f64 = 1e-9;

/// Reports the first pivot of the tangent basis that vanishes at the start.
pub fn judge(
    system: &InitialSystem,
    rows: &[DifferentiatedRow],
    carriers: &Carriers,
    tangent: &Tangent,
    errors: &mut Diagnostics,
) {
    let Some(elimination) = &tangent.elimination else { return };
    let graph = &system.graph;
    let known = |s: Symbol| {
        let given = system.start.iter().chain(&system.nominal).find(|(symbol, _)| *symbol == s).map(|(_, v)| *v);
        given.or((s == system.time).then_some(0.0)).or((s == graph.pi_symbol()).then_some(std::f64::consts::PI))
    };
    let all_known =
        |e: Expr| graph.symbols_of(&[e]).into_iter().all(|s| known(s).is_some()) && graph.given_in(&[e]).is_empty();
    let value = |e: Expr| graph.evaluate_scaled(&[e], &|s| known(s).unwrap_or(f64::NAN))[0];
    for (pivot, column) in elimination.values.iter().zip(&elimination.pivots) {
        if graph.as_number(*pivot).is_some() || !all_known(*pivot) {
            continue;
        }
        let (v, size) = value(*pivot);
        if !v.is_finite() || v.abs() > VANISHES * size {
            continue;
        }
        let better = tangent.gradients.entries().iter().all(|e| all_known(*e)).then(|| {
            let entry = |i: usize, j: usize| value(tangent.gradients.get(i, j)).0;
            let numbers = (0..tangent.gradients.rows())
                .map(|i| (0..tangent.gradients.columns()).map(|j| entry(i, j)).collect())
                .collect();
            line(system, carriers, numbers)
        });
        let place = match system.independent.first() {
            Some(choice) => choice.span,
            None => tangent.rows.first().map_or(system.places.model, |row| rows[*row].span),
        };
        let (text, name) = (graph.display(*pivot), graph.name(carriers.speeds[*column]));
        let by_user = !system.independent.is_empty();
        errors.report(place, messages::singular_at_start(&text, name, by_user, better.flatten().as_deref()));
        return;
    }
}

/// The `independent` statement that full pivoting finds; `None` where the rows are dependent.
fn line(system: &InitialSystem, carriers: &Carriers, mut c: Vec<Vec<f64>>) -> Option<String> {
    let width = carriers.speeds.len();
    let largest = c.iter().flatten().fold(0.0_f64, |a, b| a.max(b.abs()));
    let (mut open, mut dependent): (Vec<usize>, Vec<usize>) = ((0..c.len()).collect(), Vec::new());
    while !open.is_empty() {
        let places = open.iter().flat_map(|i| (0..width).map(move |j| (*i, j)));
        let free = places.filter(|(_, j)| !dependent.contains(j));
        let (row, column) = free.max_by(|a, b| c[a.0][a.1].abs().total_cmp(&c[b.0][b.1].abs()))?;
        let pivot = c[row][column];
        if pivot.abs() <= VANISHES * largest {
            return None;
        }
        open.retain(|i| *i != row);
        dependent.push(column);
        let pivot_row = c[row].clone();
        for i in &open {
            let factor = c[*i][column] / pivot;
            c[*i].iter_mut().zip(&pivot_row).for_each(|(a, b)| *a -= factor * b);
        }
    }
    let written = (0..width).filter(|j| !dependent.contains(j)).map(|j| {
        let name = system.graph.name(carriers.speeds[j]);
        name.strip_prefix("dot_").map_or_else(|| name.to_owned(), |q| format!("dot({q})"))
    });
    Some(format!("#[independent({})]", written.collect::<Vec<_>>().join(", ")))
}
