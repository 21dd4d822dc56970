//! Events: zeros of functions of the time and the state, located on the dense output of a step.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use crate::ConstrainedSystem;

/// A step is searched in this many parts: two zeros of one event within a part are not seen.
const PARTS: usize = 8;
/// The first looks after a start at which the function is zero, as parts of the step.
const FIRST: [f64; 4] = [1e-6, 1e-4, 1e-3, 1e-2];
/// A zero is located to this part of a step.
const FINEST: f64 = 0.25 * f64::EPSILON;

/// A function of the time and the state, whose zeros a run locates; for [`Simulation::event`](super::Simulation::event).
///
/// Zeros are found where the function changes its sign within an eighth of a step, and located to rounding on the dense output,
/// which is as accurate as the steps. A function that is zero at the start, or after a reset, is watched from where it leaves
/// zero. What touches zero and turns back within an eighth of a step is not seen: shorten the steps by `max_step`.
///
/// ```
/// # mod models {
/// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs"));
/// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/oscillator.rs"));
/// # }
/// # use models::{Oscillator, OscillatorInputs, OscillatorState};
/// use holonomy::prelude::*;
/// use holonomy::simulate::Event;
///
/// // A ball that falls with 10 m/s² and keeps half of its speed at every impact.
/// let ball = Oscillator { m: 1.0, a: 0.0, k: 0.0, c: 0.0, b: 0.0 }.prepare()?;
/// let impact = Event::<Oscillator>::new("impact", |_, s| s.x)
///     .falling()
///     .reset(|_, s| OscillatorState { x: 0.0, dot_x: -0.5 * s.dot_x });
/// let run = ball
///     .simulate(OscillatorState { x: 5.0, dot_x: 0.0 })
///     .inputs(|_, _| OscillatorInputs { tau: -10.0 })
///     .event(impact)
///     .event(Event::<Oscillator>::new("apex", |_, s| s.dot_x).falling())
///     .until(2.7)?;
/// let times: Vec<_> = run.events().iter().map(|event| (event.name, event.time)).collect();
/// let exact = [("impact", 1.0), ("apex", 1.5), ("impact", 2.0), ("apex", 2.25), ("impact", 2.5), ("apex", 2.625)];
/// assert_eq!(times.len(), exact.len());
/// for ((name, time), (expected, at)) in times.into_iter().zip(exact) {
///     assert!(name == expected && (time - at).abs() < 1e-12);
/// }
/// # Ok::<(), Error>(())
/// ```
pub struct Event<'a, M: ConstrainedSystem> {
    name: &'static str,
    function: Function<'a, M>,
    direction: Direction,
    action: Action<'a, M>,
}

/// What is watched.
type Function<'a, M> = Box<dyn FnMut(f64, &<M as ConstrainedSystem>::State<f64>) -> f64 + 'a>;

/// Which changes of sign count.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Direction {
    Both,
    Rising,
    Falling,
}

/// A new state in place of the one at a zero.
pub(super) type Reset<'a, M> =
    Box<dyn FnMut(f64, &<M as ConstrainedSystem>::State<f64>) -> <M as ConstrainedSystem>::State<f64> + 'a>;

/// What a run does at a zero.
enum Action<'a, M: ConstrainedSystem> {
    Continue,
    Stop,
    Reset(Reset<'a, M>),
}

impl<'a, M: ConstrainedSystem> Event<'a, M> {
    /// An event where the function is zero, in whichever direction it runs through; the run goes on.
    pub fn new(name: &'static str, function: impl FnMut(f64, &M::State<f64>) -> f64 + 'a) -> Self {
        Event { name, function: Box::new(function), direction: Direction::Both, action: Action::Continue }
    }

    /// Only where the function grows along the run.
    #[must_use]
    pub fn rising(mut self) -> Self {
        self.direction = Direction::Rising;
        self
    }

    /// Only where the function falls along the run.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.direction = Direction::Falling;
        self
    }

    /// The run ends at the first such zero.
    #[must_use]
    pub fn stop(mut self) -> Self {
        self.action = Action::Stop;
        self
    }

    /// The run goes on from another state: an impact, a switch. The new state must satisfy the constraints as a start does.
    #[must_use]
    pub fn reset(mut self, state: impl FnMut(f64, &M::State<f64>) -> M::State<f64> + 'a) -> Self {
        self.action = Action::Reset(Box::new(state));
        self
    }

    fn counts(&self, rises: bool) -> bool {
        match self.direction {
            Direction::Both => true,
            Direction::Rising => rises,
            Direction::Falling => !rises,
        }
    }
}

impl<M: ConstrainedSystem> fmt::Debug for Event<'_, M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let action = match self.action {
            Action::Continue => "continue",
            Action::Stop => "stop",
            Action::Reset(_) => "reset",
        };
        out.debug_struct("Event")
            .field("name", &self.name)
            .field("direction", &self.direction)
            .field("action", &action)
            .finish_non_exhaustive()
    }
}

/// An event that took place; from [`Trajectory::events`](super::Trajectory::events).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Occurrence<S> {
    /// The event's name.
    pub name: &'static str,
    /// When.
    pub time: f64,
    /// The state, before a reset.
    pub state: S,
    /// Whether the function grew along the run.
    pub rising: bool,
}

/// What follows from an event for the run.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    Continue,
    Stop,
    /// By the event of that index.
    Reset(usize),
}

/// A zero within a step: where, of which event, in which direction.
#[derive(Copy, Clone, Debug)]
pub(super) struct Zero {
    pub(super) theta: f64,
    event: usize,
    pub(super) rising: bool,
}

/// The events of a run, and the signs of their functions at the last point: none where a function is, or was just, zero.
pub(super) struct Events<'a, M: ConstrainedSystem> {
    list: Vec<Event<'a, M>>,
    signs: Vec<Option<bool>>,
}

impl<'a, M: ConstrainedSystem> Events<'a, M> {
    pub(super) fn new(list: Vec<Event<'a, M>>) -> Self {
        let signs = alloc::vec![None; list.len()];
        Events { list, signs }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The functions start anew, at a start or after a reset.
    pub(super) fn start(&mut self, t: f64, s: &M::State<f64>) {
        for (event, sign) in self.list.iter_mut().zip(&mut self.signs) {
            *sign = sign_of((event.function)(t, s));
        }
    }

    /// All zeros within a step in their order. `at` gives time and state at a part of the step.
    pub(super) fn within(&mut self, mut at: impl FnMut(f64) -> (f64, M::State<f64>)) -> Vec<Zero> {
        let mut zeros = Vec::new();
        for (index, (event, sign)) in self.list.iter_mut().zip(&mut self.signs).enumerate() {
            let mut value = |theta: f64| {
                let (t, s) = at(theta);
                (event.function)(t, &s)
            };
            let mut from = (0.0, *sign);
            let first = FIRST.iter().copied().filter(|_| sign.is_none());
            let looks = first.chain((1..=PARTS).map(|part| part as f64 / PARTS as f64));
            for theta in looks {
                let found = sign_of(value(theta));
                if let Some(was) = from.1
                    && found != Some(was)
                {
                    let rising = !was;
                    let theta = match found {
                        None => theta,
                        Some(_) => locate(&mut value, from.0, theta, was),
                    };
                    zeros.push(Zero { theta, event: index, rising });
                }
                from = (theta, found);
            }
            *sign = from.1;
        }
        zeros.retain(|zero| self.list[zero.event].counts(zero.rising));
        zeros.sort_by(|a, b| a.theta.total_cmp(&b.theta).then(a.event.cmp(&b.event)));
        zeros
    }

    pub(super) fn verdict(&self, zero: &Zero) -> Verdict {
        match self.list[zero.event].action {
            Action::Continue => Verdict::Continue,
            Action::Stop => Verdict::Stop,
            Action::Reset(_) => Verdict::Reset(zero.event),
        }
    }

    pub(super) fn occurrence(&self, zero: &Zero, time: f64, state: M::State<f64>) -> Occurrence<M::State<f64>> {
        Occurrence { name: self.list[zero.event].name, time, state, rising: zero.rising }
    }

    /// The state that takes the place of the one at a zero.
    pub(super) fn reset(&mut self, event: usize, t: f64, s: &M::State<f64>) -> M::State<f64> {
        match &mut self.list[event].action {
            Action::Reset(state) => state(t, s),
            Action::Continue | Action::Stop => *s,
        }
    }

    /// After a cut: the function of the event that cut is at its zero, the others start anew.
    pub(super) fn leave(&mut self, event: usize) {
        self.signs[event] = None;
    }
}

/// The sign of a figure; none for zero and for what is not a number.
fn sign_of(value: f64) -> Option<bool> {
    if value > 0.0 {
        Some(true)
    } else if value < 0.0 {
        Some(false)
    } else {
        None
    }
}

/// The first point found at which the sign is no longer `was`, next to one at which it is: by halving, which no function misleads.
fn locate(value: &mut impl FnMut(f64) -> f64, from: f64, to: f64, was: bool) -> f64 {
    let (mut a, mut b) = (from, to);
    loop {
        let middle = a + 0.5 * (b - a);
        if middle <= a || middle >= b || b - a <= FINEST {
            return b;
        }
        if sign_of(value(middle)) == Some(was) { a = middle } else { b = middle }
    }
}
