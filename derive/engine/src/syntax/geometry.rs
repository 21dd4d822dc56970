//! Frames, points, bodies and what acts on them: the statements of level 2, as they are written.

use proc_macro2::{Delimiter, Ident, Span, TokenTree};

use super::declarations::{Define, Inertia};
use super::diagnostics::{Diagnostics, did_you_mean, messages, nearest};
use super::entries::{self, Entry, is_colon, single_ident};
use super::expression::Expression;
use super::forms;

/// A model's geometry.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// `#[frame(A = rotate(N, z, theta))]`, in order of appearance (which has no meaning).
    pub frames: Vec<Define>,
    /// `#[point(P = O + l*A.x)]`, in order of appearance (which has no meaning).
    pub points: Vec<Define>,
    /// Bodies and what acts on them, in order.
    pub elements: Vec<Element>,
    /// `#[gravity(-g*N.y)]`
    pub gravity: Option<Expression>,
    /// `#[generalized_force(crank = tau)]`: a coordinate or a speed, and the force whose power is that with its rate.
    pub generalized: Vec<Define>,
}

impl Geometry {
    /// Bodies and particles.
    pub fn bodies(&self) -> impl Iterator<Item = &Element> {
        self.elements.iter().filter(|element| element.kind.has_mass())
    }

    /// Releases.
    pub fn releases(&self) -> impl Iterator<Item = &Element> {
        self.elements.iter().filter(|element| element.kind == ElementKind::Release)
    }
}

/// What an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementKind {
    /// `particle`
    Particle,
    /// `body`
    Body,
    /// `force`
    Force,
    /// `torque`
    Torque,
    /// `spring`
    Spring,
    /// `damper`
    Damper,
    /// `armature`
    Armature,
    /// `release`
    Release,
}

/// A kind with its statement, its keys, and those of them that it needs.
struct Form {
    kind: ElementKind,
    statement: &'static str,
    keys: &'static [&'static str],
    needed: &'static [&'static str],
    written: &'static str,
}

const FORMS: [Form; 8] = [
    Form {
        kind: ElementKind::Particle,
        statement: "particle",
        keys: &["at", "mass"],
        needed: &["at", "mass"],
        written: "at: P, mass: m",
    },
    Form {
        kind: ElementKind::Body,
        statement: "body",
        keys: &["frame", "center", "mass", "inertia", "about"],
        needed: &["frame", "center", "mass", "inertia"],
        written: "frame: A, center: P, mass: m, inertia: rod(m, l, x)",
    },
    Form {
        kind: ElementKind::Force,
        statement: "force",
        keys: &["at", "value", "on", "from"],
        needed: &["at", "value"],
        written: "at: P, value: f*N.x",
    },
    Form {
        kind: ElementKind::Torque,
        statement: "torque",
        keys: &["on", "value", "from"],
        needed: &["on", "value"],
        written: "on: A, value: tau*N.z",
    },
    Form {
        kind: ElementKind::Spring,
        statement: "spring",
        keys: &["from", "to", "of", "stiffness", "length"],
        needed: &["stiffness"],
        written: "from: P, to: Q, stiffness: k, length: l",
    },
    Form {
        kind: ElementKind::Damper,
        statement: "damper",
        keys: &["from", "to", "of", "coefficient"],
        needed: &["coefficient"],
        written: "from: P, to: Q, coefficient: c",
    },
    Form {
        kind: ElementKind::Armature,
        statement: "armature",
        keys: &["of", "inertia"],
        needed: &["of", "inertia"],
        written: "of: theta, inertia: j",
    },
    Form {
        kind: ElementKind::Release,
        statement: "release",
        keys: &["point", "along", "frame", "about"],
        needed: &[],
        written: "point: P, along: L.y",
    },
];

impl ElementKind {
    fn form(self) -> &'static Form {
        FORMS.iter().find(|form| form.kind == self).unwrap_or(&FORMS[0])
    }

    /// The statement that declares it.
    pub fn statement(self) -> &'static str {
        self.form().statement
    }

    /// Whether it is a body or a particle.
    pub fn has_mass(self) -> bool {
        matches!(self, ElementKind::Body | ElementKind::Particle)
    }

    /// The kind that a statement declares.
    pub(crate) fn of(statement: &str) -> Option<Self> {
        FORMS.iter().find(|form| form.statement == statement).map(|form| form.kind)
    }
}

/// `name = { key: expression, .. }`
#[derive(Clone, Debug)]
pub struct Element {
    /// What it is.
    pub kind: ElementKind,
    /// Its name.
    pub name: Ident,
    /// The keys with their values, the inertia of a body apart.
    pub entries: Vec<(Ident, Expression)>,
    /// The inertia of a body.
    pub inertia: Option<BodyInertia>,
}

/// The inertia of a body, as written.
#[derive(Clone, Debug)]
pub enum BodyInertia {
    /// `diag(..)` or `matrix(..)`
    Matrix(Inertia),
    /// `rod(m, l, x)` and the like
    Shape(Expression),
}

impl Element {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&Expression> {
        self.entries.iter().find(|(name, _)| name == key).map(|(_, value)| value)
    }
}

/// One entry of an element's statement.
pub(super) fn element(kind: ElementKind, entry: &Entry, diagnostics: &mut Diagnostics) -> Option<Element> {
    let form = kind.form();
    let written = format!("name = {{ {} }}", form.written);
    let (left, _, right) = entry.assignment(&written, diagnostics)?;
    let name = single_ident(left, entry.place(), diagnostics);
    let group = match right {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Brace => group,
        _ => {
            diagnostics.report(entry.place(), messages::element_form(form.statement, form.written));
            return None;
        }
    };
    let name = name?;
    let mut element = Element { kind, name, entries: Vec::new(), inertia: None };
    let mut seen: Vec<String> = Vec::new();
    for entry in entries::split(group.stream(), group.span_close()) {
        let (key, colon, value) = match entry.tokens.as_slice() {
            [TokenTree::Ident(key), colon, value @ ..] if is_colon(colon) => (key.clone(), colon.span(), value),
            _ => {
                diagnostics.report(entry.place(), messages::element_form(form.statement, form.written));
                continue;
            }
        };
        let text = key.to_string();
        if !form.keys.contains(&text.as_str()) {
            let hint = did_you_mean(nearest(&text, form.keys.iter().copied()));
            let known: Vec<String> = form.keys.iter().map(|key| format!("`{key}`")).collect();
            diagnostics.report_local(&key, messages::element_key(&text, form.statement, known.join(", "), hint));
            continue;
        }
        if seen.contains(&text) {
            diagnostics.report_local(&key, messages::element_key_twice(&text));
            continue;
        }
        if kind == ElementKind::Body && text == "inertia" {
            element.inertia = body_inertia(value, colon, diagnostics);
        } else {
            element.entries.push((key, Expression::read(value, colon, diagnostics)));
        }
        seen.push(text);
    }
    let missing = |key: &&&str| !seen.iter().any(|seen| seen == **key);
    for key in form.needed.iter().filter(missing) {
        diagnostics.report_local(&element.name, messages::element_key_missing(key, &element.name));
    }
    lengths(&element, diagnostics);
    Some(element)
}

/// A spring or damper stands between two points, or along an expression; a point is released along a vector, a frame about one.
fn lengths(element: &Element, diagnostics: &mut Diagnostics) {
    let given = |key| element.get(key).is_some();
    if element.kind == ElementKind::Release {
        let pairs = [("point", "along"), ("frame", "about")];
        let begun: Vec<_> = pairs.iter().filter(|(first, second)| given(first) || given(second)).collect();
        match begun.as_slice() {
            [(first, second)] => {
                for key in [first, second].into_iter().filter(|key| !given(key)) {
                    diagnostics.report_local(&element.name, messages::element_key_missing(key, &element.name));
                }
            }
            _ => {
                let message =
                    messages::element_keys_exclude(&element.name, "`point` and `along`", "`frame` and `about`");
                diagnostics.report_local(&element.name, message);
            }
        }
    }
    if matches!(element.kind, ElementKind::Spring | ElementKind::Damper) {
        match (given("of"), given("from"), given("to")) {
            (true, false, false) | (false, true, true) => {}
            (true, ..) => {
                let message = messages::element_keys_exclude(&element.name, "`of`", "`from` and `to`");
                diagnostics.report_local(&element.name, message);
            }
            (false, true, false) => {
                diagnostics.report_local(&element.name, messages::element_key_missing("to", &element.name));
            }
            (false, ..) => {
                diagnostics.report_local(&element.name, messages::element_key_missing("from", &element.name))
            }
        }
    }
}

fn body_inertia(value: &[TokenTree], colon: Span, diagnostics: &mut Diagnostics) -> Option<BodyInertia> {
    match value {
        [TokenTree::Ident(form), TokenTree::Group(_)] if form == "diag" || form == "matrix" => {
            let span = form.span();
            let entries = entries::split(value.iter().cloned().collect(), span);
            forms::inertia(&entries, span, diagnostics).map(BodyInertia::Matrix)
        }
        _ => Some(BodyInertia::Shape(Expression::read(value, colon, diagnostics))),
    }
}
