//! What a run leaves behind.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use super::charts::Chart;
use super::equations::Strength;
use super::events::Occurrence;
use super::flow::Point;
use super::readings::Residuals;
use super::stages::interpolate;
use crate::carriers::{Carriers, with_speeds};
use crate::vector::entry;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// A state, of which the coordinates count, and v.
pub(super) type Standing<M> = (<M as ConstrainedSystem>::State<f64>, <M as ConstrainedSystem>::Velocities<f64>);

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
    pub(super) model: Prepared<M>,
    times: Vec<f64>,
    states: Vec<M::State<f64>>,
    velocities: Vec<M::Velocities<f64>>,
    steps: Vec<Step>,
    /// For every step its coefficients, entry by entry.
    coefficients: Vec<f64>,
    residuals: Residuals,
    counts: Vec<(Chart, usize)>,
    events: Vec<Occurrence<M::State<f64>>>,
    /// Where branches met: times between which so little was left of the rank that nothing was restored, and how strong the rows of C
    /// were at best.
    meetings: Vec<(f64, f64, Strength)>,
    pub(super) statistics: Statistics,
}

/// A step with dense output.
#[derive(Copy, Clone)]
struct Step {
    start: f64,
    /// With the sign of the direction of the run.
    length: f64,
    chart: Chart,
    /// Where its coefficients begin.
    first: usize,
    /// The number of points of its chart that are its coefficients.
    stride: usize,
}

/// What a run took.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// Steps that were taken.
    pub accepted: usize,
    /// Steps that were tried and repeated with a smaller size.
    pub rejected: usize,
    /// Evaluations of `derivative`, or of the general form.
    pub evaluations: usize,
    /// How often the run went over to another chart.
    pub chart_changes: usize,
    /// How often the run passed a point where constraints lose their rank; see [`Crossing`](super::Crossing). A motion that turns
    /// right behind such a point passes it twice within one step, which does not count.
    pub crossings: usize,
}

/// The most Gauss-Newton steps to speeds on which v depends nonlinearly.
const REPEATS: usize = 20;

/// The state of coordinates and velocities, in the speeds of the first chart; of `s` the coordinates are read.
pub(super) fn view<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    v: &M::Velocities<f64>,
) -> M::State<f64> {
    let mut found = with_speeds::<M, f64>(s, entry(&model.chart_speeds(0, t, s, v)));
    // Where v is linear in the speeds the first is the last.
    for _ in 0..REPEATS {
        let next = with_speeds::<M, f64>(&found, entry(&model.chart_speeds(0, t, &found, v)));
        if next == found {
            break;
        }
        found = next;
    }
    found
}

impl<M: ConstrainedSystem> Trajectory<M> {
    pub(super) fn new(model: &Prepared<M>, t: f64, s: M::State<f64>, v: M::Velocities<f64>) -> Self {
        Trajectory {
            model: model.clone(),
            times: alloc::vec![t],
            states: alloc::vec![s],
            velocities: alloc::vec![v],
            steps: Vec::new(),
            coefficients: Vec::new(),
            residuals: Residuals::default(),
            counts: Vec::new(),
            events: Vec::new(),
            meetings: Vec::new(),
            statistics: Statistics::default(),
        }
    }

    pub(super) fn push(&mut self, t: f64, s: M::State<f64>, v: M::Velocities<f64>) {
        self.times.push(t);
        self.states.push(s);
        self.velocities.push(v);
    }

    pub(super) fn push_step<P: Point>(&mut self, (start, length): (f64, f64), chart: Chart, coefficients: &[P]) {
        self.steps.push(Step { start, length, chart, first: self.coefficients.len(), stride: coefficients.len() });
        for point in coefficients {
            self.coefficients.extend((0..point.len()).map(|i| point.get(i)));
        }
    }

    /// Counts an accepted step, and what remained of the constraints at its end.
    pub(super) fn accept(&mut self, chart: Chart, residuals: Residuals) {
        self.statistics.accepted += 1;
        self.residuals.position = self.residuals.position.max(residuals.position);
        self.residuals.velocity = self.residuals.velocity.max(residuals.velocity);
        match self.counts.iter_mut().find(|(known, _)| *known == chart) {
            Some((_, count)) => *count += 1,
            None => self.counts.push((chart, 1)),
        }
    }

    /// Counts losses of rank that were passed, and remembers where.
    pub(super) fn pass(&mut self, (from, to): (f64, f64), strength: Strength, losses: usize) {
        self.statistics.crossings += losses;
        self.meetings.push((from, to, strength));
    }

    /// Where the rank is as good as lost at a time, in the inner tenth of where nothing was restored, what the rows were at best.
    pub(super) fn meeting(&self, t: f64) -> Option<&Strength> {
        let is_within = |from: f64, to: f64| (t - 0.5 * (from + to)).abs() <= 0.05 * (to - from);
        self.meetings.iter().find(|(from, to, _)| is_within(*from, *to)).map(|(_, _, strength)| strength)
    }

    pub(super) fn record(&mut self, occurrence: Occurrence<M::State<f64>>) {
        self.events.push(occurrence);
    }

    pub(super) fn last_velocities(&self) -> &M::Velocities<f64> {
        // As long as the times, and never empty.
        &self.velocities[self.velocities.len() - 1]
    }

    /// The times of the states: every step, or what `every` asked for, and always the start, the end and the time of an event that
    /// ends the run or resets the state. A reset stands twice, with the state before and the state after it.
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

    /// The charts in which the run took steps, with the number of steps, in the order in which it first entered them.
    pub fn charts(&self) -> &[(Chart, usize)] {
        &self.counts
    }

    /// The events that took place, in their order; see [`Event`](super::Event).
    pub fn events(&self) -> &[Occurrence<M::State<f64>>] {
        &self.events
    }

    /// v at the [`times`](Trajectory::times): all velocities, also where the speeds of the state do not determine them.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// // Over the top, and through the places where ẋ says nothing about ẏ.
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let run = pendulum.simulate(PendulumState { x: 0.0, y: -0.5, dot_x: 5.5 }).until(2.0)?;
    /// for ((_, s), v) in run.iter().zip(run.velocities()) {
    ///     let energy = v.dot_x * v.dot_x + v.dot_y * v.dot_y + 2.0 * 9.81 * s.y;
    ///     assert!((energy - (5.5 * 5.5 - 9.81)).abs() < 1e-6);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn velocities(&self) -> &[M::Velocities<f64>] {
        &self.velocities
    }

    /// The state at any time of the run, by the dense output of the method, which is as accurate as its steps.
    ///
    /// Position constraints hold there to the accuracy of the run, and to rounding at [`times`](Trajectory::times).
    pub fn at(&self, t: f64) -> Result<M::State<f64>, Error> {
        Ok(self.standing(t)?.0)
    }

    /// v at any time of the run; see [`at`](Trajectory::at).
    pub fn velocities_at(&self, t: f64) -> Result<M::Velocities<f64>, Error> {
        Ok(self.standing(t)?.1)
    }

    /// The largest residuals at the end of any step, kept or not, of the constraints that steps may leave: zero where the
    /// coordinates and speeds of the state satisfy all constraints by construction.
    pub fn largest_residuals(&self) -> Residuals {
        self.residuals
    }

    /// Time, state and velocities at one of the times.
    pub(super) fn stored(&self, index: usize) -> (f64, &M::State<f64>, &M::Velocities<f64>) {
        (self.times[index], &self.states[index], &self.velocities[index])
    }

    /// State and velocities at any time of the run.
    pub(super) fn standing(&self, t: f64) -> Result<Standing<M>, Error> {
        let (from, (to, end)) = (self.times[0], self.last());
        let direction = if to < from { -1.0 } else { 1.0 };
        // Also true where the time is not a number.
        if !((t - from) * direction >= 0.0 && (to - t) * direction >= 0.0) {
            return Err(Error::OutOfRange { time: t, from, to });
        }
        if t == to {
            return Ok((*end, *self.last_velocities()));
        }
        let before = |start: f64| (t - start) * direction >= 0.0;
        let stored = self.times.partition_point(|time| before(*time)).saturating_sub(1);
        if self.times[stored] == t {
            return Ok((self.states[stored], self.velocities[stored]));
        }
        match self.steps.partition_point(|step| before(step.start)) {
            0 => Err(Error::NoDenseOutput { time: t }),
            after => Ok(self.within(&self.steps[after - 1], t)),
        }
    }

    /// State and velocities within a step.
    fn within(&self, step: &Step, t: f64) -> Standing<M> {
        let carriers = match step.chart {
            Chart::Emitted(chart) => Carriers::Chart(chart),
            Chart::General => Carriers::General,
        };
        let first = M::MODEL.state_coordinates.len();
        let length = first + carriers.count::<M>();
        let coefficients = &self.coefficients[step.first..step.first + step.stride * length];
        let theta = (t - step.start) / step.length;
        let entry = |i: usize| interpolate(step.stride, theta, |j| coefficients[j * length + i]);
        let s = M::State::from_fn(|i| if i < length { entry(i) } else { 0.0 });
        let v = carriers.velocities(&self.model, t, &s, |i| entry(first + i));
        match step.chart {
            Chart::Emitted(0) => (s, v),
            _ => (view(&self.model, t, &s, &v), v),
        }
    }
}

impl<M: ConstrainedSystem> Clone for Trajectory<M> {
    fn clone(&self) -> Self {
        Trajectory {
            model: self.model.clone(),
            times: self.times.clone(),
            states: self.states.clone(),
            velocities: self.velocities.clone(),
            steps: self.steps.clone(),
            coefficients: self.coefficients.clone(),
            residuals: self.residuals,
            counts: self.counts.clone(),
            events: self.events.clone(),
            meetings: self.meetings.clone(),
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
/// use holonomy::simulate::Charts;
///
/// // The speed ẋ does not describe the pendulum where the rod is level, and the run is told to stay with it.
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let start = PendulumState { x: 0.0, y: -0.5, dot_x: 4.0 };
/// let interrupted = pendulum.simulate(start).charts(Charts::Stay).until(10.0).unwrap_err();
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
