//! Newton's method for fewer equations than unknowns, or for equations that cannot all be met.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::forms::least_squares;

/// A residual below this many units of rounding of its terms is met.
const MET: f64 = 8.0 * f64::EPSILON;
/// Where Newton's method makes no more progress, a residual below this fraction of its terms is met.
pub(crate) const STALLED: f64 = 1e-12;
/// Singular values below this fraction of the largest count as zero.
const RANK: f64 = 1e-10;
/// Full steps end where the residuals are below this fraction of their terms: the way down is short from there.
const NEAR: f64 = 1e-3;
const FULL_STEPS: usize = 60;
const ITERATIONS: usize = 200;
const HALVINGS: usize = 40;

/// Equations r(y) = 0.
pub(crate) trait Equations {
    /// r at y; entries that cannot be had are not a number.
    fn residual(&self, y: &[f64]) -> Vec<f64>;
    /// ∂r/∂y.
    fn jacobian(&self, y: &[f64]) -> DMatrix<f64>;
    /// S: of all steps S z that serve, the one with the shortest z is taken.
    fn measure(&self, y: &[f64]) -> DMatrix<f64>;
}

/// Moves y until the equations are met or no step makes the residual smaller. `sizes` are the sizes of the residuals' terms;
/// they grow with what is met on the way.
pub(crate) fn newton(equations: &dyn Equations, y: &mut Vec<f64>, sizes: &mut [f64]) -> Vec<f64> {
    let mut r = equations.residual(y);
    for _ in 0..ITERATIONS {
        if worst(&r, sizes).1 <= MET {
            break;
        }
        let jacobian = equations.jacobian(y);
        for (i, size) in sizes.iter_mut().enumerate() {
            let sum: f64 = y.iter().enumerate().map(|(j, y)| (jacobian[(i, j)] * y).abs()).sum();
            if sum > *size && sum.is_finite() {
                *size = sum;
            }
        }
        if worst(&r, sizes).1 <= MET {
            break;
        }
        let Some(step) = shortest_step(&jacobian, &equations.measure(y), &r, sizes) else {
            break;
        };
        let Some((next, residual)) = descend(equations, y, &step, &r, sizes) else {
            break;
        };
        (*y, r) = (next, residual);
    }
    r
}

/// Takes full steps of Newton's method, whether or not they make the residual smaller, until y is near a solution, or for so
/// many steps: it leaves places where no small step makes the residual smaller, and may come near any solution.
pub(crate) fn wander(equations: &dyn Equations, y: &mut [f64], sizes: &[f64]) {
    for _ in 0..FULL_STEPS {
        let r = equations.residual(y);
        if worst(&r, sizes).1 <= NEAR {
            break;
        }
        let Some(step) = shortest_step(&equations.jacobian(y), &equations.measure(y), &r, sizes) else {
            break;
        };
        y.iter_mut().zip(step.iter()).for_each(|(y, delta)| *y += delta);
    }
}

/// The largest residual relative to its terms, and its row. NaN counts as infinite.
pub(crate) fn worst(r: &[f64], sizes: &[f64]) -> (usize, f64) {
    let ratios = r.iter().zip(sizes).map(|(residual, size)| ratio(*residual, *size)).enumerate();
    ratios.fold((0, 0.0), |worst, (i, ratio)| if ratio > worst.1 { (i, ratio) } else { worst })
}

/// A residual relative to the size of its terms.
fn ratio(residual: f64, size: f64) -> f64 {
    match residual.abs() {
        0.0 => 0.0,
        residual if residual.is_finite() && size > 0.0 => residual / size,
        _ => f64::INFINITY,
    }
}

fn weight(size: f64) -> f64 {
    if size > 0.0 { 1.0 / size } else { 1.0 }
}

/// The shortest step that meets the linearised equations, or comes nearest to it.
fn shortest_step(jacobian: &DMatrix<f64>, measure: &DMatrix<f64>, r: &[f64], sizes: &[f64]) -> Option<DVector<f64>> {
    let mut matrix = jacobian * measure;
    let right = DVector::from_fn(r.len(), |i, _| -r[i] * weight(sizes[i]));
    for (i, size) in sizes.iter().enumerate() {
        matrix.row_mut(i).scale_mut(weight(*size));
    }
    if matrix.iter().chain(right.iter()).any(|entry| !entry.is_finite()) {
        return None;
    }
    let step = measure * least_squares(matrix, &right, RANK);
    step.iter().any(|entry| *entry != 0.0).then_some(step)
}

/// The longest of the step, its half, its quarter … that makes the residual smaller.
fn descend(
    equations: &dyn Equations,
    y: &[f64],
    step: &DVector<f64>,
    r: &[f64],
    sizes: &[f64],
) -> Option<(Vec<f64>, Vec<f64>)> {
    let square =
        |r: &[f64]| -> f64 { r.iter().zip(sizes).map(|(r, size)| r * weight(*size)).map(|ratio| ratio * ratio).sum() };
    let before = square(r);
    let mut fraction = 1.0;
    for _ in 0..HALVINGS {
        let next: Vec<f64> = y.iter().zip(step.iter()).map(|(y, delta)| y + fraction * delta).collect();
        let residual = equations.residual(&next);
        // Also false where the residual is not a number.
        if square(&residual) <= (1.0 - 0.1 * fraction) * before {
            return Some((next, residual));
        }
        fraction *= 0.5;
    }
    None
}
