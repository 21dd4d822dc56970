//! Joints in short: rotations of frames, a point that slides, and constraints that close loops.
//!
//! Each stands for what could be written out. A constraint's rows are those of its long form in a fixed order: first P - Q along the
//! axes of N, or of `expressed`, then scalar products of axes that are at right angles.

use super::Vector;
use super::equations::components;
use crate::model::context::Context;
use crate::model::names::Mentions;
use crate::model::value::Lowered;
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::Expr;
use crate::syntax::{AXES, Constraint, Diagnostics, Expression, JOINTS, Term, messages};
use proc_macro2::Span;

/// A row: its name, left minus right, and what it mentions.
type Row = (String, Expr, Mentions);

/// An axis with what its frame mentions.
#[derive(Clone)]
struct Axis {
    vector: Vector,
    mentions: Mentions,
    /// The frame and the number of the axis, where it is written so.
    of: Option<(usize, usize)>,
}

impl Vocabulary<'_> {
    /// `P + s*direction` of `prismatic(P, direction, s)`; `None` in place of the value where something was reported.
    pub(super) fn slid(
        &mut self,
        written: &Expression,
        diagnostics: &mut Diagnostics,
    ) -> Option<Option<(Vector, Mentions)>> {
        let Some((Term::Call(function, arguments), span)) = written.terms().last() else { return None };
        if function != "prismatic" {
            return None;
        }
        let [point, direction, way] = arguments.as_slice() else {
            diagnostics.report(*span, messages::joint_form("prismatic(P, A.x, s)"));
            return Some(None);
        };
        let point = self.lower_vector(&written.part(*point), Context::GEOMETRY, diagnostics);
        let way = self.lower(&written.part(*way), Context::GEOMETRY, diagnostics);
        let direction = self.unit(&written.part(*direction), diagnostics);
        Some((|| {
            let ((point, of_point), (direction, of_direction)) = (point?, direction?);
            let Lowered { expr, mentions } = way?;
            let along = direction.times(expr, &mut self.graph, &self.geometry);
            let end = point.plus(&along, &mut self.graph, &self.geometry);
            Some((end, of_point.and(of_direction).and(mentions)))
        })())
    }

    /// A unit vector.
    fn unit(&mut self, written: &Expression, diagnostics: &mut Diagnostics) -> Option<(Vector, Mentions)> {
        let (vector, mentions) = self.lower_vector(written, Context::GEOMETRY, diagnostics)?;
        let square = vector.dot(&vector, &mut self.graph, &self.geometry);
        let one = self.graph.one();
        if !self.graph.identical(square, one) {
            let square = self.graph.display(square);
            diagnostics.report(written.place(), messages::axis_not_unit(square));
            return None;
        }
        Some((vector, mentions))
    }
}

/// The rows of a constraint that names a joint; `None` where something was reported.
pub(in crate::model) fn rows(
    constraint: &Constraint,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Row>> {
    let written = &constraint.left;
    let (Term::Call(function, arguments), span) = written.terms().last()? else { return None };
    let (name, counts, form) = JOINTS.iter().find(|(name, ..)| function == name)?;
    if !counts.contains(&arguments.len()) {
        diagnostics.report(*span, messages::joint_form(form));
        return None;
    }
    let parts: Vec<Expression> = arguments.iter().map(|at| written.part(*at)).collect();
    let mut joint = Joint { constraint, vocabulary, diagnostics };
    let rows = match *name {
        "rolling" => joint.rolling(&parts),
        "spherical" => joint.together(&parts),
        "revolute" => {
            let (rows, axes) = (joint.together(&parts), joint.parallel(&parts));
            joined(rows, axes)
        }
        "universal" => {
            let (rows, axes) = (joint.together(&parts), joint.across(&parts));
            joined(rows, axes)
        }
        "prismatic" => joint.along(&parts),
        _ => {
            let (rows, axes) = (joint.together(&parts), joint.same_axes(&parts[2], &parts[3]));
            joined(rows, axes)
        }
    }?;
    let rows: Vec<Row> = rows.into_iter().filter(|(_, e, _)| !vocabulary.vanishes(*e)).collect();
    if rows.is_empty() {
        diagnostics.report(&constraint.name, messages::vector_equation_empty(&constraint.name));
        return None;
    }
    Some(rows)
}

fn joined(rows: Option<Vec<Row>>, more: Option<Vec<Row>>) -> Option<Vec<Row>> {
    let (mut rows, more) = (rows?, more?);
    rows.extend(more);
    Some(rows)
}

/// A constraint in the making.
struct Joint<'a, 'b> {
    constraint: &'a Constraint,
    vocabulary: &'a mut Vocabulary<'b>,
    diagnostics: &'a mut Diagnostics,
}

impl Joint<'_, '_> {
    /// The rows of a vector that vanishes.
    fn vanishing(&mut self, vector: &Vector, mentions: Mentions) -> Option<Vec<Row>> {
        components(self.constraint, vector, mentions, self.vocabulary, self.diagnostics)
    }

    /// P - Q of the first two arguments.
    fn between(&mut self, parts: &[Expression]) -> Option<(Vector, Mentions)> {
        let [p, q] = [0, 1].map(|at| self.vocabulary.lower_vector(&parts[at], Context::CONSTRAINT, self.diagnostics));
        let ((p, of_p), (q, of_q)) = (p?, q?);
        let (graph, geometry) = (&mut self.vocabulary.graph, &self.vocabulary.geometry);
        let back = q.negative(graph, geometry);
        Some((p.plus(&back, graph, geometry), of_p.and(of_q)))
    }

    /// P == Q
    fn together(&mut self, parts: &[Expression]) -> Option<Vec<Row>> {
        let (between, mentions) = self.between(parts)?;
        self.vanishing(&between, mentions)
    }

    /// velocity(P, wheel) == 0, or that of the ground's point there.
    fn rolling(&mut self, parts: &[Expression]) -> Option<Vec<Row>> {
        let point = self.vocabulary.lower_vector(&parts[0], Context::CONSTRAINT, self.diagnostics);
        let bodies: Vec<Option<_>> = parts[1..]
            .iter()
            .map(|part| {
                let (name, span) = named(part, self.diagnostics)?;
                self.vocabulary.rigid_named(&name, span, true, self.diagnostics)
            })
            .collect();
        let (point, mut mentions) = point?;
        let mut slip = Vector::default();
        for (at, body) in bodies.into_iter().enumerate() {
            let rigid = body?;
            mentions |= rigid.mentions;
            let velocity = self.vocabulary.velocity_in(&point, rigid);
            let (graph, geometry) = (&mut self.vocabulary.graph, &self.vocabulary.geometry);
            let velocity = if at == 0 { velocity } else { velocity.negative(graph, geometry) };
            slip = slip.plus(&velocity, graph, geometry);
        }
        let moves = mentions.intersects(Mentions::COORDINATES);
        self.vanishing(&slip, if moves { mentions.and(Mentions::RATES) } else { mentions })
    }

    /// A vector, and whether it is an axis of a frame.
    fn axis(&mut self, written: &Expression) -> Option<Axis> {
        let (vector, mentions) = self.vocabulary.lower_vector(written, Context::CONSTRAINT, self.diagnostics)?;
        let of = match written.terms() {
            [(Term::Axis(frame, axis), span)] => {
                let frame = self.vocabulary.frame_named(frame, *span, self.diagnostics)?;
                Some((frame, *axis))
            }
            _ => None,
        };
        Some(Axis { vector, mentions, of })
    }

    fn axis_of_frame(&mut self, frame: usize, axis: usize) -> Axis {
        let vector = Vector::along(frame, self.vocabulary.graph.axis(axis));
        Axis { vector, mentions: self.vocabulary.geometry.frames[frame].mentions, of: Some((frame, axis)) }
    }

    /// Two axes at right angles.
    fn square(&mut self, a: &Axis, b: &Axis, called: &str) -> Row {
        let (graph, geometry) = (&mut self.vocabulary.graph, &self.vocabulary.geometry);
        let product = a.vector.dot(&b.vector, graph, geometry);
        (format!("{}_axes{called}", self.constraint.name), product, a.mentions.and(b.mentions))
    }

    /// The third and fourth arguments are parallel: the two axes beside one are at right angles to the other.
    fn parallel(&mut self, parts: &[Expression]) -> Option<Vec<Row>> {
        let (a, b) = (self.axis(&parts[2]), self.axis(&parts[3]));
        let (a, b) = (a?, b?);
        let (own, other) = if a.of.is_some() { (a, b) } else { (b, a) };
        let Some((frame, axis)) = own.of else {
            self.diagnostics.report(parts[2].place(), messages::joint_axis());
            return None;
        };
        let beside = (0..3).filter(|i| *i != axis);
        let rows = beside.map(|i| {
            let beside = self.axis_of_frame(frame, i);
            self.square(&beside, &other, &format!("_{}", AXES[i]))
        });
        Some(rows.collect())
    }

    /// The third and fourth arguments are at right angles.
    fn across(&mut self, parts: &[Expression]) -> Option<Vec<Row>> {
        let (a, b) = (self.axis(&parts[2]), self.axis(&parts[3]));
        let (a, b) = (a?, b?);
        Some(vec![self.square(&a, &b, "")])
    }

    /// Axes of two frames or bodies are the same.
    fn same_axes(&mut self, a: &Expression, b: &Expression) -> Option<Vec<Row>> {
        let [a, b] = [a, b].map(|part| {
            let (name, span) = named(part, self.diagnostics)?;
            self.vocabulary.rigid_named(&name, span, false, self.diagnostics)
        });
        let (a, b) = (a?, b?);
        Some(self.aligned(a.frame, b.frame))
    }

    fn aligned(&mut self, a: usize, b: usize) -> Vec<Row> {
        let rows = (0..3).map(|i| {
            let j = (i + 1) % 3;
            let (own, other) = (self.axis_of_frame(a, i), self.axis_of_frame(b, j));
            self.square(&own, &other, &format!("_{}{}", AXES[i], AXES[j]))
        });
        rows.collect()
    }

    /// P - Q lies along an axis, and another frame has the axes of that one's.
    fn along(&mut self, parts: &[Expression]) -> Option<Vec<Row>> {
        let between = self.between(parts);
        let axis = self.axis(&parts[2]);
        let other = named(&parts[3], self.diagnostics)
            .and_then(|(name, span)| self.vocabulary.rigid_named(&name, span, false, self.diagnostics));
        let ((between, mentions), axis, other) = (between?, axis?, other?);
        let Some((frame, axis)) = axis.of else {
            self.diagnostics.report(parts[2].place(), messages::joint_axis());
            return None;
        };
        if let Some(expressed) = &self.constraint.expressed {
            self.diagnostics.report(expressed, messages::joint_expressed("prismatic"));
            return None;
        }
        let beside: Vec<usize> = (0..3).filter(|i| *i != axis).collect();
        let mut rows = Vec::new();
        for i in beside {
            let beside = self.axis_of_frame(frame, i);
            let (graph, geometry) = (&mut self.vocabulary.graph, &self.vocabulary.geometry);
            let off = beside.vector.dot(&between, graph, geometry);
            rows.push((format!("{}_{}", self.constraint.name, AXES[i]), off, mentions.and(beside.mentions)));
        }
        rows.extend(self.aligned(frame, other.frame));
        Some(rows)
    }
}

/// The name that an argument is.
fn named(written: &Expression, diagnostics: &mut Diagnostics) -> Option<(String, Span)> {
    match written.terms() {
        [(Term::Name(name), span)] => Some((name.clone(), *span)),
        [(Term::Hole, _)] => None,
        _ => {
            diagnostics.report(written.place(), messages::body_expected("this", "an expression"));
            None
        }
    }
}
