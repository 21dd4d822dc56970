//! The equations of an open mechanism joint by joint: v̇, h*, T and V, without M.

use super::acting::acting;
use super::articulated::accelerations;
use super::energy::potential;
use super::further::further;
use super::inverse::balance;
use super::partial::columns;
use super::recursive::collected;
use super::releases;
use crate::model::InitialSystem;
use crate::model::mechanism::Mechanism;
use crate::symbolic::{Expr, Matrix, Symbol};

/// Completes the system where nothing ties its speeds and each of them is of one joint; whether it is so.
pub fn complete(
    system: &mut InitialSystem,
    mechanism: &Mechanism,
    speeds: &[Symbol],
    motion: &[(Symbol, Expr)],
) -> bool {
    if !system.is_open() {
        return false;
    }
    let n = system.speeds.len();
    let columns = columns(&mut system.graph, mechanism, speeds);
    let mut moving = releases::stopped(&mut system.graph, mechanism);
    moving.whole = true;
    let potential = potential(&mut system.graph, mechanism);
    let mut further = further(system, mechanism, speeds, motion, potential);
    let mut potential = further.potential.total(&mut system.graph);
    releases::hold_along(&mut system.graph, &mechanism.releases, &mut further, &mut potential);
    let graph = &mut system.graph;
    let acting = acting(graph, &moving, motion);
    let along = (&further.along.inertia, &further.along.forces[..n]);
    let Some(found) = accelerations(graph, &moving, &columns, &acting.own, &acting.wrenches, along) else {
        return false;
    };
    let forces = collected(graph, &moving, &columns, acting.wrenches.clone(), speeds.len());
    let forces = forces[..n].iter().zip(&further.along.forces).map(|(a, b)| graph.add(*a, *b)).collect();
    let kinetic = graph.add(acting.kinetic, further.kinetic);
    if !mechanism.releases.is_empty() {
        let mut rates = graph.vars(&system.outputs.accelerations);
        rates.resize(speeds.len(), graph.zero());
        let balance = balance(graph, &moving, &columns, &rates, acting, &further.along);
        releases::tell(system, &mechanism.releases, &balance[n..]);
    }
    moving.along = Some(further.along);
    system.inertia = Matrix::zeros(&system.graph, 0, 0);
    (system.forces, system.kinetic, system.potential) = (forces, Some(kinetic), potential);
    (system.open, system.mechanism) = (Some(found), Some(moving));
    true
}
