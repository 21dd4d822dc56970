//! All that acts along the speeds and is no body's: springs, dampers, armatures, a given potential, listed forces.

use super::energy::Potential;
use super::lines;
use crate::model::InitialSystem;
use crate::model::mechanism::{Along, Mechanism};
use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// Inertias and forces along the speeds, with their energies.
pub struct Further {
    /// What they add to M and h*.
    pub along: Along,
    /// T of armatures.
    pub kinetic: Expr,
    /// V.
    pub potential: Potential,
}

/// What acts along the speeds, those of what is released included.
pub fn further(
    system: &mut InitialSystem,
    mechanism: &Mechanism,
    speeds: &[Symbol],
    motion: &[(Symbol, Expr)],
    potential: Potential,
) -> Further {
    let norms = system.norm_rates();
    let graph = &mut system.graph;
    let (inertia, kinetic) = (Matrix::zeros(graph, speeds.len(), speeds.len()), graph.zero());
    let along = Along { inertia, forces: vec![graph.zero(); speeds.len()], motion: motion.to_vec() };
    let mut further = Further { along, kinetic, potential };
    lines::add(graph, &mechanism.lines, speeds, motion, &mut further);
    if let Some(given) = system.potential {
        further.potential.terms.push(given);
        let slopes = graph.jacobian(&[given], &system.coordinates);
        let mut driven = system.kinematics.a.transpose().mul_vec(graph, slopes.row(0));
        let released: Vec<Symbol> = mechanism.releases.iter().map(|release| release.coordinate).collect();
        driven.extend(graph.jacobian(&[given], &released).row(0));
        for (force, slope) in further.along.forces.iter_mut().zip(driven) {
            *force = graph.sub(*force, slope);
        }
    }
    for ((force, listed), further) in further.along.forces.iter_mut().zip(&system.forces).zip(&mechanism.generalized) {
        *force = graph.sum(&[*force, *listed, *further]);
    }
    // A norm has no inertia, no force acts along it, and its rate is zero: any other inertia leaves M regular and changes nothing else.
    for (i, _) in speeds.iter().enumerate().filter(|(_, speed)| norms.contains(speed)) {
        further.along.forces[i] = graph.zero();
        further.along.inertia.set(i, i, graph.one());
    }
    further
}

impl Further {
    /// Adds these to what the bodies give.
    pub fn add_to(&self, graph: &mut Graph, inertia: &mut Matrix, forces: &mut [Expr]) {
        for (entry, more) in inertia.entries_mut().iter_mut().zip(self.along.inertia.entries()) {
            *entry = graph.add(*entry, *more);
        }
        for (force, more) in forces.iter_mut().zip(&self.along.forces) {
            *force = graph.add(*force, *more);
        }
    }
}
