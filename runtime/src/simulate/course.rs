//! A model on its way through a plan, from chart to chart.

use alloc::boxed::Box;

use super::charts::{Chart, Charts, Quality, STEEP};
use super::emitted::Emitted;
use super::equations::{Baumgarte, Equations};
use super::flow::Flow;
use super::general::{General, point};
use super::guards::{Watch, of_chart};
use super::inputs::InputSource;
use super::kernel::{Exit, Plan, Run};
use super::tableau::Tableau;
use super::trajectory::{Standing, Trajectory};
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
    pub(super) charts: Charts,
    pub(super) baumgarte: Baumgarte,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
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
            chart = better(quality, self.model, plan.start, &standing.0);
        }
        let mut run = Run::new(tableau, plan, trajectory, self.progress.take());
        let result = loop {
            let result = self.leg(chart, &mut run, quality.as_ref(), &mut standing);
            let next = match (&quality, result) {
                (_, Ok(Exit::End)) => break Ok(()),
                (Some(quality), Ok(Exit::Leaves)) => better(quality, self.model, run.t, &standing.0),
                (Some(_), Err(error)) if is_of_chart::<M>(chart, &error) => Chart::General,
                (None, Ok(Exit::Leaves)) => chart,
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

    /// What judges the charts, where the model has any that may break down, and the run may change them.
    fn quality(&self) -> Result<Option<Quality<M>>, Error> {
        let mut guards = M::MODEL.charts.iter().flat_map(|chart| chart.guards).chain(M::MODEL.guards);
        let changes = self.charts == Charts::Change && guards.any(of_chart);
        if changes { Quality::new(self.model).map(Some) } else { Ok(None) }
    }

    /// The steps in one chart.
    fn leg<const S: usize>(
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
        match chart {
            Chart::Emitted(chart) => {
                let start = match chart {
                    0 => s,
                    _ => with_speeds::<M, f64>(&s, entry(&model.chart_speeds(chart, t, &s, &v))),
                };
                let mut flow = Emitted {
                    model,
                    chart,
                    watch: Watch::new(model, chart, t, &start)?,
                    drift: drift(Carriers::Chart(chart))?,
                    source: &mut self.source,
                    manifold: self.manifold.as_mut(),
                    quality,
                };
                let mut y = start.into();
                let result = run.steps(&mut flow, &mut y);
                if run.t != t {
                    *standing = flow.view(run.t, &y);
                }
                result
            }
            Chart::General => {
                let mut equations = Equations::new(model)?;
                let w = equations.carriers(model, t, &s, &v);
                let mut flow = General {
                    model,
                    watch: Watch::unjudged(model, 0, t, &s)?,
                    drift: drift(Carriers::General)?,
                    source: &mut self.source,
                    equations: &mut equations,
                    manifold: self.manifold.as_mut(),
                    quality,
                    baumgarte: self.baumgarte,
                    failure: None,
                };
                let mut y = point::<M>(&s, w);
                let result = run.steps(&mut flow, &mut y);
                if run.t != t {
                    *standing = flow.view(run.t, &y);
                }
                result
            }
        }
    }
}

/// The flattest of the emitted charts, or the general one.
fn better<M: ConstrainedSystem>(quality: &Quality<M>, model: &Prepared<M>, t: f64, s: &M::State<f64>) -> Chart {
    quality.flattest(model, t, s).map_or(Chart::General, Chart::Emitted)
}

/// Whether an error is the breakdown of an emitted chart, which the mechanism does not share.
fn is_of_chart<M: ConstrainedSystem>(chart: Chart, error: &Error) -> bool {
    let (Chart::Emitted(chart), Error::ChartSingularity { guard, .. }) = (chart, error) else {
        return false;
    };
    let guards = M::MODEL.charts.get(chart).map_or(M::MODEL.guards, |chart| chart.guards);
    guards.iter().any(|info| info.name == *guard && of_chart(info))
}
