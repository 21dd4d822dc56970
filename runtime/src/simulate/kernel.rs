//! The loop over the steps.

use super::control::{Controller, Tolerance};
use super::course::{COEFFICIENTS, Course, dense_output, finite};
use super::inputs::InputSource;
use super::tableau::Tableau;
use super::trajectory::{StateArray, Trajectory, interpolate};
use crate::{ConstrainedSystem, Error};

/// Times that differ by less than this part of a step are the same.
const SAME_TIME: f64 = 1e-12;
/// A step is lengthened to reach the end if less than this part of it would remain.
const REMAINDER: f64 = 0.01;
/// With fixed steps only rounding is made up for.
const FIXED_REMAINDER: f64 = 1e-9;
/// Progress is told when this part of the run has been added.
const PROGRESS: f64 = 0.005;

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

impl Plan {
    /// 1 forwards in time, −1 backwards.
    pub(super) fn direction(&self) -> f64 {
        if self.end < self.start { -1.0 } else { 1.0 }
    }

    /// The end of the step that follows `taken` steps and starts at t, `size` long if the method may choose.
    fn next(&self, t: f64, taken: usize, size: f64) -> f64 {
        let (next, remainder) = match self.pace {
            // From a count, so that the times do not gather rounding errors.
            Pace::Fixed { step } => {
                let next = self.start + self.direction() * step * (taken + 1) as f64;
                (next, FIXED_REMAINDER)
            }
            Pace::Adaptive { .. } => (t + self.direction() * size, REMAINDER),
        };
        if (self.end - next) * self.direction() <= remainder * size { self.end } else { next }
    }

    /// The time of the output after `count` ones; none where every step is kept.
    fn output(&self, count: usize) -> Option<f64> {
        let every = self.every?;
        Some(self.start + self.direction() * every * (count + 1) as f64)
    }

    /// Whether the next output lies strictly before the end of the step.
    fn output_within(&self, count: usize, next: f64, h: f64) -> Option<f64> {
        let within = |at: &f64| (next - at) * self.direction() > SAME_TIME * h.abs();
        self.output(count).filter(within)
    }

    /// Whether the end of the step is to be kept.
    fn output_at(&self, count: usize, next: f64, h: f64) -> bool {
        let reached = |at: f64| (next - at) * self.direction() >= -SAME_TIME * h.abs();
        self.output(count).is_none_or(reached)
    }
}

impl<M: ConstrainedSystem, I: InputSource<M>> Course<'_, M, I> {
    /// Takes all steps from the start of the plan to its end.
    pub(super) fn run<const S: usize>(
        &mut self,
        tableau: &Tableau<S>,
        plan: &Plan,
        trajectory: &mut Trajectory<M>,
    ) -> Result<(), Error> {
        let mut t = plan.start;
        let mut y = (*trajectory.last().1).into();
        let result = self.steps(tableau, plan, (&mut t, &mut y), trajectory);
        trajectory.statistics.evaluations = self.evaluations;
        // What there is of an interrupted run ends at its last regular state.
        if trajectory.last().0 != t {
            trajectory.push(t, y.into());
        }
        result
    }

    /// The loop. `t` and `y` are the last accepted state, also when it ends with an error.
    #[inline(never)]
    fn steps<const S: usize>(
        &mut self,
        tableau: &Tableau<S>,
        plan: &Plan,
        (t, y): (&mut f64, &mut StateArray<M>),
        trajectory: &mut Trajectory<M>,
    ) -> Result<(), Error> {
        let last = tableau.stages - 1;
        let (rate, _) = self.evaluate(*t, y);
        if !finite(&rate) {
            return Err(self.diagnose((*t, *t), y, &rate));
        }
        let mut k = [rate; S];
        let mut controller = Controller::new(tableau);
        let mut size = match plan.pace {
            Pace::Fixed { step } => step,
            Pace::Adaptive { tolerance, longest } => {
                let first = self.first_step(tableau.order, plan, tolerance, y, &rate);
                first.min(longest)
            }
        };
        let (mut outputs, mut told) = (0, 0.0);
        while *t != plan.end {
            let statistics = &mut trajectory.statistics;
            if statistics.accepted + statistics.rejected >= plan.max_steps {
                let (steps, time) = (plan.max_steps, *t);
                return Err(Error::TooManySteps { steps, time });
            }
            let next = plan.next(*t, statistics.accepted, size);
            let h = next - *t;
            if h.abs() <= 4.0 * f64::EPSILON * t.abs() || h == 0.0 {
                return Err(self.too_small(h, *t, y));
            }
            let (mut ahead, mut guards) = self.stages(tableau, 1..tableau.stages, (*t, h), y, &mut k);
            let regular = finite(&ahead) && finite(&k[last]);
            match plan.pace {
                Pace::Adaptive { tolerance, longest } => {
                    let error = match regular {
                        true => tolerance.error(tableau, h, &k, y, &ahead),
                        false => f64::INFINITY,
                    };
                    if error > 1.0 || error.is_nan() {
                        statistics.rejected += 1;
                        size = h.abs() * controller.reject(error);
                        let furthest = t.abs().max(plan.end.abs());
                        if !regular && size <= 64.0 * f64::EPSILON * furthest {
                            return Err(self.diagnose((*t, next), y, &ahead));
                        }
                        continue;
                    }
                    size = (h.abs() * controller.accept(error)).min(longest);
                }
                Pace::Fixed { .. } if !regular => {
                    return Err(self.diagnose((*t, next), y, &ahead));
                }
                Pace::Fixed { .. } => {}
            }

            let dense = plan.dense || plan.output_within(outputs, next, h).is_some();
            if dense && tableau.stages < S {
                self.stages(tableau, tableau.stages..S, (*t, h), y, &mut k);
            }
            if self.restore(next, &mut ahead)? {
                (k[last], guards) = self.evaluate(next, &ahead);
                if !finite(&k[last]) {
                    return Err(self.diagnose((*t, next), y, &k[last]));
                }
            }
            self.watch.judge(next, guards.into().as_ref())?;

            trajectory.statistics.accepted += 1;
            let (from, base) = (*t, *y);
            (*t, *y) = (next, ahead);
            if dense {
                let mut coefficients = [base; COEFFICIENTS];
                let count = dense_output(tableau, h, &k, &base, &ahead, &mut coefficients);
                let coefficients = &coefficients[..count];
                if plan.dense {
                    trajectory.push_step(from, h, coefficients);
                }
                while let Some(at) = plan.output_within(outputs, next, h) {
                    outputs += 1;
                    let mut between = interpolate::<M>(coefficients, (at - from) / h);
                    self.restore(at, &mut between)?;
                    trajectory.push(at, between.into());
                }
            }
            k[0] = k[last];
            let kept = plan.output_at(outputs, next, h);
            outputs += usize::from(kept);
            if kept || next == plan.end {
                trajectory.push(next, ahead.into());
            }
            self.tell(plan, next, &mut told);
        }
        Ok(())
    }

    fn tell(&mut self, plan: &Plan, t: f64, told: &mut f64) {
        if let Some(progress) = &mut self.progress {
            let fraction = (t - plan.start) / (plan.end - plan.start);
            if fraction >= *told + PROGRESS || t == plan.end {
                *told = fraction;
                progress(fraction);
            }
        }
    }
}
