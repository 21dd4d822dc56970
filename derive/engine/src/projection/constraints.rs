//! Constraint rows in the acceleration form C v̇ + c0* = 0 (2.4).

use crate::model::{InitialSystem, Row, RowKind};
use crate::symbolic::{Expr, Graph, Symbol};
use proc_macro2::Span;

/// One row, differentiated as often as its kind asks for.
#[derive(Clone, Debug)]
pub struct DifferentiatedRow {
    /// The constraint's name.
    pub name: String,
    /// Where it stands.
    pub span: Span,
    /// f(x, t), for a position row.
    pub position: Option<Expr>,
    /// ḟ or φ as a function of (v, x, t): zero on the motion, linear in v.
    pub velocity: Expr,
    /// The row of C (2.5).
    pub gradient: Vec<Expr>,
    /// c0* (2.6): the derivative of `velocity` along the motion with v̇ = 0.
    pub bias: Expr,
}

/// The rates of (x, t) along the motion: ẋ = A v + a0 (2.1), ṫ = 1.
pub fn motion(system: &mut InitialSystem) -> Vec<(Symbol, Expr)> {
    let speeds = system.graph.vars(&system.speeds);
    let linear = system.kinematics.a.mul_vec(&mut system.graph, &speeds);
    let mut rates = Vec::with_capacity(linear.len() + 1);
    for ((x, a), a0) in system.coordinates.iter().zip(linear).zip(&system.kinematics.a0) {
        rates.push((*x, system.graph.add(a, *a0)));
    }
    rates.push((system.time, system.graph.one()));
    rates
}

/// All rows of the system, in the order of declaration.
pub fn differentiate(system: &mut InitialSystem) -> Vec<DifferentiatedRow> {
    let motion = motion(system);
    let speeds = system.speeds.clone();
    system.rows.clone().into_iter().map(|row| differentiate_row(&mut system.graph, row, &motion, &speeds)).collect()
}

fn differentiate_row(graph: &mut Graph, row: Row, motion: &[(Symbol, Expr)], speeds: &[Symbol]) -> DifferentiatedRow {
    let (position, velocity) = match row.kind {
        // ḟ = f_x (A v + a0) + f_t; its gradient in v is f_x A, the first line of (2.5).
        RowKind::Position(f) => (Some(f), graph.along(&[f], motion)[0]),
        RowKind::Velocity(phi) => (None, phi),
    };
    let gradient = graph.jacobian(&[velocity], speeds).row(0).to_vec();
    let bias = graph.along(&[velocity], motion)[0];
    DifferentiatedRow { name: row.name, span: row.span, position, velocity, gradient, bias }
}
