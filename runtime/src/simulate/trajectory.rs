//! What a run leaves behind.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use super::flow::Point;
use super::stages::interpolate;
use crate::{ConstrainedSystem, Error, Vector};

/// The array behind a model's state.
pub(super) type StateArray<M> = <<M as ConstrainedSystem>::State<f64> as Vector<f64>>::Array;

/// The states of a run in their order, and the polynomials between them.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let run = pendulum.simulate(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }).every(0.25).until(1.0)?;
/// assert_eq!(run.times(), [0.0, 0.25, 0.5, 0.75, 1.0]);
/// for (t, state) in run.iter() {
///     assert!((pendulum.energy(t, state) + 7.848).abs() < 1e-6);
/// }
/// let between = run.at(0.4)?;
/// assert!((between.x.hypot(between.y) - 0.5).abs() < 1e-7);
/// # Ok::<(), Error>(())
/// ```
pub struct Trajectory<M: ConstrainedSystem> {
    times: Vec<f64>,
    states: Vec<M::State<f64>>,
    /// Start and length of every step, in the direction of the run.
    steps: Vec<(f64, f64)>,
    /// For every step `stride` points, entry by entry.
    coefficients: Vec<f64>,
    stride: usize,
    pub(super) statistics: Statistics,
}

/// What a run took.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// Steps that were taken.
    pub accepted: usize,
    /// Steps that were tried and repeated with a smaller size.
    pub rejected: usize,
    /// Evaluations of `derivative`.
    pub evaluations: usize,
}

impl<M: ConstrainedSystem> Trajectory<M> {
    pub(super) fn new(t: f64, s: M::State<f64>) -> Self {
        Trajectory {
            times: alloc::vec![t],
            states: alloc::vec![s],
            steps: Vec::new(),
            coefficients: Vec::new(),
            stride: 0,
            statistics: Statistics::default(),
        }
    }

    pub(super) fn push(&mut self, t: f64, s: M::State<f64>) {
        self.times.push(t);
        self.states.push(s);
    }

    pub(super) fn push_step<P: Point>(&mut self, t: f64, h: f64, coefficients: &[P]) {
        self.stride = coefficients.len();
        self.steps.push((t, h));
        for point in coefficients {
            self.coefficients.extend((0..point.len()).map(|i| point.get(i)));
        }
    }

    /// The times of the states: every step, or what `every` asked for, and always the start and the end.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The states at those times.
    pub fn states(&self) -> &[M::State<f64>] {
        &self.states
    }

    /// Times and states in their order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (f64, &M::State<f64>)> + ExactSizeIterator {
        self.times.iter().copied().zip(&self.states)
    }

    /// The last time and the last state.
    pub fn last(&self) -> (f64, &M::State<f64>) {
        // A trajectory is made with its start and only grows.
        let last = self.times.len() - 1;
        (self.times[last], &self.states[last])
    }

    /// What the run took.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// The state at any time of the run, by the dense output of the method, which is as accurate as its steps.
    ///
    /// Position constraints hold there to the accuracy of the run, and to rounding at [`times`](Trajectory::times).
    pub fn at(&self, t: f64) -> Result<M::State<f64>, Error> {
        let (from, (to, end)) = (self.times[0], self.last());
        let direction = if to < from { -1.0 } else { 1.0 };
        // Also true where the time is not a number.
        if !((t - from) * direction >= 0.0 && (to - t) * direction >= 0.0) {
            return Err(Error::OutOfRange { time: t, from, to });
        }
        if t == to {
            return Ok(*end);
        }
        let before = |start: f64| (t - start) * direction >= 0.0;
        let stored = self.times.partition_point(|time| before(*time)).saturating_sub(1);
        if self.times[stored] == t {
            return Ok(self.states[stored]);
        }
        match self.steps.partition_point(|(start, _)| before(*start)) {
            0 => Err(Error::NoDenseOutput { time: t }),
            after => {
                let (start, h) = self.steps[after - 1];
                let count = self.stride;
                let length = self.coefficients.len() / (self.steps.len() * count);
                let coefficients = &self.coefficients[(after - 1) * count * length..after * count * length];
                let entry = |i: usize| interpolate(count, (t - start) / h, |j| coefficients[j * length + i]);
                Ok(M::State::from_fn(entry))
            }
        }
    }
}

impl<M: ConstrainedSystem> Clone for Trajectory<M> {
    fn clone(&self) -> Self {
        Trajectory {
            times: self.times.clone(),
            states: self.states.clone(),
            steps: self.steps.clone(),
            coefficients: self.coefficients.clone(),
            stride: self.stride,
            statistics: self.statistics,
        }
    }
}

impl<M: ConstrainedSystem> fmt::Debug for Trajectory<M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Trajectory")
            .field("model", &M::MODEL.name)
            .field("states", &self.states.len())
            .field("last", &self.last())
            .field("statistics", &self.statistics)
            .finish()
    }
}

/// A run that could not be finished: why, and what there is of it.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// // The speed ẋ does not describe the pendulum where the rod is level.
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let interrupted = pendulum.simulate(PendulumState { x: 0.0, y: -0.5, dot_x: 4.0 }).until(10.0).unwrap_err();
/// assert!(matches!(interrupted.error, Error::ChartSingularity { guard: "y", .. }));
/// let (t, last) = interrupted.trajectory.last();
/// assert!(t > 0.1 && last.y < 0.0);
/// # Ok::<(), Error>(())
/// ```
pub struct Interrupted<M: ConstrainedSystem> {
    /// Why the run ended.
    pub error: Error,
    /// The run so far; at least the start.
    pub trajectory: Trajectory<M>,
}

impl<M: ConstrainedSystem> fmt::Debug for Interrupted<M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Interrupted").field("error", &self.error).field("trajectory", &self.trajectory).finish()
    }
}

impl<M: ConstrainedSystem> fmt::Display for Interrupted<M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.fmt(out)
    }
}

impl<M: ConstrainedSystem> core::error::Error for Interrupted<M> {}

impl<M: ConstrainedSystem> From<Box<Interrupted<M>>> for Error {
    fn from(interrupted: Box<Interrupted<M>>) -> Error {
        interrupted.error
    }
}
