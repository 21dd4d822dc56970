//! The choice of independent speeds, judged at the start that the model names.
//!
//! A choice is made from the declarations alone, because it names the fields of the state. Where `start` and `nominal`
//! give numbers for everything that a figure depends on, it is judged there, once the start is closed: rows that depend on each
//! other there and pivots that vanish there are errors. What is no error is told as a figure: the relative pivot of a chart,
//! |det [C; L]| over the volumes of the rows of C and of L. It is one where the independent speeds are at right angles to all
//! that the constraints bind, and zero where they do not determine the others. The numbers never enter the equations.

use super::carriers::{CarriedRow, Carriers};
use super::constraints::DifferentiatedRow;
use super::offer::offer;
use super::overconstrained::{BESIDE, repeat};
use super::start::{Start, dot};
use super::tangent::Tangent;
use super::{Simplifier, messages};
use crate::model::InitialSystem;
use crate::symbolic::{Assumptions, Expr, Graph};
use crate::syntax::Diagnostics;

/// Below this fraction of its terms a figure is zero.
pub const VANISHES: f64 = 1e-9;

/// Rows of which less than this is left beside the others depend on them. Where they do so at a point, Newton's method reaches
/// the point to half of the digits.
pub const DEPENDS: f64 = 1e-6;

/// What a choice of speeds is judged by.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// All rows.
    pub rows: &'a [DifferentiatedRow],
    /// Those that are independent.
    pub kept: &'a [usize],
    /// Of these the ones that bind the carriers.
    pub carried: &'a [CarriedRow],
    /// What independent speeds are chosen among.
    pub carriers: &'a Carriers,
}

/// Judges the start itself, the rows at it, and the pivots of the tangent basis at it; gives the start, closed.
///
/// Other speeds are tried with what was assumed `before` these were; nothing is left of them but what the arena has grown by,
/// and that only where there is an error.
pub fn judge(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    judged: Judged<'_>,
    tangent: &Tangent,
    before: &Assumptions,
    errors: &mut Diagnostics,
) -> Start {
    let Judged { rows, kept, carried, carriers } = judged;
    let mut start = Start::of(system);
    if let Err(open) = start.close(system, rows, carriers) {
        let open: Vec<(&str, f64)> = open.iter().map(|(row, rest)| (rows[*row].name.as_str(), *rest)).collect();
        errors.report(system.places.start, messages::start_not_closed(&open));
        return start;
    }
    let graph = &system.graph;
    let gradients: Vec<Option<Vec<f64>>> = carried.iter().map(|row| numbers(&start, graph, &row.gradient)).collect();
    let gradients: Option<Vec<Vec<f64>>> = gradients.into_iter().collect();
    if let Some(gradients) = &gradients
        && let Some((row, weights)) = dependence(gradients)
    {
        let name = |at: usize| rows[kept[carried[at].row]].name.as_str();
        let parts: Vec<(&str, f64)> = weights.iter().map(|(at, weight)| (name(*at), *weight)).collect();
        let dependent = kept[carried[row].row];
        let everywhere =
            carriers.partial_velocities.is_none() && repeat(system, rows, carriers, &start, (kept, &[dependent]));
        let message = if everywhere { messages::overconstrained } else { messages::dependent_at_start };
        errors.report(rows[dependent].span, message(name(row), &parts));
        return start;
    }
    let Some((pivot, column)) = vanishing(system, judged, &start, tangent) else { return start };
    let place = match system.independent.first() {
        Some(choice) => choice.span,
        None => tangent.rows.first().map_or(system.places.model, |row| rows[*row].span),
    };
    let (text, name) = (graph.display(pivot), graph.name(carriers.speeds[column]).to_owned());
    let by_user = !system.independent.is_empty();
    let offer = offer(system, simplifier, judged, &start, gradients, before);
    errors.report(place, messages::singular_at_start(&text, &name, by_user, offer.as_deref()));
    start
}

/// The pivot that vanishes at the start, and the speed that does not follow from it.
///
/// A chart that is none at the start has one. Of any other chart a pivot may be small among its terms alone.
pub fn vanishing(
    system: &InitialSystem,
    judged: Judged<'_>,
    start: &Start,
    tangent: &Tangent,
) -> Option<(Expr, usize)> {
    let elimination = tangent.elimination.as_ref()?;
    let relative = relative_pivot(system, start, judged.carried, judged.carriers, (0, tangent));
    let regular = relative.is_none_or(|relative| relative > VANISHES);
    let graph = &system.graph;
    let known = elimination.values.iter().zip(&elimination.pivots).filter(|(pivot, _)| start.knows(graph, **pivot));
    let vanishes = |pivot: Expr| {
        let (v, size) = start.value(graph, pivot);
        v.is_finite() && v.abs() <= VANISHES * size && !(regular && is_usual(system, start, (pivot, v)))
    };
    known.into_iter().find(|(pivot, _)| vanishes(**pivot)).map(|(pivot, column)| (*pivot, *column))
}

/// Whether the value of a pivot at the start is no smaller than beside it.
///
/// The terms of a pivot that other pivots stand in are larger, step by step, than what becomes of them: that it is small among these
/// tells nothing alone. It is compared where the loops are open: a pivot may vanish wherever they are closed, and rounding alone be
/// compared with rounding there.
fn is_usual(system: &InitialSystem, start: &Start, (pivot, value): (Expr, f64)) -> bool {
    let beside = (1..=BESIDE).map(|at| start.beside(system, at).value(&system.graph, pivot).0.abs());
    let largest = beside.fold(0.0, f64::max);
    largest.is_finite() && value.abs() > DEPENDS * largest
}

/// The relative pivot of a chart at the start; `None` where the start does not tell, or where nothing was chosen.
pub fn relative_pivot(
    system: &InitialSystem,
    start: &Start,
    carried: &[CarriedRow],
    carriers: &Carriers,
    (chart, tangent): (usize, &Tangent),
) -> Option<f64> {
    tangent.elimination.as_ref()?;
    if system.start.is_empty() {
        return None;
    }
    let row = |gradient: &[Expr]| numbers(start, &system.graph, gradient);
    let c: Vec<Vec<f64>> = carried.iter().map(|carried| row(&carried.gradient)).collect::<Option<_>>()?;
    let l: Vec<Vec<f64>> = match (&tangent.readings, system.independent.get(chart)) {
        (Some(_), Some(choice)) => choice.speeds.iter().map(|speed| row(&speed.gradient)).collect::<Option<_>>()?,
        _ => {
            let unit = |speed| carriers.speeds.iter().map(|w| f64::from(u8::from(w == speed))).collect();
            tangent.speeds.iter().map(unit).collect()
        }
    };
    let (beside, alone) = (remainders(&[c.clone(), l.clone()].concat()), remainders(&l));
    let relative = beside[c.len()..].iter().product::<f64>() / alone.iter().product::<f64>();
    relative.is_finite().then(|| rounded(relative.min(1.0)))
}

/// The figure of a guard at the start, where all that it depends on has a value.
pub fn figure(start: &Start, graph: &Graph, e: Expr) -> Option<f64> {
    let known = start.knows(graph, e).then(|| start.value(graph, e).0)?;
    known.is_finite().then(|| rounded(known))
}

/// Three digits: what is told must not depend on the machine that tells it.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// The values of expressions, zero where they vanish among their terms; `None` where one is not known.
pub fn numbers(start: &Start, graph: &Graph, entries: &[Expr]) -> Option<Vec<f64>> {
    let number = |e: &Expr| {
        let (value, size) = start.knows(graph, *e).then(|| start.value(graph, *e))?;
        let zero = value.abs() <= VANISHES * size;
        value.is_finite().then_some(if zero { 0.0 } else { value })
    };
    entries.iter().map(number).collect()
}

/// What is left of the length of each row beside the rows before it.
fn remainders(rows: &[Vec<f64>]) -> Vec<f64> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut left = Vec::new();
    for row in rows {
        let mut rest = row.clone();
        for _ in 0..2 {
            for direction in &basis {
                let along = dot(&rest, direction);
                rest.iter_mut().zip(direction).for_each(|(r, d)| *r -= along * d);
            }
        }
        let length = dot(&rest, &rest).sqrt();
        left.push(length);
        if length > 0.0 {
            basis.push(rest.iter().map(|r| r / length).collect());
        }
    }
    left
}

/// The first row that depends on those before it, with its weights over them.
fn dependence(rows: &[Vec<f64>]) -> Option<(usize, Vec<(usize, f64)>)> {
    // Orthonormal directions, each with its weights over the rows.
    let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
    for (at, row) in rows.iter().enumerate() {
        let whole = dot(row, row).sqrt();
        let (mut rest, mut weights) = (row.clone(), vec![0.0; rows.len()]);
        weights[at] = 1.0;
        for _ in 0..2 {
            for (direction, of) in &basis {
                let along = dot(&rest, direction);
                rest.iter_mut().zip(direction).for_each(|(r, d)| *r -= along * d);
                weights.iter_mut().zip(of).for_each(|(w, o)| *w -= along * o);
            }
        }
        let length = dot(&rest, &rest).sqrt();
        if length <= DEPENDS * whole {
            // rest = row + Σ weights·rows = 0.
            let size = |j: usize| dot(&rows[j], &rows[j]).sqrt();
            let parts = (0..at).map(|j| (j, -weights[j])).filter(|(j, w)| w.abs() * size(*j) > DEPENDS * whole);
            return Some((at, parts.collect()));
        }
        basis.push((rest.iter().map(|r| r / length).collect(), weights.iter().map(|w| w / length).collect()));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dependent_row_is_told_by_the_rows_before_it() {
        let rows = [vec![1.0, 1.0, 0.0], vec![0.0, 2.0, 1.0], vec![3.0, -1.0, -2.0], vec![0.0, 0.0, 1.0]];
        let (row, weights) = dependence(&rows).expect("the third is 3 times the first less 2 times the second");
        assert_eq!(row, 2);
        let expected = [(0, 3.0), (1, -2.0)];
        let close = |(found, expected): (&(usize, f64), &(usize, f64))| {
            found.0 == expected.0 && (found.1 - expected.1).abs() < 1e-13
        };
        assert!(weights.len() == 2 && weights.iter().zip(&expected).all(close), "{weights:?}");
        assert!(dependence(&rows[1..]).is_none());
    }

    /// Whatever the lengths of the rows: a weight counts by what it adds to the row.
    #[test]
    fn dependence_does_not_depend_on_units() {
        let rows = [vec![1e6, 0.0, 0.0], vec![0.0, 1e-6, 0.0], vec![2e3, 3e3, 0.0]];
        let (row, weights) = dependence(&rows).expect("a combination");
        let expected = [(0, 2e-3), (1, 3e9)];
        let close = |(found, expected): (&(usize, f64), &(usize, f64))| {
            found.0 == expected.0 && (found.1 / expected.1 - 1.0).abs() < 1e-9
        };
        assert!(row == 2 && weights.len() == 2 && weights.iter().zip(&expected).all(close), "{weights:?}");
        // What is below the millionth part of the row takes no part; rows as short as that are independent.
        let (_, weights) = dependence(&[vec![1e3, 0.0], vec![0.0, 1e3], vec![1e3, 1e-5]]).expect("a combination");
        assert!(weights.len() == 1 && weights[0].0 == 0, "{weights:?}");
        assert!(dependence(&[vec![1e-8, 0.0], vec![1e-8, 1e-9]]).is_none());
        assert!(dependence(&[vec![1e8, 0.0], vec![1e8, 10.0]]).is_some());
        let nothing = dependence(&[vec![1e6, 0.0], vec![0.0, 0.0]]).expect("a row of zeros");
        assert_eq!(nothing, (1, Vec::new()));
    }

    #[test]
    fn a_row_that_depends_on_others_leaves_nothing_and_hides_nothing() {
        let left = remainders(&[vec![1.0, 0.0, 0.0], vec![2.0, 0.0, 0.0], vec![1.0, 3.0, 4.0]]);
        assert_eq!(left, [1.0, 0.0, 5.0]);
    }

    #[test]
    fn remainders_multiply_to_the_determinant() {
        let rows = [vec![2.0, 1.0, 0.0], vec![1.0, 3.0, 1.0], vec![0.0, 1.0, 4.0]];
        let volume: f64 = remainders(&rows).iter().product();
        assert!((volume - 18.0).abs() < 1e-13);
    }
}
