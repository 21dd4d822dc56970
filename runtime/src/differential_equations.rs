//! Methods of the crate `differential-equations`, implicit ones above all, for models that are stiff.
//!
//! [`Prepared::simulate`] integrates explicitly, which takes very small steps where a spring is very stiff or a damper very
//! strong. [`Equations`] makes a model an `ODE` of that crate, whose Radau5 and other methods run it then. The Jacobian is
//! exact, by dual numbers through the emitted code.
//!
//! Radau5 wants its tolerances as lists, `rtol([1e-9; 3])` for a state of three entries: version 0.7 of that crate makes its tolerances
//! coarser for its own use, a single number once for every entry of the state: with eight of them 1e-11 becomes what 3e-4 should be.
//!
//! ```
//! # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
//! # use models::{Pendulum, PendulumState};
//! use differential_equations::methods::ImplicitRungeKutta;
//! use holonomy::differential_equations::Equations;
//! use holonomy::prelude::*;
//!
//! let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
//! let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
//! let method = ImplicitRungeKutta::radau5().rtol([1e-9; 3]).atol([1e-9; 3]);
//! let states = Equations::new(&pendulum)?.every(0.1).solve(method, start, (0.0, 1.0))?;
//! let (t, end) = states.last().expect("the end");
//! assert_eq!((states.len(), *t), (11, 1.0));
//! assert!((pendulum.energy(1.0, end) - pendulum.energy(0.0, &start)).abs() < 1e-6);
//! assert!((end.x.hypot(end.y) - 0.5).abs() < 1e-15);
//! # Ok::<(), Error>(())
//! ```

mod watched;

use alloc::string::ToString;
use alloc::vec::Vec;
use core::cell::RefCell;
use core::fmt;

use ::differential_equations::error::Error as Failure;
use ::differential_equations::interpolate::Interpolation;
use ::differential_equations::linalg::Matrix;
use ::differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use ::differential_equations::traits::State as Entered;

use crate::manifold::lift;
use crate::simulate::{InputSource, NoInputs};
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Prepared, Vector};
use watched::Watched;

/// The step for differences of the inputs over the state, √ε.
const DIFFERENCE: f64 = 1.5e-8;

/// The array of a state's entries, which that crate integrates: its Radau5 takes no vectors.
pub type Entries<M> = <<M as ConstrainedSystem>::State<f64> as Vector<f64>>::Array;

/// Times and states in their order.
pub type States<M> = Vec<(f64, <M as ConstrainedSystem>::State<f64>)>;

/// A model as an `ODE` over the state's entries, and the way to run it.
pub struct Equations<'a, M: ConstrainedSystem, I = NoInputs> {
    model: &'a Prepared<M>,
    dual: Prepared<M, Dual>,
    // The trait evaluates through a shared reference.
    source: RefCell<I>,
    every: Option<f64>,
    drift: f64,
}

impl<'a, M: ConstrainedSystem> Equations<'a, M> {
    /// The equations of a model.
    pub fn new(model: &'a Prepared<M>) -> Result<Self, Error> {
        Ok(Equations { model, dual: lift(model)?, source: RefCell::new(NoInputs), every: None, drift: 1e-6 })
    }
}

impl<'a, M: ConstrainedSystem, I: InputSource<M>> Equations<'a, M, I>
where
    Entries<M>: Entered<f64>,
{
    /// Gives the inputs as a function of the time and the state. The Jacobian takes their share by differences.
    #[must_use]
    pub fn inputs<F>(self, source: F) -> Equations<'a, M, F>
    where
        F: FnMut(f64, &M::State<f64>) -> M::Inputs<f64>,
    {
        let Equations { model, dual, every, drift, .. } = self;
        Equations { model, dual, source: RefCell::new(source), every, drift }
    }

    /// Keeps the states at this spacing, by the dense output of the method, and the end; otherwise the state after every step.
    #[must_use]
    pub fn every(mut self, spacing: f64) -> Self {
        self.every = Some(spacing);
        self
    }

    /// How far the coordinates may leave f = 0, relative to their size, before the method starts again from the nearest point on
    /// it; 1e-6 otherwise.
    ///
    /// The states that [`solve`](Equations::solve) returns lie on f = 0 to rounding in any case. Inside of the method a small
    /// drift is left alone, because an implicit method loses its step size and its matrices where it starts again, and
    /// near the end of the run, where its first step could reach too far.
    #[must_use]
    pub fn drift(mut self, most: f64) -> Self {
        self.drift = most;
        self
    }

    /// Runs a method of `differential-equations` from a start over (from, to), which may also lie before; gives times and states.
    ///
    /// The start, and the state after every step, must be one at which a simulation may start: finite, regular, and on the
    /// constraints. A pivot that changes its sign ends the run, as it does in [`Prepared::simulate`].
    pub fn solve<S>(&self, mut method: S, start: M::State<f64>, (from, to): (f64, f64)) -> Result<States<M>, Error>
    where
        S: OrdinaryNumericalMethod<f64, Entries<M>> + Interpolation<f64, Entries<M>>,
    {
        if !to.is_finite() {
            return Err(Error::NonFinite { name: "end" });
        }
        for (name, value) in [("spacing of the output", self.every.unwrap_or(1.0)), ("drift", self.drift)] {
            if value <= 0.0 || value.is_nan() {
                return Err(Error::NotPositive { name, value });
            }
        }
        let mut watched = Watched::new(self, start, (from, to))?;
        if from == to {
            return Ok(watched.states);
        }
        let y: Entries<M> = start.into();
        let result = solve_ode(&mut method, self, from, to, &y, &mut watched);
        if let Some(error) = watched.error.take() {
            return Err(error);
        }
        result.map_err(|failure| told::<M>(&failure, watched.reached))?;
        watched.finish(to)
    }

    /// Whether a run may start here; `simulate` knows all that must hold.
    fn check(&self, t: f64, s: &M::State<f64>) -> Result<(), Error> {
        let inputs = |t: f64, s: &M::State<f64>| self.source.borrow_mut().inputs(t, s);
        let still = self.model.simulate(*s).starting_at(t);
        if I::GIVEN {
            still.inputs(inputs).until(t)?
        } else {
            still.until(t)?
        };
        Ok(())
    }
}

impl<M: ConstrainedSystem, I: InputSource<M>> ODE<f64, Entries<M>> for Equations<'_, M, I>
where
    Entries<M>: Entered<f64>,
{
    fn diff(&self, t: f64, y: &Entries<M>, rate: &mut Entries<M>) {
        let s = (*y).into();
        let inputs = self.source.borrow_mut().inputs(t, &s);
        *rate = self.model.derivative(t, &s, &inputs).0.into();
    }

    fn jacobian(&self, t: f64, y: &Entries<M>, jacobian: &mut Matrix<f64>) {
        let s: M::State<f64> = (*y).into();
        let y: &[f64] = y.as_ref();
        let inputs = self.source.borrow_mut().inputs(t, &s);
        for column in 0..y.len() {
            let mut slopes: M::Inputs<f64> = M::Inputs::from_fn(|_| 0.0);
            if I::GIVEN {
                let step = DIFFERENCE * y[column].abs().max(1.0);
                let aside = M::State::from_fn(|i| if i == column { y[i] + step } else { y[i] });
                let there: <M::Inputs<f64> as Vector<f64>>::Array = self.source.borrow_mut().inputs(t, &aside).into();
                let here: <M::Inputs<f64> as Vector<f64>>::Array = inputs.into();
                slopes = M::Inputs::from_fn(|i| (there.as_ref()[i] - here.as_ref()[i]) / step);
            }
            let slopes: <M::Inputs<f64> as Vector<f64>>::Array = slopes.into();
            let moving = convert(&s, |i, value| Dual::new(value, if i == column { 1.0 } else { 0.0 }));
            let driven = convert(&inputs, |i, value| Dual::new(value, slopes.as_ref()[i]));
            let rate: <M::State<Dual> as Vector<Dual>>::Array =
                self.dual.derivative(Dual::constant(t), &moving, &driven).0.into();
            for (row, entry) in rate.as_ref().iter().enumerate() {
                jacobian[(row, column)] = entry.derivative;
            }
        }
    }
}

/// Their failure in our words where we have words for it.
fn told<M: ConstrainedSystem>(failure: &Failure<f64, Entries<M>>, time: f64) -> Error
where
    Entries<M>: Entered<f64>,
{
    let reason = match failure {
        Failure::MaxSteps { .. } => "it took as many steps as it may".to_string(),
        Failure::StepSize { .. } => "its steps became too small".to_string(),
        Failure::Stiffness { .. } => "the system is stiff for it; implicit methods are made for that".to_string(),
        Failure::LinearAlgebra { msg, .. } | Failure::BadInput { msg } => msg.clone(),
        // The failures of the other kinds of equations.
        _ => "it could not go on".to_string(),
    };
    Error::Solver { reason, time }
}

impl<M: ConstrainedSystem, I> fmt::Debug for Equations<'_, M, I> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Equations").field("model", self.model).field("every", &self.every).finish_non_exhaustive()
    }
}
