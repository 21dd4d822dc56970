//! From bodies to M and h*: Newton's and Euler's equations projected onto partial velocities.
//!
//! With V = (v, ω) the twists of the nodes that are heavy, V = J v + V0 and V̇ = J v̇ + γ, the bodies' own equations
//! 𝓜 V̇ + Ω × 𝓜 V = F, multiplied by Jᵀ, are (2.3) with
//!
//! ```text
//!     M = Jᵀ 𝓜 J,      h* = Jᵀ (F − 𝓜 γ − Ω × 𝓜 V)
//! ```
//!
//! which is the first stage of a chain of projections (4.10), its reactions those of joints that were never written as
//! constraints. Velocities and accelerations are found outwards along the tree of twists, forces are collected inwards.
//!
//! | file | idea |
//! |---|---|
//! | `rotors` | symmetric bodies need not turn their axes |
//! | `sweep` | velocities and accelerations, outwards |
//! | `spatial` | inertias about points, moved and turned |
//! | `recursive` | composite inertias and forces inwards, where each speed moves one joint: O(n²) in a chain |
//! | `direct` | body by body, where v are speeds of the model's own |
//! | `energy` | T, and V of gravity |
//! | `lines` | springs, dampers, armatures |
//! | `releases` | reactions of joints that are no constraints |

mod direct;
mod energy;
mod lines;
mod recursive;
mod releases;
mod rotors;
mod spatial;
mod sweep;

use super::Simplifier;
use super::constraints::motion_of_norm;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Matrix, Symbol};

/// M, h*, T and V of a system of bodies; what the model lists as forces is added to h*.
pub fn complete(system: &mut InitialSystem, simplifier: &mut dyn Simplifier) {
    let Some(mut mechanism) = system.mechanism.take() else { return };
    let motion = motion_of_norm(system);
    let n = system.speeds.len();
    let speeds = releases::extended(system, &mut mechanism);
    let own = system.joint_speeds || system.rates_are_speeds();
    let norms = system.norm_rates();
    let graph = &mut system.graph;
    rotors::stop(graph, &mut mechanism);
    let mut sums = match own {
        true => recursive::equations(graph, &mechanism, &speeds, &motion),
        false => direct::equations(graph, simplifier, &mechanism, &speeds, &motion),
    };
    let mut potential = energy::potential(graph, &mechanism);
    lines::add(graph, &mechanism.lines, &speeds, &motion, &mut sums, &mut potential);
    if let Some(given) = system.potential {
        potential.terms.push(given);
        let slopes = graph.jacobian(&[given], &system.coordinates);
        let mut driven = system.kinematics.a.transpose().mul_vec(graph, slopes.row(0));
        let released: Vec<Symbol> = mechanism.releases.iter().map(|release| release.coordinate).collect();
        driven.extend(graph.jacobian(&[given], &released).row(0));
        for (force, slope) in sums.forces.iter_mut().zip(driven) {
            *force = graph.sub(*force, slope);
        }
    }
    let mut potential = potential.total(graph);
    releases::hold(graph, &mechanism.releases, &mut sums, &mut potential);
    for ((force, listed), further) in sums.forces.iter_mut().zip(&system.forces).zip(&mechanism.generalized) {
        *force = graph.sum(&[*force, *listed, *further]);
    }
    // No force is needed to hold a norm, and none acts along it.
    for (force, speed) in sums.forces.iter_mut().zip(&system.speeds) {
        if norms.contains(speed) {
            *force = graph.zero();
        }
    }
    releases::tell(system, &mechanism.releases, &sums);
    let graph = &mut system.graph;
    let mut inertia = Matrix::zeros(graph, n, n);
    for (i, j) in (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        let entry = sums.inertia.get(i, j);
        let entry = if graph.vanishes(entry) { graph.zero() } else { simplifier.one(graph, entry) };
        inertia.set(i, j, entry);
        inertia.set(j, i, entry);
    }
    // A norm has no inertia, and its rate is zero: any other number leaves M regular and changes nothing else.
    for (i, _) in system.speeds.iter().enumerate().filter(|(_, speed)| norms.contains(speed)) {
        inertia.set(i, i, graph.one());
    }
    system.inertia = inertia;
    system.forces = sums.forces[..n].iter().map(|force| simplifier.one(graph, *force)).collect();
    system.kinetic = Some(sums.kinetic);
    system.potential = potential;
}

/// What bodies and lines add up to.
struct Sums {
    /// M, its lower triangle.
    inertia: Matrix,
    /// h*.
    forces: Vec<Expr>,
    /// T.
    kinetic: Expr,
}
