//! An emitted chart as a flow: its points are states whose speeds are those of the chart.

use super::charts::{Chart, Quality, STEEP};
use super::crossing::Approach;
use super::equations::Equations;
use super::flow::Flow;
use super::guards::{Watch, figures, widen};
use super::inputs::InputSource;
use super::readings::Residuals;
use super::redundancy::Redundancy;
use super::trajectory::view;
use crate::assemble::first_non_finite;
use crate::carriers::StateArray;
use crate::drift::Drift;
use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// Where no pivot of the chart has lost more than this factor, the chart is not compared with others.
const WATCHED: f64 = 0.8;

/// Where no pivot of the chart has lost more than this factor, the chart is not left for the general one.
const LOST: f64 = 0.5;

/// Where a pivot of the chart has lost this factor, the chart is left even where it is flat: rounding errors are magnified by its
/// inverse.
const SPENT: f64 = 1e-2;

/// An error estimate counts at most so much more near the zero of a pivot.
const STRICTEST: f64 = 1000.0;

/// A model in one of its charts, with its inputs, its guards and its way back onto the constraints.
pub(super) struct Emitted<'r, M: ConstrainedSystem, I> {
    pub(super) model: &'r Prepared<M>,
    pub(super) chart: usize,
    pub(super) source: &'r mut I,
    pub(super) watch: Watch<M>,
    pub(super) manifold: Option<&'r mut Manifold<M>>,
    /// What looks at the rows that are marked redundant, where there are some.
    pub(super) redundancy: Option<&'r mut Redundancy<M>>,
    pub(super) drift: Option<Drift<M>>,
    /// The rows of C from step to step, where there are nonlinear ones: they vanish, and turn over, without a pivot that tells.
    pub(super) crossing: Option<Equations<M>>,
    /// With the charts that the run may change to.
    pub(super) quality: Option<&'r Quality<M>>,
    /// What watches for losses of rank that the run may pass, where a pivot of the chart tells that one may be near.
    pub(super) approach: Option<&'r mut Approach<M>>,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Emitted<'_, M, I> {
    /// The rate in a chart other than that of the state.
    #[inline(never)]
    fn further(&mut self, t: f64, y: &StateArray<M>) -> (StateArray<M>, M::ChartGuards<f64>) {
        let inputs = self.inputs(t, y);
        let (rate, guards) = M::chart_derivative(self.chart, self.model.values(), t, &(*y).into(), &inputs);
        (rate.into(), guards)
    }

    fn inputs(&mut self, t: f64, y: &StateArray<M>) -> M::Inputs<f64> {
        let s = if I::GIVEN { self.view(t, y).0 } else { (*y).into() };
        self.source.inputs(t, &s)
    }
}

impl<M: ConstrainedSystem, I: InputSource<M>> Flow<M> for Emitted<'_, M, I> {
    type Point = StateArray<M>;
    type Guards = M::ChartGuards<f64>;

    #[inline(always)]
    fn rate(&mut self, t: f64, y: &Self::Point) -> (Self::Point, Self::Guards) {
        if M::MODEL.charts.len() > 1 && self.chart > 0 {
            return self.further(t, y);
        }
        let s = (*y).into();
        let inputs = self.source.inputs(t, &s);
        let (rate, guards) = M::derivative(self.model.values(), t, &s, &inputs);
        (rate.into(), widen::<M, f64>(guards))
    }

    fn judge_stage(&self, t: f64, guards: &Self::Guards) -> Result<(), Error> {
        self.watch.check(t, (*guards).into().as_ref())
    }

    fn judge(&mut self, t: f64, guards: &Self::Guards) -> Result<(), Error> {
        self.watch.judge(t, (*guards).into().as_ref())
    }

    fn passed(&mut self, t: f64, y: &Self::Point) -> Result<(), Error> {
        if self.redundancy.is_none() && self.crossing.is_none() {
            return Ok(());
        }
        let ((s, v), inputs) = (self.view(t, y), self.inputs(t, y));
        if let Some(rows) = &mut self.redundancy {
            rows.check(self.model, t, (&s, &v), &inputs)?;
        }
        let Some(crossing) = &mut self.crossing else { return Ok(()) };
        crossing.crossed(self.model, t, (&s, &v), &inputs).map_err(|mut error| {
            if let Error::Dependent { rows, guard, .. } = &mut error {
                let guards = figures(self.model, self.chart, t, &(*y).into()).into();
                *guard = self.watch.of_rows(guards.as_ref(), rows);
            }
            error
        })
    }

    fn restore(&mut self, t: f64, y: &mut Self::Point) -> Result<bool, Error> {
        let mut moved = false;
        if let Some(manifold) = &mut self.manifold {
            let mut s = (*y).into();
            moved = manifold.restore(self.model, t, &mut s)?;
            if moved {
                *y = s.into();
            }
        }
        if let Some(drift) = &mut self.drift {
            let s = (*y).into();
            moved |= drift.restore(self.model, t, &s, &mut y.as_mut()[M::MODEL.state_coordinates.len()..])?;
        }
        Ok(moved)
    }

    fn residuals(&self) -> Residuals {
        Residuals {
            position: self.manifold.as_ref().map_or(0.0, |manifold| manifold.last),
            velocity: self.drift.as_ref().map_or(0.0, |drift| drift.last),
        }
    }

    fn view(&self, t: f64, y: &Self::Point) -> (M::State<f64>, M::Velocities<f64>) {
        let s = (*y).into();
        match self.chart {
            0 => (s, self.model.velocities(t, &s)),
            chart => {
                let v = self.model.chart_velocities(chart, t, &s);
                (view(self.model, t, &s, &v), v)
            }
        }
    }

    fn chart(&self) -> Chart {
        Chart::Emitted(self.chart)
    }

    fn leaves(&mut self, t: f64, y: &Self::Point, guards: &Self::Guards) -> bool {
        let Some(quality) = self.quality else {
            return false;
        };
        let margin = self.watch.margin((*guards).into().as_ref());
        if margin >= WATCHED {
            return false;
        }
        let s = (*y).into();
        let steepness = quality.steepness(self.model, self.chart, t, &s);
        margin < SPENT
            || margin < LOST && steepness > STEEP
            || quality.has_flatter(self.model, self.chart, t, &s, 0.5 * steepness)
    }

    fn nears(&mut self, t: f64, y: &Self::Point, guards: &Self::Guards) -> bool {
        if self.approach.is_none() || self.watch.margin((*guards).into().as_ref()) >= LOST {
            return false;
        }
        let ((s, v), inputs) = (self.view(t, y), self.inputs(t, y));
        self.approach.as_mut().is_some_and(|approach| approach.look(self.model, t, (&s, &v), &inputs))
    }

    /// The estimates are made of lower orders, five and three, than the step's own error, which grows faster towards the zero of
    /// a pivot, by three to five powers of the distance. Four are made up for, by measurement: at most speeds a pendulum then loses a
    /// third to a twentieth of the energy that it loses with two.
    fn strictness(&self, guards: &Self::Guards) -> f64 {
        let margin = self.watch.margin((*guards).into().as_ref());
        let square = margin * margin;
        (1.0 / (square * square)).min(STRICTEST)
    }

    fn diagnose(&mut self, (t, next): (f64, f64), y: &Self::Point, broken: &Self::Point) -> Error {
        if let Some(error) = self.suspect(t, y) {
            return error;
        }
        for at in [t, next] {
            if let Err(error) = check_inputs::<M>(&self.inputs(at, y)) {
                return error;
            }
        }
        Error::Diverged { name: first_non_finite::<M>(&(*broken).into()).unwrap_or("derivative"), time: t }
    }

    fn suspect(&mut self, t: f64, y: &Self::Point) -> Option<Error> {
        self.watch.suspect(t, figures(self.model, self.chart, t, &(*y).into()).into().as_ref())
    }
}

/// Inputs that a source gave must be finite.
pub(crate) fn check_inputs<M: ConstrainedSystem>(inputs: &M::Inputs<f64>) -> Result<(), Error> {
    let array: <M::Inputs<f64> as Vector<f64>>::Array = (*inputs).into();
    match array.as_ref().iter().position(|input| !input.is_finite()) {
        Some(at) => Err(Error::NonFinite { name: M::MODEL.inputs.get(at).copied().unwrap_or("input") }),
        None => Ok(()),
    }
}
