//! Whether a body can have its inertia, judged by the model's nominal numbers.
//!
//! The tensor of a body about its centre of mass is tr(Σ) 1 - Σ with the second moments of its mass Σ = Σ_i m_i r_i r_iᵀ, so
//! that Σ = tr(I)/2 1 - I has no negative eigenvalue: no principal moment is greater than the two others together.

use crate::model::mechanism::Mass;
use crate::model::numbers::nominal;
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::Symbol;
use crate::syntax::{BodyInertia, Diagnostics, Element, messages};

/// Figures this much below zero, relative to the tensor, are rounding of published numbers.
const ROUNDING: f64 = 1e-3;

/// Reports masses that are not positive, and matrices that are no inertia; shapes are what they say.
pub(super) fn check(bodies: &[(&Element, Mass)], vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    let numbers = nominal(vocabulary, diagnostics);
    let pi = vocabulary.graph.pi_symbol();
    let value = |s: Symbol| match numbers.iter().find(|(known, _)| *known == s) {
        Some((_, value)) => *value,
        None if s == pi => std::f64::consts::PI,
        None => f64::NAN,
    };
    for (element, mass) in bodies {
        let figure = vocabulary.graph.evaluate(&[mass.mass], &value)[0];
        if figure < 0.0 {
            diagnostics.report(&element.name, messages::mass_negative(&element.name, figure));
        }
        let (Some(BodyInertia::Matrix(written)), Some(tensor)) = (&element.inertia, mass.inertia) else { continue };
        let entries = vocabulary.graph.evaluate(tensor.as_flattened(), &value);
        let moments = |i: usize, j: usize| {
            let half = (entries[0] + entries[4] + entries[8]) / 2.0;
            if i == j { half - entries[3 * i + j] } else { -entries[3 * i + j] }
        };
        let scale = entries.iter().fold(0.0, |scale: f64, e| scale.max(e.abs()));
        let pair = |i: usize, j: usize| moments(i, i) * moments(j, j) - moments(i, j) * moments(i, j);
        let all = moments(0, 0) * pair(1, 2)
            - moments(0, 1) * (moments(0, 1) * moments(2, 2) - moments(0, 2) * moments(1, 2))
            + moments(0, 2) * (moments(0, 1) * moments(1, 2) - moments(0, 2) * moments(1, 1));
        // All principal minors of a matrix without negative eigenvalues are not negative.
        let minors = [
            (moments(0, 0), 1),
            (moments(1, 1), 1),
            (moments(2, 2), 1),
            (pair(0, 1), 2),
            (pair(0, 2), 2),
            (pair(1, 2), 2),
            (all, 3),
        ];
        if minors.iter().any(|(minor, degree)| *minor < -ROUNDING * scale.powi(*degree)) {
            diagnostics.report(written.span, messages::inertia_of_no_body(&element.name));
        }
    }
}
