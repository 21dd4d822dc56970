//! One namespace: fields, coordinates, speeds, inputs and defines, and what an expression mentions.

use std::collections::BTreeMap;
use std::ops::BitOrAssign;

use proc_macro2::Ident;

use super::functions::FUNCTIONS;
use super::geometry::VECTOR_FUNCTIONS;
use crate::syntax::{Declarations, Diagnostics, Element, ElementKind, Speed, did_you_mean, messages, nearest};

/// Names with a meaning of their own.
const RESERVED: [(&str, &str); 4] =
    [("t", "the time"), ("PI", "the number π"), ("N", "the inertial frame"), ("O", "the origin")];

/// What a name stands for; the index is that in the list of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    Field(usize),
    Coordinate(usize),
    /// A generalised coordinate from `configuration(of(..))`.
    Further(usize),
    Speed(usize),
    /// A quasi-velocity from `configuration(speeds(..))`.
    Quasi(usize),
    /// An independent speed from `velocities(of(..))`.
    Free(usize),
    /// A combination of speeds from `independent(s = ..)`, counted through all lists.
    Combination(usize),
    Input(usize),
    Define(usize),
    /// A function of the user's.
    Function(usize),
    Frame(usize),
    Point(usize),
    /// A body or a particle, counted among these.
    Body(usize),
    /// A force, torque, spring and the like.
    Acting(ElementKind),
    Inertial,
    Origin,
    Time,
    Pi,
}

impl Meaning {
    /// For messages: "`x` is ..".
    pub fn describe(self) -> &'static str {
        match self {
            Meaning::Field(_) => "a field",
            Meaning::Coordinate(_) => "a coordinate",
            Meaning::Further(_) => "a coordinate of `configuration`",
            Meaning::Speed(_) => "a speed",
            Meaning::Quasi(_) => "a speed of `configuration`",
            Meaning::Free(_) => "a speed of `velocities`",
            Meaning::Combination(_) => "a combination of speeds in `independent`",
            Meaning::Input(_) => "an input",
            Meaning::Define(_) => "a define",
            Meaning::Function(_) => "a function",
            Meaning::Frame(_) => "a frame",
            Meaning::Point(_) => "a point",
            Meaning::Body(_) => "a body",
            Meaning::Acting(ElementKind::Force) => "a force",
            Meaning::Acting(ElementKind::Torque) => "a torque",
            Meaning::Acting(ElementKind::Spring) => "a spring",
            Meaning::Acting(ElementKind::Damper) => "a damper",
            Meaning::Acting(_) => "an armature",
            Meaning::Inertial => "the inertial frame",
            Meaning::Origin => "the origin",
            Meaning::Time => "the time",
            Meaning::Pi => "the number π",
        }
    }
}

/// All names of a model.
pub(super) struct Names {
    table: BTreeMap<String, Meaning>,
    /// The lengths of arrays, whose entries stand in the table.
    arrays: BTreeMap<String, i64>,
    /// The names of outputs, which stand in no table: they are a namespace of their own.
    outputs: Vec<String>,
    /// Those of constraints, which are another one.
    constraints: Vec<String>,
}

impl Names {
    /// Enters every name; reserved and duplicate ones are reported.
    pub fn of(declarations: &Declarations, diagnostics: &mut Diagnostics) -> Self {
        let known = [("t", Meaning::Time), ("PI", Meaning::Pi), ("N", Meaning::Inertial), ("O", Meaning::Origin)];
        let table = known.into_iter().map(|(name, meaning)| (name.to_owned(), meaning)).collect();
        let outputs = declarations.outputs.iter().map(|output| output.name.ident.to_string()).collect();
        let constraints = declarations.constraints.iter().map(|constraint| &constraint.name);
        let constraints = constraints.chain(declarations.geometry.releases().map(|release| &release.name));
        let constraints = constraints.map(ToString::to_string).collect();
        let mut names = Names { table, arrays: declarations.arrays.clone(), outputs, constraints };
        let mut enter = |ident: &Ident, meaning| names.enter(ident, meaning, diagnostics);
        for (i, field) in declarations.fields.iter().enumerate() {
            enter(&field.ident, Meaning::Field(i));
        }
        for (i, name) in declarations.coordinates.iter().enumerate() {
            enter(&name.ident, Meaning::Coordinate(i));
        }
        for (i, name) in declarations.configuration.iter().flat_map(|c| &c.further).enumerate() {
            enter(&name.ident, Meaning::Further(i));
        }
        let quaternions = declarations.quaternions();
        for (i, speed) in declarations.all_speeds(&quaternions).into_iter().enumerate() {
            let of = match speed {
                Speed::Given(at) => declarations.speeds.as_ref().map(|speeds| speeds.names[at].ident.clone()),
                Speed::Rate(_) => None,
                Speed::Angular(at, _) | Speed::Norm(at) => {
                    let name = declarations.speed_name(speed, &quaternions);
                    Some(Ident::new(&name, quaternions[at].name.span()))
                }
            };
            if let Some(ident) = of {
                enter(&ident, Meaning::Speed(i));
            }
        }
        for (i, name) in declarations.configuration.iter().flat_map(|c| &c.speeds).enumerate() {
            enter(&name.ident, Meaning::Quasi(i));
        }
        for (i, name) in declarations.velocities.iter().flat_map(|v| &v.further).enumerate() {
            enter(&name.ident, Meaning::Free(i));
        }
        for (i, (name, _)) in declarations.independent.iter().flat_map(|list| list.combinations()).enumerate() {
            enter(&name.ident, Meaning::Combination(i));
        }
        for (i, name) in declarations.inputs.iter().enumerate() {
            enter(&name.ident, Meaning::Input(i));
        }
        for (i, define) in declarations.defines.iter().enumerate() {
            enter(&define.name, Meaning::Define(i));
        }
        let geometry = &declarations.geometry;
        for (i, frame) in geometry.frames.iter().enumerate() {
            enter(&frame.name, Meaning::Frame(i));
        }
        for (i, point) in geometry.points.iter().enumerate() {
            enter(&point.name, Meaning::Point(i));
        }
        for (i, body) in geometry.bodies().enumerate() {
            enter(&body.name, Meaning::Body(i));
        }
        // A release is a reaction, as a constraint is.
        let named = |element: &&Element| !element.kind.has_mass() && element.kind != ElementKind::Release;
        for element in geometry.elements.iter().filter(named) {
            enter(&element.name, Meaning::Acting(element.kind));
        }
        for (i, function) in declarations.functions.iter().enumerate() {
            let name = function.name.to_string();
            if FUNCTIONS.iter().chain(&VECTOR_FUNCTIONS).any(|(known, _)| *known == name) {
                let message = messages::duplicate_name(name, "a function of the model", "a function of the language");
                diagnostics.report(&function.name, message);
            } else {
                names.enter(&function.name, Meaning::Function(i), diagnostics);
            }
        }
        names
    }

    fn enter(&mut self, ident: &Ident, meaning: Meaning, diagnostics: &mut Diagnostics) {
        let name = ident.to_string();
        if reserved(ident, diagnostics) {
            return;
        }
        if let Some(other) = self.table.get(&name) {
            diagnostics.report(ident, messages::duplicate_name(name, meaning.describe(), other.describe()));
        } else if let Some(of) = self.rate_of(&name) {
            diagnostics.report(ident, messages::name_of_rate(&name, of));
        } else {
            self.table.insert(name, meaning);
        }
    }

    /// The coordinate of which this is the name of the rate in emitted code.
    pub fn rate_of<'a>(&self, name: &'a str) -> Option<&'a str> {
        let of = name.strip_prefix("dot_")?;
        matches!(self.table.get(of), Some(Meaning::Coordinate(_) | Meaning::Further(_))).then_some(of)
    }

    pub fn get(&self, name: &str) -> Option<Meaning> {
        self.table.get(name).copied()
    }

    /// The error for a name that is not there.
    pub fn unknown(&self, name: &str) -> String {
        if self.outputs.iter().any(|output| output == name) {
            return messages::output_out_of_place(name);
        }
        self.missing(name)
    }

    /// The same for a name that is no output's either.
    pub fn missing(&self, name: &str) -> String {
        if FUNCTIONS.iter().chain(&VECTOR_FUNCTIONS).any(|(function, _)| *function == name) {
            return messages::function_as_name(name);
        }
        if self.constraints.iter().any(|constraint| constraint == name) {
            return messages::constraint_as_name(name);
        }
        if let Some(length) = self.arrays.get(name) {
            return messages::array_without_index(name, length);
        }
        let hint = match self.rate_of(name) {
            Some(of) => messages::write_dot(of),
            None => did_you_mean(nearest(name, self.table.keys().map(String::as_str))),
        };
        messages::unknown_name(name, hint)
    }
}

/// Whether a name has a meaning of its own, which is reported.
pub(super) fn reserved(ident: &Ident, diagnostics: &mut Diagnostics) -> bool {
    let name = ident.to_string();
    let found = RESERVED.iter().find(|(reserved, _)| *reserved == name);
    if let Some((_, what)) = found {
        diagnostics.report(ident, messages::reserved_name(name, what));
    }
    found.is_some()
}

/// A set of kinds of names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Mentions(u16);

impl Mentions {
    pub const NONE: Self = Mentions(0);
    pub const PARAMETERS: Self = Mentions(1);
    pub const TIME: Self = Mentions(2);
    pub const COORDINATES: Self = Mentions(4);
    pub const FURTHER: Self = Mentions(8);
    pub const SPEEDS: Self = Mentions(16);
    pub const RATES: Self = Mentions(32);
    pub const INPUTS: Self = Mentions(64);
    pub const ACCELERATIONS: Self = Mentions(128);
    pub const FURTHER_RATES: Self = Mentions(256);
    pub const QUASI: Self = Mentions(512);
    pub const FREE: Self = Mentions(1024);
    pub const COMBINATIONS: Self = Mentions(16384);
    pub const REACTIONS: Self = Mentions(2048);
    /// Rates of what only a configuration has: its coordinates twice, its speeds once.
    pub const FURTHER_ACCELERATIONS: Self = Mentions(4096);
    /// Other outputs; what these mention counts besides.
    pub const OUTPUTS: Self = Mentions(8192);

    /// What `dot` and `ddot` of a configuration's further coordinate are.
    pub fn of_further(function: &str) -> Mentions {
        if function == "dot" { Self::FURTHER_RATES } else { Self::FURTHER_ACCELERATIONS }
    }

    pub const fn and(self, other: Mentions) -> Mentions {
        Mentions(self.0 | other.0)
    }

    /// Those that are not in `allowed`.
    pub fn beyond(self, allowed: Mentions) -> Mentions {
        Mentions(self.0 & !allowed.0)
    }

    pub fn intersects(self, other: Mentions) -> bool {
        self.0 & other.0 != 0
    }

    /// For messages: the kind of what is mentioned, the most changeable first.
    pub fn describe(self) -> &'static str {
        [
            (Self::REACTIONS, "a reaction"),
            (Self::INPUTS, "an input"),
            (Self::ACCELERATIONS.and(Self::FURTHER_ACCELERATIONS), "an acceleration"),
            (Self::COMBINATIONS, "a combination of speeds in `independent`"),
            (Self::FREE, "a speed of `velocities`"),
            (Self::QUASI, "a speed of `configuration`"),
            (Self::FURTHER_RATES, "a rate"),
            (Self::RATES, "a rate"),
            (Self::SPEEDS, "a speed"),
            (Self::FURTHER, "a coordinate of `configuration`"),
            (Self::COORDINATES, "a coordinate"),
            (Self::TIME, "the time"),
            (Self::PARAMETERS, "a parameter"),
        ]
        .into_iter()
        .find(|(kind, _)| self.intersects(*kind))
        .map_or("a number", |(_, text)| text)
    }
}

impl BitOrAssign for Mentions {
    fn bitor_assign(&mut self, other: Mentions) {
        *self = self.and(other);
    }
}
