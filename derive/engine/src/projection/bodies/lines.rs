//! Springs, dampers and armatures: what acts along a scalar of the configuration.

use super::further::Further;
use crate::model::mechanism::{Line, LineKind};
use crate::symbolic::{Expr, Graph, Rational, Symbol};

/// What pulls along one scalar.
struct Pull {
    length: Expr,
    /// d.
    gradient: Vec<Expr>,
    /// Q.
    force: Expr,
}

/// Adds them: with d = ∂ṡ/∂v a force Q along s is d Q in h*, and an inertia j is j d dᵀ in M and -j d s̈ for v̇ = 0 in h*.
///
/// A spring and a damper along one scalar pull as one: their forces are summed before d multiplies them.
pub fn add(graph: &mut Graph, lines: &[Line], speeds: &[Symbol], motion: &[(Symbol, Expr)], sums: &mut Further) {
    let mut pulls: Vec<Pull> = Vec::new();
    for line in lines {
        let gradient = graph.jacobian(&[line.rate], speeds).row(0).to_vec();
        let force = match &line.kind {
            LineKind::Spring { stiffness, rest } => {
                let stretch = graph.sub(line.length, *rest);
                let square = graph.powi(stretch, 2);
                let energy = graph.mul(*stiffness, square);
                sums.potential.terms.push(graph.scale(Rational::Small(1, 2), energy));
                graph.mul(*stiffness, stretch)
            }
            LineKind::Damper { coefficient } => graph.mul(*coefficient, line.rate),
            LineKind::Armature { inertia } => {
                for (i, j) in (0..speeds.len()).flat_map(|i| (0..=i).map(move |j| (i, j))) {
                    let entry = graph.product(&[*inertia, gradient[i], gradient[j]]);
                    let sum = graph.add(sums.along.inertia.get(i, j), entry);
                    sums.along.inertia.set(i, j, sum);
                    sums.along.inertia.set(j, i, sum);
                }
                let square = graph.powi(line.rate, 2);
                let twice = graph.mul(*inertia, square);
                let energy = graph.scale(Rational::Small(1, 2), twice);
                sums.kinetic = graph.add(sums.kinetic, energy);
                let second = graph.along(&[line.rate], motion)[0];
                graph.mul(*inertia, second)
            }
        };
        match pulls.iter_mut().find(|pull| pull.length == line.length) {
            Some(pull) => pull.force = graph.add(pull.force, force),
            None => pulls.push(Pull { length: line.length, gradient, force }),
        }
    }
    for Pull { gradient, force, .. } in pulls {
        for (total, slope) in sums.along.forces.iter_mut().zip(&gradient) {
            let part = graph.mul(*slope, force);
            *total = graph.sub(*total, part);
        }
    }
}
