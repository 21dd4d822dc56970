//! States on the constraint manifold: Newton's method on f, least squares on φ.

use super::declaration::Level;
use super::linear::seeded;
use super::number::{Dual, Number};
use super::system::System;
use nalgebra::{DMatrix, DVector};

/// Directions below this part of the largest are none while a configuration is closed.
const DEPENDS: f64 = 1e-6;

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
        // rows that depend on others where all hold are nearly dependent nearby, and say nothing that the others do not say
        let svd = jacobian.svd(true, true);
        let step = svd.solve(&f, DEPENDS * svd.singular_values.max()).ok()?;
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

/// Velocities near the given ones that satisfy every row at velocity level, or `None` if Newton's method does not close.
pub fn onto_velocity_rows(system: &System<'_>, t: f64, x: &[f64], v: &[f64]) -> Option<Vec<f64>> {
    onto_rows(system, t, x, v, |_| true, |u| u.to_vec())
}

/// Speeds u near the given ones whose velocities satisfy the rows that are not linear in v.
///
/// The velocities are affine in u and satisfy the linear rows by themselves.
pub fn onto_nonlinear_rows(
    system: &System<'_>,
    t: f64,
    x: &[f64],
    u: &[f64],
    velocities: impl Fn(&[f64]) -> Vec<f64>,
) -> Option<Vec<f64>> {
    let linear = system.rows(t, x, &velocities(u)).linear;
    onto_rows(system, t, x, u, |row| !linear[row], velocities)
}

/// Newton's method in u for rows in v = B u + b, by the least change of u in each step.
fn onto_rows(
    system: &System<'_>,
    t: f64,
    x: &[f64],
    u: &[f64],
    wanted: impl Fn(usize) -> bool,
    velocities: impl Fn(&[f64]) -> Vec<f64>,
) -> Option<Vec<f64>> {
    let binds = |row: &usize| system.model.constraints[*row].level != Level::Acceleration && wanted(*row);
    let rows: Vec<usize> = (0..system.model.constraints.len()).filter(binds).collect();
    if rows.is_empty() || u.is_empty() {
        return Some(u.to_vec());
    }
    let bias = DVector::from_vec(velocities(&vec![0.0; u.len()]));
    let column = |j: usize| {
        let unit: Vec<f64> = (0..u.len()).map(|i| f64::from(u8::from(i == j))).collect();
        DVector::from_vec(velocities(&unit)) - &bias
    };
    let b = DMatrix::from_columns(&(0..u.len()).map(column).collect::<Vec<_>>());
    let mut u = DVector::from_column_slice(u);
    let fixed: Vec<Dual<f64>> = x.iter().map(|&x| Dual::fixed(x)).collect();
    for _ in 0..50 {
        let v = &b * &u + &bias;
        let residual = DVector::from_fn(rows.len(), |i, _| system.velocity(rows[i], t, x, v.as_slice()));
        let slope =
            |i: usize, j: usize| system.velocity(rows[i], Dual::constant(t), &fixed, &seeded(v.as_slice(), j)).rate;
        let jacobian = DMatrix::from_fn(rows.len(), v.len(), slope) * &b;
        let step = jacobian.svd(true, true).solve(&residual, 1e-9).ok()?;
        u -= &step;
        let scale = u.amax().max(1.0);
        if !scale.is_finite() || scale > 10.0 {
            return None;
        }
        if step.amax() < 4.0 * f64::EPSILON * scale {
            break;
        }
    }
    let v = &b * &u + &bias;
    // rows that depend on each other leave a residual step of rounding size
    rows.iter().all(|&row| system.velocity(row, t, x, v.as_slice()).abs() < 1e-12).then(|| u.as_slice().to_vec())
}
