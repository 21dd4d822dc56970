//! M and h* of (2.3), M from the kinetic energy too.

use proc_macro2::Span;

use super::context::Context;
use super::linear;
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Matrix, Symbol};
use crate::syntax::{Diagnostics, Expression, Inertia, InertiaEntry, InertiaForm, List, messages};

/// M; `None` where something was reported.
pub(super) fn inertia(
    inertia: &Inertia,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Matrix> {
    matrix(inertia, (vocabulary.coordinates.len(), "speed", "speeds"), Context::INERTIA, vocabulary, diagnostics)
}

/// A symmetric n x n matrix as written; `expected` is n, and what there are n of.
pub(super) fn matrix(
    inertia: &Inertia,
    expected: (usize, &str, &str),
    context: Context,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Matrix> {
    let n = expected.0;
    match &inertia.form {
        InertiaForm::Diagonal(entries) => {
            let fits = fits("inertia", entries.len(), expected, inertia.span, diagnostics);
            let entries: Vec<Option<Expr>> = entries
                .iter()
                .map(|entry| vocabulary.lower(entry, context, diagnostics).map(|lowered| lowered.expr))
                .collect();
            let entries: Vec<Expr> = entries.into_iter().collect::<Option<_>>()?;
            let zero = vocabulary.graph.zero();
            fits.then(|| Matrix::from_fn(n, n, |i, j| if i == j { entries[i] } else { zero }))
        }
        InertiaForm::Matrix(rows) => {
            let mut sound = fits("inertia", rows.len(), expected, inertia.span, diagnostics);
            let mut lowered: Vec<Vec<Entry>> = Vec::new();
            for row in rows {
                sound &= fits("this row of `inertia`", row.entries.len(), expected, row.span, diagnostics);
                let entries = row.entries.iter();
                lowered.push(
                    entries
                        .map(|entry| match entry {
                            InertiaEntry::Symmetric(span) => Entry::Symmetric(*span),
                            InertiaEntry::Given(given) => match vocabulary.lower(given, context, diagnostics) {
                                Some(value) => Entry::Given(value.expr, given.place()),
                                None => Entry::Refused,
                            },
                        })
                        .collect(),
                );
            }
            sound.then(|| symmetric(&lowered, vocabulary, diagnostics))?
        }
    }
}

/// An entry of M as far as it is known.
#[derive(Clone, Copy)]
enum Entry {
    Given(Expr, crate::syntax::Place),
    Symmetric(Span),
    Refused,
}

/// Fills in what follows by symmetry, and checks the rest.
fn symmetric(entries: &[Vec<Entry>], vocabulary: &Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Matrix> {
    let graph = &vocabulary.graph;
    let n = entries.len();
    let mut matrix = Matrix::zeros(graph, n, n);
    let mut sound = true;
    for (i, j) in (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        let value = match (entries[i][j], entries[j][i]) {
            (Entry::Refused, _) | (_, Entry::Refused) => None,
            (Entry::Symmetric(span), Entry::Symmetric(_)) => {
                let message = if i == j { messages::underscore_on_diagonal() } else { messages::underscore_twice() };
                diagnostics.report(span, message);
                None
            }
            (Entry::Given(value, _), Entry::Symmetric(_)) | (Entry::Symmetric(_), Entry::Given(value, _)) => {
                Some(value)
            }
            (Entry::Given(below, place), Entry::Given(above, _)) => {
                if graph.identical(below, above) {
                    Some(above)
                } else {
                    let (row, column) = (j + 1, i + 1);
                    let (above, below) = (graph.display(above), graph.display(below));
                    diagnostics.report(place, messages::not_symmetric(row, column, above, below));
                    None
                }
            }
        };
        match value {
            Some(value) => {
                matrix.set(i, j, value);
                matrix.set(j, i, value);
            }
            None => sound = false,
        }
    }
    sound.then_some(matrix)
}

/// M = ∂²T/∂v²; `None` where that is not free of v.
pub(super) fn second_derivative(
    kinetic: Expr,
    written: &Expression,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Matrix> {
    let speeds = vocabulary.speeds.clone();
    let graph = &mut vocabulary.graph;
    let momenta = graph.jacobian(&[kinetic], &speeds);
    match linear::split(graph, momenta.row(0), &speeds) {
        Ok(split) => {
            let n = speeds.len();
            let zero = graph.zero();
            let entry = |i: usize, j: usize| split.coefficients.get(i.min(j), i.max(j));
            let matrix = Matrix::from_fn(n, n, |i, j| if graph.vanishes(entry(i, j)) { zero } else { entry(i, j) });
            let moves = matrix.entries().iter().any(|entry| *entry != zero);
            if !moves {
                diagnostics.report(written.place(), messages::kinetic_without_speed());
            }
            moves.then_some(matrix)
        }
        Err(refused) => {
            // One says it all: the others are its relatives by symmetry.
            if let Some(nonlinear) = refused.first() {
                // Speeds without names are written as rates.
                let name = |symbol: Symbol| match graph.name(symbol).strip_prefix("dot_") {
                    Some(of) if vocabulary.declarations.speeds.is_none() => format!("dot({of})"),
                    _ => graph.name(symbol).to_owned(),
                };
                let (row, column) = (name(speeds[nonlinear.row]), name(nonlinear.variable));
                let derivative = graph.display(nonlinear.derivative);
                diagnostics.report(written.place(), messages::kinetic_not_quadratic(row, column, derivative));
            }
            None
        }
    }
}

/// Reports every entry on which the inertia as written and that of the kinetic energy differ.
pub(super) fn compare(given: &Matrix, found: &Matrix, vocabulary: &Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    let Some(statement) = &vocabulary.declarations.inertia else { return };
    let graph = &vocabulary.graph;
    for (i, j) in (0..given.rows()).flat_map(|i| (i..given.rows()).map(move |j| (i, j))) {
        let (given, found) = (given.get(i, j), found.get(i, j));
        if !graph.identical(given, found) {
            let (given, found) = (graph.display(given), graph.display(found));
            diagnostics.report(statement.span, messages::inertia_differs(i + 1, j + 1, given, found));
        }
    }
}

/// h*, with rates still as written.
pub(super) fn forces(
    forces: &List,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Expr>> {
    let expected = (vocabulary.coordinates.len(), "speed", "speeds");
    let fits = fits("forces", forces.entries.len(), expected, forces.span, diagnostics);
    let entries: Vec<Option<Expr>> = forces
        .entries
        .iter()
        .map(|entry| vocabulary.lower(entry, Context::FORCES, diagnostics).map(|lowered| lowered.expr))
        .collect();
    let entries = entries.into_iter().collect::<Option<_>>()?;
    fits.then_some(entries)
}

fn fits(what: &str, found: usize, expected: (usize, &str, &str), span: Span, diagnostics: &mut Diagnostics) -> bool {
    let (number, one, many) = expected;
    if found != number {
        let what = if what.contains(' ') { what.to_owned() } else { format!("`{what}`") };
        diagnostics.report(
            span,
            messages::wrong_length(
                what,
                messages::counted(found, "entry", "entries"),
                messages::counted(number, one, many),
            ),
        );
    }
    found == number
}
