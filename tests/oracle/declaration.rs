//! A model as it is declared: names and expressions, nothing computed.

use super::families::Indices;
use super::geometry::Geometry;
use std::collections::{BTreeMap, BTreeSet};
use syn::Expr;

/// The level at which a constraint binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// f(x, t) = 0.
    Position,
    /// φ(v, x, t) = 0, linear in v or not.
    Velocity,
    /// C v̇ + c0* = 0 as it is given.
    Acceleration,
}

/// One constraint, as left side minus right side.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Its name.
    pub name: String,
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
    /// Read off what the two sides mention.
    pub level: Level,
    /// The row may depend on the others.
    pub redundant: bool,
    /// The frame in whose axes a vector equation has its rows; `N` unless it says so.
    pub expressed: Expr,
    /// Whether it stands in a joint: rows that vanish are left out.
    pub in_short: bool,
}

/// An independent speed.
#[derive(Clone, Debug)]
pub struct Chosen {
    /// The name that the list gives it, where it does.
    pub name: Option<String>,
    /// What it is.
    pub value: Expr,
}

/// x = g(q, t) (4.2).
#[derive(Clone, Debug, Default)]
pub struct Configuration {
    /// q: the initial coordinates that are not given by g, then those introduced by `of`.
    pub coordinates: Vec<String>,
    /// g for the initial coordinates that have one; the others are their own.
    pub map: BTreeMap<String, Expr>,
    /// Its quasi-velocities.
    pub speeds: Vec<String>,
    /// What is said of its quasi-velocities (4.3): `u = ..` over q and q̇, or `dot(q) = ..` over q and u.
    pub quasi: Vec<(Expr, Expr)>,
}

/// A declared model.
#[derive(Clone, Debug, Default)]
pub struct Declaration {
    /// Name of the struct.
    pub name: String,
    /// Fields of type f64, with their nominal values.
    pub parameters: Vec<(String, Option<f64>)>,
    /// Inputs.
    pub inputs: Vec<String>,
    /// x.
    pub coordinates: Vec<String>,
    /// v; `dot_x` where none are declared.
    pub speeds: Vec<String>,
    /// dot(x) = …, in the order of x (2.1).
    pub rates: Option<Vec<Expr>>,
    /// v = …, in the order of v (2.2).
    pub speeds_by_rates: Option<Vec<Expr>>,
    /// Entries of M; `None` where symmetry gives it or where it is zero beside a diagonal. Empty where T is given instead.
    pub inertia: Vec<Vec<Option<Expr>>>,
    /// T.
    pub kinetic_energy: Option<Expr>,
    /// h*; with T alone, the forces beside those of inertia and of V.
    pub forces: Vec<Expr>,
    /// V.
    pub potential_energy: Option<Expr>,
    /// Constraints in the order of their declaration.
    pub constraints: Vec<Constraint>,
    /// x = g(q, t).
    pub configuration: Option<Configuration>,
    /// The speeds asked for as independent, list by list.
    pub charts: Vec<Vec<Chosen>>,
    /// Whether v = g(u, x, t) is given (5.8): then the state's speeds satisfy the nonlinear rows as well.
    pub gives_velocities: bool,
    /// Rows of D, each with the name of its speed.
    pub complement: Vec<(String, Vec<Expr>)>,
    /// Sizes of families.
    pub sizes: Indices,
    /// Functions of the user's.
    pub functions: BTreeSet<String>,
    /// Outputs in the order of their declaration.
    pub outputs: Vec<(String, Expr)>,
    /// Named intermediates.
    pub definitions: BTreeMap<String, Expr>,
    /// Start values.
    pub start: BTreeMap<String, f64>,
    /// Frames, points, bodies and what acts on them.
    pub geometry: Geometry,
}

impl Declaration {
    /// Number of speeds.
    pub fn n(&self) -> usize {
        self.speeds.len()
    }

    /// The nominal parameters, or one, in the order of the fields.
    pub fn nominal(&self) -> Vec<f64> {
        self.parameters.iter().map(|(_, value)| value.unwrap_or(1.0)).collect()
    }

    /// The coordinates of the state: q, or x without a configuration.
    pub fn state_coordinates(&self) -> &[String] {
        self.configuration.as_ref().map_or(&self.coordinates, |c| &c.coordinates)
    }
}
