//! Inertias of bodies: matrices, and shapes from their measures.

use crate::model::context::Context;
use crate::model::dynamics;
use crate::model::functions::wrong_number_of_arguments;
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Rational, Rotation, Triple};
use crate::syntax::{AXES, BodyInertia, Diagnostics, Expression, Term, messages};

/// m (r² 1 - r rᵀ)
pub(super) fn point_tensor(graph: &mut Graph, mass: Expr, arm: &Triple) -> Rotation {
    let square = graph.dot(arm, arm);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let product = graph.mul(arm[i], arm[j]);
            let entry = if i == j { graph.sub(square, product) } else { graph.neg(product) };
            graph.mul(mass, entry)
        })
    })
}

/// The inertia of a body as written.
pub(super) fn inertia(
    given: &BodyInertia,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Rotation> {
    match given {
        BodyInertia::Matrix(written) => {
            let matrix = dynamics::matrix(written, (3, "axis", "axes"), Context::BODY, vocabulary, diagnostics)?;
            Some(std::array::from_fn(|i| std::array::from_fn(|j| matrix.get(i, j))))
        }
        BodyInertia::Shape(written) => shape(written, vocabulary, diagnostics),
    }
}

/// The shapes: their names, numbers of measures, and whether an axis follows.
const SHAPES: [(&str, usize, bool); 6] = [
    ("rod", 2, true),
    ("disk", 2, true),
    ("cylinder", 3, true),
    ("sphere", 2, false),
    ("cuboid", 4, false),
    ("planar", 1, false),
];

/// The inertia of a shape about its centre of mass. Textbook: a slender rod has m l²/12 across, a thin disk m r²/2 about its axis
/// and half of it across, a cylinder m (3 r² + h²)/12 across, a sphere 2 m r²/5, a cuboid m (b² + c²)/12.
fn shape(written: &Expression, vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Rotation> {
    let called = match written.terms().last() {
        Some((Term::Call(function, arguments), span)) => Some((function.as_str(), arguments.clone(), *span)),
        Some((Term::Hole, _)) => return None,
        _ => None,
    };
    let found = called.as_ref().and_then(|(function, ..)| SHAPES.iter().find(|(name, ..)| name == function));
    let (Some((_, arguments, span)), Some((name, count, turned))) = (called, found) else {
        diagnostics.report(written.place(), messages::body_inertia_form());
        return None;
    };
    let expected = count + usize::from(*turned);
    if arguments.len() != expected {
        let message = wrong_number_of_arguments(name, expected, arguments.len());
        diagnostics.report(span, message);
        return None;
    }
    let axis = match turned {
        true => {
            let (term, place) = &written.terms()[arguments[*count]];
            let axis = match term {
                Term::Name(name) => AXES.iter().position(|axis| name == axis),
                _ => None,
            };
            if axis.is_none() {
                diagnostics.report(*place, messages::body_axis());
            }
            axis
        }
        false => Some(2),
    };
    let measures: Vec<Option<Expr>> = arguments[..*count]
        .iter()
        .map(|at| vocabulary.lower(&written.part(*at), Context::BODY, diagnostics).map(|lowered| lowered.expr))
        .collect();
    let measures: Vec<Expr> = measures.into_iter().collect::<Option<_>>()?;
    let axis = axis?;
    let graph = &mut vocabulary.graph;
    let squares: Vec<Expr> = measures.iter().map(|e| graph.powi(*e, 2)).collect();
    let mut scaled = |parts: &[(i64, i64, usize)]| {
        let terms: Vec<Expr> =
            parts.iter().map(|(over, under, at)| graph.scale(Rational::Small(*over, *under), squares[*at])).collect();
        let sum = graph.sum(&terms);
        graph.mul(measures[0], sum)
    };
    let (along, across) = match *name {
        "rod" => (None, scaled(&[(1, 12, 1)])),
        "disk" => (Some(scaled(&[(1, 2, 1)])), scaled(&[(1, 4, 1)])),
        "cylinder" => (Some(scaled(&[(1, 2, 1)])), scaled(&[(1, 4, 1), (1, 12, 2)])),
        "sphere" => {
            let same = scaled(&[(2, 5, 1)]);
            (Some(same), same)
        }
        "cuboid" => {
            let sides: Triple = std::array::from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                scaled(&[(1, 12, 1 + j), (1, 12, 1 + k)])
            });
            return Some(diagonal(graph, &sides));
        }
        _ => (Some(measures[0]), graph.zero()),
    };
    let along = along.unwrap_or_else(|| graph.zero());
    let entries: Triple = std::array::from_fn(|i| if i == axis { along } else { across });
    Some(diagonal(graph, &entries))
}

fn diagonal(graph: &Graph, entries: &Triple) -> Rotation {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { entries[i] } else { graph.zero() }))
}
