//! Defines, frames, points and bodies in the order of their dependence, which need not be that of their appearance.

use super::bodies::rigid_of;
use super::{Frame, Geometry, Place};
use crate::model::context::Context;
use crate::model::names::{Meaning, Mentions};
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::Graph;
use crate::syntax::{Declarations, Diagnostics, Element, Expression, Term, messages};
use proc_macro2::Ident;

/// What is lowered once all that it needs is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Item {
    Define(usize),
    Frame(usize),
    Point(usize),
    Body(usize),
}

impl Item {
    fn describe(self) -> &'static str {
        match self {
            Item::Define(_) => "define",
            Item::Frame(_) => "frame",
            Item::Point(_) => "point",
            Item::Body(_) => "body",
        }
    }
}

impl Geometry {
    /// The inertial frame and its origin.
    pub fn new(graph: &Graph, declarations: &Declarations) -> Self {
        let still = graph.no_vector();
        let rotation = std::array::from_fn(|i| graph.axis(i));
        let inertial = Frame { base: 0, rotation, turn: None, spin: still, omega: still, mentions: Mentions::NONE };
        let geometry = &declarations.geometry;
        Geometry {
            frames: vec![inertial],
            places: vec![Place { from: 0, frame: 0, offset: still }],
            named_frames: vec![None; geometry.frames.len()],
            named_points: vec![None; geometry.points.len()],
            named_bodies: vec![None; geometry.bodies().count()],
        }
    }
}

/// Lowers every one of them; those in a cycle are reported and stay without a value.
pub(in crate::model) fn lower(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    vocabulary.check_releases(diagnostics);
    let items = items(vocabulary);
    let needs: Vec<Vec<usize>> = items.iter().map(|(_, _, written)| needs(written, &items, vocabulary)).collect();
    let mut done = vec![false; items.len()];
    loop {
        // What is ready is lowered; then what is in a cycle is told and left without a value, and what needs only that.
        if let Some(i) = (0..items.len()).find(|&i| !done[i] && needs[i].iter().all(|&k| done[k])) {
            item(items[i].0, vocabulary, diagnostics);
            done[i] = true;
            continue;
        }
        let Some(start) = done.iter().position(|done| !done) else { break };
        let cycle = cycle_from(start, &needs, &done);
        match cycle.iter().min() {
            Some(&first) => {
                let turn = cycle.iter().position(|&i| i == first).unwrap_or_default();
                let round = cycle.iter().cycle().skip(turn).take(cycle.len() + 1);
                let names: Vec<String> = round.map(|&i| format!("`{}`", items[i].1)).collect();
                diagnostics.report_local(items[first].1, messages::cycle(items[first].0.describe(), names.join(" → ")));
                cycle.iter().for_each(|&i| done[i] = true);
            }
            None => done[start] = true,
        }
    }
}

/// An item, its name, and the expressions that it is made of.
type Written<'a> = (Item, &'a Ident, Vec<&'a Expression>);

fn items<'a>(vocabulary: &Vocabulary<'a>) -> Vec<Written<'a>> {
    let declarations = vocabulary.declarations;
    let geometry = &declarations.geometry;
    let mut items: Vec<Written<'a>> = Vec::new();
    items.extend(declarations.defines.iter().enumerate().map(|(i, d)| (Item::Define(i), &d.name, vec![&d.value])));
    // What is let go needs the vector along or about which it is.
    let with = |value: &'a Expression, name: &Ident, key: &str, direction: &str| -> Vec<&'a Expression> {
        let of = |release: &&'a Element| match release.get(key).map(|written| written.terms()) {
            Some([(Term::Name(other), _)]) => name == other,
            _ => false,
        };
        let directions = geometry.releases().filter(of).filter_map(|release| release.get(direction));
        std::iter::once(value).chain(directions).collect()
    };
    for (i, d) in geometry.frames.iter().enumerate() {
        items.push((Item::Frame(i), &d.name, with(&d.value, &d.name, "frame", "about")));
    }
    for (i, d) in geometry.points.iter().enumerate() {
        items.push((Item::Point(i), &d.name, with(&d.value, &d.name, "point", "along")));
    }
    for (i, body) in geometry.bodies().enumerate() {
        let written = ["frame", "center", "at"].into_iter().filter_map(|key| body.get(key)).collect();
        items.push((Item::Body(i), &body.name, written));
    }
    items
}

fn needs(written: &[&Expression], items: &[Written<'_>], vocabulary: &Vocabulary<'_>) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    for (term, _) in written.iter().flat_map(|expression| expression.terms()) {
        let (Term::Name(name) | Term::Axis(name, _)) = term else { continue };
        let item = match vocabulary.names.get(name) {
            Some(Meaning::Define(i)) => Item::Define(i),
            Some(Meaning::Frame(i)) => Item::Frame(i),
            Some(Meaning::Point(i)) => Item::Point(i),
            Some(Meaning::Body(i)) => Item::Body(i),
            _ => continue,
        };
        found.extend(items.iter().position(|(other, ..)| *other == item));
    }
    // Where a frame stands for its body, the body must be known.
    for (term, _) in written.iter().flat_map(|expression| expression.terms()) {
        let Term::Call(function, arguments) = term else { continue };
        if function == "velocity" && arguments.len() == 2 {
            found.extend((0..items.len()).filter(|i| {
                let (Item::Body(_), _, parts) = &items[*i] else { return false };
                let named = |expression: &&Expression| match expression.terms() {
                    [(Term::Name(frame), _)] => written
                        .iter()
                        .any(|e| e.terms().iter().any(|(term, _)| matches!(term, Term::Name(name) if name == frame))),
                    _ => false,
                };
                parts.first().is_some_and(named)
            }));
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

fn item(item: Item, vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    let declarations = vocabulary.declarations;
    match item {
        Item::Define(i) => {
            vocabulary.defines[i] = vocabulary.value(&declarations.defines[i].value, Context::DEFINE, diagnostics);
        }
        Item::Frame(i) => {
            let frame = &declarations.geometry.frames[i];
            vocabulary.geometry.named_frames[i] = vocabulary.frame(&frame.name.to_string(), &frame.value, diagnostics);
        }
        Item::Point(i) => {
            let point = &declarations.geometry.points[i];
            let slid = vocabulary.slid(&point.value, diagnostics);
            let vector = slid.unwrap_or_else(|| vocabulary.lower_vector(&point.value, Context::GEOMETRY, diagnostics));
            vocabulary.geometry.named_points[i] = vector.and_then(|(vector, mentions)| {
                let vector = vocabulary.let_go(&point.name.to_string(), vector, diagnostics)?;
                Some((vocabulary.place(&vector), mentions))
            });
        }
        Item::Body(i) => {
            let Some(body) = declarations.geometry.bodies().nth(i) else { return };
            vocabulary.geometry.named_bodies[i] = rigid_of(body, vocabulary, diagnostics);
        }
    }
}

/// Follows the first open need of each item until one comes round again.
fn cycle_from(start: usize, needs: &[Vec<usize>], done: &[bool]) -> Vec<usize> {
    let mut path = vec![start];
    while let Some(next) = path.last().and_then(|&i| needs[i].iter().copied().find(|&k| !done[k])) {
        match path.iter().position(|&i| i == next) {
            Some(at) => return path.split_off(at),
            None => path.push(next),
        }
    }
    Vec::new()
}
