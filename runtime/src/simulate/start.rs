//! What must hold before the first step, and after a jump.

use crate::manifold::{Manifold, term_sizes};
use crate::{ConstrainedSystem, Error, Prepared};

/// The residual that a start may have in f and φ, as a fraction of the terms of the constraint.
pub const START_TOLERANCE: f64 = 1e-9;

/// f and φ of a state that takes the place of another one.
pub(super) fn check_on_manifold<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    v: &M::Velocities<f64>,
) -> Result<(), Error> {
    check_position(model, t, s)?;
    check_velocity(model, t, s, v)
}

/// f at the start; gives the manifold to stay on where the state holds the coordinates of position rows.
pub(crate) fn check_position<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
) -> Result<Option<Manifold<M>>, Error> {
    let mut manifold = Manifold::new(model, t, s)?;
    let f = model.position_residual_at(t, s).into();
    if let Some((row, residual)) = unmet(f.as_ref(), &manifold.sizes) {
        let constraint = M::MODEL.position_rows.get(row).copied().unwrap_or("position");
        return Err(Error::Unmet { constraint, residual });
    }
    // With independent coordinates, f is identically zero.
    Ok(if manifold.is_satisfied(t, s) { None } else { Some(manifold) })
}

/// φ at the start.
pub(crate) fn check_velocity<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    v: &M::Velocities<f64>,
) -> Result<(), Error> {
    let x = model.coordinates(t, s);
    let phi = model.velocity_residual(t, &x, v).into();
    let sizes = term_sizes(model, t, &x, v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
    match unmet(phi.as_ref(), &sizes) {
        Some((row, residual)) => Err(Error::Unmet {
            constraint: M::MODEL.velocity_rows().nth(row).map_or("velocity", |row| row.name),
            residual,
        }),
        None => Ok(()),
    }
}

/// The first row whose residual is too large for a start.
fn unmet(residuals: &[f64], sizes: &[f64]) -> Option<(usize, f64)> {
    let missed = |(residual, size): (&f64, &f64)| residual.is_nan() || residual.abs() > START_TOLERANCE * size;
    let row = residuals.iter().zip(sizes).position(missed)?;
    Some((row, residuals[row]))
}
