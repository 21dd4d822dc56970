//! The kinematics of joints: the rates of coordinates as they are, and frames by quaternions with ė = A (ω, σ).

use super::context::Context;
use super::kinematics::{Subject, directions};
use super::names::Meaning;
use super::system::Kinematics;
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::{self, Diagnostics, Quantity, Speed, messages};

/// ẋ = A w and its inverse, for w the rates of coordinates, angular velocities of quaternions' frames and rates of norms.
pub(super) fn of_joints(kinds: &[Speed], vocabulary: &mut Vocabulary<'_>) -> (Matrix, Matrix) {
    let n = vocabulary.coordinates.len();
    let graph = &mut vocabulary.graph;
    let (mut a, mut b) = (Matrix::zeros(graph, n, n), Matrix::zeros(graph, n, n));
    let place = |wanted: Speed| kinds.iter().position(|speed| *speed == wanted).unwrap_or_default();
    for (column, speed) in kinds.iter().enumerate() {
        match speed {
            Speed::Rate(row) => {
                a.set(*row, column, graph.one());
                b.set(column, *row, graph.one());
            }
            Speed::Norm(at) => {
                let omega = std::array::from_fn(|axis| place(Speed::Angular(*at, axis)));
                vocabulary.turnings[*at].enter((omega, column), &vocabulary.coordinates, graph, (&mut a, &mut b));
            }
            Speed::Angular(..) | Speed::Given(_) => {}
        }
    }
    (a, b)
}

/// The kinematics of named speeds where there are quaternions: (w, σ) = [A_u, 1] (u, σ) after ẋ = A (w, σ).
pub(super) fn beside_quaternions(
    written: &syntax::Kinematics,
    fits: bool,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Kinematics> {
    let by_rates: Vec<&Quantity> =
        written.entries.iter().map(|(left, _)| left).filter(|left| matches!(left, Quantity::Rate(..))).collect();
    if !by_rates.is_empty() {
        for left in by_rates {
            diagnostics.report(left.place(), messages::quaternion_kinematics(left.ident()));
        }
        return None;
    }
    let count = vocabulary.declarations.speeds.as_ref().map_or(0, |speeds| speeds.names.len());
    let mut kinds: Vec<Speed> = Vec::new();
    for place in 0..vocabulary.coordinates.len() {
        if !vocabulary.quaternions.iter().any(|quaternion| quaternion.coordinates.contains(&place)) {
            kinds.push(Speed::Rate(place));
        }
    }
    let quaternions = 0..vocabulary.quaternions.len();
    kinds.extend(quaternions.clone().flat_map(|at| (0..3).map(move |axis| Speed::Angular(at, axis))));
    let w: Vec<Symbol> = kinds
        .iter()
        .filter_map(|kind| match kind {
            Speed::Rate(place) => Some(vocabulary.rates[*place]),
            Speed::Angular(at, axis) => Some(vocabulary.turnings[*at].omega[*axis]),
            _ => None,
        })
        .collect();
    let mut adapt: Vec<(Symbol, Expr)> = Vec::new();
    for turning in vocabulary.turnings.clone() {
        let moved = turning.moved(&vocabulary.coordinates, &mut vocabulary.graph);
        adapt.extend(moved.map(|(place, rate)| (vocabulary.rates[place], rate)));
    }
    let subject = Subject {
        entries: &written.entries,
        span: written.span,
        speeds: vocabulary.speeds[..count].to_vec(),
        rates: w.clone(),
        meanings: ((0..count).map(Meaning::Speed).collect(), Vec::new()),
        contexts: (Context::SPEEDS, Context::RATES),
        adapt,
    };
    let inner = directions(&subject, fits, vocabulary, diagnostics)?;
    let (k, n) = (w.len(), vocabulary.coordinates.len());
    let u = vocabulary.graph.vars(&vocabulary.speeds[..k]);
    let moved = inner.a.mul_vec(&mut vocabulary.graph, &u);
    for ((symbol, moved), bias) in w.iter().zip(moved).zip(&inner.a0).skip(k - 3 * quaternions.len()) {
        let value = vocabulary.graph.add(moved, *bias);
        vocabulary.turned.push((*symbol, value));
    }
    kinds.extend(quaternions.map(Speed::Norm));
    let (outer, back) = of_joints(&kinds, vocabulary);
    let graph = &mut vocabulary.graph;
    let beside_norms = |matrix: &Matrix, graph: &Graph| {
        Matrix::from_fn(n, n, |i, j| match (i < k, j < k) {
            (true, true) => matrix.get(i, j),
            _ if i == j => graph.one(),
            _ => graph.zero(),
        })
    };
    let still = |bias: &[Expr], graph: &Graph| -> Vec<Expr> {
        bias.iter().copied().chain(std::iter::repeat_n(graph.zero(), n - k)).collect()
    };
    let (a, b) = (beside_norms(&inner.a, graph), beside_norms(&inner.b, graph));
    let (a0, b0) = (still(&inner.a0, graph), still(&inner.b0, graph));
    let a0 = outer.mul_vec(graph, &a0);
    Some(Kinematics { a: outer.mul(graph, &a), a0, b: b.mul(graph, &back), b0, pivots: inner.pivots })
}
