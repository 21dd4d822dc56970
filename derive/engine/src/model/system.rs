//! The initial system: what a model declares, as expressions.

use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use proc_macro2::Span;

/// A constraint-free system with the constraints that are to bind it: ẋ = A v + a0 (2.1), M v̇ = h* (2.3), rows f or φ.
#[derive(Clone, Debug)]
pub struct InitialSystem {
    /// The arena of all expressions.
    pub graph: Graph,
    /// t.
    pub time: Symbol,
    /// Parameters that the equations use, in the order of the fields.
    pub parameters: Vec<Symbol>,
    /// Inputs.
    pub inputs: Vec<Symbol>,
    /// x, n of them.
    pub coordinates: Vec<Symbol>,
    /// v, n of them; `dot_<x>` where the model names no speeds.
    pub speeds: Vec<Symbol>,
    /// Both directions of the kinematics.
    pub kinematics: Kinematics,
    /// M, n x n, symmetric.
    pub inertia: Matrix,
    /// The statement that gives M.
    pub inertia_span: Span,
    /// h*, n.
    pub forces: Vec<Expr>,
    /// V(x, t), for reports of the energy.
    pub potential: Option<Expr>,
    /// The constraints, in the order of declaration.
    pub rows: Vec<Row>,
    /// x = g(q, t) (4.2).
    pub configuration: Option<Configuration>,
    /// The independent speeds that the model names: expressions in v, or in q̇ where there is a configuration.
    pub independent: Option<Vec<(Expr, Span)>>,
    /// The statement that names them.
    pub independent_span: Span,
    /// D, row by row, as the model gives it.
    pub complement: Option<Vec<ComplementRow>>,
    /// The statement that gives D.
    pub complement_span: Span,
    /// Values of coordinates and speeds for judging (`start`). They never enter emitted arithmetic.
    pub start: Vec<(Symbol, f64)>,
    /// Values of parameters for judging (`nominal`).
    pub nominal: Vec<(Symbol, f64)>,
}

/// ẋ = A v + a0 (2.1) and v = B ẋ + b0 (2.2).
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// A, n x n.
    pub a: Matrix,
    /// a0, n.
    pub a0: Vec<Expr>,
    /// B = A⁻¹, n x n.
    pub b: Matrix,
    /// b0 = -A⁻¹ a0, n.
    pub b0: Vec<Expr>,
    /// What must not vanish for the inverse to exist: the factors of the inversion's divisors that are not numbers.
    pub pivots: Vec<Expr>,
}

/// A constraint.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// Its name in the model.
    pub span: Span,
    /// Left minus right side, by kind.
    pub kind: RowKind,
}

/// What a constraint binds, read off what it mentions.
#[derive(Copy, Clone, Debug)]
pub enum RowKind {
    /// f(x, t).
    Position(Expr),
    /// φ(v, x, t), linear in v; rates of coordinates stand as A v + a0.
    Velocity(Expr),
}

/// x = g(q, t).
#[derive(Clone, Debug)]
pub struct Configuration {
    /// q.
    pub coordinates: Vec<Symbol>,
    /// q̇, named `dot_<q>`.
    pub rates: Vec<Symbol>,
    /// g, one for each x.
    pub map: Vec<Expr>,
    /// The statement.
    pub span: Span,
}

/// A row of D.
#[derive(Clone, Debug)]
pub struct ComplementRow {
    /// The name of its speed.
    pub name: String,
    /// Its n entries.
    pub entries: Vec<Expr>,
    /// Where it stands.
    pub span: Span,
}
