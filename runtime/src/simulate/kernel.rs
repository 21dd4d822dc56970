//! The loop over the steps.

use alloc::boxed::Box;
use core::ops::Range;

use super::control::{Controller, Tolerance};
use super::guards::Watch;
use super::inputs::InputSource;
use super::tableau::Tableau;
use super::trajectory::{StateArray, Trajectory, interpolate};
use crate::assemble::first_non_finite;
use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// The most coefficients that a method's dense output has.
const COEFFICIENTS: usize = 8;
/// Times that differ by less than this part of a step are the same.
const SAME_TIME: f64 = 1e-12;

/// Sizes of the steps.
#[derive(Copy, Clone, Debug)]
pub(super) enum Pace {
    Fixed { step: f64 },
    Adaptive { tolerance: Tolerance, longest: f64 },
}

/// What a run is to do; all figures are checked.
#[derive(Copy, Clone, Debug)]
pub(super) struct Plan {
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) pace: Pace,
    pub(super) every: Option<f64>,
    pub(super) dense: bool,
    pub(super) max_steps: usize,
}

/// A model with its inputs, its guards and its way back onto the constraints.
pub(super) struct Course<'a, M: ConstrainedSystem, I> {
    pub(super) model: &'a Prepared<M>,
    pub(super) source: I,
    pub(super) watch: Watch<M>,
    pub(super) manifold: Option<Manifold<M>>,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Course<'_, M, I> {
    /// Stages of one step: their rates go to k; returns the state and the guards at the last one.
    ///
    /// The only call site of `derivative` in the loop, so that it is inlined once.
    #[inline(never)]
    fn stages<const S: usize>(
        &mut self,
        tableau: &Tableau<S>,
        range: Range<usize>,
        (t, h): (f64, f64),
        y: &StateArray<M>,
        k: &mut [StateArray<M>; S],
    ) -> (StateArray<M>, M::Guards<f64>) {
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
    fn evaluate(&mut self, t: f64, y: &StateArray<M>) -> (StateArray<M>, M::Guards<f64>) {
        let s = (*y).into();
        let inputs = self.source.inputs(t, &s);
        let (rate, guards) = M::derivative(self.model.values(), t, &s, &inputs);
        (rate.into(), guards)
    }

    /// Why the run broke down after a regular state.
    fn diagnose(&mut self, t: f64, y: &StateArray<M>, broken: &StateArray<M>) -> Error {
        let s = (*y).into();
        if let Some(error) = self.watch.suspect(t, self.model.guards(t, &s).into().as_ref()) {
            return error;
        }
        let inputs = self.source.inputs(t, &s).into();
        if let Some(at) = inputs.as_ref().iter().position(|input| !input.is_finite()) {
            return Error::NonFinite { name: M::MODEL.inputs.get(at).copied().unwrap_or("input") };
        }
        Error::Diverged { name: first_non_finite::<M>(&(*broken).into()).unwrap_or("derivative"), time: t }
    }

    /// A first step size that makes an Euler step's error small (Hairer, Nørsett, Wanner, section II.4).
    fn first_step(
        &mut self,
        order: i32,
        plan: &Plan,
        tolerance: Tolerance,
        y: &StateArray<M>,
        k: &StateArray<M>,
    ) -> f64 {
        let (span, direction) = ((plan.end - plan.start).abs(), direction(plan));
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
        let second = if steepest <= 1e-15 {
            (1e-3 * h).max(1e-6 * span)
        } else {
            crate::math::double::pow(0.01 / steepest, 1.0 / f64::from(order))
        };
        let h = if second.is_finite() { second.min(100.0 * h) } else { h };
        h.min(span)
    }

    /// Takes all steps from the start of the plan to its end.
    #[inline(never)]
    pub(super) fn run<const S: usize>(
        &mut self,
        tableau: &Tableau<S>,
        plan: &Plan,
        trajectory: &mut Trajectory<M>,
    ) -> Result<(), Error> {
        let direction = direction(plan);
        let mut t = plan.start;
        let mut y: StateArray<M> = (*trajectory.last().1).into();
        let (rate, _) = self.evaluate(t, &y);
        if !finite(&rate) {
            return Err(self.diagnose(t, &y, &rate));
        }
        let mut k = [rate; S];
        let mut evaluations = 1;
        let mut controller = Controller::new(tableau);
        let mut size = match plan.pace {
            Pace::Fixed { step } => step,
            Pace::Adaptive { tolerance, longest } => {
                evaluations += 1;
                self.first_step(tableau.order, plan, tolerance, &y, &rate).min(longest)
            }
        };
        let mut outputs = 0;
        let mut told = 0.0;
        let result = loop {
            if t == plan.end {
                break Ok(());
            }
            let taken = trajectory.statistics.accepted;
            if taken + trajectory.statistics.rejected >= plan.max_steps {
                break Err(Error::TooManySteps { steps: plan.max_steps, time: t });
            }
            // The time comes from a step count where the steps are fixed, and the last step ends at the end.
            let mut next = match plan.pace {
                Pace::Fixed { step } => plan.start + direction * step * (taken + 1) as f64,
                Pace::Adaptive { .. } => t + direction * size,
            };
            let margin = if matches!(plan.pace, Pace::Fixed { .. }) { 1e-9 } else { 0.01 };
            if (plan.end - next) * direction <= margin * size {
                next = plan.end;
            }
            let h = next - t;
            if h.abs() <= 4.0 * f64::EPSILON * t.abs() || h == 0.0 {
                let guards = self.model.guards(t, &y.into()).into();
                let error = self.watch.suspect(t, guards.as_ref());
                break Err(error.unwrap_or(Error::StepTooSmall { step: h, time: t }));
            }
            let (mut ahead, mut guards) = self.stages(tableau, 1..tableau.stages, (t, h), &y, &mut k);
            evaluations += tableau.stages - 1;
            let regular = finite(&ahead) && finite(&k[tableau.stages - 1]);
            if let Pace::Adaptive { tolerance, longest } = plan.pace {
                let error = if regular { tolerance.error(tableau, h, &k, &y, &ahead) } else { f64::INFINITY };
                // Also true where the error is not a number.
                if !(error <= 1.0) {
                    trajectory.statistics.rejected += 1;
                    size = h.abs() * controller.reject(error);
                    if !regular && size <= 64.0 * f64::EPSILON * t.abs().max(plan.end.abs()) {
                        break Err(self.diagnose(t, &y, &ahead));
                    }
                    continue;
                }
                size = (h.abs() * controller.accept(error)).min(longest);
            } else if !regular {
                break Err(self.diagnose(t, &y, &ahead));
            }

            let outputs_within = plan.every.is_some_and(|every| {
                let first = plan.start + direction * every * (outputs + 1) as f64;
                (next - first) * direction > SAME_TIME * h.abs()
            });
            let dense = plan.dense || outputs_within;
            if dense && tableau.stages < S {
                self.stages(tableau, tableau.stages..S, (t, h), &y, &mut k);
                evaluations += S - tableau.stages;
            }
            if let Some(manifold) = &mut self.manifold {
                let mut s = ahead.into();
                match manifold.restore(self.model, next, &mut s) {
                    Ok(false) => {}
                    Ok(true) => {
                        ahead = s.into();
                        let (rate, found) = self.evaluate(next, &ahead);
                        evaluations += 1;
                        (k[tableau.stages - 1], guards) = (rate, found);
                        if !finite(&rate) {
                            break Err(self.diagnose(t, &y, &rate));
                        }
                    }
                    Err(error) => break Err(error),
                }
            }
            if let Err(error) = self.watch.judge(next, guards.into().as_ref()) {
                break Err(error);
            }

            trajectory.statistics.accepted += 1;
            if dense {
                let mut coefficients = [y; COEFFICIENTS];
                let count = dense_output(tableau, h, &k, &y, &ahead, &mut coefficients);
                let coefficients = &coefficients[..count];
                if plan.dense {
                    trajectory.push_step(t, h, coefficients);
                }
                if let Some(every) = plan.every {
                    let mut error = None;
                    loop {
                        let at = plan.start + direction * every * (outputs + 1) as f64;
                        if (next - at) * direction <= SAME_TIME * h.abs() {
                            break;
                        }
                        outputs += 1;
                        let mut s = interpolate::<M>(coefficients, (at - t) / h).into();
                        if let Some(manifold) = &mut self.manifold
                            && let Err(found) = manifold.restore(self.model, at, &mut s)
                        {
                            error = Some(found);
                            break;
                        }
                        trajectory.push(at, s);
                    }
                    if let Some(error) = error {
                        break Err(error);
                    }
                }
            }
            let due = plan.every.is_none_or(|every| {
                let at = plan.start + direction * every * (outputs + 1) as f64;
                (next - at) * direction >= -SAME_TIME * h.abs()
            });
            if due || next == plan.end {
                outputs += usize::from(due);
                trajectory.push(next, ahead.into());
            }
            k[0] = k[tableau.stages - 1];
            (t, y) = (next, ahead);
            if let Some(progress) = &mut self.progress {
                let fraction = (t - plan.start) / (plan.end - plan.start);
                if fraction >= told + 0.005 || t == plan.end {
                    told = fraction;
                    progress(fraction);
                }
            }
        };
        trajectory.statistics.evaluations = evaluations;
        // What there is of an interrupted run ends at its last regular state.
        if trajectory.last().0 != t {
            trajectory.push(t, y.into());
        }
        result
    }
}

/// Coefficients of the continuous extension of a step in Hairer's form, and their number.
fn dense_output<A: AsRef<[f64]> + AsMut<[f64]> + Copy, const S: usize>(
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

fn direction(plan: &Plan) -> f64 {
    if plan.end < plan.start { -1.0 } else { 1.0 }
}

fn finite<A: AsRef<[f64]>>(array: &A) -> bool {
    array.as_ref().iter().all(|entry| entry.is_finite())
}
