//! Simulation: integrating the minimal equations, watching the guards, staying on the constraints.

mod charts;
mod control;
mod course;
mod dop853;
mod emitted;
mod equations;
mod events;
mod flow;
mod general;
mod guards;
mod inputs;
mod kernel;
mod orientation;
mod stages;
mod tableau;
#[cfg(test)]
mod tests;
mod trajectory;

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use crate::assemble::check_finite;
use crate::manifold::{Manifold, term_sizes};
use crate::{ConstrainedSystem, Error, Prepared};
use control::Tolerance;
use course::Course;
use emitted::check_inputs;
use equations::Baumgarte;
use guards::Watch;
use kernel::{Pace, Plan};

pub use charts::{Chart, Charts, FLAT, STEEP};
pub use events::{Event, Occurrence};
pub use guards::SINGULAR;
pub use inputs::{InputSource, NoInputs, Sampled};
pub use trajectory::{Interrupted, Residuals, Statistics, Trajectory};

/// The residual that a start may have in f and φ, as a fraction of the terms of the constraint.
pub const START_TOLERANCE: f64 = 1e-9;

/// Outputs closer than this fraction of the run would not fit into memory.
const SPACING: f64 = 1e-12;

/// How the equations are integrated. All methods are explicit Runge-Kutta methods.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
/// let run = |method| pendulum.simulate(start).method(method).tolerance(1e-10, 1e-10).until(1.0);
/// let (fifth, eighth) = (run(Method::DormandPrince)?, run(Method::Dop853)?);
/// assert!(fifth.statistics().evaluations > eighth.statistics().evaluations);
/// # Ok::<(), Error>(())
/// ```
#[derive(Copy, Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// The classical method of order 4 with a fixed step; its dense output is the cubic through both ends of a step.
    Rk4 {
        /// The step; the last one is shorter where the steps do not fill the time.
        step: f64,
    },
    /// Dormand and Prince 5(4), adaptive, with its dense output of order 4.
    DormandPrince,
    /// Dormand and Prince 8(5,3), adaptive, with its dense output of order 7: the default.
    Dop853,
}

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
    model: &'a Prepared<M>,
    start: M::State<f64>,
    from: f64,
    method: Method,
    tolerance: Tolerance,
    longest: f64,
    every: Option<f64>,
    dense: bool,
    max_steps: usize,
    charts: Charts,
    baumgarte: Baumgarte,
    velocities: Option<M::Velocities<f64>>,
    events: Vec<Event<'a, M>>,
    source: I,
    progress: Option<Box<dyn FnMut(f64) + 'a>>,
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
    /// A run leaves a chart that is steeper than [`STEEP`] for the flattest of the model's charts that is flatter than [`FLAT`], and
    /// works in the general one, all velocities with the numerical null space of C (3.5), while there is none. Steps, accuracy
    /// and step size are the same in all; the general chart takes longer.
    #[must_use]
    pub fn charts(mut self, charts: Charts) -> Self {
        self.charts = charts;
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
    /// over: bound the steps by [`max_step`](Simulation::max_step).
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
    /// The start must satisfy the constraints to [`START_TOLERANCE`]. After every step the guards are judged (see [`SINGULAR`]),
    /// and where the state holds the coordinates of position constraints these are brought back onto f = 0.
    pub fn until(self, end: f64) -> Result<Trajectory<M>, Box<Interrupted<M>>> {
        let method = self.method;
        let velocities = match self.velocities {
            Some(v) => v,
            None => self.model.velocities(self.from, &self.start),
        };
        let start = match self.velocities {
            Some(v) => trajectory::view(self.model, self.from, &self.start, &v),
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

    /// Everything that can be said before the first step.
    fn check(mut self, end: f64) -> Result<(Plan, Course<'a, M, I>), Error> {
        let (model, start, from) = (self.model, self.start, self.from);
        check_finite::<M>(from, &start)?;
        if let Some(v) = &self.velocities
            && let Some(at) = (*v).into().as_ref().iter().position(|entry| !entry.is_finite())
        {
            return Err(Error::NonFinite { name: M::MODEL.velocities.get(at).copied().unwrap_or("velocity") });
        }
        if let Some((alpha, beta)) = self.baumgarte {
            for (name, gain) in [("first gain of `baumgarte`", alpha), ("second gain of `baumgarte`", beta)] {
                not_negative(name, gain)?;
            }
        }
        if !end.is_finite() {
            return Err(Error::NonFinite { name: "end" });
        }
        positive("longest step", self.longest)?;
        if let Some(every) = self.every {
            positive("spacing of the output", every)?;
            if every < SPACING * (end - from).abs() {
                return Err(Error::StepTooSmall { step: every, time: from });
            }
        }
        let pace = match self.method {
            Method::Rk4 { step } => {
                positive("step", step)?;
                Pace::Fixed { step: step.min((end - from).abs()) }
            }
            Method::DormandPrince | Method::Dop853 => {
                positive("relative tolerance", self.tolerance.relative)?;
                positive("absolute tolerance", self.tolerance.absolute)?;
                Pace::Adaptive { tolerance: self.tolerance, longest: self.longest }
            }
        };
        if let Some(period) = self.source.period() {
            positive("sampling period", period)?;
            if period < SPACING * (end - from).abs() {
                return Err(Error::StepTooSmall { step: period, time: from });
            }
        }
        if !I::GIVEN && !M::MODEL.inputs.is_empty() {
            return Err(Error::MissingInputs { inputs: M::MODEL.inputs });
        }
        check_inputs::<M>(&self.source.inputs(from, &start))?;
        // The guards stand between f and φ: where one vanishes, the velocities are not finite.
        let manifold = check_position(model, from, &start)?;
        let v = match self.velocities {
            Some(v) => {
                let watch = Watch::unjudged(model, 0, from, &start)?;
                watch.check_shared(from, guards::figures(model, 0, from, &start).into().as_ref())?;
                v
            }
            None => {
                Watch::new(model, 0, from, &start)?;
                model.velocities(from, &start)
            }
        };
        check_velocity(model, from, &start, &v)?;
        let plan = Plan { start: from, end, pace, every: self.every, dense: self.dense, max_steps: self.max_steps };
        let course = Course {
            model,
            source: self.source,
            // Stabilised constraints are not restored.
            manifold: manifold.filter(|_| self.baumgarte.is_none()),
            charts: self.charts,
            baumgarte: self.baumgarte,
            events: self.events,
            progress: self.progress,
        };
        Ok((plan, course))
    }
}

/// f and φ of a state that takes the place of another one.
fn check_on_manifold<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    v: &M::Velocities<f64>,
) -> Result<(), Error> {
    check_position(model, t, s)?;
    check_velocity(model, t, s, v)
}

/// f at the start; gives the manifold to stay on where the state holds the coordinates of position rows.
fn check_position<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
) -> Result<Option<Manifold<M>>, Error> {
    let mut manifold = Manifold::new(model, t, s)?;
    let f = model.position_residual_at(t, s).into();
    if let Some((row, residual)) = unmet(f.as_ref(), &manifold.sizes) {
        let constraint = M::MODEL.position_rows.get(row).copied().unwrap_or("position");
        return Err(Error::Unmet { constraint, residual });
    }
    // With independent coordinates, f is identically zero.
    Ok(if manifold.is_satisfied(t, s) { None } else { Some(manifold) })
}

/// φ at the start.
fn check_velocity<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    v: &M::Velocities<f64>,
) -> Result<(), Error> {
    let x = model.coordinates(t, s);
    let phi = model.velocity_residual(t, &x, v).into();
    let sizes = term_sizes(model, t, &x, v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
    match unmet(phi.as_ref(), &sizes) {
        Some((row, residual)) => Err(Error::Unmet {
            constraint: M::MODEL.velocity_rows().nth(row).map_or("velocity", |row| row.name),
            residual,
        }),
        None => Ok(()),
    }
}

/// The first row whose residual is too large for a start.
fn unmet(residuals: &[f64], sizes: &[f64]) -> Option<(usize, f64)> {
    let missed = |(residual, size): (&f64, &f64)| residual.is_nan() || residual.abs() > START_TOLERANCE * size;
    let row = residuals.iter().zip(sizes).position(missed)?;
    Some((row, residuals[row]))
}

fn positive(name: &'static str, value: f64) -> Result<(), Error> {
    // Also false where the value is not a number.
    if value > 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
}

fn not_negative(name: &'static str, value: f64) -> Result<(), Error> {
    // Also false where the value is not a number.
    if value >= 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
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
