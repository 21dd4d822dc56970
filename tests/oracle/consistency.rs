//! States on the constraint manifold: Newton's method on f, least squares on φ.

use super::declaration::Level;
use super::linear::seeded;
use super::number::{Dual, Number};
use super::system::System;
use nalgebra::{DMatrix, DVector};

/// Coordinates near the given ones with f(x, t) = 0 for every position row, or `None` if Newton's method does not close.
///
/// The least change of coordinates in each step; nothing is done with a configuration, whose coordinates are free.
pub fn closed(system: &System<'_>, t: f64, start: &[f64]) -> Option<Vec<f64>> {
    let levels = system.model.constraints.iter().enumerate();
    let rows: Vec<usize> = levels.filter(|(_, c)| c.level == Level::Position).map(|(i, _)| i).collect();
    if rows.is_empty() || system.model.configuration.is_some() {
        return Some(start.to_vec());
    }
    let mut x = start.to_vec();
    for _ in 0..50 {
        let f = DVector::from_iterator(rows.len(), rows.iter().map(|&row| system.position(row, t, &x)));
        let slope = |i: usize, j: usize| system.position(rows[i], Dual::fixed(t), &seeded(&x, j)).rate;
        let jacobian = DMatrix::from_fn(rows.len(), x.len(), slope);
        let step = jacobian.svd(true, true).solve(&f, 1e-12).ok()?;
        x.iter_mut().zip(step.iter()).for_each(|(x, step)| *x -= step);
        if x.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let scale = x.iter().fold(1.0_f64, |scale, x| scale.max(x.abs()));
        if step.amax() < 4.0 * f64::EPSILON * scale {
            return Some(x);
        }
    }
    // rows that depend on each other leave a residual step of rounding size
    rows.iter().all(|&row| system.position(row, t, &x).abs() < 1e-13).then_some(x)
}

/// The velocities nearest to the given ones that satisfy every row at velocity level.
pub fn onto_velocity_rows(system: &System<'_>, t: f64, x: &[f64], v: &[f64]) -> Vec<f64> {
    let m = system.model.constraints.len();
    let mut v = DVector::from_column_slice(v);
    for _ in 0..2 {
        let residual = DVector::from_fn(m, |i, _| system.velocity(i, t, x, v.as_slice()));
        let fixed: Vec<Dual<f64>> = x.iter().map(|&x| Dual::fixed(x)).collect();
        let slope = |i: usize, j: usize| system.velocity(i, Dual::constant(t), &fixed, &seeded(v.as_slice(), j)).rate;
        let jacobian = DMatrix::from_fn(m, v.len(), slope);
        if m > 0 {
            v -= jacobian.svd(true, true).solve(&residual, 1e-9).expect("both sets of singular vectors");
        }
    }
    v.as_slice().to_vec()
}
