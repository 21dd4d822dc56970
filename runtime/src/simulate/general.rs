//! The general chart as a flow: its points are the coordinates of the state and the carriers.

use super::charts::{Chart, Quality};
use super::crossing::Approach;
use super::emitted::check_inputs;
use super::equations::{Baumgarte, Equations};
use super::flow::{Flow, Point};
use super::guards::{Watch, figures};
use super::inputs::InputSource;
use super::readings::Residuals;
use super::redundancy::Redundancy;
use super::trajectory::view;
use crate::carriers::StateArray;
use crate::drift::Drift;
use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// A smallest pivot of C below this fraction of its largest value may have magnified rounding errors: with its square in the
/// velocities, with its cube in their rates, where the rows are those of positions.
const WORN: f64 = 0.01;

/// The array behind a model's carriers.
pub(super) type CarrierArray<M> = <<M as ConstrainedSystem>::Carriers<f64> as Vector<f64>>::Array;

/// Coordinates of a state and carriers.
#[derive(Copy, Clone)]
pub(super) struct Pair<S, W> {
    /// A state, of which the coordinates count.
    state: S,
    carriers: W,
    /// The number of coordinates.
    first: usize,
}

impl<S: Copy, W: AsRef<[f64]> + AsMut<[f64]> + Copy> Pair<S, W> {
    /// Multiplies the carriers.
    pub(super) fn scale_carriers(&mut self, factor: f64) {
        self.carriers.as_mut().iter_mut().for_each(|w| *w *= factor);
    }
}

impl<S: AsRef<[f64]> + AsMut<[f64]> + Copy, W: AsRef<[f64]> + AsMut<[f64]> + Copy> Point for Pair<S, W> {
    fn len(&self) -> usize {
        self.first + self.carriers.as_ref().len()
    }
    fn get(&self, i: usize) -> f64 {
        if i < self.first { self.state.as_ref()[i] } else { self.carriers.as_ref()[i - self.first] }
    }
    fn get_mut(&mut self, i: usize) -> &mut f64 {
        if i < self.first { &mut self.state.as_mut()[i] } else { &mut self.carriers.as_mut()[i - self.first] }
    }
}

/// A point of the general chart.
pub(super) type GeneralPoint<M> = Pair<StateArray<M>, CarrierArray<M>>;

/// The point with the coordinates of a state and with carriers.
pub(super) fn point<M: ConstrainedSystem>(s: &M::State<f64>, w: M::Carriers<f64>) -> GeneralPoint<M> {
    Pair { state: (*s).into(), carriers: w.into(), first: M::MODEL.state_coordinates.len() }
}

/// A model in its general chart.
pub(super) struct General<'r, M: ConstrainedSystem, I> {
    pub(super) model: &'r Prepared<M>,
    pub(super) source: &'r mut I,
    pub(super) equations: &'r mut Equations<M>,
    pub(super) manifold: Option<&'r mut Manifold<M>>,
    /// What looks at the rows that are marked redundant, where there are some.
    pub(super) redundancy: Option<&'r mut Redundancy<M>>,
    pub(super) drift: Option<Drift<M>>,
    /// The guards of the first chart, of which those of the kinematics count here as well.
    pub(super) watch: Watch<M>,
    /// With the charts that the run may return to.
    pub(super) quality: Option<&'r Quality<M>>,
    /// With these the constraints are stabilised instead of restored.
    pub(super) baumgarte: Baumgarte,
    /// Why the last rate could not be found.
    pub(super) failure: Option<Error>,
    /// What watches for losses of rank, where the run may pass them.
    pub(super) approach: Option<&'r mut Approach<M>>,
    /// Times between which points are as exact as they can be: so near to a loss of rank restoring them would only add rounding.
    pub(super) untouched: Option<(f64, f64)>,
}

impl<M: ConstrainedSystem, I: InputSource<M>> General<'_, M, I> {
    /// Names the pivot of the first chart that vanishes with the rank.
    fn with_guard(&self, error: Error, guards: &M::ChartGuards<f64>) -> Error {
        match error {
            Error::Dependent { rows, value, guard: None, time } => {
                let guard = self.watch.of_rows((*guards).into().as_ref(), &rows);
                Error::Dependent { rows, value, guard, time }
            }
            error => error,
        }
    }

    /// A first guess of the point a while later, of second order in the coordinates: with the velocities of half the time.
    pub(super) fn guess(&self, t: f64, y: &GeneralPoint<M>, rate: &GeneralPoint<M>, later: f64) -> GeneralPoint<M> {
        let after = |part: f64| {
            let w = |i: usize| y.carriers.as_ref()[i] + part * later * rate.carriers.as_ref()[i];
            M::Carriers::from_fn(w)
        };
        let rates = self.model.carried_rates(t, &y.state.into(), &after(0.5)).into();
        let mut ahead = *y;
        for (q, rate) in ahead.state.as_mut().iter_mut().zip(rates.as_ref()) {
            *q += later * rate;
        }
        ahead.carriers = after(1.0).into();
        ahead
    }

    /// The kinetic and the potential energy of a point; none, where the model has no potential energy, or moves at w = 0.
    pub(super) fn energies(&self, t: f64, y: &GeneralPoint<M>) -> Option<(f64, f64)> {
        let s: M::State<f64> = y.state.into();
        let at_rest = self.model.carried_velocities(t, &s, &M::Carriers::from_fn(|_| 0.0)).into();
        if at_rest.as_ref().iter().any(|v| *v != 0.0) {
            return None;
        }
        let (x, v) = (self.model.coordinates(t, &s), self.velocities(t, y));
        Some((self.model.kinetic_energy(t, &x, &v), self.model.potential_energy(t, &x)?))
    }

    fn velocities(&self, t: f64, y: &GeneralPoint<M>) -> M::Velocities<f64> {
        self.model.carried_velocities(t, &y.state.into(), &y.carriers.into())
    }
}

impl<M: ConstrainedSystem, I: InputSource<M>> Flow<M> for General<'_, M, I> {
    type Point = GeneralPoint<M>;
    type Guards = M::ChartGuards<f64>;

    fn rate(&mut self, t: f64, y: &Self::Point) -> (Self::Point, Self::Guards) {
        let s = self.view(t, y).0;
        let inputs = self.source.inputs(t, &s);
        let guards = figures(self.model, 0, t, &s);
        let mut rate = *y;
        match self.equations.solve(self.model, t, &s, &y.carriers.into(), &inputs, self.baumgarte) {
            Ok(rates) => {
                let rates = rates.into();
                rate.state.as_mut()[..y.first].copy_from_slice(rates.as_ref());
                rate.carriers.as_mut().copy_from_slice(&self.equations.rates);
                self.failure = None;
            }
            Err(error) => {
                (0..rate.len()).for_each(|i| *rate.get_mut(i) = f64::NAN);
                self.failure = Some(self.with_guard(error, &guards));
            }
        }
        (rate, guards)
    }

    fn judge_stage(&self, t: f64, guards: &Self::Guards) -> Result<(), Error> {
        match &self.failure {
            Some(error) => Err(error.clone()),
            None => self.watch.check_shared(t, (*guards).into().as_ref()),
        }
    }

    fn judge(&mut self, t: f64, guards: &Self::Guards) -> Result<(), Error> {
        self.judge_stage(t, guards)?;
        self.equations.accept(t).map_err(|error| self.with_guard(error, guards))
    }

    fn passed(&mut self, t: f64, y: &Self::Point) -> Result<(), Error> {
        // A loss of rank was judged with the guards: every stage was seen.
        if self.redundancy.is_none() {
            return Ok(());
        }
        let (s, v) = self.view(t, y);
        let inputs = self.source.inputs(t, &s);
        self.redundancy.as_mut().map_or(Ok(()), |rows| rows.check(self.model, t, (&s, &v), &inputs))
    }

    fn restore(&mut self, t: f64, y: &mut Self::Point) -> Result<bool, Error> {
        if self.baumgarte.is_some() || self.untouched.is_some_and(|(from, to)| from <= t && t <= to) {
            return Ok(false);
        }
        let mut moved = false;
        if let Some(manifold) = &mut self.manifold {
            let mut s = y.state.into();
            moved = manifold.restore(self.model, t, &mut s)?;
            y.state = s.into();
        }
        if let Some(drift) = &mut self.drift {
            moved |= drift.restore(self.model, t, &y.state.into(), y.carriers.as_mut())?;
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
        let v = self.velocities(t, y);
        (view(self.model, t, &y.state.into(), &v), v)
    }

    fn chart(&self) -> Chart {
        Chart::General
    }

    fn leaves(&mut self, t: f64, y: &Self::Point, _: &Self::Guards) -> bool {
        // All charts lose their pivots with the rank, also those that look flat there.
        self.equations.weakest(t, WORN).is_none()
            && self.quality.is_some_and(|quality| quality.flattest(self.model, None, t, &y.state.into()).is_some())
    }

    fn nears(&mut self, _: f64, _: &Self::Point, _: &Self::Guards) -> bool {
        let left = self.equations.rank_left();
        self.approach.as_mut().is_some_and(|approach| approach.nears(left))
    }

    fn strictness(&self, _: &Self::Guards) -> f64 {
        1.0
    }

    fn diagnose(&mut self, (t, next): (f64, f64), y: &Self::Point, _: &Self::Point) -> Error {
        let s = self.view(t, y).0;
        for at in [t, next] {
            if let Err(error) = check_inputs::<M>(&self.source.inputs(at, &s)) {
                return error;
            }
        }
        let failure = match self.failure.take() {
            Some(Error::NonFinite { .. }) | None => None,
            failure => failure,
        };
        let diverged = Error::Diverged { name: "derivative", time: t };
        failure.or_else(|| self.suspect(t, y)).unwrap_or(diverged)
    }

    fn suspect(&mut self, t: f64, y: &Self::Point) -> Option<Error> {
        let s = self.view(t, y).0;
        self.watch.suspect_shared(t, figures(self.model, 0, t, &s).into().as_ref())
    }
}
