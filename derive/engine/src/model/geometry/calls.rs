//! The functions of vectors.

use super::{Rigid, Vector, momentum};
use crate::model::context::Context;
use crate::model::functions::wrong_number_of_arguments;
use crate::model::names::{Meaning, Mentions};
use crate::model::value::Value;
use crate::model::vocabulary::Vocabulary;
use crate::syntax::{Diagnostics, ElementKind, Term, did_you_mean, messages, nearest};
use proc_macro2::Span;

/// The functions of vectors and of points, with their numbers of arguments.
pub(in crate::model) const VECTOR_FUNCTIONS: [(&str, usize); 9] = [
    ("cross", 2),
    ("norm", 1),
    ("unit", 1),
    ("velocity", 1),
    ("acceleration", 1),
    ("angular_velocity", 1),
    ("angular_acceleration", 1),
    ("momentum", 1),
    ("angular_momentum", 2),
];

/// Whether an argument of a function is the name of a body or a frame, and no value.
pub(in crate::model) fn names_a_body(function: &str, argument: usize) -> bool {
    match function {
        "velocity" => argument == 1,
        "angular_velocity" | "angular_acceleration" | "momentum" | "angular_momentum" => argument == 0,
        _ => false,
    }
}

/// A call as written.
pub(in crate::model) struct VectorCall<'a> {
    pub function: &'a str,
    pub span: Span,
    /// The places of the arguments among the terms.
    pub arguments: &'a [usize],
    pub terms: &'a [(Term, Span)],
}

impl VectorCall<'_> {
    /// The value; what vectors mention besides their arguments.
    pub fn lower(
        &self,
        mut values: Vec<Option<Value>>,
        mentioned: Mentions,
        context: Context,
        vocabulary: &mut Vocabulary<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<(Value, Mentions)> {
        let expected = VECTOR_FUNCTIONS.iter().find(|(name, _)| *name == self.function).map_or(2, |(_, count)| *count);
        let fits = values.len() == expected || (self.function == "velocity" && values.len() == 2);
        if !fits {
            diagnostics.report(self.span, wrong_number_of_arguments(self.function, expected, values.len()));
            return None;
        }
        if self.function.ends_with("momentum") {
            return self.momentum(values, mentioned, context, vocabulary, diagnostics);
        }
        if names_a_body(self.function, 0) {
            let rigid = self.body(0, vocabulary, diagnostics)?;
            return self.angular(rigid, context, vocabulary, diagnostics);
        }
        let rigid = match values.len() == 2 && names_a_body(self.function, 1) {
            true => Some(self.body(1, vocabulary, diagnostics)),
            false => None,
        };
        let count = if rigid.is_some() { 1 } else { values.len() };
        values.truncate(count);
        let values: Vec<Value> = values.into_iter().collect::<Option<_>>()?;
        let mut vectors = Vec::new();
        for value in values {
            match value {
                Value::Vector(vector) => vectors.push(vector),
                _ => {
                    diagnostics.report(self.span, messages::vector_expected(self.function));
                    return None;
                }
            }
        }
        let a = vectors.first()?;
        let velocity = match self.function {
            "velocity" => Some(Mentions::RATES),
            "acceleration" => Some(Mentions::RATES.and(Mentions::ACCELERATIONS)),
            _ => None,
        };
        if let Some(rates) = velocity {
            let rigid = rigid.unwrap_or(None);
            if self.arguments.len() == 2 && rigid.is_none() {
                return None;
            }
            let of_body = rigid.map_or(Mentions::NONE, |rigid| rigid.mentions);
            let moves = mentioned.and(of_body).intersects(Mentions::COORDINATES);
            let rates = if moves { rates } else { Mentions::NONE };
            self.allowed(rates, context, diagnostics)?;
            let value = match (rigid, self.function) {
                (Some(rigid), _) => vocabulary.velocity_in(a, rigid),
                (None, "velocity") => {
                    let motion = vocabulary.motion();
                    a.rate(&motion, &mut vocabulary.graph, &vocabulary.geometry)
                }
                (None, _) => {
                    let (first, second) = (vocabulary.motion(), vocabulary.second_motion());
                    let velocity = a.rate(&first, &mut vocabulary.graph, &vocabulary.geometry);
                    velocity.rate(&second, &mut vocabulary.graph, &vocabulary.geometry)
                }
            };
            return Some((Value::Vector(value), rates.and(of_body)));
        }
        let (graph, geometry) = (&mut vocabulary.graph, &vocabulary.geometry);
        let value = match (self.function, vectors.get(1)) {
            ("dot", Some(b)) => Value::Expr(a.dot(b, graph, geometry)),
            ("cross", Some(b)) => Value::Vector(a.cross(b, graph, geometry)),
            ("norm", _) => Value::Expr(a.norm(graph, geometry)),
            _ => {
                let norm = a.norm(graph, geometry);
                if graph.vanishes(norm) {
                    diagnostics.report(self.span, messages::zero_vector());
                    return None;
                }
                let one = graph.one();
                let scale = graph.div(one, norm);
                Value::Vector(a.times(scale, graph, geometry))
            }
        };
        Some((value, Mentions::NONE))
    }

    fn angular(
        &self,
        rigid: Rigid,
        context: Context,
        vocabulary: &mut Vocabulary<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<(Value, Mentions)> {
        let frame = &vocabulary.geometry.frames[rigid.frame];
        let moves = frame.mentions.intersects(Mentions::COORDINATES);
        let rates = match (moves, self.function) {
            (false, _) => Mentions::NONE,
            (true, "angular_velocity") => Mentions::RATES,
            _ => Mentions::RATES.and(Mentions::ACCELERATIONS),
        };
        let mentions = frame.mentions.and(rates);
        self.allowed(mentions, context, diagnostics)?;
        let omega = Vector::along(rigid.frame, frame.omega);
        let value = match self.function {
            "angular_velocity" => omega,
            _ => {
                let motion = vocabulary.second_motion();
                omega.rate(&motion, &mut vocabulary.graph, &vocabulary.geometry)
            }
        };
        Some((Value::Vector(value), mentions))
    }

    /// Of a body by its name, about the second argument where there is one.
    fn momentum(
        &self,
        mut values: Vec<Option<Value>>,
        mentioned: Mentions,
        context: Context,
        vocabulary: &mut Vocabulary<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<(Value, Mentions)> {
        let body = match &self.terms[self.arguments[0]] {
            (Term::Name(name), span) => momentum::named(name, *span, vocabulary, diagnostics)?,
            (Term::Hole, _) => return None,
            (_, span) => {
                diagnostics.report(*span, messages::momentum_of_no_body("this", "an expression"));
                return None;
            }
        };
        let about = match values.len() {
            2 => match values.swap_remove(1)? {
                Value::Vector(vector) => Some(vector),
                _ => {
                    diagnostics.report(self.span, messages::vector_expected(self.function));
                    return None;
                }
            },
            _ => None,
        };
        let (value, of_body) = momentum::momentum(body, about.as_ref(), vocabulary)?;
        let moves = mentioned.and(of_body).intersects(Mentions::COORDINATES);
        let mentions = if moves { of_body.and(Mentions::RATES) } else { of_body };
        self.allowed(mentions, context, diagnostics)?;
        Some((Value::Vector(value), mentions.and(Mentions::PARAMETERS)))
    }

    fn allowed(&self, mentions: Mentions, context: Context, diagnostics: &mut Diagnostics) -> Option<()> {
        if mentions.beyond(context.allowed) == Mentions::NONE {
            return Some(());
        }
        let what = mentions.beyond(context.allowed).describe();
        diagnostics.report(self.span, messages::out_of_place(self.function, what, context.rule));
        None
    }

    /// The body or frame that an argument names.
    fn body(&self, argument: usize, vocabulary: &Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Rigid> {
        match &self.terms[self.arguments[argument]] {
            (Term::Name(name), span) => {
                let point_needed = self.function == "velocity";
                vocabulary.rigid_named(name, *span, point_needed, diagnostics)
            }
            (Term::Hole, _) => None,
            (_, span) => {
                diagnostics.report(*span, messages::body_expected("this", "an expression"));
                None
            }
        }
    }
}

impl Vocabulary<'_> {
    /// A body by its name, or by that of its frame where no other body has this frame.
    pub(super) fn rigid_named(
        &self,
        name: &str,
        span: Span,
        point_needed: bool,
        diagnostics: &mut Diagnostics,
    ) -> Option<Rigid> {
        let bodies = &self.geometry.named_bodies;
        let frame = match self.names.get(name) {
            Some(Meaning::Body(i)) => return bodies[i],
            Some(Meaning::Inertial) => 0,
            Some(Meaning::Frame(i)) => self.geometry.named_frames[i]?,
            Some(meaning) => {
                diagnostics.report(span, messages::body_expected(name, meaning.describe()));
                return None;
            }
            None => {
                let geometry = &self.declarations.geometry;
                let known = geometry.bodies().map(|body| &body.name).chain(geometry.frames.iter().map(|f| &f.name));
                let known: Vec<String> = known.map(ToString::to_string).collect();
                let hint = did_you_mean(nearest(name, known.iter().map(String::as_str)));
                diagnostics.report(span, messages::body_unknown(name, hint));
                return None;
            }
        };
        let mentions = self.geometry.frames[frame].mentions;
        if frame == 0 || !point_needed {
            return Some(Rigid { frame, center: 0, mentions });
        }
        // A particle has no axes of its own: it is meant only by its name.
        let declared = self.declarations.geometry.bodies().enumerate();
        let rigid = declared.filter(|(_, body)| body.kind == ElementKind::Body).map(|(i, _)| i);
        let of_frame: Vec<usize> = rigid.filter(|i| bodies[*i].is_some_and(|rigid| rigid.frame == frame)).collect();
        match of_frame.as_slice() {
            [only] => bodies[*only],
            several => {
                let names = self.declarations.geometry.bodies().enumerate();
                let names: Vec<String> =
                    names.filter(|(i, _)| several.contains(i)).map(|(_, body)| format!("`{}`", body.name)).collect();
                let text = if names.is_empty() { "no body".to_owned() } else { names.join(" and ") };
                diagnostics.report(span, messages::frame_without_body(name, text));
                None
            }
        }
    }

    /// The velocity of the material point of a body at a position: v_C + ω × r.
    pub(super) fn velocity_in(&mut self, position: &Vector, rigid: Rigid) -> Vector {
        let motion = self.motion();
        let (graph, geometry) = (&mut self.graph, &self.geometry);
        let center = Vector { from: rigid.center, parts: Vec::new() };
        let back = center.negative(graph, geometry);
        let arm = position.plus(&back, graph, geometry).flattened(graph, geometry);
        let omega = Vector::along(rigid.frame, geometry.frames[rigid.frame].omega);
        let carried = arm.cross(&omega, graph, geometry).negative(graph, geometry);
        let velocity = center.rate(&motion, graph, geometry);
        velocity.plus(&carried, graph, geometry)
    }
}
