//! The equations of a tree joint by joint: what acts at its joints, h*, T and V, without M.

use super::acting::acting;
use super::articulated::Joints;
use super::energy::potential;
use super::further::further;
use super::inverse::balance;
use super::loops::Tree;
use super::partial::columns;
use super::recursive::collected;
use super::releases;
use crate::model::InitialSystem;
use crate::model::mechanism::Mechanism;
use crate::symbolic::{Expr, Matrix, Symbol};

/// Completes the system but for M where its speeds are those of a tree's joints, each of one joint; `None` where they are not.
pub fn complete(
    system: &mut InitialSystem,
    mechanism: &Mechanism,
    speeds: &[Symbol],
    motion: &[(Symbol, Expr)],
) -> Option<Tree> {
    if !system.is_tree() {
        return None;
    }
    let norms = system.norm_rates();
    let idle: Vec<bool> = system.speeds.iter().map(|speed| norms.contains(speed)).collect();
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
    let joints = Joints::eliminated(graph, &moving, columns.clone(), &acting.own, &further.along.inertia, &idle)?;
    let felt = joints.acting(graph, &moving, acting.wrenches.clone(), &further.along.forces[..n]);
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
    system.mechanism = Some(moving);
    Some(Tree { joints, acting: felt })
}
