//! The loop over the steps.

use alloc::boxed::Box;

use super::control::Controller;
use super::events::{Events, Verdict};
use super::flow::{Flow, Point};
use super::stages::{COEFFICIENTS, dense_output, evaluate, first_step, interpolate, stages};
use super::tableau::Tableau;
use super::trajectory::Trajectory;
use crate::{ConstrainedSystem, Error};

mod leap;
mod plan;

pub(super) use leap::Leap;
pub(super) use plan::{Pace, Plan};

/// Times that differ by less than this part of a step are the same.
const SAME_TIME: f64 = 1e-12;
/// Progress is told when this part of the run has been added.
const PROGRESS: f64 = 0.005;

/// Why a flow was left without an error.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Exit {
    /// The barrier: the end of the plan, or the next sampling instant.
    Barrier,
    /// An event that ends the run, or puts another state in place of this one.
    Event(Verdict),
    /// Another chart is better.
    Leaves,
    /// A loss of rank is near.
    Nears,
    /// A loss of rank was passed.
    Passed,
}

/// A run on its way: what is carried over from one flow to the next.
pub(super) struct Run<'r, 'a, M: ConstrainedSystem, const S: usize> {
    pub(super) tableau: &'static Tableau<S>,
    pub(super) plan: &'r Plan,
    pub(super) trajectory: &'r mut Trajectory<M>,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
    /// The time of the last accepted point.
    pub(super) t: f64,
    /// Where steps must end.
    pub(super) barrier: f64,
    pub(super) events: Events<'a, M>,
    /// Whether a loss of rank came near in the last step.
    pub(super) nearing: bool,
    controller: Controller,
    /// The size of the next step, once there is one.
    size: Option<f64>,
    /// Since when steps were taken without a cut, and how many.
    since: (f64, usize),
    outputs: usize,
    told: f64,
}

impl<'r, 'a, M: ConstrainedSystem, const S: usize> Run<'r, 'a, M, S> {
    pub(super) fn new(
        tableau: &'static Tableau<S>,
        plan: &'r Plan,
        trajectory: &'r mut Trajectory<M>,
        events: Events<'a, M>,
        progress: Option<Box<dyn FnMut(f64) + 'a>>,
    ) -> Self {
        let (t, controller) = (plan.start, Controller::new(tableau));
        let (barrier, since) = (plan.end, (plan.start, 0));
        Run {
            tableau,
            plan,
            trajectory,
            progress,
            t,
            barrier,
            events,
            nearing: false,
            controller,
            size: None,
            since,
            outputs: 0,
            told: 0.0,
        }
    }

    /// Begins anew at the last accepted time: after a jump of the inputs or of the state the steps before tell nothing.
    pub(super) fn begin(&mut self) {
        self.since = (self.t, 0);
        self.size = None;
        self.controller = Controller::new(self.tableau);
    }

    /// The size of the step that would come next, or a small part of the run.
    pub(super) fn size(&self) -> f64 {
        let small = 1e-4 * (self.plan.end - self.plan.start).abs();
        self.size.map_or(small, |size| size.min(small))
    }

    /// Halves the size of the next step, where the method may choose it.
    pub(super) fn shorten(&mut self) -> bool {
        let adaptive = matches!(self.plan.pace, Pace::Adaptive { .. });
        if adaptive {
            self.size = Some(self.size.map_or(self.size(), |size| 0.5 * size));
        }
        adaptive
    }

    /// Takes the steps to the end of the plan, or until the chart is to be changed. `y` is the last accepted point, also when it
    /// ends with an error.
    #[inline(never)]
    pub(super) fn steps<F: Flow<M>>(&mut self, flow: &mut F, y: &mut F::Point) -> Result<Exit, Error> {
        let (tableau, plan) = (self.tableau, self.plan);
        let last = tableau.stages - 1;
        let fixed = matches!(plan.pace, Pace::Fixed { .. });
        let rate = self.evaluate(flow, self.t, y).0;
        if !rate.is_finite() {
            return Err(flow.diagnose((self.t, self.t), y, &rate));
        }
        let mut k = [rate; S];
        let mut size = match self.size {
            Some(size) => size,
            None => self.first_size(flow, y, &rate),
        };
        while self.t != self.barrier {
            let statistics = &mut self.trajectory.statistics;
            if statistics.accepted + statistics.rejected >= plan.max_steps {
                return Err(Error::TooManySteps { steps: plan.max_steps, time: self.t });
            }
            let t = self.t;
            let next = plan.next(t, self.since, size, self.barrier);
            let h = next - t;
            if h.abs() <= 4.0 * f64::EPSILON * t.abs() || h == 0.0 {
                return Err(flow.suspect(t, y).unwrap_or(Error::StepTooSmall { step: h, time: t }));
            }
            statistics.evaluations += last;
            let (mut ahead, guards) = stages(flow, tableau, 1..tableau.stages, fixed, (t, h), y, &mut k)?;
            let regular = ahead.is_finite() && k[last].is_finite();
            match plan.pace {
                Pace::Adaptive { tolerance, longest } => {
                    let error = match regular {
                        true => {
                            tolerance.error(tableau, h, &k, y, &ahead) * guards.map_or(1.0, |g| flow.strictness(&g))
                        }
                        false => f64::INFINITY,
                    };
                    if error > 1.0 || error.is_nan() {
                        statistics.rejected += 1;
                        size = h.abs() * self.controller.reject(error);
                        let furthest = t.abs().max(plan.end.abs());
                        if !regular && size <= 64.0 * f64::EPSILON * furthest {
                            return Err(flow.diagnose((t, next), y, &ahead));
                        }
                        continue;
                    }
                    size = (h.abs() * self.controller.accept(error)).min(longest);
                }
                Pace::Fixed { .. } if !regular => {
                    return Err(flow.diagnose((t, next), y, &ahead));
                }
                Pace::Fixed { .. } => {}
            }

            let watched = !self.events.is_empty();
            let dense = plan.dense || watched || plan.output_within(self.outputs, next, h).is_some();
            if dense && tableau.stages < S {
                self.trajectory.statistics.evaluations += S - tableau.stages;
                stages(flow, tableau, tableau.stages..S, false, (t, h), y, &mut k)?;
            }
            let mut guards = guards;
            if flow.restore(next, &mut ahead)? {
                let (rate, found) = self.evaluate(flow, next, &ahead);
                (k[last], guards) = (rate, Some(found));
                if !rate.is_finite() {
                    return Err(flow.diagnose((t, next), y, &rate));
                }
            }
            if let Some(guards) = &guards {
                flow.judge(next, guards)?;
            }
            flow.passed(next, &ahead)?;

            let (mut next, mut cut) = (next, None);
            let mut coefficients = [*y; COEFFICIENTS];
            let mut count = 0;
            if dense {
                count = dense_output(tableau, h, &k, y, &ahead, &mut coefficients);
            }
            if watched && let Some((at, point, verdict)) = self.watch(flow, (t, next, h), &coefficients[..count])? {
                (next, ahead, cut) = (at, point, Some(verdict));
            }
            self.trajectory.accept(flow.chart(), flow.residuals());
            (self.t, *y) = (next, ahead);
            self.since.1 += 1;
            self.size = Some(size);
            if dense {
                self.between(flow, (t, next, h), &coefficients[..count])?;
            }
            k[0] = k[last];
            let kept = plan.output_at(self.outputs, next, h);
            self.outputs += usize::from(kept);
            if kept || next == plan.end || cut.is_some() {
                let (s, v) = flow.view(next, y);
                self.trajectory.push(next, s, v);
            }
            self.tell(next);
            if let Some(verdict) = cut {
                return Ok(Exit::Event(verdict));
            }
            if let Some(guards) = guards
                && next != plan.end
            {
                self.nearing = flow.nears(next, y, &guards);
                if next != self.barrier && self.nearing {
                    return Ok(Exit::Nears);
                }
                if next != self.barrier && flow.leaves(next, y, &guards) {
                    return Ok(Exit::Leaves);
                }
            }
        }
        Ok(Exit::Barrier)
    }

    /// Keeps the polynomials of a step, and the outputs that lie within it.
    fn between<F: Flow<M>>(
        &mut self,
        flow: &mut F,
        (from, next, h): (f64, f64, f64),
        coefficients: &[F::Point],
    ) -> Result<(), Error> {
        if self.plan.dense {
            self.trajectory.push_step((from, h), flow.chart(), coefficients);
        }
        while let Some(at) = self.plan.output_within(self.outputs, next, h) {
            self.outputs += 1;
            let mut point = within(coefficients, (at - from) / h);
            flow.restore(at, &mut point)?;
            let (s, v) = flow.view(at, &point);
            self.trajectory.push(at, s, v);
        }
        Ok(())
    }

    /// Locates the events of a step, and records them up to the first that cuts it: then the time and the point of the cut, and
    /// what follows from it.
    #[inline(never)]
    fn watch<F: Flow<M>>(
        &mut self,
        flow: &mut F,
        (from, next, h): (f64, f64, f64),
        coefficients: &[F::Point],
    ) -> Result<Option<(f64, F::Point, Verdict)>, Error> {
        // The end of a step is its end, whatever its length was rounded to. A step that was cut is searched up to there.
        let part = (next - from) / h;
        let time = |theta: f64| if theta >= 1.0 { next } else { from + theta * (next - from) };
        let zeros = self.events.within(|theta| {
            let t = time(theta);
            (t, flow.view(t, &within(coefficients, theta * part)).0)
        });
        let mut cut: Option<(f64, F::Point, Verdict)> = None;
        let mut last = f64::INFINITY;
        for zero in &zeros {
            // Others at the very same time still count.
            if zero.theta > last {
                break;
            }
            let mut point = within(coefficients, zero.theta * part);
            let t = time(zero.theta);
            flow.restore(t, &mut point)?;
            let occurrence = self.events.occurrence(zero, t, flow.view(t, &point).0);
            self.trajectory.record(occurrence);
            let verdict = self.events.verdict(zero);
            if verdict != Verdict::Continue && cut.is_none() {
                last = zero.theta;
                cut = Some((t, point, verdict));
            }
        }
        Ok(cut)
    }

    fn first_size<F: Flow<M>>(&mut self, flow: &mut F, y: &F::Point, rate: &F::Point) -> f64 {
        match self.plan.pace {
            Pace::Fixed { step } => step,
            Pace::Adaptive { tolerance, longest } => {
                self.trajectory.statistics.evaluations += 1;
                let first = first_step(flow, (self.tableau.order, self.t), self.plan, tolerance, y, rate);
                first.min(longest)
            }
        }
    }

    fn evaluate<F: Flow<M>>(&mut self, flow: &mut F, t: f64, y: &F::Point) -> (F::Point, F::Guards) {
        self.trajectory.statistics.evaluations += 1;
        evaluate(flow, t, y)
    }

    fn tell(&mut self, t: f64) {
        if let Some(progress) = &mut self.progress {
            let fraction = (t - self.plan.start) / (self.plan.end - self.plan.start);
            if fraction >= self.told + PROGRESS || t == self.plan.end {
                self.told = fraction;
                progress(fraction);
            }
        }
    }
}

/// The point at a part of a step.
fn within<P: Point>(coefficients: &[P], theta: f64) -> P {
    let mut point = coefficients[0];
    for i in 0..point.len() {
        *point.get_mut(i) = interpolate(coefficients.len(), theta, |j| coefficients[j].get(i));
    }
    point
}
