//! Judging the guards: a state at which a pivot vanishes is not a regular one.

use alloc::vec::Vec;
use core::marker::PhantomData;

use crate::manifold::lift;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, GuardKind, Prepared, Vector};

/// A guard counts as vanished below this fraction of the largest magnitude that it had in the run.
///
/// What is divided by it has then lost about ten digits.
pub const SINGULAR: f64 = 1e-10;

/// A guard below this fraction is named when the run breaks down for no other reason.
const SUSPECT: f64 = 1e-3;

/// Coordinates of other kinds count with this weight in a guard's size at the start.
const OTHERS: f64 = 1e-4;

/// Watches the guards along a run.
pub(super) struct Watch<M> {
    largest: Vec<f64>,
    negative: Vec<bool>,
    model: PhantomData<M>,
}

impl<M: ConstrainedSystem> Watch<M> {
    /// Starts watching, and judges the start.
    ///
    /// A guard alone does not tell whether it is small. At the start it is compared with how much it changes over the state's
    /// coordinates and the time, so that cos θ at θ = π/2 counts as zero although rounding leaves 6e-17.
    pub(super) fn new(model: &Prepared<M>, t: f64, s: &M::State<f64>) -> Result<Self, Error> {
        let array = model.guards(t, s).into();
        let guards: &[f64] = array.as_ref();
        let mut largest = guards.iter().map(|guard| guard.abs()).collect::<Vec<_>>();
        let dual = lift(model)?;
        let state: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        let columns = M::MODEL.state_coordinates.len();
        let coordinates = &state.as_ref()[..columns.min(state.as_ref().len())];
        let reach = coordinates.iter().fold(0.0, |reach: f64, q| reach.max(q.abs()));
        let in_time = dual.guards(Dual::variable(t), &convert(s, |_, value| Dual::constant(value)));
        let in_time = in_time.into();
        let change = in_time.as_ref().iter().map(|guard| (guard.derivative * t).abs());
        let mut sums = change.collect::<Vec<f64>>();
        for (j, q) in coordinates.iter().enumerate() {
            let seeded = convert(s, |i, value| Dual::new(value, if i == j { 1.0 } else { 0.0 }));
            let array = dual.guards(Dual::constant(t), &seeded).into();
            for (sum, guard) in sums.iter_mut().zip(array.as_ref()) {
                *sum += guard.derivative.abs() * q.abs().max(OTHERS * reach);
            }
        }
        for (largest, sum) in largest.iter_mut().zip(sums) {
            if sum.is_finite() {
                *largest = largest.max(sum);
            }
        }
        let negative = guards.iter().map(|guard| *guard < 0.0).collect();
        let mut watch = Watch { largest, negative, model: PhantomData };
        watch.judge(t, guards)?;
        Ok(watch)
    }

    /// Magnitude, change of sign and finiteness of the guards of a state.
    pub(super) fn check(&self, time: f64, guards: &[f64]) -> Result<(), Error> {
        let watched = self.largest.iter().zip(&self.negative);
        for ((info, &value), (largest, negative)) in M::MODEL.guards.iter().zip(guards).zip(watched) {
            // Also true where the guard is not a number.
            let vanished = !(value.abs() > SINGULAR * *largest && value.is_finite());
            match info.kind {
                GuardKind::Positive if !vanished && value < 0.0 => {
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

    /// The same for a state that is accepted; the largest magnitudes grow with it.
    pub(super) fn judge(&mut self, time: f64, guards: &[f64]) -> Result<(), Error> {
        self.check(time, guards)?;
        for (largest, value) in self.largest.iter_mut().zip(guards) {
            *largest = largest.max(value.abs());
        }
        Ok(())
    }

    /// The guard that has come nearest to zero, if it is near enough to be the reason for a breakdown.
    pub(super) fn suspect(&self, time: f64, guards: &[f64]) -> Option<Error> {
        let mut smallest = SUSPECT;
        let mut found = None;
        for ((info, &value), largest) in M::MODEL.guards.iter().zip(guards).zip(&self.largest) {
            let ratio = value.abs() / largest;
            if ratio < smallest {
                smallest = ratio;
                found = Some(Error::ChartSingularity { guard: info.name, value, time });
            }
        }
        found
    }
}
