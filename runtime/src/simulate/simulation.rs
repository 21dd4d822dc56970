//! A run in the making: what the user chooses, and the checks of it.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use super::Method;
use super::charts::Charts;
use super::control::Tolerance;
use super::crossing::Crossing;
use super::equations::Baumgarte;
use super::events::Event;
use super::inputs::{InputSource, NoInputs, Sampled};
use super::trajectory::{Interrupted, Trajectory, view};
use super::{dop853, tableau};
use crate::{ConstrainedSystem, Prepared};

/// A run in the making; from [`Prepared::simulate`].
///
/// By default it starts at t = 0, uses [`Method::Dop853`] with a relative and absolute tolerance of 1e-9, and keeps every step.
///
/// ```
/// # mod models {
/// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs"));
/// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/oscillator.rs"));
/// # }
/// # use models::{Oscillator, OscillatorInputs, OscillatorState};
/// use holonomy::prelude::*;
///
/// // A controlled mass: the input is a function of the time and the state.
/// let mass = Oscillator { m: 2.0, a: 0.0, k: 0.0, c: 0.0, b: 0.0 }.prepare()?;
/// let run = mass
///     .simulate(OscillatorState { x: 1.0, dot_x: 0.0 })
///     .inputs(|_, s| OscillatorInputs { tau: -8.0 * s.x - 8.0 * s.dot_x })
///     .tolerance(1e-10, 1e-12)
///     .every(0.5)
///     .progress(|fraction| println!("{:3.0} %", 100.0 * fraction))
///     .until(2.0)?;
/// let exact = |t: f64| (1.0 + 2.0 * t) * (-2.0 * t).exp();
/// assert!(run.iter().all(|(t, s)| (s.x - exact(t)).abs() < 1e-8));
/// # Ok::<(), Error>(())
/// ```
pub struct Simulation<'a, M: ConstrainedSystem, I = NoInputs> {
    pub(super) model: &'a Prepared<M>,
    pub(super) start: M::State<f64>,
    pub(super) from: f64,
    pub(super) method: Method,
    pub(super) tolerance: Tolerance,
    pub(super) longest: f64,
    pub(super) every: Option<f64>,
    pub(super) dense: bool,
    pub(super) max_steps: usize,
    pub(super) charts: Charts,
    pub(super) crossing: Crossing,
    pub(super) baumgarte: Baumgarte,
    pub(super) velocities: Option<M::Velocities<f64>>,
    pub(super) events: Vec<Event<'a, M>>,
    pub(super) source: I,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// Integrates the equations of motion from a start; see [`Simulation`].
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    /// use holonomy::simulate::Method;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    /// let fixed = pendulum.simulate(start).method(Method::Rk4 { step: 1e-3 }).until(1.0)?;
    /// let adaptive = pendulum.simulate(start).tolerance(1e-12, 1e-12).until(1.0)?;
    /// assert!((fixed.last().1.x - adaptive.last().1.x).abs() < 1e-9);
    ///
    /// // A start off the constraint is refused.
    /// let off = pendulum.simulate(PendulumState { x: 0.3, y: -0.5, dot_x: 0.0 }).until(1.0).unwrap_err();
    /// assert!(matches!(off.error, Error::Unmet { constraint: "rod", .. }));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn simulate(&self, start: M::State<f64>) -> Simulation<'_, M> {
        Simulation {
            model: self,
            start,
            from: 0.0,
            method: Method::Dop853,
            tolerance: Tolerance { relative: 1e-9, absolute: 1e-9 },
            longest: f64::INFINITY,
            every: None,
            dense: true,
            max_steps: 10_000_000,
            charts: Charts::Change,
            crossing: Crossing::Pass,
            baumgarte: None,
            velocities: None,
            events: Vec::new(),
            source: NoInputs,
            progress: None,
        }
    }
}

impl<'a, M: ConstrainedSystem, I: InputSource<M>> Simulation<'a, M, I> {
    /// The time of the start; zero otherwise.
    #[must_use]
    pub fn starting_at(mut self, t: f64) -> Self {
        self.from = t;
        self
    }

    /// The method.
    #[must_use]
    pub fn method(mut self, method: Method) -> Self {
        self.method = method;
        self
    }

    /// What an adaptive method may err in a step: `absolute + relative · |y|`, in the root mean square over the state.
    #[must_use]
    pub fn tolerance(mut self, relative: f64, absolute: f64) -> Self {
        self.tolerance = Tolerance { relative, absolute };
        self
    }

    /// The longest step of an adaptive method: for inputs that are zero for a while, say.
    #[must_use]
    pub fn max_step(mut self, step: f64) -> Self {
        self.longest = step;
        self
    }

    /// The most steps, rejected ones included; ten millions otherwise.
    #[must_use]
    pub fn max_steps(mut self, steps: usize) -> Self {
        self.max_steps = steps;
        self
    }

    /// Which charts the run may use: it changes them otherwise, so that no choice of independent speeds ends it.
    ///
    /// A run leaves a chart that is steeper than [`STEEP`](super::STEEP) for the flattest of the model's charts that is flatter than
    /// [`FLAT`](super::FLAT), and works in the general one, all velocities with the numerical null space of C (3.5), while there is
    /// none. Steps, accuracy and step size are the same in all; the general chart takes longer.
    #[must_use]
    pub fn charts(mut self, charts: Charts) -> Self {
        self.charts = charts;
        self
    }

    /// What the run does where constraints lose their rank, and branches of the mechanism meet: it goes through otherwise, on the
    /// branch on which it arrives.
    ///
    /// A motion that arrives with a velocity passes smoothly; the equations alone divide by zero there. Where little is left of the
    /// rank, the run looks for one step through it, by collocation at points on both sides, each of them brought onto the
    /// constraints; it takes the step if it is smooth to the tolerance, looks again nearer by if not, and ends with
    /// [`Error::Impassable`](crate::Error::Impassable) where nothing is found: at a dead end, or where the velocity would jump. Where
    /// no power acts the step keeps the energy. [`Statistics::crossings`](super::Statistics::crossings) counts the passages.
    ///
    /// Near the crossing itself, where less than a hundredth is left of the rank, outputs and events stand on the polynomial of that
    /// step, and are not brought onto the constraints once more. A start right on a crossing is refused.
    ///
    /// Runs that stay in their chart ([`Charts::Stay`]), or are stabilised by [`baumgarte`](Simulation::baumgarte), and models with
    /// rows that are not linear in the velocities do not pass. Inputs are asked for at points of the whole step, also where the
    /// run ends, or takes a sample, within it.
    #[must_use]
    pub fn crossing(mut self, crossing: Crossing) -> Self {
        self.crossing = crossing;
        self
    }

    /// All velocities of the start, for a start at which the speeds of the state do not determine the others; the speeds of the
    /// state then do not count.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState, PendulumVelocities};
    /// use holonomy::prelude::*;
    ///
    /// // The rod is level, and the mass falls: ẋ is zero whatever ẏ is.
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let level = PendulumState { x: 0.5, y: 0.0, dot_x: 0.0 };
    /// assert!(pendulum.simulate(level).until(0.1).is_err());
    /// let falling = PendulumVelocities { dot_x: 0.0, dot_y: -1.0 };
    /// let run = pendulum.simulate(level).velocities(falling).until(0.1)?;
    /// assert!(run.last().1.y < -0.1);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn velocities(mut self, v: M::Velocities<f64>) -> Self {
        self.velocities = Some(v);
        self
    }

    /// Stabilises the constraints instead of restoring them: C v̇ + c0* + 2α φ + β² f = 0, in the general chart throughout.
    ///
    /// For comparison with other programs, and the worse choice: residuals stay as large as the errors of the steps make them, the
    /// motion depends on α and β, and large ones make it stiff. Errors decay critically damped with α = β.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    /// let stabilised = pendulum.simulate(start).tolerance(1e-6, 1e-6).baumgarte(10.0, 10.0).until(5.0)?;
    /// let restored = pendulum.simulate(start).tolerance(1e-6, 1e-6).until(5.0)?;
    /// let last = |run: &holonomy::Trajectory<Pendulum>| run.residuals(run.times().len() - 1).position;
    /// assert!(last(&restored) < 1e-14 && last(&stabilised) > 1e-14 && last(&stabilised) < 1e-6);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn baumgarte(mut self, alpha: f64, beta: f64) -> Self {
        self.baumgarte = Some((alpha, beta));
        self.charts = Charts::General;
        self
    }

    /// Keeps the states at this spacing, by dense output, and the end; otherwise the state after every step.
    #[must_use]
    pub fn every(mut self, spacing: f64) -> Self {
        self.every = Some(spacing);
        self
    }

    /// Whether the polynomials between the steps are kept for [`Trajectory::at`]; they are otherwise.
    #[must_use]
    pub fn dense(mut self, keep: bool) -> Self {
        self.dense = keep;
        self
    }

    /// Watches for an event; may be called for several. See [`Event`].
    #[must_use]
    pub fn event(mut self, event: Event<'a, M>) -> Self {
        self.events.push(event);
        self
    }

    /// Ends the run where a function of the time and the state runs through zero.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    /// let run = pendulum.simulate(start).stop_at("bottom", |_, s| s.x).until(10.0)?;
    /// let (t, bottom) = run.last();
    /// assert!(t < 1.0 && bottom.x.abs() < 1e-12);
    /// assert_eq!(run.events()[0].name, "bottom");
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn stop_at(self, name: &'static str, function: impl FnMut(f64, &M::State<f64>) -> f64 + 'a) -> Self {
        self.event(Event::new(name, function).stop())
    }

    /// Gives the inputs as a function of the time and the state.
    ///
    /// The adaptive methods expect smooth inputs: where they jump at known times use [`sampled`](Simulation::sampled), where they
    /// jump by the state an [`Event`] that stops the run, and start again after it. Inputs that are zero for a while may be stepped
    /// over: bound the steps by [`max_step`](Simulation::max_step). [`Prepared::inputs_for`](crate::Prepared::inputs_for) gives those
    /// under which a motion goes as wanted.
    #[must_use]
    pub fn inputs<F>(self, source: F) -> Simulation<'a, M, F>
    where
        F: FnMut(f64, &M::State<f64>) -> M::Inputs<f64>,
    {
        self.with_source(source)
    }

    /// Gives the inputs by a digital controller: computed at the start and after every period, and held in between. The steps end at
    /// every sample.
    ///
    /// ```
    /// # mod models {
    /// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs"));
    /// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/oscillator.rs"));
    /// # }
    /// # use models::{Oscillator, OscillatorInputs, OscillatorState};
    /// use holonomy::prelude::*;
    ///
    /// // A free mass that is brought to rest in two periods of a quarter: deadbeat control.
    /// let (m, period) = (2.0, 0.25);
    /// let mass = Oscillator { m, a: 0.0, k: 0.0, c: 0.0, b: 0.0 }.prepare()?;
    /// let run = mass
    ///     .simulate(OscillatorState { x: 1.0, dot_x: 0.0 })
    ///     .sampled(period, move |_, s| OscillatorInputs {
    ///         tau: -m * (s.x / (period * period) + 1.5 * s.dot_x / period),
    ///     })
    ///     .until(1.0)?;
    /// let at_rest = run.at(0.75)?;
    /// assert!(at_rest.x.abs() < 1e-12 && at_rest.dot_x.abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn sampled<F>(self, period: f64, controller: F) -> Simulation<'a, M, Sampled<F, M::Inputs<f64>>>
    where
        F: FnMut(f64, &M::State<f64>) -> M::Inputs<f64>,
    {
        self.with_source(Sampled::new(period, controller))
    }

    fn with_source<J>(self, source: J) -> Simulation<'a, M, J> {
        Simulation {
            model: self.model,
            start: self.start,
            from: self.from,
            method: self.method,
            tolerance: self.tolerance,
            longest: self.longest,
            every: self.every,
            dense: self.dense,
            max_steps: self.max_steps,
            charts: self.charts,
            crossing: self.crossing,
            baumgarte: self.baumgarte,
            velocities: self.velocities,
            events: self.events,
            source,
            progress: self.progress,
        }
    }

    /// Is called with the fraction of the run that is done, about 200 times.
    #[must_use]
    pub fn progress(mut self, told: impl FnMut(f64) + 'a) -> Self {
        self.progress = Some(Box::new(told));
        self
    }

    /// Integrates to `end`, which may also lie before the start.
    ///
    /// The start must satisfy the constraints to [`START_TOLERANCE`](super::START_TOLERANCE). After every step the guards are judged
    /// (see [`SINGULAR`](super::SINGULAR)), and where the state holds the coordinates of position constraints these are brought back
    /// onto f = 0.
    pub fn until(self, end: f64) -> Result<Trajectory<M>, Box<Interrupted<M>>> {
        let method = self.method;
        let velocities = match self.velocities {
            Some(v) => v,
            None => self.model.velocities(self.from, &self.start),
        };
        let start = match self.velocities {
            Some(v) => view(self.model, self.from, &self.start, &v),
            None => self.start,
        };
        let mut trajectory = Trajectory::new(self.model, self.from, start, velocities);
        let result = self.check(end).and_then(|(plan, course)| match method {
            Method::Rk4 { .. } => course.run(&tableau::RK4, &plan, &mut trajectory),
            Method::DormandPrince => course.run(&tableau::DORMAND_PRINCE, &plan, &mut trajectory),
            Method::Dop853 => course.run(&dop853::DOP853, &plan, &mut trajectory),
        });
        match result {
            Ok(()) => Ok(trajectory),
            Err(error) => Err(Box::new(Interrupted { error, trajectory })),
        }
    }
}

impl<M: ConstrainedSystem, I> fmt::Debug for Simulation<'_, M, I> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Simulation")
            .field("model", &M::MODEL.name)
            .field("start", &self.start)
            .field("from", &self.from)
            .field("method", &self.method)
            .finish_non_exhaustive()
    }
}
