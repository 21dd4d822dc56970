//! The kinetic energy as a measure of changes of the state.

use nalgebra::DMatrix;

use super::conditions::{entries, seeded};
use crate::forms::{dynamic_matrix, solve};
use crate::{ConstrainedSystem, Dual, Prepared, Vector};

/// Yᵀ M Y over some entries of the state, coordinates or speeds: twice the kinetic energy of a motion with those rates, or of
/// the velocities with those speeds. `None` where A is singular.
pub(super) fn kinetic_metric<M: ConstrainedSystem>(
    model: &Prepared<M>,
    dual: &Prepared<M, Dual>,
    t: f64,
    state: &[f64],
    among: &[usize],
) -> Option<DMatrix<f64>> {
    let coordinates = M::MODEL.state_coordinates.len();
    let x = model.coordinates(t, &M::State::from_fn(|i| state[i]));
    let column = |at: usize| {
        let s = seeded::<M::State<f64>, M::State<Dual>>(state, Some(at));
        if at < coordinates {
            entries(&dual.coordinates(Dual::constant(t), &s))
        } else {
            entries(&dual.velocities(Dual::constant(t), &s))
        }
    };
    let columns: alloc::vec::Vec<_> = among.iter().map(|at| column(*at)).collect();
    let n = M::MODEL.velocities.len();
    let mut rates = DMatrix::from_fn(n, among.len(), |i, j| columns[j][i].derivative);
    if among.first().is_some_and(|at| *at < coordinates) {
        // A Y = ∂x/∂q.
        rates = solve("A", dynamic_matrix(&model.kinematic_matrix(t, &x)), rates).ok()?;
    }
    Some(rates.transpose() * dynamic_matrix(&model.inertia(t, &x)) * rates)
}
