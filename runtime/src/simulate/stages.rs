//! One step: its stages, its first size, its dense output.

use core::ops::Range;

use super::control::Tolerance;
use super::flow::{Flow, Point};
use super::kernel::Plan;
use super::tableau::Tableau;
use crate::math::double::pow;
use crate::{ConstrainedSystem, Error};

/// The most coefficients that a method's dense output has.
pub(super) const COEFFICIENTS: usize = 8;

/// Stages of one step: their rates go to k; returns the point and the guards at the last one.
///
/// Where `judged`, the guards of every stage must be regular; steps of adaptive methods are rejected where they are not.
/// The only call site of `rate` in the loop, so that it is inlined once.
#[inline(never)]
pub(super) fn stages<M: ConstrainedSystem, F: Flow<M>, const S: usize>(
    flow: &mut F,
    tableau: &Tableau<S>,
    range: Range<usize>,
    judged: bool,
    (t, h): (f64, f64),
    y: &F::Point,
    k: &mut [F::Point; S],
) -> Result<(F::Point, Option<F::Guards>), Error> {
    let mut stage = *y;
    let mut guards = None;
    for i in range {
        let mut sum = *y;
        for j in 0..sum.len() {
            *sum.get_mut(j) = 0.0;
        }
        for (weight, k) in tableau.a[i].iter().zip(&*k).take(i) {
            if *weight != 0.0 {
                for j in 0..sum.len() {
                    *sum.get_mut(j) += weight * k.get(j);
                }
            }
        }
        for j in 0..stage.len() {
            *stage.get_mut(j) = y.get(j) + h * sum.get(j);
        }
        let at = t + tableau.c[i] * h;
        let (rate, found) = flow.rate(at, &stage);
        k[i] = rate;
        // Where the stage itself is not finite the run diverges, whatever its guards are.
        if judged && stage.is_finite() {
            flow.judge_stage(at, &found)?;
        }
        guards = Some(found);
    }
    Ok((stage, guards))
}

/// The rate and the guards at one point, outside of the loop.
#[inline(never)]
pub(super) fn evaluate<M: ConstrainedSystem, F: Flow<M>>(flow: &mut F, t: f64, y: &F::Point) -> (F::Point, F::Guards) {
    flow.rate(t, y)
}

/// A first step size that makes an Euler step's error small (Hairer, Nørsett, Wanner, section II.4); one evaluation.
pub(super) fn first_step<M: ConstrainedSystem, F: Flow<M>>(
    flow: &mut F,
    (order, t): (i32, f64),
    plan: &Plan,
    tolerance: Tolerance,
    y: &F::Point,
    k: &F::Point,
) -> f64 {
    let (span, direction) = ((plan.end - t).abs(), plan.direction());
    let size = tolerance.norm(y, y);
    let slope = tolerance.norm(k, y);
    let mut h = if size < 1e-5 || slope < 1e-5 { 1e-6 * span } else { 0.01 * size / slope };
    h = h.min(span);
    let mut ahead = *y;
    for i in 0..ahead.len() {
        *ahead.get_mut(i) += direction * h * k.get(i);
    }
    let (mut change, _) = evaluate(flow, t + direction * h, &ahead);
    for i in 0..change.len() {
        *change.get_mut(i) -= k.get(i);
    }
    let curvature = tolerance.norm(&change, y) / h;
    let steepest = slope.max(curvature);
    let second =
        if steepest <= 1e-15 { (1e-3 * h).max(1e-6 * span) } else { pow(0.01 / steepest, 1.0 / f64::from(order)) };
    let h = if second.is_finite() { second.min(100.0 * h) } else { h };
    h.min(span)
}

/// Coefficients of the continuous extension of a step in Hairer's form, and their number.
pub(super) fn dense_output<P: Point, const S: usize>(
    tableau: &Tableau<S>,
    h: f64,
    k: &[P; S],
    y: &P,
    ahead: &P,
    out: &mut [P; COEFFICIENTS],
) -> usize {
    let (first, last) = (&k[0], &k[tableau.stages - 1]);
    for i in 0..y.len() {
        let (start, end) = (y.get(i), ahead.get(i));
        let rise = end - start;
        let bend = h * first.get(i) - rise;
        *out[0].get_mut(i) = start;
        *out[1].get_mut(i) = rise;
        *out[2].get_mut(i) = bend;
        *out[3].get_mut(i) = rise - h * last.get(i) - bend;
        for (weights, out) in tableau.dense.iter().zip(&mut out[4..]) {
            let sum: f64 = weights.iter().zip(k).map(|(weight, k)| weight * k.get(i)).sum();
            *out.get_mut(i) = h * sum;
        }
    }
    4 + tableau.dense.len()
}

/// c₀ + θ (c₁ + (1 − θ) (c₂ + θ (c₃ + …))): Hairer's form of the continuous extensions, for one entry of the point.
#[inline]
pub(super) fn interpolate(count: usize, theta: f64, coefficient: impl Fn(usize) -> f64) -> f64 {
    let Some(last) = count.checked_sub(1) else {
        return 0.0;
    };
    let mut sum = coefficient(last);
    for j in (0..last).rev() {
        let factor = if j % 2 == 0 { theta } else { 1.0 - theta };
        sum = coefficient(j) + factor * sum;
    }
    sum
}
