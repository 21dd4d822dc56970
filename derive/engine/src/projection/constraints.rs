//! Constraint rows in the acceleration form C v̇ + c0* = 0 (2.4).

use super::equations::{Level, RowFacts};
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
    /// Whether it may depend on other rows.
    pub redundant: bool,
    /// Whether `velocity` is linear in v.
    pub linear: bool,
    /// f(x, t), for a position row.
    pub position: Option<Expr>,
    /// ḟ or φ as a function of (v, x, t), zero on the motion; `None` for an acceleration row.
    pub velocity: Option<Expr>,
    /// The row of C (2.5).
    pub gradient: Vec<Expr>,
    /// Whether a force holds it.
    pub reaction: bool,
    /// c0* (2.6): the derivative of `velocity` along the motion with v̇ = 0, or as an acceleration row gives it.
    pub bias: Expr,
}

impl DifferentiatedRow {
    /// Whether speeds follow from it: f and linear φ take them out of the state, the others bind only accelerations.
    pub fn binds_speeds(&self) -> bool {
        self.linear && self.velocity.is_some()
    }

    /// What the row is, for those who use it; `redundant` if it does depend on other rows.
    pub fn facts(&self, redundant: bool) -> RowFacts {
        let level = match (self.position, self.velocity) {
            (Some(_), _) => Level::Position,
            (None, Some(_)) => Level::Velocity,
            (None, None) => Level::Acceleration,
        };
        RowFacts { name: self.name.clone(), level, linear: self.linear, redundant }
    }
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

/// [`motion`] where the norms of quaternions keep their length.
pub fn motion_of_norm(system: &mut InitialSystem) -> Vec<(Symbol, Expr)> {
    let (mut motion, held) = (motion(system), system.norms_held());
    if !held.is_empty() {
        let rates: Vec<Expr> = motion.iter().map(|(_, rate)| *rate).collect();
        let rates = system.graph.substitute(&rates, &held);
        motion.iter_mut().zip(rates).for_each(|((_, rate), new)| *rate = new);
    }
    motion
}

/// All rows of the system, in the order of declaration. Those of norms take the rates of the norms out of all others.
/// Where C is `handed_on`, it is found by one sweep back over each row: what a long chain hands on is not written out for every speed.
pub fn differentiate(system: &mut InitialSystem, handed_on: bool) -> Vec<DifferentiatedRow> {
    let motion = motion_of_norm(system);
    let speeds = system.speeds.clone();
    let rows = system.rows.clone().into_iter();
    rows.map(|row| differentiate_row(&mut system.graph, row, &motion, &speeds, handed_on)).collect()
}

fn differentiate_row(
    graph: &mut Graph,
    row: Row,
    motion: &[(Symbol, Expr)],
    speeds: &[Symbol],
    handed_on: bool,
) -> DifferentiatedRow {
    let Row { name, span, kind, redundant, .. } = row;
    let reaction = !matches!(kind, RowKind::Norm { .. });
    let (linear, position, velocity) = match kind {
        // ḟ = f_x (A v + a0) + f_t; its gradient in v is f_x A, the first line of (2.5).
        RowKind::Position(f) => (true, Some(f), graph.along(&[f], motion)[0]),
        RowKind::Norm { f, rate } => (true, Some(f), graph.var(rate)),
        RowKind::Velocity(phi) => (true, None, phi),
        // The same two lines hold: C = ∂φ/∂v, c0* = φ_x ẋ + φ_t.
        RowKind::Nonlinear(phi) => (false, None, phi),
        RowKind::Acceleration { gradient, bias } => {
            return DifferentiatedRow {
                name,
                span,
                redundant,
                linear: true,
                position: None,
                velocity: None,
                gradient,
                reaction,
                bias,
            };
        }
    };
    let slopes = if handed_on { graph.slopes(velocity, speeds) } else { None };
    let gradient = slopes.unwrap_or_else(|| graph.jacobian(&[velocity], speeds).row(0).to_vec());
    let bias = graph.along(&[velocity], motion)[0];
    DifferentiatedRow { name, span, redundant, linear, position, velocity: Some(velocity), gradient, reaction, bias }
}
