//! What geometry statements declare, as it is written.

use super::families::{Indices, Named, written};
use super::statements::plain;
use std::collections::BTreeMap;
use syn::parse::{Parse, ParseStream};
use syn::{Expr, Ident, Result, Token, braced};

/// Frames, points, and everything that has a name and entries: bodies, forces, springs.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// `A = rotate(N, z, crank)`
    pub frames: BTreeMap<String, Expr>,
    /// `P = O + a*A.x`
    pub points: BTreeMap<String, Expr>,
    /// The acceleration of gravity, term by term.
    pub gravity: Vec<Expr>,
    /// Coordinates and speeds with the forces along them.
    pub generalized: Vec<(String, Expr)>,
    /// Joints that are let go to tell what holds them.
    pub releases: Vec<Record>,
    /// All else, in the order of its declaration.
    pub records: Vec<Record>,
}

/// `body(bar = { frame: A, .. })`
#[derive(Clone, Debug)]
pub struct Record {
    /// `body`, `particle`, `force`, ..
    pub kind: String,
    /// Its name.
    pub name: String,
    /// Its entries.
    pub entries: BTreeMap<String, Expr>,
}

impl Record {
    /// An entry that must be there.
    ///
    /// # Panics
    /// If it is not.
    pub fn entry(&self, key: &str) -> &Expr {
        self.entries.get(key).unwrap_or_else(|| panic!("{} {} has no `{key}`", self.kind, self.name))
    }

    /// Whether it has mass.
    pub fn has_mass(&self) -> bool {
        matches!(self.kind.as_str(), "body" | "particle")
    }

    /// Where its mass centre is.
    pub fn center(&self) -> &Expr {
        self.entry(if self.kind == "body" { "center" } else { "at" })
    }
}

impl Geometry {
    /// Whether there is anything with mass.
    pub fn has_bodies(&self) -> bool {
        self.records.iter().any(Record::has_mass)
    }

    /// The body of that name.
    pub fn body(&self, name: &str) -> Option<&Record> {
        self.records.iter().find(|record| record.kind == "body" && record.name == name)
    }

    /// The body that a name stands for: a body, or a frame that exactly one body has.
    ///
    /// # Panics
    /// If it is neither.
    pub fn carrier(&self, name: &str) -> &Record {
        let in_frame =
            |record: &&Record| record.kind == "body" && plain(record.entry("frame")).as_deref() == Some(name);
        self.body(name).unwrap_or_else(|| {
            let mut bodies = self.records.iter().filter(in_frame);
            let (first, second) = (bodies.next(), bodies.next());
            first.filter(|_| second.is_none()).unwrap_or_else(|| panic!("`{name}` is not one body"))
        })
    }

    /// Whether an expression is a vector; names of definitions lead on to what they stand for.
    pub fn is_vector(&self, e: &Expr, definitions: &BTreeMap<String, Expr>) -> bool {
        let vector = |e: &Expr| self.is_vector(e, definitions);
        match e {
            Expr::Paren(inner) => vector(&inner.expr),
            Expr::Group(inner) => vector(&inner.expr),
            Expr::Unary(u) => vector(&u.expr),
            Expr::Binary(b) => vector(&b.left) || vector(&b.right),
            Expr::Field(_) => true,
            Expr::Path(_) => plain(e).is_some_and(|name| {
                name == "O" || self.points.contains_key(&name) || definitions.get(&name).is_some_and(vector)
            }),
            Expr::Call(call) => matches!(
                plain(&call.func).as_deref(),
                Some(
                    "cross"
                        | "unit"
                        | "velocity"
                        | "angular_velocity"
                        | "acceleration"
                        | "angular_acceleration"
                        | "momentum"
                        | "angular_momentum"
                )
            ),
            _ => false,
        }
    }
}

/// `bar = { frame: A, .. }`
pub struct NamedRecord {
    name: Named,
    entries: Vec<(Ident, Expr)>,
}

impl Parse for NamedRecord {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        let inner;
        braced!(inner in input);
        let entry = |input: ParseStream<'_>| {
            let key = input.parse()?;
            input.parse::<Token![:]>()?;
            Ok((key, input.parse()?))
        };
        let entries = inner.parse_terminated(entry, Token![,])?;
        Ok(Self { name, entries: entries.into_iter().collect() })
    }
}

impl NamedRecord {
    /// What it declares, as a statement of that name.
    pub fn record(&self, kind: &str, indices: &Indices) -> Record {
        let entries = self.entries.iter().map(|(key, e)| (key.to_string(), written(e, indices)));
        Record { kind: kind.to_string(), name: self.name.entry(indices), entries: entries.collect() }
    }
}
