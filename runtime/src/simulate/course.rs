//! A model on its way: the stages of a step, and what is asked about a state outside of the loop.

use alloc::boxed::Box;
use core::ops::Range;

use super::control::Tolerance;
use super::guards::Watch;
use super::inputs::InputSource;
use super::kernel::Plan;
use super::tableau::Tableau;
use super::trajectory::StateArray;
use crate::assemble::first_non_finite;
use crate::manifold::Manifold;
use crate::math::double::pow;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// The most coefficients that a method's dense output has.
pub(super) const COEFFICIENTS: usize = 8;

/// A model with its inputs, its guards and its way back onto the constraints.
pub(super) struct Course<'a, M: ConstrainedSystem, I> {
    pub(super) model: &'a Prepared<M>,
    pub(super) source: I,
    pub(super) watch: Watch<M>,
    pub(super) manifold: Option<Manifold<M>>,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
    /// Evaluations of `derivative` so far.
    pub(super) evaluations: usize,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Course<'_, M, I> {
    /// Stages of one step: their rates go to k; returns the state and the guards at the last one.
    ///
    /// The only call site of `derivative` in the loop, so that it is inlined once.
    #[inline(never)]
    pub(super) fn stages<const S: usize>(
        &mut self,
        tableau: &Tableau<S>,
        range: Range<usize>,
        (t, h): (f64, f64),
        y: &StateArray<M>,
        k: &mut [StateArray<M>; S],
    ) -> (StateArray<M>, M::Guards<f64>) {
        self.evaluations += range.len();
        let mut stage = *y;
        let mut guards = M::Guards::from_fn(|_| 0.0);
        for i in range {
            let mut sum = *y;
            sum.as_mut().fill(0.0);
            for (weight, k) in tableau.a[i].iter().zip(&*k).take(i) {
                if *weight != 0.0 {
                    for (sum, k) in sum.as_mut().iter_mut().zip(k.as_ref()) {
                        *sum += weight * k;
                    }
                }
            }
            for ((stage, y), sum) in stage.as_mut().iter_mut().zip(y.as_ref()).zip(sum.as_ref()) {
                *stage = y + h * sum;
            }
            let (at, s) = (t + tableau.c[i] * h, stage.into());
            let inputs = self.source.inputs(at, &s);
            let (rate, found) = M::derivative(self.model.values(), at, &s, &inputs);
            k[i] = rate.into();
            guards = found;
        }
        (stage, guards)
    }

    /// The rate and the guards at one state, outside of the loop.
    #[inline(never)]
    pub(super) fn evaluate(&mut self, t: f64, y: &StateArray<M>) -> (StateArray<M>, M::Guards<f64>) {
        self.evaluations += 1;
        let s = (*y).into();
        let inputs = self.source.inputs(t, &s);
        let (rate, guards) = M::derivative(self.model.values(), t, &s, &inputs);
        (rate.into(), guards)
    }

    /// Why the run broke down between a regular state and a later time.
    pub(super) fn diagnose(&mut self, (t, next): (f64, f64), y: &StateArray<M>, broken: &StateArray<M>) -> Error {
        let s = (*y).into();
        if let Some(error) = self.watch.suspect(t, self.model.guards(t, &s).into().as_ref()) {
            return error;
        }
        for at in [t, next] {
            let inputs = self.source.inputs(at, &s).into();
            if let Some(at) = inputs.as_ref().iter().position(|input| !input.is_finite()) {
                return Error::NonFinite { name: M::MODEL.inputs.get(at).copied().unwrap_or("input") };
            }
        }
        Error::Diverged { name: first_non_finite::<M>(&(*broken).into()).unwrap_or("derivative"), time: t }
    }

    /// Brings a state back onto the position constraints, and tells whether it was moved.
    pub(super) fn restore(&mut self, t: f64, y: &mut StateArray<M>) -> Result<bool, Error> {
        let Some(manifold) = &mut self.manifold else {
            return Ok(false);
        };
        let mut s = (*y).into();
        let moved = manifold.restore(self.model, t, &mut s)?;
        if moved {
            *y = s.into();
        }
        Ok(moved)
    }

    /// Why the steps have become too small.
    pub(super) fn too_small(&self, step: f64, time: f64, y: &StateArray<M>) -> Error {
        let guards = self.model.guards(time, &(*y).into()).into();
        let suspect = self.watch.suspect(time, guards.as_ref());
        suspect.unwrap_or(Error::StepTooSmall { step, time })
    }

    /// A first step size that makes an Euler step's error small (Hairer, Nørsett, Wanner, section II.4).
    pub(super) fn first_step(
        &mut self,
        order: i32,
        plan: &Plan,
        tolerance: Tolerance,
        y: &StateArray<M>,
        k: &StateArray<M>,
    ) -> f64 {
        let (span, direction) = ((plan.end - plan.start).abs(), plan.direction());
        let size = tolerance.norm(y.as_ref(), y.as_ref());
        let slope = tolerance.norm(k.as_ref(), y.as_ref());
        let mut h = if size < 1e-5 || slope < 1e-5 { 1e-6 * span } else { 0.01 * size / slope };
        h = h.min(span);
        let mut ahead = *y;
        for (y, k) in ahead.as_mut().iter_mut().zip(k.as_ref()) {
            *y += direction * h * k;
        }
        let (mut change, _) = self.evaluate(plan.start + direction * h, &ahead);
        for (change, k) in change.as_mut().iter_mut().zip(k.as_ref()) {
            *change -= k;
        }
        let curvature = tolerance.norm(change.as_ref(), y.as_ref()) / h;
        let steepest = slope.max(curvature);
        let second =
            if steepest <= 1e-15 { (1e-3 * h).max(1e-6 * span) } else { pow(0.01 / steepest, 1.0 / f64::from(order)) };
        let h = if second.is_finite() { second.min(100.0 * h) } else { h };
        h.min(span)
    }
}

/// Coefficients of the continuous extension of a step in Hairer's form, and their number.
pub(super) fn dense_output<A: AsRef<[f64]> + AsMut<[f64]> + Copy, const S: usize>(
    tableau: &Tableau<S>,
    h: f64,
    k: &[A; S],
    y: &A,
    ahead: &A,
    out: &mut [A; COEFFICIENTS],
) -> usize {
    let (first, last) = (k[0].as_ref(), k[tableau.stages - 1].as_ref());
    for i in 0..y.as_ref().len() {
        let (start, end) = (y.as_ref()[i], ahead.as_ref()[i]);
        let rise = end - start;
        let bend = h * first[i] - rise;
        out[0].as_mut()[i] = start;
        out[1].as_mut()[i] = rise;
        out[2].as_mut()[i] = bend;
        out[3].as_mut()[i] = rise - h * last[i] - bend;
        for (weights, out) in tableau.dense.iter().zip(&mut out[4..]) {
            let sum: f64 = weights.iter().zip(k).map(|(weight, k)| weight * k.as_ref()[i]).sum();
            out.as_mut()[i] = h * sum;
        }
    }
    4 + tableau.dense.len()
}

pub(super) fn finite<A: AsRef<[f64]>>(array: &A) -> bool {
    array.as_ref().iter().all(|entry| entry.is_finite())
}
