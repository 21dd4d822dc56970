//! What a model says, as it says it: the result of reading, before any name is resolved.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Span, TokenStream};
use syn::{Generics, Path, Type, Visibility};

use super::diagnostics::Place;
use super::expression::Expression;
use super::geometry::Geometry;

/// A derive input, statement by statement.
#[derive(Clone, Debug)]
pub struct Declarations {
    /// The struct's name.
    pub ident: Ident,
    /// The struct's visibility, which the emitted types share.
    pub vis: Visibility,
    /// The struct's generics with their where-clause.
    pub generics: Generics,
    /// The struct's fields in order: parameters and what passes through.
    pub fields: Vec<Field>,
    /// The arrays among the names with their lengths: `a[3]` stands for `a_0`, `a_1`, `a_2`.
    pub arrays: BTreeMap<String, i64>,
    /// `#[holonomy(..)]`.
    pub options: Options,
    /// `#[coordinates(..)]`, in order, without the further coordinates of `configuration`.
    pub coordinates: Vec<Name>,
    /// `#[speeds(..)]`; without it the speeds are the rates of the coordinates.
    pub speeds: Option<Speeds>,
    /// `#[inputs(..)]`.
    pub inputs: Vec<Name>,
    /// `#[define(..)]`, in order of appearance (which has no meaning).
    pub defines: Vec<Define>,
    /// `#[output(..)]`, in order.
    pub outputs: Vec<Output>,
    /// `#[function(..)]`, in order.
    pub functions: Vec<UserFunction>,
    /// `#[kinematics(..)]`, (2.1) or (2.2) or both.
    pub kinematics: Option<Kinematics>,
    /// `#[inertia(..)]`, M of (2.3).
    pub inertia: Option<Inertia>,
    /// `#[forces(..)]`, h* of (2.3); beside `kinetic_energy` the further generalised forces in it.
    pub forces: Option<List>,
    /// `#[kinetic_energy(..)]`, from which M and the inertia terms of h* follow.
    pub kinetic_energy: Option<Expression>,
    /// `#[potential_energy(..)]`.
    pub potential_energy: Option<Expression>,
    /// `#[constraint(..)]`, in order.
    pub constraints: Vec<Constraint>,
    /// `#[configuration(..)]`, (4.2).
    pub configuration: Option<Configuration>,
    /// `#[independent(..)]`, in order: the first names the state's speeds, the others are further charts.
    pub independent: Vec<Independent>,
    /// `#[velocities(..)]`, (5.8).
    pub velocities: Option<Velocities>,
    /// `#[complement(..)]`, D of (3.1) by rows.
    pub complement: Option<Complement>,
    /// `#[start(..)]`.
    pub start: Vec<Assignment>,
    /// `frame`, `point`, `body` and the like.
    pub geometry: Geometry,
    /// Whether errors, if there are any, left no more than holes in expressions. Otherwise names or
    /// entries are missing, and checks of the model would report what is not the user's mistake.
    pub complete: bool,
}

/// A field of the struct.
#[derive(Clone, Debug)]
pub struct Field {
    /// The field's name; `m_0` for the first entry of an array.
    pub ident: Ident,
    /// The field as it is read: `m`, or `m[0]`.
    pub member: TokenStream,
    /// Its type as written.
    pub ty: Type,
    /// Whether the type is written `f64` or is one of the struct's type parameters: such a field is
    /// a parameter of the equations as soon as one of them mentions it.
    pub scalar: bool,
    /// Its doc comment, line by line.
    pub docs: Vec<String>,
    /// `#[unit(..)]`.
    pub unit: Option<Unit>,
    /// `#[nominal(..)]`.
    pub nominal: Option<Expression>,
}

/// A unit of measurement: names with their exponents, sorted by name; empty for `1`.
#[derive(Clone, Debug)]
pub struct Unit {
    /// `kg*m/s` is `[("kg", 1), ("m", 1), ("s", -1)]`.
    pub factors: Vec<(String, i32)>,
    /// The names as they are written, with their places.
    pub names: Vec<(String, Span)>,
}

/// How the motion of bodies is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Elimination {
    /// By M_d as a whole.
    Matrix,
    /// Joint by joint from the leaves, loops closed on top.
    Recursive,
}

/// `#[holonomy(crate = path, simplify = off, elimination = recursive)]`.
#[derive(Clone, Debug)]
pub struct Options {
    /// The path under which emitted code finds the runtime.
    pub krate: Path,
    /// Whether the search for cheaper forms runs.
    pub simplify: bool,
    /// How the motion of bodies is to be found, where the model says so.
    pub elimination: Option<(Elimination, Span)>,
}

/// A name that a statement introduces, with the doc comment before it.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name.
    pub ident: Ident,
    /// Its doc comment, line by line.
    pub docs: Vec<String>,
    /// `#[unit(..)]` before it.
    pub unit: Option<Unit>,
}

/// `#[speeds(..)]`.
#[derive(Clone, Debug)]
pub struct Speeds {
    /// The names in order: v.
    pub names: Vec<Name>,
    /// The statement's own name, for errors about the whole.
    pub span: Span,
}

/// What an equation may have alone on its left, or `independent` in its list: a name or the rate of
/// a coordinate.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// `v1`
    Name(Ident),
    /// `dot(x)`, and where it stands.
    Rate(Ident, Place),
}

impl Quantity {
    /// The name inside.
    pub fn ident(&self) -> &Ident {
        match self {
            Quantity::Name(ident) | Quantity::Rate(ident, _) => ident,
        }
    }

    /// The name, or all of `dot(x)`.
    pub fn place(&self) -> Place {
        match self {
            Quantity::Name(ident) => ident.into(),
            Quantity::Rate(_, place) => *place,
        }
    }
}

impl std::fmt::Display for Quantity {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Quantity::Name(ident) => write!(formatter, "{ident}"),
            Quantity::Rate(ident, _) => write!(formatter, "dot({ident})"),
        }
    }
}

/// `name = value`
#[derive(Clone, Debug)]
pub struct Assignment {
    /// The left side.
    pub name: Ident,
    /// The right side.
    pub value: Expression,
}

/// `#[function(road(s), derivatives = [droad, ddroad])]`
#[derive(Clone, Debug)]
pub struct UserFunction {
    /// Its name in equations: the last segment of its path.
    pub name: Ident,
    /// The paths of the function, of its derivative, of the second derivative and so on.
    pub orders: Vec<Path>,
}

/// `#[define(mu = ..)]`
pub type Define = Assignment;

/// `#[output(power = ..)]`, or `#[output(mu)]` for what the model calls so already.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name, with the doc comment before it.
    pub name: Name,
    /// What it is.
    pub value: Expression,
}

/// A list of expressions.
#[derive(Clone, Debug)]
pub struct List {
    /// The expressions in order.
    pub entries: Vec<Expression>,
    /// The statement's own name.
    pub span: Span,
}

/// `#[kinematics(..)]`
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// `v1 = ..` (2.2) or `dot(x) = ..` (2.1), in order of appearance.
    pub entries: Vec<(Quantity, Expression)>,
    /// The statement's own name.
    pub span: Span,
}

/// `#[inertia(..)]`
#[derive(Clone, Debug)]
pub struct Inertia {
    /// How M is written.
    pub form: InertiaForm,
    /// The statement's own name.
    pub span: Span,
}

/// How M is written.
#[derive(Clone, Debug)]
pub enum InertiaForm {
    /// `diag(a, b, ..)`
    Diagonal(Vec<Expression>),
    /// `matrix([a, b], [_, c])`
    Matrix(Vec<InertiaRow>),
}

/// One `[a, _, ..]` of `matrix(..)`.
#[derive(Clone, Debug)]
pub struct InertiaRow {
    /// The entries in order.
    pub entries: Vec<InertiaEntry>,
    /// The row's bracket.
    pub span: Span,
}

/// One entry of `matrix(..)`.
#[derive(Clone, Debug)]
pub enum InertiaEntry {
    /// As written.
    Given(Expression),
    /// `_`: equal to the entry across the diagonal.
    Symmetric(Span),
}

/// `#[constraint(name: left == right)]` or `#[constraint(name: spherical(P, Q))]`, or with `, redundant` behind it.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// The constraint's name: the name of its multiplier and of its reaction.
    pub name: Ident,
    /// The left side, on which λ acts; or a joint.
    pub left: Expression,
    /// The right side; `None` for a joint.
    pub right: Option<Expression>,
    /// The `==`; of a joint its name.
    pub sign: Place,
    /// Whether the model says that it may depend on other constraints.
    pub redundant: bool,
    /// `expressed = B`: the frame of whose axes a vector equation's rows are components.
    pub expressed: Option<Ident>,
}

/// `#[configuration(of(alpha), x = .., z = 0)]`, and with quasi-velocities `speeds(u), dot(alpha) = ..` or `u = ..`
#[derive(Clone, Debug)]
pub struct Configuration {
    /// `of(..)`: generalised coordinates that are not initial ones.
    pub further: Vec<Name>,
    /// `speeds(..)`: the quasi-velocities u of (4.3).
    pub speeds: Vec<Name>,
    /// `dot(q) = ..` (4.3) or `u = ..`, in order of appearance.
    pub kinematics: Vec<(Quantity, Expression)>,
    /// The initial coordinates that are given as functions of the others.
    pub map: Vec<Assignment>,
    /// The statement's own name.
    pub span: Span,
}

/// `#[velocities(of(u), v1 = .., v2 = ..)]`
#[derive(Clone, Debug)]
pub struct Velocities {
    /// `of(..)`: independent speeds that are no speeds of the system.
    pub further: Vec<Name>,
    /// The speeds that are given as functions of the others and of these.
    pub map: Vec<(Quantity, Expression)>,
    /// The statement's own name.
    pub span: Span,
}

/// `#[independent(v6, dot(phi), s = v1 + 2*v2)]`
#[derive(Clone, Debug)]
pub struct Independent {
    /// The independent speeds in order: u.
    pub entries: Vec<IndependentEntry>,
    /// The statement's own name.
    pub span: Span,
}

impl Independent {
    /// The names that the list introduces, with what they stand for.
    pub fn combinations(&self) -> impl Iterator<Item = (&Name, &Expression)> {
        self.entries.iter().filter_map(|entry| match entry {
            IndependentEntry::Combination { name, value } => Some((name, value)),
            IndependentEntry::Speed(_) => None,
        })
    }
}

/// One independent speed.
#[derive(Clone, Debug)]
pub enum IndependentEntry {
    /// `v6` or `dot(phi)`
    Speed(Quantity),
    /// `s = v1 + 2*v2`
    Combination {
        /// The name that the combination gets in the state.
        name: Name,
        /// The combination.
        value: Expression,
    },
}

/// `#[complement(w1 = [..], ..)]`
#[derive(Clone, Debug)]
pub struct Complement {
    /// The rows of D in order.
    pub rows: Vec<ComplementRow>,
    /// The statement's own name.
    pub span: Span,
}

/// One `w1 = [..]` of `complement`.
#[derive(Clone, Debug)]
pub struct ComplementRow {
    /// The name of the row's speed.
    pub name: Ident,
    /// The row's entries.
    pub entries: Vec<Expression>,
    /// The row's bracket.
    pub span: Span,
}
