//! Collocation at Gauss' points: one implicit step of order 2s whose points keep away from the middle.
//!
//! The rate k(θ) is a sum of Legendre polynomials, κ_m P_m(2θ − 1), which is exact for what s points give: κ_m =
//! (2m + 1) Σ_j b_j P_m(ξ_j) k_j (Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed., section II.7, and
//! Hairer and Wanner, II, section IV.5). Integrated, y(θ) = y0 + h Σ κ_m ∫ P_m with ∫_0^θ P_m(2τ − 1) dτ =
//! (P_{m+1} − P_{m−1})/(2 (2m + 1)), and (ξ + 1)/2 for m = 0: at the end only κ_0 is left.

use alloc::vec;
use alloc::vec::Vec;

use super::flow::Point;
use crate::math::sin_cos;

/// Newton steps to a zero of a Legendre polynomial; from Chebyshev's points five are enough.
const NEWTON: usize = 10;

/// Gauss' points of one number, and the sums over them.
pub(super) struct Gauss {
    /// θ of the points, in their order.
    pub(super) points: Vec<f64>,
    /// (2m + 1) b_j P_m(ξ_j), by m.
    transform: Vec<Vec<f64>>,
}

/// P_0 … P_n at ξ, by (m + 1) P_{m+1} = (2m + 1) ξ P_m − m P_{m−1}.
fn legendre(n: usize, xi: f64) -> Vec<f64> {
    let mut values = vec![1.0, xi];
    for m in 1..n {
        let factor = m as f64;
        values.push(((2.0 * factor + 1.0) * xi * values[m] - factor * values[m - 1]) / (factor + 1.0));
    }
    values
}

impl Gauss {
    /// With s points, two at least.
    pub(super) fn new(s: usize) -> Self {
        let n = s as f64;
        let (mut points, mut weights) = (Vec::with_capacity(s), Vec::with_capacity(s));
        for i in 0..s {
            let mut xi = -sin_cos(core::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).1;
            let mut slope = 1.0;
            for _ in 0..NEWTON {
                let p = legendre(s, xi);
                slope = n * (xi * p[s] - p[s - 1]) / (xi * xi - 1.0);
                xi -= p[s] / slope;
            }
            points.push(0.5 * (1.0 + xi));
            // Those of [0, 1] are half of those of [−1, 1].
            weights.push(1.0 / ((1.0 - xi * xi) * slope * slope));
        }
        let values: Vec<Vec<f64>> = points.iter().map(|theta| legendre(s, 2.0 * theta - 1.0)).collect();
        let row = |m: usize| (0..s).map(|j| (2 * m + 1) as f64 * weights[j] * values[j][m]).collect();
        Gauss { transform: (0..s).map(row).collect(), points }
    }

    /// κ of the rates at the points.
    pub(super) fn expand<P: Point>(&self, rates: &[P]) -> Vec<P> {
        self.transform.iter().map(|row| combine(rates, |j| row[j])).collect()
    }
}

/// y0 + h Σ κ_m ∫_0^θ P_m.
pub(super) fn integral<P: Point>(y: &P, h: f64, kappa: &[P], theta: f64) -> P {
    let p = legendre(kappa.len(), 2.0 * theta - 1.0);
    let weight = |m: usize| match m {
        0 => theta,
        _ => (p[m + 1] - p[m - 1]) / (2 * (2 * m + 1)) as f64,
    };
    let rise = combine(kappa, weight);
    let mut point = *y;
    for i in 0..y.len() {
        *point.get_mut(i) += h * rise.get(i);
    }
    point
}

/// Σ κ_m P_m: the rate at a part of the step.
pub(super) fn slope<P: Point>(kappa: &[P], theta: f64) -> P {
    let p = legendre(kappa.len(), 2.0 * theta - 1.0);
    combine(kappa, |m| p[m])
}

/// A sum of points; there is one at least.
fn combine<P: Point>(points: &[P], weight: impl Fn(usize) -> f64) -> P {
    let mut sum = points[0];
    for i in 0..sum.len() {
        *sum.get_mut(i) = points.iter().enumerate().map(|(j, point)| weight(j) * point.get(i)).sum();
    }
    sum
}

/// The polynomial of the step in the form of the dense output, through `ahead` at its end.
///
/// In that form the first four coefficients are the cubic through the ends; of the others
/// c_4 + θ (c_5 + (1 − θ) (c_6 + …)) = (y − cubic)/(θ² (1 − θ)²), which is solved for at Gauss' points.
pub(super) fn dense<P: Point>(gauss: &Gauss, y: &P, h: f64, kappa: &[P], ahead: &P) -> Vec<P> {
    let s = gauss.points.len();
    let (first, last) = (slope(kappa, 0.0), slope(kappa, 1.0));
    let mut out = vec![*y; 4 + s];
    for i in 0..y.len() {
        let rise = ahead.get(i) - y.get(i);
        let bend = h * first.get(i) - rise;
        *out[1].get_mut(i) = rise;
        *out[2].get_mut(i) = bend;
        *out[3].get_mut(i) = rise - h * last.get(i) - bend;
    }
    let mut within: Vec<P> = gauss.points.iter().map(|theta| integral(y, h, kappa, *theta)).collect();
    let mut matrix = Vec::with_capacity(s);
    for (theta, point) in gauss.points.iter().zip(&mut within) {
        let flat = (theta * (1.0 - theta)) * (theta * (1.0 - theta));
        for i in 0..y.len() {
            let cubic = super::stages::interpolate(4, *theta, |j| out[j].get(i));
            *point.get_mut(i) = (point.get(i) - cubic) / flat;
        }
        let mut product = 1.0;
        let mut row = Vec::with_capacity(s);
        for j in 0..s {
            row.push(product);
            product *= if j % 2 == 0 { *theta } else { 1.0 - theta };
        }
        matrix.push(row);
    }
    solve(&mut matrix, &mut within);
    out[4..].copy_from_slice(&within);
    out
}

/// Elimination with row pivots; the solution takes the place of the right side.
fn solve<P: Point>(matrix: &mut [Vec<f64>], right: &mut [P]) {
    let n = right.len();
    for j in 0..n {
        let at = (j..n).fold(j, |at, i| if matrix[i][j].abs() > matrix[at][j].abs() { i } else { at });
        matrix.swap(j, at);
        right.swap(j, at);
        let (above, below) = matrix.split_at_mut(j + 1);
        for (row, i) in below.iter_mut().zip(j + 1..) {
            let factor = row[j] / above[j][j];
            row.iter_mut().zip(&above[j]).skip(j).for_each(|(entry, pivot)| *entry -= factor * pivot);
            subtract(right, i, j, factor);
        }
    }
    for j in (0..n).rev() {
        for (i, factor) in matrix[j].iter().enumerate().skip(j + 1) {
            subtract(right, j, i, *factor);
        }
        for e in 0..right[j].len() {
            *right[j].get_mut(e) /= matrix[j][j];
        }
    }
}

/// Takes a multiple of one point from another.
fn subtract<P: Point>(points: &mut [P], from: usize, what: usize, factor: f64) {
    let taken = points[what];
    for e in 0..taken.len() {
        *points[from].get_mut(e) -= factor * taken.get(e);
    }
}

#[cfg(test)]
mod tests;
