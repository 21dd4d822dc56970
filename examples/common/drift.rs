//! How well an undriven run keeps what it must.

use holonomy::Trajectory;
use holonomy::prelude::*;

/// What a run without work done on it has lost.
pub struct Drift {
    /// The largest change of the energy at any state kept, in units of the largest kinetic energy of the run: the energy's own
    /// value is as large as one likes to measure heights.
    pub energy: f64,
    /// The largest residual of a constraint or of its rate at the end of any step, relative to the size of its terms.
    pub residual: f64,
}

/// By all velocities, as the speeds of the state do not tell them everywhere.
pub fn drift<M: ConstrainedSystem>(model: &Prepared<M>, run: &Trajectory<M>) -> Drift {
    let (mut first, mut changed, mut moved) = (None, 0.0f64, 0.0f64);
    for ((t, s), v) in run.iter().zip(run.velocities()) {
        let x = model.coordinates(t, s);
        let kinetic = model.kinetic_energy(t, &x, v);
        let energy = kinetic + model.potential_energy(t, &x).unwrap_or(f64::NAN);
        // A figure that is not a number stays one, and fails.
        let change = (energy - *first.get_or_insert(energy)).abs();
        changed = if change.is_nan() { f64::NAN } else { changed.max(change) };
        moved = moved.max(kinetic);
    }
    let residuals = run.largest_residuals();
    Drift { energy: changed / moved, residual: residuals.position.max(residuals.velocity) }
}
