//! Frames that turn against others: about axes that are fixed in both, or by quaternions.

use super::Vector;
use super::vector::path;
use crate::model::context::Context;
use crate::model::names::{Meaning, Mentions};
use crate::model::value::Lowered;
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Rotation, Stage, Symbol, Triple};
use crate::syntax::{AXES, Diagnostics, Expression, ROTATIONS, Term, did_you_mean, is_quaternion, messages, nearest};
use proc_macro2::Span;

/// A frame.
#[derive(Clone, Debug)]
pub(in crate::model) struct Frame {
    /// The frame against which it turns, before it in the list; the inertial frame's is itself.
    pub base: usize,
    /// From components in its axes to those in the base's.
    pub rotation: Rotation,
    /// The axis and the angle of this rotation, where it is one about an axis that is fixed in both.
    pub turn: Option<(Triple, Expr)>,
    /// The angular velocity against the base, in its own axes.
    pub spin: Triple,
    /// The angular velocity against the inertial frame, in its own axes.
    pub omega: Triple,
    /// What the rotations from the inertial frame to it mention.
    pub mentions: Mentions,
}

impl Vocabulary<'_> {
    /// `rotate(base, axis, angle)`, the base perhaps such a rotation itself; the last is the frame of that name. Or
    /// `quaternion(base, e0, e1, e2, e3)` with such a base. Joints in short are other names for them.
    pub(super) fn frame(&mut self, called: &str, written: &Expression, diagnostics: &mut Diagnostics) -> Option<usize> {
        match written.terms().last() {
            Some((Term::Call(function, arguments), span)) if is_quaternion(function) => {
                let arguments = arguments.clone();
                if arguments.len() != 5 {
                    diagnostics.report(*span, messages::quaternion_form(function));
                    return None;
                }
                let base = self.chain(called, &written.part(arguments[0]), true, diagnostics);
                self.turned_by_quaternion(called, base, (written, &arguments), diagnostics)
            }
            _ => self.chain(called, written, false, diagnostics),
        }
    }

    /// A chain of rotations, which may be `empty`.
    fn chain(
        &mut self,
        called: &str,
        written: &Expression,
        empty: bool,
        diagnostics: &mut Diagnostics,
    ) -> Option<usize> {
        let mut empty = empty;
        // From the outermost call inwards.
        let mut turns: Vec<(Expression, Expression)> = Vec::new();
        let mut at = written.clone();
        loop {
            let terms = at.terms();
            match terms.last() {
                Some((Term::Call(function, _), span)) if is_quaternion(function) => {
                    diagnostics.report(*span, messages::quaternion_inside());
                    return None;
                }
                Some((Term::Call(function, arguments), span))
                    if ROTATIONS.iter().any(|(known, ..)| function == known) =>
                {
                    let form = ROTATIONS.iter().find(|(known, ..)| function == known);
                    let Some((base, turned)) =
                        arguments.split_first().filter(|_| form.is_some_and(|(_, count, _)| *count == arguments.len()))
                    else {
                        let message = match form {
                            Some((known, _, form)) if *known != "rotate" => messages::joint_form(form),
                            _ => messages::frame_form(),
                        };
                        diagnostics.report(*span, message);
                        return None;
                    };
                    // The last rotation comes first, and none at all is a weld.
                    empty |= turned.is_empty();
                    turns.extend(turned.chunks_exact(2).rev().map(|pair| (at.part(pair[0]), at.part(pair[1]))));
                    at = at.part(*base);
                }
                Some((Term::Name(name), span)) if empty || !turns.is_empty() => {
                    let base = self.frame_named(name, *span, diagnostics);
                    let mut frame = base.and_then(|base| self.turned_loose(called, base, diagnostics));
                    for (axis, angle) in turns.iter().rev() {
                        frame = self.turned(frame, axis, angle, diagnostics);
                    }
                    return frame;
                }
                Some((Term::Hole, _)) | None => return None,
                Some((_, span)) => {
                    let place = if turns.is_empty() { written.place() } else { (*span).into() };
                    diagnostics.report(place, messages::frame_form());
                    return None;
                }
            }
        }
    }

    /// The frame that a name stands for.
    pub(in crate::model) fn frame_named(&self, name: &str, span: Span, diagnostics: &mut Diagnostics) -> Option<usize> {
        match self.names.get(name) {
            Some(Meaning::Inertial) => Some(0),
            Some(Meaning::Frame(i)) => self.geometry.named_frames[i],
            Some(meaning) => {
                diagnostics.report(span, messages::frame_expected(name, meaning.describe()));
                None
            }
            None => {
                let frames = self.declarations.geometry.frames.iter().map(|frame| frame.name.to_string());
                let frames: Vec<String> = frames.chain(["N".to_owned()]).collect();
                let hint = did_you_mean(nearest(name, frames.iter().map(String::as_str)));
                diagnostics.report(span, messages::frame_unknown(name, hint));
                None
            }
        }
    }

    fn turned(
        &mut self,
        base: Option<usize>,
        axis: &Expression,
        angle: &Expression,
        diagnostics: &mut Diagnostics,
    ) -> Option<usize> {
        let components = self.axis(base, axis, diagnostics);
        let Lowered { expr: angle, mentions } = self.lower(angle, Context::GEOMETRY, diagnostics)?;
        let (base, axis) = (base?, components?);
        let motion = self.motion();
        let rate = self.graph.along(&[angle], &motion)[0];
        Some(self.turned_by(base, axis, (angle, rate), mentions))
    }

    /// A new frame that turns by an angle with its rate.
    pub(super) fn turned_by(
        &mut self,
        base: usize,
        axis: Triple,
        (angle, rate): (Expr, Expr),
        mentions: Mentions,
    ) -> usize {
        let graph = &mut self.graph;
        let rotation = graph.rotation(&axis, angle);
        let spin = graph.times(rate, &axis);
        let frame = self.pushed(base, rotation, spin, mentions);
        self.geometry.frames[frame].turn = Some((axis, angle));
        frame
    }

    /// A new frame by its rotation and its angular velocity against its base.
    pub(super) fn pushed(&mut self, base: usize, rotation: Rotation, spin: Triple, mentions: Mentions) -> usize {
        let graph = &mut self.graph;
        let parent = &self.geometry.frames[base];
        let carried = graph.turned_back(&rotation, &parent.omega);
        let omega = graph.plus(&carried, &spin);
        let mentions = mentions.and(parent.mentions);
        self.geometry.frames.push(Frame { base, rotation, turn: None, spin, omega, mentions });
        self.geometry.frames.len() - 1
    }

    /// `x`, `-z`, or a unit vector that is fixed in the base.
    fn axis(&mut self, base: Option<usize>, written: &Expression, diagnostics: &mut Diagnostics) -> Option<Triple> {
        let bare = |term: &Term| match term {
            Term::Name(name) => AXES.iter().position(|axis| name == axis),
            _ => None,
        };
        match written.terms() {
            [(term, _)] if bare(term).is_some() => return bare(term).map(|axis| self.graph.axis(axis)),
            [(term, _), (Term::Negative(_), _)] if bare(term).is_some() => {
                let axis = bare(term).map(|axis| self.graph.axis(axis))?;
                let zero = self.graph.no_vector();
                return Some(self.graph.minus(&zero, &axis));
            }
            _ => {}
        }
        let (vector, _) = self.lower_vector(written, Context::GEOMETRY, diagnostics)?;
        let base = base?;
        let components = vector.expressed(base, &mut self.graph, &self.geometry);
        let graph = &mut self.graph;
        let components = components.map(|e| if graph.vanishes(e) { graph.zero() } else { e });
        if components.iter().any(|e| graph.stage(*e) > Stage::Parameter) {
            let name = self.frame_name(base);
            diagnostics.report(written.place(), messages::axis_not_fixed(name));
            return None;
        }
        let square = graph.dot(&components, &components);
        let one = graph.one();
        if !graph.identical(square, one) {
            let square = graph.display(square);
            diagnostics.report(written.place(), messages::axis_not_unit(square));
            return None;
        }
        Some(components)
    }

    /// The name of a frame, or of the nearest named one towards the inertial frame.
    fn frame_name(&self, frame: usize) -> String {
        let declared = &self.declarations.geometry.frames;
        let named = |at: &usize| self.geometry.named_frames.iter().position(|named| *named == Some(*at));
        let found = path(&self.geometry.frames, frame).iter().rev().find_map(named);
        found.map_or("N".to_owned(), |i| declared[i].name.to_string())
    }

    /// An axis of a frame.
    pub(in crate::model) fn frame_axis(
        &mut self,
        name: &str,
        axis: usize,
        span: Span,
        diagnostics: &mut Diagnostics,
    ) -> Option<(Vector, Mentions)> {
        let frame = self.frame_named(name, span, diagnostics)?;
        let mentions = self.geometry.frames[frame].mentions;
        Some((Vector::along(frame, self.graph.axis(axis)), mentions))
    }

    /// The rates of (x, t): `dot(x)` for each coordinate.
    pub(super) fn motion(&mut self) -> Vec<(Symbol, Expr)> {
        let rates = self.graph.vars(&self.rates);
        let mut motion: Vec<(Symbol, Expr)> = self.coordinates.iter().copied().zip(rates).collect();
        for turning in &self.turnings {
            for (place, rate) in turning.moved(&self.coordinates, &mut self.graph) {
                motion[place].1 = rate;
            }
        }
        motion.extend(self.released.iter().map(|released| (released.coordinate, self.graph.var(released.rate))));
        motion.push((self.time, self.graph.one()));
        motion
    }

    /// The rates of (x, ẋ, t).
    pub(super) fn second_motion(&mut self) -> Vec<(Symbol, Expr)> {
        let second = self.graph.vars(&self.second_rates);
        let mut motion = self.motion();
        motion.extend(self.rates.iter().copied().zip(second));
        for turning in &self.turnings {
            let rates = turning.omega_rates.map(|symbol| self.graph.var(symbol));
            motion.extend(turning.omega.into_iter().zip(rates));
        }
        motion.extend(self.released.iter().map(|released| (released.rate, self.graph.var(released.second))));
        motion
    }
}
