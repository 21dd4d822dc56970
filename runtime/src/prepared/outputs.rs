//! Outputs: what a model tells of a state besides its motion.

use super::Prepared;
use crate::{ConstrainedSystem, Scalar};

impl<M: ConstrainedSystem, T: Scalar> Prepared<M, T> {
    /// The outputs at a state, by name; what they are: [`Description::outputs`](crate::Description::outputs).
    ///
    /// As with [`multipliers`](Self::multipliers) nothing is judged: where a divisor of an output vanishes that output is not
    /// finite. A [`Trajectory`](crate::Trajectory::outputs_at) gives an error there.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::{ConstrainedSystem, State};
    ///
    /// /// A ladder's foot that is drawn along the floor: which friction would hold it there?
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, y)]
    /// #[inertia(diag(m, m))]
    /// #[forces(pull, -m*g)]
    /// #[inputs(pull)]
    /// #[constraint(floor: y == 0)]
    /// #[constraint(grip: dot(x) == 0)]
    /// #[output(
    ///     /// The least coefficient of friction.
    ///     friction = abs(reaction(grip))/reaction(floor),
    ///     distance = x,
    /// )]
    /// struct Foot {
    ///     m: f64,
    ///     g: f64,
    /// }
    ///
    /// let foot = Foot { m: 2.0, g: 10.0 }.prepare()?;
    /// let rest = State::<Foot> { x: 1.5, y: 0.0 };
    /// let outputs = foot.outputs(0.0, &rest, &[5.0].into());
    /// assert_eq!((outputs.friction, outputs.distance), (0.25, 1.5));
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    #[inline]
    pub fn outputs(&self, t: T, s: &M::State<T>, i: &M::Inputs<T>) -> M::Outputs<T> {
        M::outputs(self.values(), t, s, i)
    }

    /// The outputs for the carriers w, their rates and the multipliers; of `s` the coordinates are read.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::{ConstrainedSystem, State};
    ///
    /// /// A mass on the floor, and the power that it gains.
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, y)]
    /// #[inertia(diag(m, m))]
    /// #[forces(0, -m*g)]
    /// #[constraint(floor: y == 0)]
    /// #[output(load = reaction(floor), power = m*dot(x)*ddot(x))]
    /// struct Mass {
    ///     m: f64,
    ///     g: f64,
    /// }
    ///
    /// let mass = Mass { m: 2.0, g: 10.0 }.prepare()?;
    /// let (velocities, rates, reactions) = ([3.0, 0.0], [0.5, 0.0], [20.0].into());
    /// let outputs = mass.carried_outputs(0.0, &State::<Mass>::default(), (&velocities, &rates), &reactions, &[]);
    /// assert_eq!((outputs.load, outputs.power), (20.0, 3.0));
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    #[inline]
    pub fn carried_outputs(
        &self,
        t: T,
        s: &M::State<T>,
        (w, rates): (&M::Carriers<T>, &M::Carriers<T>),
        multipliers: &M::Multipliers<T>,
        i: &M::Inputs<T>,
    ) -> M::Outputs<T> {
        M::carried_outputs(self.values(), t, s, w, rates, multipliers, i)
    }
}
