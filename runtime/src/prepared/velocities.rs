//! Velocities that meet constraints which are not linear in them.

use crate::{ConstrainedSystem, Error, Prepared};

impl<M: ConstrainedSystem> Prepared<M> {
    /// Moves the speeds of a guess until the velocities meet all constraints, φ(v, x, t) = 0.
    ///
    /// The coordinates and the `held` speeds keep their values. Constraints that are linear in the velocities hold for all speeds of
    /// the state; those that are not have several branches, and which one is found depends on the guess: Newton's method
    /// goes to a near one, by steps of least norm. Where none is found, the
    /// error names the row and what remains. It is [`assemble`](Prepared::assemble) with all coordinates held.
    ///
    /// ```
    /// use holonomy::prelude::*;
    /// use holonomy::State;
    ///
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, y)]
    /// #[inertia(diag(m, m))]
    /// #[forces(0, -m*g)]
    /// #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == powi(c, 2))]
    /// struct Runner {
    ///     m: f64,
    ///     g: f64,
    ///     c: f64,
    /// }
    ///
    /// # fn main() -> Result<(), Error> {
    /// // A particle whose speed is 2.5: the velocity (1.5, -2) has it.
    /// let runner = Runner { m: 1.0, g: 9.81, c: 2.5 }.prepare()?;
    /// let guess = State::<Runner> { dot_x: 1.5, dot_y: -1.0, ..Default::default() };
    /// let start = runner.solve_velocities(0.0, &guess, &["dot_x"])?;
    /// assert!((start.dot_y + 2.0).abs() < 1e-14);
    ///
    /// // One component is too fast already.
    /// let guess = State::<Runner> { dot_x: 3.0, dot_y: -1.0, ..Default::default() };
    /// let error = runner.solve_velocities(0.0, &guess, &["dot_x"]).unwrap_err();
    /// assert!(matches!(error, Error::Assembly { constraint: "speed", .. }));
    /// # Ok(())
    /// # }
    /// ```
    pub fn solve_velocities(&self, t: f64, guess: &M::State<f64>, held: &[&str]) -> Result<M::State<f64>, Error> {
        let speeds = M::MODEL.state_speeds;
        if let Some(name) = held.iter().find(|name| !speeds.contains(name)) {
            return Err(Error::UnknownName { name: (*name).into(), known: speeds.to_vec() });
        }
        let kept = M::MODEL.state_coordinates.iter().chain(held);
        kept.fold(self.assemble(*guess).at_time(t), |assembly, name| assembly.hold(name)).solve()
    }
}
