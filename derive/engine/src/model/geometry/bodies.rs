//! Bodies and what acts on them, at the nodes of a tree.

use super::possible;
use super::shapes::{inertia, point_tensor};
use super::tree::Tree;
use super::{Rigid, Vector};
use crate::model::context::Context;
use crate::model::mechanism::{Line, LineKind, Load, Mass, Mechanism, Release};
use crate::model::names::{Meaning, Mentions};
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Rotation};
use crate::syntax::{Diagnostics, Element, ElementKind, Expression, Term, did_you_mean, messages, nearest};

/// The mechanism, rates as written; `None` without bodies, and where something was reported.
pub(in crate::model) fn mechanism(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Mechanism> {
    let geometry = &vocabulary.declarations.geometry;
    let mut tree = Tree::new(vocabulary);
    let (mut masses, mut loads, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let mut sound = true;
    let mut bodies = 0;
    for element in &geometry.elements {
        let known = match element.kind {
            ElementKind::Particle | ElementKind::Body => {
                let rigid = vocabulary.geometry.named_bodies[bodies];
                bodies += 1;
                mass(element, rigid, &mut tree, vocabulary, diagnostics).map(|mass| masses.push((element, mass)))
            }
            ElementKind::Force => force(element, &mut tree, vocabulary, diagnostics).map(|found| loads.extend(found)),
            ElementKind::Torque => torque(element, &mut tree, vocabulary, diagnostics).map(|found| loads.extend(found)),
            ElementKind::Release => Some(()),
            ElementKind::Spring | ElementKind::Damper | ElementKind::Armature => {
                line(element, vocabulary, diagnostics).map(|line| lines.push(line))
            }
        };
        sound &= known.is_some();
    }
    let gravity = geometry.gravity.as_ref().map(|written| {
        let vector = vocabulary.lower_vector(written, Context::FORCES, diagnostics);
        vector.map(|(vector, _)| vector.expressed(0, &mut vocabulary.graph, &vocabulary.geometry))
    });
    let generalized = generalized(vocabulary, diagnostics);
    let gravity = match gravity {
        Some(given) => Some(given?),
        None => None,
    };
    let generalized = generalized?;
    possible::check(&masses, vocabulary, diagnostics);
    let masses = masses.into_iter().map(|(_, mass)| mass).collect();
    let releases = geometry.releases().zip(&vocabulary.released).map(|(release, released)| Release {
        name: release.name.to_string(),
        coordinate: released.coordinate,
        rate: released.rate,
    });
    let releases = releases.collect();
    (sound && bodies > 0).then_some(Mechanism {
        nodes: tree.nodes,
        masses,
        loads,
        gravity,
        lines,
        generalized,
        releases,
        along: None,
        whole: false,
    })
}

fn mass(
    element: &Element,
    rigid: Option<Rigid>,
    tree: &mut Tree,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Mass> {
    let (mass, inertia) = centred(element, rigid, vocabulary, diagnostics)?;
    let rigid = rigid?;
    let node = tree.node(rigid.center, rigid.frame, vocabulary);
    Some(Mass { node, mass, inertia })
}

/// A body's mass, and its inertia about its centre of mass; none of a particle.
pub(super) fn centred(
    element: &Element,
    rigid: Option<Rigid>,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(Expr, Option<Rotation>)> {
    let mass = element.get("mass").map(|mass| vocabulary.lower(mass, Context::BODY, diagnostics));
    let inertia = match element.kind {
        ElementKind::Particle => Some(None),
        _ => element.inertia.as_ref().and_then(|given| inertia(given, vocabulary, diagnostics)).map(Some),
    };
    let about = match (element.get("about"), rigid) {
        (Some(point), Some(rigid)) => {
            let (point, _) = vocabulary.lower_vector(point, Context::GEOMETRY, diagnostics)?;
            let center = Vector { from: rigid.center, parts: Vec::new() };
            let back = center.negative(&mut vocabulary.graph, &vocabulary.geometry);
            let arm = point.plus(&back, &mut vocabulary.graph, &vocabulary.geometry);
            Some(arm.expressed(rigid.frame, &mut vocabulary.graph, &vocabulary.geometry))
        }
        _ => None,
    };
    let (mass, inertia) = (mass??.expr, inertia?);
    let graph = &mut vocabulary.graph;
    let inertia = match (inertia, about) {
        (Some(about_point), Some(arm)) => {
            // I_C = I_P - m (r² 1 - r rᵀ)
            let further = point_tensor(graph, mass, &arm);
            Some(std::array::from_fn(|i| graph.minus(&about_point[i], &further[i])))
        }
        (inertia, _) => inertia,
    };
    Some((mass, inertia))
}

/// A force at a point, and the opposite one where it has a counterpart.
fn force(
    element: &Element,
    tree: &mut Tree,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Load>> {
    let value = element.get("value").map(|value| vocabulary.lower_vector(value, Context::FORCES, diagnostics));
    let at = element.get("at").map(|at| vocabulary.lower_vector(at, Context::GEOMETRY, diagnostics));
    let from = element.get("from").map(|from| vocabulary.lower_vector(from, Context::GEOMETRY, diagnostics));
    let on = element.get("on").map(|on| rigid(on, true, vocabulary, diagnostics));
    let ((value, _), (at, _)) = (value??, at??);
    let mut loads = match on {
        Some(rigid) => vec![on_body(&value, &at, rigid?, tree, vocabulary)],
        None => vec![at_point(&value, &at, tree, vocabulary)],
    };
    if let Some(from) = from {
        let (from, _) = from?;
        let opposite = value.negative(&mut vocabulary.graph, &vocabulary.geometry);
        loads.push(at_point(&opposite, &from, tree, vocabulary));
    }
    Some(loads)
}

/// At a point, wherever it moves, in the axes along which it lies.
fn at_point(value: &Vector, at: &Vector, tree: &mut Tree, vocabulary: &mut Vocabulary<'_>) -> Load {
    let place = vocabulary.place(at);
    let frame = if place == 0 { 0 } else { vocabulary.geometry.places[place].frame };
    let node = tree.node(place, frame, vocabulary);
    let force = value.expressed(frame, &mut vocabulary.graph, &vocabulary.geometry);
    Load { node, force, torque: vocabulary.graph.no_vector() }
}

/// At the material point of a body, taken to its centre.
fn on_body(value: &Vector, at: &Vector, rigid: Rigid, tree: &mut Tree, vocabulary: &mut Vocabulary<'_>) -> Load {
    let node = tree.node(rigid.center, rigid.frame, vocabulary);
    let (graph, geometry) = (&mut vocabulary.graph, &vocabulary.geometry);
    let center = Vector { from: rigid.center, parts: Vec::new() };
    let back = center.negative(graph, geometry);
    let arm = at.plus(&back, graph, geometry).expressed(rigid.frame, graph, geometry);
    let force = value.expressed(rigid.frame, graph, geometry);
    let torque = graph.cross(&arm, &force);
    Load { node, force, torque }
}

/// A torque on a body or frame, and the opposite one on another.
fn torque(
    element: &Element,
    tree: &mut Tree,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Load>> {
    let value = element.get("value").map(|value| vocabulary.lower_vector(value, Context::FORCES, diagnostics));
    let on = element.get("on").map(|on| rigid(on, false, vocabulary, diagnostics));
    let from = element.get("from").map(|from| rigid(from, false, vocabulary, diagnostics));
    let ((value, _), on) = (value??, on??);
    let mut loads = vec![on_axes(&value, on, tree, vocabulary)];
    if let Some(from) = from {
        let opposite = value.negative(&mut vocabulary.graph, &vocabulary.geometry);
        loads.push(on_axes(&opposite, from?, tree, vocabulary));
    }
    Some(loads)
}

fn on_axes(value: &Vector, rigid: Rigid, tree: &mut Tree, vocabulary: &mut Vocabulary<'_>) -> Load {
    // Where a body has these axes, its node is there already.
    let of_frame = |known: &&Option<Rigid>| known.is_some_and(|known| known.frame == rigid.frame);
    let center = vocabulary.geometry.named_bodies.iter().find(of_frame).copied().flatten();
    let node = tree.node(center.map_or(rigid.center, |known| known.center), rigid.frame, vocabulary);
    let torque = value.expressed(rigid.frame, &mut vocabulary.graph, &vocabulary.geometry);
    Load { node, force: vocabulary.graph.no_vector(), torque }
}

/// The body or frame that an expression names.
fn rigid(
    written: &Expression,
    point_needed: bool,
    vocabulary: &Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Rigid> {
    match written.terms() {
        [(Term::Name(name), span)] => vocabulary.rigid_named(name, *span, point_needed, diagnostics),
        [(Term::Hole, _)] => None,
        _ => {
            diagnostics.report(written.place(), messages::body_expected("this", "an expression"));
            None
        }
    }
}

/// A spring, a damper or an armature along a scalar.
fn line(element: &Element, vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Line> {
    let mut of = |key: &str| {
        let written = element.get(key)?;
        Some(vocabulary.lower(written, Context::LINE, diagnostics).map(|lowered| lowered.expr))
    };
    let [stiffness, rest, coefficient, inertia] = ["stiffness", "length", "coefficient", "inertia"].map(&mut of);
    let length = match of("of") {
        Some(length) => length,
        None => {
            let mut end = |key: &str| vocabulary.lower_vector(element.get(key)?, Context::GEOMETRY, diagnostics);
            let (from, to) = (end("from"), end("to"));
            let ((from, _), (to, _)) = (from?, to?);
            let (graph, geometry) = (&mut vocabulary.graph, &vocabulary.geometry);
            let back = from.negative(graph, geometry);
            Some(to.plus(&back, graph, geometry).norm(graph, geometry))
        }
    };
    let zero = vocabulary.graph.zero();
    let kind = match element.kind {
        ElementKind::Spring => LineKind::Spring { stiffness: stiffness??, rest: rest.unwrap_or(Some(zero))? },
        ElementKind::Damper => LineKind::Damper { coefficient: coefficient?? },
        _ => LineKind::Armature { inertia: inertia?? },
    };
    let length = length?;
    let motion = vocabulary.motion();
    let rate = vocabulary.graph.along(&[length], &motion)[0];
    Some(Line { length, rate, kind })
}

/// `generalized_force(crank = tau)` as one force for each v; the power of a force in a rate is that in A v + a0.
fn generalized(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<Expr>> {
    let declarations = vocabulary.declarations;
    let mut sound = true;
    // As powers over rates and speeds, of which the coefficients of v are taken once rates are replaced.
    let mut powers = Vec::new();
    for given in &declarations.geometry.generalized {
        let value = vocabulary.lower(&given.value, Context::FORCES, diagnostics);
        let name = given.name.to_string();
        let rate = match vocabulary.names.get(&name) {
            Some(Meaning::Coordinate(i)) => Some(vocabulary.rates[i]),
            Some(Meaning::Speed(i)) => Some(vocabulary.speeds[i]),
            Some(meaning) => {
                diagnostics.report(&given.name, messages::generalized_of(&name, meaning.describe()));
                None
            }
            None => {
                let known = declarations.coordinates.iter().chain(declarations.speeds.iter().flat_map(|s| &s.names));
                let known: Vec<String> = known.map(|name| name.ident.to_string()).collect();
                let hint = did_you_mean(nearest(&name, known.iter().map(String::as_str)));
                diagnostics.report(&given.name, messages::unknown_name(&name, hint));
                None
            }
        };
        match (value, rate) {
            (Some(value), Some(rate)) => powers.push((rate, value.expr)),
            _ => sound = false,
        }
    }
    let n = vocabulary.speeds.len();
    let graph = &mut vocabulary.graph;
    let mut forces = vec![graph.zero(); n];
    let mut of_rates: Vec<(usize, Expr)> = Vec::new();
    for (rate, value) in powers {
        match vocabulary.speeds.iter().position(|speed| *speed == rate) {
            Some(i) => forces[i] = graph.add(forces[i], value),
            None => of_rates.extend(vocabulary.rates.iter().position(|other| *other == rate).map(|i| (i, value))),
        }
    }
    vocabulary.forces_on_rates = of_rates;
    sound.then_some(forces)
}

/// What the frame and the centre of a body mention.
pub(super) fn rigid_of(
    element: &Element,
    vocabulary: &mut Vocabulary<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Rigid> {
    let frame = match (element.kind, element.get("frame")) {
        (ElementKind::Particle, _) => Some(None),
        (_, Some(written)) => match written.terms() {
            [(Term::Name(name), span)] => vocabulary.frame_named(name, *span, diagnostics).map(Some),
            [(Term::Hole, _)] => None,
            _ => {
                diagnostics.report(written.place(), messages::frame_expected("this", "an expression"));
                None
            }
        },
        _ => None,
    };
    let key = if element.kind == ElementKind::Particle { "at" } else { "center" };
    let (center, mentions) = vocabulary.lower_vector(element.get(key)?, Context::GEOMETRY, diagnostics)?;
    let place = vocabulary.place(&center);
    let frame = match frame? {
        Some(frame) => frame,
        None if place == 0 => 0,
        None => vocabulary.geometry.places[place].frame,
    };
    let mentions: Mentions = mentions.and(vocabulary.geometry.frames[frame].mentions);
    Some(Rigid { frame, center: place, mentions })
}
