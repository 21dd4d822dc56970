//! What a trajectory tells beyond states and velocities: reactions, outputs, residuals.

use super::equations::Equations;
use super::trajectory::Trajectory;
use crate::manifold::{ratio, term_sizes};
use crate::{ConstrainedSystem, Error, Level, Prepared};

/// How well the constraints are satisfied: the largest |f| and |φ| (or |ḟ|), each relative to the size of its terms.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Of the position constraints.
    pub position: f64,
    /// Of the velocity constraints, derivatives of position constraints included.
    pub velocity: f64,
}

impl Residuals {
    /// At coordinates of a state and velocities.
    pub(super) fn at<M: ConstrainedSystem>(
        model: &Prepared<M>,
        t: f64,
        s: &M::State<f64>,
        v: &M::Velocities<f64>,
    ) -> Result<Self, Error> {
        let x = model.coordinates(t, s);
        let f = model.position_residual(t, &x).into();
        let sizes = term_sizes(model, t, &x, v, &|model, t, x, _| model.position_residual(t, x))?;
        let largest = |residuals: &[f64], sizes: &[f64]| {
            residuals.iter().zip(sizes).map(|(residual, size)| ratio(*residual, *size)).fold(0.0, f64::max)
        };
        let position = largest(f.as_ref(), &sizes);
        let phi = model.velocity_residual(t, &x, v).into();
        let sizes = term_sizes(model, t, &x, v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
        Ok(Residuals { position, velocity: largest(phi.as_ref(), &sizes) })
    }
}

impl<M: ConstrainedSystem> Trajectory<M> {
    /// λ at any time of the run, by the general form (3.5), (3.6), so that no chart matters; [`Error::Dependent`] in the moment in
    /// which a run [crosses](super::Crossing) a loss of rank, where rounding would be all that tells it.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let run = pendulum.simulate(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }).until(1.0)?;
    /// let here = pendulum.multipliers(0.7, &run.at(0.7)?, &[]).rod;
    /// assert!((run.multipliers_at(0.7, &[])?.rod - here).abs() < 1e-9);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn multipliers_at(&self, t: f64, inputs: &M::Inputs<f64>) -> Result<M::Multipliers<f64>, Error> {
        let (s, v) = self.standing(t)?;
        let mut equations = Equations::new(&self.model)?;
        let multipliers = equations.multipliers(&self.model, t, &s, &v, inputs)?;
        self.unless_meeting(t, &mut equations).map(|()| multipliers)
    }

    /// The error of reactions at a time at which the run crosses a loss of rank.
    fn unless_meeting(&self, t: f64, equations: &mut Equations<M>) -> Result<(), Error> {
        let Some(strength) = self.meeting(t) else { return Ok(()) };
        equations.strength = strength.clone();
        equations.weakest(t, f64::INFINITY).map_or(Ok(()), Err)
    }

    /// The outputs of a state and velocities.
    fn outputs_of(
        &self,
        (t, s, v): (f64, &M::State<f64>, &M::Velocities<f64>),
        inputs: &M::Inputs<f64>,
    ) -> Result<M::Outputs<f64>, Error> {
        let mut equations = Equations::new(&self.model)?;
        let outputs = equations.outputs(&self.model, t, s, v, inputs)?;
        match M::MODEL.outputs.iter().any(|output| output.level == Level::Acceleration) {
            true => self.unless_meeting(t, &mut equations).map(|()| outputs),
            false => Ok(outputs),
        }
    }

    /// The outputs at one of the [`times`](Trajectory::times), by the general form where they need accelerations or reactions, so
    /// that no chart matters; [`Error::Undefined`] where one of them has no finite value.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::{ConstrainedSystem, State};
    ///
    /// /// A pendulum with the tension of its rod.
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, y)]
    /// #[inertia(diag(m, m))]
    /// #[forces(0, -m*g)]
    /// #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    /// #[independent(dot(x))]
    /// #[output(tension = -l*reaction(rod))]
    /// struct Pendulum {
    ///     m: f64,
    ///     l: f64,
    ///     g: f64,
    /// }
    ///
    /// // Over the top, where the rod is level and ẋ says nothing about ẏ: T = m v²/l − m g y/l.
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let run = pendulum.simulate(State::<Pendulum> { x: 0.0, y: -0.5, dot_x: 5.5 }).until(2.0)?;
    /// for (index, (s, v)) in run.states().iter().zip(run.velocities()).enumerate() {
    ///     let expected = 2.0*(v.dot_x.powi(2) + v.dot_y.powi(2) - 9.81*s.y)/0.5;
    ///     assert!((run.outputs(index, &[])?.tension - expected).abs() < 1e-9);
    /// }
    /// let lowest = run.outputs_at(0.0, &[])?.tension;
    /// assert!((lowest - 140.62).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    ///
    /// # Panics
    ///
    /// If there are not so many times.
    pub fn outputs(&self, index: usize, inputs: &M::Inputs<f64>) -> Result<M::Outputs<f64>, Error> {
        self.outputs_of(self.stored(index), inputs)
    }

    /// The outputs at any time of the run; see [`outputs`](Trajectory::outputs) and [`at`](Trajectory::at).
    pub fn outputs_at(&self, t: f64, inputs: &M::Inputs<f64>) -> Result<M::Outputs<f64>, Error> {
        let (s, v) = self.standing(t)?;
        self.outputs_of((t, &s, &v), inputs)
    }

    /// How well the state at one of the [`times`](Trajectory::times) satisfies the constraints.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let run = pendulum.simulate(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }).until(1.0)?;
    /// assert!(run.residuals(3).position < 1e-14 && run.residuals(3).velocity < 1e-14);
    /// assert!(run.largest_residuals().position < 1e-14);     // at the end of any step
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If there are not so many times.
    pub fn residuals(&self, index: usize) -> Residuals {
        let (t, s, v) = self.stored(index);
        Residuals::at(&self.model, t, s, v).unwrap_or(Residuals { position: f64::NAN, velocity: f64::NAN })
    }
}
