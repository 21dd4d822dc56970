//! Judging the guards: a state at which a pivot vanishes is not a regular one.

use alloc::vec::Vec;
use core::marker::PhantomData;

use crate::manifold::lift;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, GuardInfo, GuardKind, Prepared, Scalar, Vector};

/// A guard counts as vanished below this fraction of the largest magnitude that it had in the run.
///
/// What is divided by it has then lost about ten digits.
pub const SINGULAR: f64 = 1e-10;

/// A guard below this fraction is named when the run breaks down for no other reason.
const SUSPECT: f64 = 1e-3;

/// Coordinates of other kinds count with this weight in a guard's size at the start.
const OTHERS: f64 = 1e-4;

/// How far coordinates are moved to see how large a guard becomes, in parts of themselves: irrational, so that an angle of many whole
/// turns is not moved by whole turns.
const MOVED: [f64; 3] = [-0.381_966_011_250_105_1, 0.618_033_988_749_894_9, -0.732_050_807_568_877_3];

/// The figures of a chart's guards in a state whose speeds are those of the chart.
pub(super) fn figures<M: ConstrainedSystem, T: Scalar>(
    model: &Prepared<M, T>,
    chart: usize,
    t: T,
    s: &M::State<T>,
) -> M::ChartGuards<T> {
    // A model of one chart has no other guards, and its derivative need not be compiled once more for them.
    match chart {
        _ if M::MODEL.charts.len() < 2 => widen::<M, T>(M::guards(model.values(), t, s)),
        0 => widen::<M, T>(M::guards(model.values(), t, s)),
        _ => M::chart_derivative(chart, model.values(), t, s, &M::Inputs::from_fn(|_| T::default())).1,
    }
}

/// The guards of the first chart, filled up with ones to the length of the longest list.
#[inline(always)]
pub(super) fn widen<M: ConstrainedSystem, T: Scalar>(guards: M::Guards<T>) -> M::ChartGuards<T> {
    let array: <M::Guards<T> as Vector<T>>::Array = guards.into();
    Vector::from_fn(|i| array.as_ref().get(i).copied().unwrap_or(T::from_f64(1.0)))
}

/// Whether a guard is one of the chart alone: a pivot of constraints, for which other independent speeds would do.
pub(super) fn of_chart(info: &GuardInfo) -> bool {
    info.kind == GuardKind::Pivot && !info.rows.is_empty()
}

/// Watches the guards along a run.
pub(crate) struct Watch<M> {
    infos: &'static [GuardInfo],
    largest: Vec<f64>,
    negative: Vec<bool>,
    model: PhantomData<M>,
}

impl<M: ConstrainedSystem> Watch<M> {
    /// Starts watching, and judges the start.
    ///
    /// A guard alone does not tell whether it is small. At the start it is compared with how much it changes over the state's
    /// coordinates and the time, by its slopes but no more than it becomes there, so that cos θ at θ = π/2 counts as zero although
    /// rounding leaves 6e-17.
    pub(crate) fn new(model: &Prepared<M>, chart: usize, t: f64, s: &M::State<f64>) -> Result<Self, Error> {
        let watch = Self::unjudged(model, chart, t, s)?;
        watch.check(t, figures(model, chart, t, s).into().as_ref())?;
        Ok(watch)
    }

    /// The same for a chart in which the run is not: only the guards that all charts share count.
    pub(super) fn unjudged(model: &Prepared<M>, chart: usize, t: f64, s: &M::State<f64>) -> Result<Self, Error> {
        let infos = M::MODEL.charts.get(chart).map_or(M::MODEL.guards, |chart| chart.guards);
        let array = figures(model, chart, t, s).into();
        let guards: &[f64] = &array.as_ref()[..infos.len()];
        let mut largest = guards.iter().map(|guard| guard.abs()).collect::<Vec<_>>();
        let dual = lift(model)?;
        let state: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        let columns = M::MODEL.state_coordinates.len();
        let coordinates = &state.as_ref()[..columns.min(state.as_ref().len())];
        let reach = coordinates.iter().fold(0.0, |reach: f64, q| reach.max(q.abs()));
        let in_time = figures(&dual, chart, Dual::variable(t), &convert(s, |_, value| Dual::constant(value)));
        let in_time = in_time.into();
        let change = in_time.as_ref()[..infos.len()].iter().map(|guard| (guard.derivative * t).abs());
        let mut sums = change.collect::<Vec<f64>>();
        // Slopes say too much of what is bounded: a sine of an angle of a thousand turns does not change by a thousand.
        let mut bounds = largest.clone();
        let mut bound = |t: f64, s: &M::State<f64>| {
            let array = figures(model, chart, t, s).into();
            for (bound, guard) in bounds.iter_mut().zip(array.as_ref()) {
                // Where it is not defined, the slopes have the word.
                *bound = bound.max(if guard.is_nan() { f64::INFINITY } else { guard.abs() });
            }
        };
        MOVED.iter().for_each(|part| bound(t + part * t, s));
        for (j, q) in coordinates.iter().enumerate() {
            let seeded = convert(s, |i, value| Dual::new(value, if i == j { 1.0 } else { 0.0 }));
            let array = figures(&dual, chart, Dual::constant(t), &seeded).into();
            let far = q.abs().max(OTHERS * reach);
            for (sum, guard) in sums.iter_mut().zip(array.as_ref()) {
                *sum += guard.derivative.abs() * far;
            }
            let moved = |part: &f64| convert(s, |i, value| if i == j { value + part * far } else { value });
            MOVED.iter().for_each(|part| bound(t, &moved(part)));
        }
        for (largest, (sum, bound)) in largest.iter_mut().zip(sums.into_iter().zip(bounds)) {
            let size = sum.min(bound);
            if size.is_finite() {
                *largest = largest.max(size);
            }
        }
        let negative = guards.iter().map(|guard| *guard < 0.0).collect();
        Ok(Watch { infos, largest, negative, model: PhantomData })
    }

    /// Magnitude, change of sign and finiteness of the guards of a state.
    ///
    /// A pivot of D M Dᵀ is divided by those of the chart, and may vanish before them; the chart's is then the one to name.
    pub(super) fn check(&self, time: f64, guards: &[f64]) -> Result<(), Error> {
        let watched = self.largest.iter().zip(&self.negative);
        for ((info, &value), (largest, negative)) in self.infos.iter().zip(guards).zip(watched) {
            // Also true where the guard is not a number.
            let vanished = !(value.abs() > SINGULAR * *largest && value.is_finite());
            match info.kind {
                GuardKind::Positive if vanished || value < 0.0 => {
                    if let Some(cause) = self.weakest_of_chart(time, guards, SUSPECT) {
                        return Err(cause);
                    }
                    if vanished {
                        return Err(Error::ChartSingularity { guard: info.name, value, time });
                    }
                    return Err(Error::Indefinite { pivot: info.name, value, time: Some(time) });
                }
                GuardKind::Pivot if (value < 0.0) != *negative => {
                    return Err(Error::ChartSingularity { guard: info.name, value, time });
                }
                _ if vanished => return Err(Error::ChartSingularity { guard: info.name, value, time }),
                _ => {}
            }
        }
        Ok(())
    }

    /// The same for a run that is not in this chart: the pivots of the kinematics, which all charts share.
    pub(super) fn check_shared(&self, time: f64, guards: &[f64]) -> Result<(), Error> {
        let watched = self.largest.iter().zip(&self.negative);
        for ((info, &value), (largest, negative)) in self.infos.iter().zip(guards).zip(watched) {
            // Where the chart breaks down, its other figures need not be finite.
            let shared = info.kind == GuardKind::Pivot && !of_chart(info) && value.is_finite();
            if shared && (value.abs() <= SINGULAR * *largest || (value < 0.0) != *negative) {
                return Err(Error::ChartSingularity { guard: info.name, value, time });
            }
        }
        Ok(())
    }

    /// Checks a state that is accepted; the largest magnitudes grow with it.
    pub(super) fn judge(&mut self, time: f64, guards: &[f64]) -> Result<(), Error> {
        self.check(time, guards)?;
        for (largest, value) in self.largest.iter_mut().zip(guards) {
            *largest = largest.max(value.abs());
        }
        Ok(())
    }

    /// The guard that has come nearest to zero, if it is near enough to be the reason for a breakdown.
    pub(super) fn suspect(&self, time: f64, guards: &[f64]) -> Option<Error> {
        self.weakest_of_chart(time, guards, SUSPECT).or_else(|| self.nearest(time, guards, SUSPECT, |_| true))
    }

    /// The same among the pivots of the kinematics.
    pub(super) fn suspect_shared(&self, time: f64, guards: &[f64]) -> Option<Error> {
        self.nearest(time, guards, SUSPECT, |info| info.kind == GuardKind::Pivot && !of_chart(info))
    }

    /// The same among the chart's own guards, below a fraction.
    pub(super) fn weakest_of_chart(&self, time: f64, guards: &[f64], below: f64) -> Option<Error> {
        self.nearest(time, guards, below, of_chart)
    }

    /// The pivot of one of these rows that has come nearest to zero: the one that vanishes where the rows lose their rank.
    pub(super) fn of_rows(&self, guards: &[f64], rows: &[&str]) -> Option<&'static str> {
        let takes_part = |info: &GuardInfo| of_chart(info) && info.rows.iter().any(|row| rows.contains(row));
        self.nearest(0.0, guards, f64::INFINITY, takes_part).and_then(|error| error.guard())
    }

    fn nearest(&self, time: f64, guards: &[f64], below: f64, counts: impl Fn(&GuardInfo) -> bool) -> Option<Error> {
        let mut smallest = below;
        let mut found = None;
        for ((info, &value), largest) in self.infos.iter().zip(guards).zip(&self.largest) {
            let ratio = value.abs() / largest;
            if ratio < smallest && counts(info) {
                smallest = ratio;
                found = Some(Error::ChartSingularity { guard: info.name, value, time });
            }
        }
        found
    }

    /// The smallest figure of the chart's own guards relative to the largest that it had; one, where there is none.
    pub(super) fn margin(&self, guards: &[f64]) -> f64 {
        let own = self.infos.iter().zip(guards).zip(&self.largest).filter(|((info, _), _)| of_chart(info));
        own.fold(1.0, |least: f64, ((_, value), largest)| least.min(value.abs() / largest))
    }
}
