//! Frames, points, bodies and what acts on them. Angles are pure numbers, points lengths of one kind.

use super::Checker;
use super::dimension::Dimension;
use super::expressions::place_of;
use super::report::Side;
use crate::syntax::{
    AXES, BodyInertia, Element, ElementKind, Expression, InertiaEntry, InertiaForm, ROTATIONS, Term, is_quaternion,
};
use std::collections::BTreeSet;

impl Checker<'_> {
    pub fn frames_and_points(&mut self) {
        for frame in &self.declarations.geometry.frames {
            self.origin = format!("the frame `{}`", frame.name);
            self.frame(&frame.value);
        }
        let length = self.length.clone();
        for point in &self.declarations.geometry.points {
            self.origin = format!("the point `{}`", point.name);
            match point.value.terms().last() {
                Some((Term::Call(function, arguments), _)) if function == "prismatic" && arguments.len() == 3 => {
                    self.expected_part(&point.value, arguments[0], "a point", &length);
                    self.expected_part(&point.value, arguments[1], "a direction", &Dimension::pure());
                    self.expected_part(&point.value, arguments[2], "the way along it", &length);
                }
                _ => self.expected(&point.value, "a point", &length),
            }
        }
    }

    /// Rotations about axes by angles, one inside the other.
    fn frame(&mut self, written: &Expression) {
        let pure = Dimension::pure();
        for (term, _) in written.terms() {
            let Term::Call(function, arguments) = term else { continue };
            if is_quaternion(function) {
                for component in arguments.iter().skip(1) {
                    self.expected_part(written, *component, "a component of a quaternion", &pure);
                }
            } else if ROTATIONS.iter().any(|(rotation, ..)| rotation == function) {
                for pair in arguments.get(1..).unwrap_or_default().chunks_exact(2) {
                    if !is_axis(written, pair[0]) {
                        self.expected_part(written, pair[0], "an axis", &pure);
                    }
                    self.expected_part(written, pair[1], "an angle", &pure);
                }
            }
        }
    }

    /// A part of an expression that has the dimension which it must have.
    pub fn expected_part(&mut self, written: &Expression, at: usize, what: &str, expected: &Dimension) {
        let part = written.part(at);
        if let Some(dimension) = self.dimension(&part) {
            self.expect(place_of(written, at), what, &Side::whole(dimension, &part), expected);
        }
    }

    pub fn elements(&mut self) {
        let geometry = &self.declarations.geometry;
        let (time, length, mass) = (self.time.clone(), self.length.clone(), self.mass.clone());
        let force = self.energy.over(&length);
        // What is known best comes first.
        if let Some(gravity) = &geometry.gravity {
            self.origin = "`gravity`".to_owned();
            self.expected(gravity, "gravity", &length.over(&time.powi(2)));
        }
        for element in &geometry.elements {
            self.origin = format!("the {} `{}`", element.kind.statement(), element.name);
            let keys: &[(&str, &str, &Dimension)] = match element.kind {
                ElementKind::Particle => &[("at", "a point", &length), ("mass", "the mass of a body", &mass)],
                ElementKind::Body => &[
                    ("center", "a point", &length),
                    ("mass", "the mass of a body", &mass),
                    ("about", "a point", &length),
                ],
                ElementKind::Force => {
                    &[("at", "a point", &length), ("from", "a point", &length), ("value", "this value", &force)]
                }
                ElementKind::Torque => &[("value", "this value", &self.energy.clone())],
                ElementKind::Spring | ElementKind::Damper => {
                    &[("from", "a point", &length), ("to", "a point", &length)]
                }
                ElementKind::Armature | ElementKind::Release => &[],
            };
            for (key, what, expected) in keys {
                if let Some(value) = element.get(key) {
                    self.expected(value, what, expected);
                }
            }
            if let Some(inertia) = &element.inertia {
                self.body_inertia(inertia);
            }
            if matches!(element.kind, ElementKind::Spring | ElementKind::Damper | ElementKind::Armature) {
                self.line(element);
            }
        }
        let speeds: BTreeSet<String> = self.velocities().into_iter().map(|(speed, _)| speed).collect();
        for given in &geometry.generalized {
            let name = given.name.to_string();
            self.origin = format!("the generalised force of `{name}`");
            let rate = if speeds.contains(&name) { self.of(&name) } else { self.rate_of(&name) };
            let expected = self.power().over(&rate);
            self.expected(&given.value, &format!("the force whose power is that with the rate of `{name}`"), &expected);
        }
    }

    /// What a spring, a damper or an armature stores or loses: k x², c ẋ², j ẋ².
    fn line(&mut self, element: &Element) {
        let length = match element.get("of") {
            Some(of) => self.dimension(of).unwrap_or_else(|| self.solver.fresh()),
            None => self.length.clone(),
        };
        let rate = length.over(&self.time);
        let keys = [
            ("length", "the length of a spring at rest", length.clone()),
            ("stiffness", "the stiffness of this spring", self.energy.over(&length.powi(2))),
            ("coefficient", "the coefficient of this damper", self.power().over(&rate.powi(2))),
            ("inertia", "the inertia of this armature", self.energy.over(&rate.powi(2))),
        ];
        for (key, what, expected) in keys {
            if let Some(value) = element.get(key) {
                self.expected(value, what, &expected);
            }
        }
    }

    fn body_inertia(&mut self, inertia: &BodyInertia) {
        let expected = self.mass.times(&self.length.powi(2));
        let what = "the inertia of a body";
        match inertia {
            BodyInertia::Matrix(matrix) => {
                let entries: Vec<&Expression> = match &matrix.form {
                    InertiaForm::Diagonal(entries) => entries.iter().collect(),
                    InertiaForm::Matrix(rows) => {
                        let all = rows.iter().flat_map(|row| &row.entries);
                        let given = all.filter_map(|entry| match entry {
                            InertiaEntry::Given(value) => Some(value),
                            InertiaEntry::Symmetric(_) => None,
                        });
                        given.collect()
                    }
                };
                for entry in entries {
                    self.expected(entry, what, &expected);
                }
            }
            BodyInertia::Shape(written) => {
                let Some((Term::Call(shape, arguments), _)) = written.terms().last() else { return };
                let Some((first, measures)) = arguments.split_first() else { return };
                if shape == "planar" {
                    self.expected_part(written, *first, what, &expected);
                    return;
                }
                let (mass, length) = (self.mass.clone(), self.length.clone());
                self.expected_part(written, *first, &format!("the mass of a {shape}"), &mass);
                let measures = measures.iter().filter(|at| !is_axis(written, **at));
                for measure in measures {
                    self.expected_part(written, *measure, &format!("a measure of a {shape}"), &length);
                }
            }
        }
    }
}

/// A bare `x`, `y` or `z`, or `-z`.
fn is_axis(written: &Expression, at: usize) -> bool {
    match &written.terms()[at].0 {
        Term::Name(name) => AXES.contains(&name.as_str()),
        Term::Negative(of) => matches!(&written.terms()[*of].0, Term::Name(name) if AXES.contains(&name.as_str())),
        _ => false,
    }
}
