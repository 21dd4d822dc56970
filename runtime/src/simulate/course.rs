//! A model on its way through a plan, from chart to chart.

use alloc::boxed::Box;
use alloc::vec::Vec;

use super::charts::{Chart, Charts, Quality, STEEP};
use super::control::Tolerance;
use super::crossing::{Approach, Crossing, Inside};
use super::emitted::Emitted;
use super::equations::{Baumgarte, Equations, Strength};
use super::events::{Event, Events, Verdict};
use super::flow::Flow;
use super::general::{General, point};
use super::guards::{Watch, of_chart};
use super::inputs::InputSource;
use super::kernel::{Exit, Plan, Run};
use super::redundancy::Redundancy;
use super::start::check_on_manifold;
use super::tableau::Tableau;
use super::trajectory::{Standing, Trajectory};
use crate::assemble::check_finite;
use crate::carriers::{Carriers, with_speeds};
use crate::drift::Drift;
use crate::manifold::Manifold;
use crate::vector::entry;
use crate::{ConstrainedSystem, Error, Prepared};

/// A model with its inputs and its way back onto the constraints.
pub(super) struct Course<'a, M: ConstrainedSystem, I> {
    pub(super) model: &'a Prepared<M>,
    pub(super) source: I,
    pub(super) manifold: Option<Manifold<M>>,
    pub(super) redundancy: Option<Redundancy<M>>,
    pub(super) charts: Charts,
    pub(super) baumgarte: Baumgarte,
    pub(super) events: Vec<Event<'a, M>>,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
    /// What the rows of C were at best, as far as the run has looked at it.
    pub(super) strength: Option<Strength>,
    pub(super) crossing: Crossing,
    /// For passages through losses of rank.
    pub(super) tolerance: Tolerance,
    pub(super) approach: Approach<M>,
    pub(super) inside: Option<Inside<M>>,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Course<'_, M, I> {
    /// Takes all steps from the start of the plan to its end.
    pub(super) fn run<const S: usize>(
        mut self,
        tableau: &'static Tableau<S>,
        plan: &Plan,
        trajectory: &mut Trajectory<M>,
    ) -> Result<(), Error> {
        let quality = self.quality()?;
        let mut standing = (*trajectory.last().1, *trajectory.last_velocities());
        let mut chart = match self.charts {
            Charts::General => Chart::General,
            Charts::Change | Charts::Stay => Chart::Emitted(0),
        };
        // Also where the steepness is not a number: the start may be given by its velocities.
        if let Some(quality) = &quality
            && quality.steepness(self.model, 0, plan.start, &standing.0) > STEEP
        {
            chart = better(quality, self.model, None, plan.start, &standing.0);
        }
        if quality.is_some() {
            self.strength = self.strength(plan.start, &standing)?;
        }
        let mut events = Events::new(core::mem::take(&mut self.events));
        events.start(plan.start, &standing.0);
        let mut run = Run::new(tableau, plan, trajectory, events, self.progress.take());
        let mut samples = Samples::new(self.source.period(), plan);
        let mut crowd = Crowd::default();
        let result = loop {
            run.barrier = samples.next();
            let result = self.onward(chart, &mut run, quality.as_ref(), &mut standing);
            let next = match (&quality, result) {
                (_, Ok(Exit::Barrier)) if run.t == plan.end => break Ok(()),
                (_, Ok(Exit::Barrier)) => {
                    samples.taken += 1;
                    self.source.sample(run.t, &standing.0);
                    run.begin();
                    chart
                }
                (_, Ok(Exit::Event(Verdict::Reset(event)))) => match self.reset(&mut run, event, &mut standing) {
                    Ok(()) if crowd.grows(run.t) => break Err(Error::StepTooSmall { step: 0.0, time: run.t }),
                    // At the end of the run there is nothing left to step into.
                    Ok(()) if run.t == plan.end => break Ok(()),
                    Ok(()) => chart,
                    Err(error) => break Err(error),
                },
                (_, Ok(Exit::Event(_))) => break Ok(()),
                (Some(quality), Ok(Exit::Leaves)) => better(quality, self.model, Some(chart), run.t, &standing.0),
                (Some(_), Err(error)) if is_of_chart::<M>(chart, &error) => Chart::General,
                (Some(quality), Ok(Exit::Passed)) => better(quality, self.model, None, run.t, &standing.0),
                (_, Ok(Exit::Nears)) | (None, Ok(Exit::Leaves | Exit::Passed)) => chart,
                (_, Err(error)) => break Err(error),
            };
            run.trajectory.statistics.chart_changes += usize::from(next != chart);
            chart = next;
        };
        // What there is of an interrupted run ends at its last regular state.
        if run.trajectory.last().0 != run.t {
            run.trajectory.push(run.t, standing.0, standing.1);
        }
        result
    }

    /// Puts another state in place of the one at an event.
    fn reset<const S: usize>(
        &mut self,
        run: &mut Run<'_, '_, M, S>,
        event: usize,
        standing: &mut Standing<M>,
    ) -> Result<(), Error> {
        let s = run.events.reset(event, run.t, &standing.0);
        check_finite::<M>(run.t, &s)?;
        let v = self.model.velocities(run.t, &s);
        check_on_manifold(self.model, run.t, &s, &v)?;
        run.events.start(run.t, &s);
        run.events.leave(event);
        run.trajectory.push(run.t, s, v);
        *standing = (s, v);
        self.inside = None;
        run.begin();
        Ok(())
    }

    /// What judges the charts, where the model has any that may break down, and the run may change them.
    fn quality(&self) -> Result<Option<Quality<M>>, Error> {
        let mut guards = M::MODEL.charts.iter().flat_map(|chart| chart.guards).chain(M::MODEL.guards);
        let changes = self.charts == Charts::Change && guards.any(of_chart);
        if changes { Quality::new(self.model).map(Some) } else { Ok(None) }
    }

    /// The strength of the rows of C at the start, where they have one: a start without rank is judged where the run needs it.
    fn strength(&mut self, t: f64, (s, v): &Standing<M>) -> Result<Option<Strength>, Error> {
        let mut equations = Equations::new(self.model)?;
        let w = equations.carriers(self.model, t, s, v);
        let regular = equations.solve(self.model, t, s, &w, &self.source.inputs(t, s), None).is_ok();
        Ok((regular && equations.accept(t).is_ok()).then_some(equations.strength))
    }

    /// The steps in one chart.
    pub(super) fn leg<const S: usize>(
        &mut self,
        chart: Chart,
        run: &mut Run<'_, '_, M, S>,
        quality: Option<&Quality<M>>,
        standing: &mut Standing<M>,
    ) -> Result<Exit, Error> {
        let (model, t) = (self.model, run.t);
        let (s, v) = *standing;
        let drift = |carriers: Carriers| match self.baumgarte {
            Some(_) => Ok(None),
            None => Drift::new(model, carriers, t, &model.coordinates(t, &s), &v),
        };
        let passes = self.passes();
        match chart {
            Chart::Emitted(chart) => {
                self.approach.strength = self.strength.clone();
                let start = match chart {
                    0 => s,
                    _ => with_speeds::<M, f64>(&s, entry(&model.chart_speeds(chart, t, &s, &v))),
                };
                let mut flow = Emitted {
                    model,
                    chart,
                    watch: Watch::new(model, chart, t, &start)?,
                    drift: drift(Carriers::Chart(chart))?,
                    crossing: crossing(model, t, &s, &v, &self.source.inputs(t, &s))?,
                    source: &mut self.source,
                    manifold: self.manifold.as_mut(),
                    redundancy: self.redundancy.as_mut(),
                    quality,
                    approach: quality.filter(|_| passes).map(|_| &mut self.approach),
                };
                let mut y = start.into();
                let result = run.steps(&mut flow, &mut y);
                if run.t != t {
                    *standing = flow.view(run.t, &y);
                }
                self.strength = self.approach.strength.take();
                result
            }
            Chart::General => {
                let mut equations = Equations::new(model)?;
                equations.strength = self.strength.clone().unwrap_or(equations.strength);
                let w = equations.carriers(model, t, &s, &v);
                let mut flow = General {
                    model,
                    watch: Watch::unjudged(model, 0, t, &s)?,
                    drift: drift(Carriers::General)?,
                    source: &mut self.source,
                    equations: &mut equations,
                    manifold: self.manifold.as_mut(),
                    redundancy: self.redundancy.as_mut(),
                    quality,
                    baumgarte: self.baumgarte,
                    failure: None,
                    approach: if passes { Some(&mut self.approach) } else { None },
                    untouched: None,
                };
                let mut y = point::<M>(&s, w);
                let result = run.steps(&mut flow, &mut y);
                if run.t != t {
                    *standing = flow.view(run.t, &y);
                }
                self.strength = Some(equations.strength);
                result
            }
        }
    }
}

/// What watches for losses of rank between the steps in an emitted chart, where there are nonlinear rows.
fn crossing<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    v: &M::Velocities<f64>,
    inputs: &M::Inputs<f64>,
) -> Result<Option<Equations<M>>, Error> {
    if M::MODEL.rows.iter().all(|row| row.linear) {
        return Ok(None);
    }
    let mut equations = Equations::new(model)?;
    equations.crossed(model, t, (s, v), inputs)?;
    Ok(Some(equations))
}

/// The flattest of the emitted charts other than this one, or the general one.
fn better<M: ConstrainedSystem>(
    quality: &Quality<M>,
    model: &Prepared<M>,
    here: Option<Chart>,
    t: f64,
    s: &M::State<f64>,
) -> Chart {
    quality.flattest(model, here, t, s).map_or(Chart::General, Chart::Emitted)
}

/// Whether an error is the breakdown of an emitted chart, which the mechanism does not share.
fn is_of_chart<M: ConstrainedSystem>(chart: Chart, error: &Error) -> bool {
    let (Chart::Emitted(chart), Error::ChartSingularity { guard, .. }) = (chart, error) else {
        return false;
    };
    let guards = M::MODEL.charts.get(chart).map_or(M::MODEL.guards, |chart| chart.guards);
    guards.iter().any(|info| info.name == *guard && of_chart(info))
}

/// The instants at which a digital controller takes its samples.
struct Samples<'r> {
    period: Option<f64>,
    plan: &'r Plan,
    taken: usize,
}

impl<'r> Samples<'r> {
    fn new(period: Option<f64>, plan: &'r Plan) -> Self {
        Samples { period, plan, taken: 0 }
    }

    /// Where the steps must end next; from a count, so that the times do not gather rounding errors.
    fn next(&self) -> f64 {
        let Some(period) = self.period else { return self.plan.end };
        let next = self.plan.start + self.plan.direction() * period * (self.taken + 1) as f64;
        if (self.plan.end - next) * self.plan.direction() > 0.0 { next } else { self.plan.end }
    }
}

/// Resets that follow each other without end: a ball that has come to rest on the floor.
#[derive(Default)]
struct Crowd {
    last: Option<f64>,
    count: usize,
}

impl Crowd {
    /// The most resets within the rounding of the time.
    const MOST: usize = 16;

    fn grows(&mut self, t: f64) -> bool {
        let close = |last: f64| (t - last).abs() <= 64.0 * f64::EPSILON * t.abs();
        self.count = if self.last.is_some_and(close) { self.count + 1 } else { 0 };
        self.last = Some(t);
        self.count >= Self::MOST
    }
}
