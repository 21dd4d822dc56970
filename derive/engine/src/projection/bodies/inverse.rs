//! Momenta and inverse dynamics, outwards and inwards once each: O(n), whatever the mechanism.

use super::acting::{Acting, acting};
use super::partial::{Column, columns, moved};
use super::recursive::collected;
use super::releases;
use super::rotors::own_inertias;
use super::spatial::{Inertia, Wrench};
use crate::model::mechanism::{Along, Mechanism};
use crate::projection::Equations;
use crate::symbolic::{Expr, Graph, Symbol};

/// M v and M v̇ - h* of a model of bodies whose speeds are those of its joints.
pub fn tell(equations: &mut Equations) {
    let Some(mechanism) = equations.mechanism.take() else { return };
    let Some(along) = mechanism.along.clone() else { return };
    let n = equations.speeds.len();
    let released = mechanism.releases.iter().map(|release| release.rate);
    let speeds: Vec<Symbol> = equations.speeds.iter().copied().chain(released).collect();
    let graph = &mut equations.graph;
    let columns = columns(graph, &mechanism, &speeds);
    let mut moving = releases::stopped(graph, &mechanism);
    moving.whole = true;
    let padded = |graph: &Graph, symbols: &[Symbol]| {
        let mut list = graph.vars(symbols);
        list.resize(speeds.len(), graph.zero());
        list
    };
    let (v, rates) = (padded(graph, &equations.speeds), padded(graph, &equations.velocity_rate_symbols));
    let own = own_inertias(graph, &moving);
    equations.momenta = momenta(graph, &moving, &columns, &own, &v, &along);
    let acting = acting(graph, &moving, &along.motion);
    equations.inverse_dynamics = balance(graph, &moving, &columns, &rates, acting, &along);
    equations.momenta.truncate(n);
    equations.inverse_dynamics.truncate(n);
    equations.mechanism = Some(mechanism);
}

/// M w.
fn momenta(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    own: &[Inertia],
    w: &[Expr],
    along: &Along,
) -> Vec<Expr> {
    let wrenches = inertial(graph, mechanism, columns, own, w);
    let bodies = collected(graph, mechanism, columns, wrenches, w.len());
    let further = along.inertia.mul_vec(graph, w);
    bodies.into_iter().zip(further).map(|(a, b)| graph.add(a, b)).collect()
}

/// M v̇ - h*: what further forces along the speeds the accelerations need (Luh, Walker and Paul 1980).
pub fn balance(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    rates: &[Expr],
    acting: Acting,
    along: &Along,
) -> Vec<Expr> {
    let inertial = inertial(graph, mechanism, columns, &acting.own, rates);
    let wrenches =
        inertial.into_iter().zip(&acting.wrenches).map(|(needed, there)| needed.less(there, graph)).collect();
    let bodies = collected(graph, mechanism, columns, wrenches, rates.len());
    let further = along.inertia.mul_vec(graph, rates);
    let parts = bodies.into_iter().zip(further).zip(&along.forces);
    parts
        .map(|((a, b), force)| {
            let needed = graph.add(a, b);
            graph.sub(needed, *force)
        })
        .collect()
}

/// What accelerations J w of the bodies need.
fn inertial(
    graph: &mut Graph,
    mechanism: &Mechanism,
    columns: &[Vec<Column>],
    own: &[Inertia],
    w: &[Expr],
) -> Vec<Wrench> {
    let moved = moved(graph, mechanism, columns, |_, at, place, _| w[columns[at][place].speed]);
    let of = own.iter().zip(&moved).map(|(inertia, moved)| {
        let (force, torque) = inertia.of(&moved.linear, &moved.angular, graph);
        Wrench::new(force, torque)
    });
    of.collect()
}
