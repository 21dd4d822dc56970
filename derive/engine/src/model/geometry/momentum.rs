//! Momenta of bodies: m v_C, and (C − P) × m v_C + I ω about a point P.

use super::bodies::centred;
use super::{Rigid, Vector};
use crate::model::names::{Meaning, Mentions};
use crate::model::vocabulary::Vocabulary;
use crate::syntax::{Diagnostics, did_you_mean, messages, nearest};
use proc_macro2::Span;

/// A body or particle of that name, by its number.
pub(super) fn named(
    name: &str,
    span: Span,
    vocabulary: &Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let message = match vocabulary.names.get(name) {
        Some(Meaning::Body(i)) => return Some(i),
        Some(meaning) => messages::momentum_of_no_body(name, meaning.describe()),
        None => {
            let known: Vec<String> =
                vocabulary.declarations.geometry.bodies().map(|body| body.name.to_string()).collect();
            messages::body_unknown(name, did_you_mean(nearest(name, known.iter().map(String::as_str))))
        }
    };
    diagnostics.report(span, message);
    None
}

/// The momentum of a body, its angular one where a point is given; `None` where the body itself could not be read.
pub(super) fn momentum(
    body: usize,
    about: Option<&Vector>,
    vocabulary: &mut Vocabulary<'_>,
) -> Option<(Vector, Mentions)> {
    let Rigid { frame, center, mentions } = vocabulary.geometry.named_bodies[body]?;
    let element = vocabulary.declarations.geometry.bodies().nth(body)?;
    // What is wrong with the body is told where it stands.
    let (mass, inertia) =
        centred(element, Some(Rigid { frame, center, mentions }), vocabulary, &mut Diagnostics::new())?;
    let motion = vocabulary.motion();
    let (graph, geometry) = (&mut vocabulary.graph, &vocabulary.geometry);
    let position = Vector { from: center, parts: Vec::new() };
    let linear = position.rate(&motion, graph, geometry).times(mass, graph, geometry);
    let Some(about) = about else { return Some((linear, mentions)) };
    let back = about.negative(graph, geometry);
    let arm = position.plus(&back, graph, geometry).flattened(graph, geometry);
    let orbital = arm.cross(&linear, graph, geometry);
    let Some(inertia) = inertia else { return Some((orbital, mentions)) };
    let spin = Vector::along(frame, graph.turned(&inertia, &geometry.frames[frame].omega));
    Some((orbital.plus(&spin, graph, geometry), mentions))
}
