//! A cheap canonical form of one expression.

use super::angles::fold;
use super::cost::{cost, total};
use super::expand::{Angle, Atoms, Depth, Square, angles, expand, reduce, spheres};
use super::factor::{Style, write};
use super::fraction::{Fraction, Sums};
use super::limits::{MODEL_WORK, NUMERATOR_FORMS};
use super::polynomial::{Monomial, Polynomial, Work};
use crate::symbolic::{Expr, Graph, Node};
use std::collections::BTreeSet;

/// A cheap form of the expression, identical to it: quotients divided out, sin² + cos² = 1 used, factored.
///
/// Meant for the steps of an elimination, where what cancels must cancel at once. The expression comes back as it is
/// where no form within the limits is cheaper.
pub fn normalise(graph: &mut Graph, e: Expr) -> Expr {
    normalise_within(graph, e, &mut { MODEL_WORK })
}

/// [`normalise`] out of the work that a model has left.
pub fn normalise_within(graph: &mut Graph, e: Expr, left: &mut usize) -> Expr {
    if *left == 0 || !matches!(graph.node(e), Node::Sum { .. } | Node::Product(_)) {
        return e;
    }
    let mut best = (rank(graph, e), e);
    for depth in [Depth::Full, Depth::Running] {
        let Some((found, atoms)) = forms(graph, e, depth, left) else { continue };
        let mut chosen = false;
        for form in found {
            let rank = rank(graph, form);
            if rank < best.0 && graph.proven(form, e) {
                best = (rank, form);
                chosen = true;
            }
        }
        if chosen {
            atoms.record(graph);
        }
        break;
    }
    best.1
}

/// Run-time work first, then all work: a simpler coefficient is better though it is free.
pub(super) fn rank(graph: &Graph, e: Expr) -> (usize, usize) {
    (cost(graph, &[e]).weight(), total(graph, &[e]))
}

/// Forms of an expression that are worth comparing; `None` beyond the limits.
pub(super) fn forms(graph: &mut Graph, e: Expr, depth: Depth, left: &mut usize) -> Option<(Vec<Expr>, Atoms)> {
    let mut work = Work::out_of(*left);
    let before = work.left();
    let found = forms_within(graph, e, depth, &mut work);
    *left -= before - work.left();
    found
}

fn forms_within(graph: &mut Graph, e: Expr, depth: Depth, work: &mut Work) -> Option<(Vec<Expr>, Atoms)> {
    let (mut atoms, mut sums) = (Atoms::default(), Sums::default());
    let polynomial = expand(graph, e, depth, &mut atoms, work)?;
    let mut fraction = Fraction::of(graph, polynomial, depth, &mut atoms, &mut sums, work)?;
    let turns = angles(graph, &mut atoms);
    let balls = spheres(graph, &mut atoms);
    fraction.cancel(graph, depth, &mut atoms, &mut sums, (&turns, &balls), work)?;
    let mut out: Vec<Expr> = Vec::new();
    let styles: &[Style] = match fraction.denominator.keys().any(|a| atoms.runs(*a)) {
        true => &[Style::Split, Style::Joint],
        false => &[Style::Split],
    };
    let mut numerators = variants(&fraction.numerator, &squares(&turns, &balls), &atoms, work);
    if turns.len() > 1
        && let Some(folded) = fold(graph, &fraction.numerator, &turns, &mut atoms)
    {
        let more = angles(graph, &mut atoms);
        let shortest = variants(&folded, &squares(&more, &balls), &atoms, work).swap_remove(0);
        numerators.push(shortest);
    }
    for numerator in numerators {
        let fraction = Fraction { numerator, denominator: fraction.denominator.clone() };
        for style in styles {
            if let Some(form) = write(graph, &fraction, *style, &atoms, &sums, work)
                && !out.contains(&form)
            {
                out.push(form);
            }
        }
    }
    Some((out, atoms))
}

/// The squares that may be written by others, angle by angle and quaternion by quaternion.
fn squares(angles: &[Angle], spheres: &[Vec<Square>]) -> Vec<Vec<Square>> {
    let of_angles = angles.iter().map(|angle| vec![angle.sin_square(), angle.cos_square()]);
    of_angles.chain(spheres.iter().cloned()).collect()
}

/// The forms of a numerator under sin² + cos² = 1, and where the four squares of a unit quaternion add up to one: as it is, and with
/// the shorter choice for every one of them in turn.
fn variants(numerator: &Polynomial, choices: &[Vec<Square>], atoms: &Atoms, work: &mut Work) -> Vec<Polynomial> {
    let mut all = vec![numerator.clone()];
    let mut shortest = numerator.clone();
    let mut least = None;
    // One choice may open another, so they are gone through again while something changes.
    for _ in 0..choices.len() {
        let before = all.len();
        for squares in choices {
            for square in squares {
                if !square.applies(&shortest) {
                    continue;
                }
                let Some(form) = reduce(&shortest, square, work) else { continue };
                let (new, old) = (length(&form, atoms), least.unwrap_or_else(|| length(&shortest, atoms)));
                least = Some(new.min(old));
                if new < old {
                    all.push(std::mem::replace(&mut shortest, form));
                } else if choices.len() == 1 {
                    all.push(form);
                }
            }
        }
        if all.len() == before {
            break;
        }
    }
    let mut distinct = vec![shortest];
    for polynomial in all {
        if !distinct.contains(&polynomial) {
            distinct.push(polynomial);
        }
    }
    distinct.truncate(NUMERATOR_FORMS);
    distinct
}

/// Terms with coefficients collected, their factors, and terms in all.
fn length(polynomial: &Polynomial, atoms: &Atoms) -> (usize, usize, usize) {
    let running: BTreeSet<Monomial> = polynomial
        .0
        .keys()
        .map(|m| Monomial(m.0.iter().filter(|(atom, _)| atoms.runs(*atom)).copied().collect()))
        .collect();
    (running.len(), running.iter().map(Monomial::degree).sum(), polynomial.len())
}
