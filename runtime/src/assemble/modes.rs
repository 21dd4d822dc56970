//! All ways in which a mechanism can be assembled.

mod search;
mod space;

use alloc::vec::Vec;
use core::fmt;

use super::problem::Problem;
use super::{Assembly, AssemblyReport};
use crate::{ConstrainedSystem, Error, Vector};

/// The assembly modes of a mechanism that were found; from [`Assembly::modes`].
#[derive(Clone)]
pub struct AssemblyModes<M: ConstrainedSystem> {
    /// The modes, the nearest to the guess first.
    pub modes: Vec<AssemblyMode<M>>,
    /// How many starts did not close: Newton's method ended with a residual that it could not make smaller.
    pub unclosed: usize,
    /// The [`Error::Assembly`] of the start that came nearest of these, with its residual and its report.
    pub nearest_miss: Option<Error>,
    /// How many starts closed where the mechanism is not held: such configurations belong to whole curves of them, and are not
    /// among the modes.
    pub movable: usize,
}

/// One way in which a mechanism can be assembled.
#[derive(Clone)]
pub struct AssemblyMode<M: ConstrainedSystem> {
    /// The state. Angles are within half a turn of the guess, unless another equation counts their turns; of the two signs of a
    /// quaternion it has the one nearer to the guess.
    pub state: M::State<f64>,
    /// The parameters: those of the model, but for the ones solved for.
    pub parameters: M::Parameters<f64>,
    /// What was met, and how well.
    pub report: AssemblyReport,
    /// How far it is from the guess: the root of the sum of squares of the changes, of angles in rad, of other coordinates
    /// relative to their reach, of parameters relative to their values.
    pub distance: f64,
    /// How many starts led here, the guess among them.
    pub starts: usize,
    /// Why the velocities asked for cannot be had in this mode, where they cannot; the state has the speeds of the guess then.
    pub unmet: Option<Error>,
}

impl<M: ConstrainedSystem> Assembly<'_, M> {
    /// All modes in which the mechanism closes with what was asked for, as far as they can be reached from the guess and from so
    /// many further starts: both sides of a four-bar linkage whose crank is held, say.
    ///
    /// As many coordinates as there are degrees of freedom must be held, or other quantities asked for: configurations that
    /// can still move are no modes. What was asked of velocities is met in each mode afterwards.
    ///
    /// Nothing proves that there are no further modes. That every mode was reached by several starts is a good sign; a few dozen
    /// starts find those of a single loop, a few hundred those of platforms and of chains of loops.
    ///
    /// # How they are found
    ///
    /// A coordinate in which some equation is the same after a turn, as evaluations at several points show, is an angle. Angles
    /// start anywhere within half a turn of the guess, other coordinates within their reach on both sides of it and of zero: the
    /// change of the coordinate that changes a constraint by as much as its terms are large, lengths of the mechanism among
    /// them. The starts are the points of Richtmyer's sequence, the multiples of the roots of the primes modulo one: they fill
    /// the space evenly and are the same in every run. Parameters that are solved for start from their values.
    ///
    /// From each start Newton's method goes as in [`solve`](Self::solve), and once more with full steps where it ends without a
    /// solution. Solutions count as the same if no angle differs by more than 1e-5 rad, turns apart, no other coordinate by
    /// more than 1e-5 of its reach, and no parameter by more than 1e-5 of its value; the two signs of a quaternion are one
    /// attitude.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let guess = PendulumState { x: 0.3, y: -0.5, dot_x: 0.0 };
    /// let found = pendulum.assemble(guess).hold("x").modes(20)?;
    /// let heights: Vec<f64> = found.modes.iter().map(|mode| mode.state.y).collect();
    /// assert!(heights.len() == 2 && (heights[0] + 0.4).abs() < 1e-15 && (heights[1] - 0.4).abs() < 1e-15);
    /// assert_eq!(found.modes[0].starts + found.modes[1].starts + found.unclosed, 21);
    ///
    /// // Nothing is held: the pendulum can still move.
    /// let error = pendulum.assemble(guess).modes(20).unwrap_err();
    /// assert_eq!(error, Error::Movable { freedom: 1, among: vec!["x", "y"] });
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Assembly`] of the start that came nearest, where none closed; [`Error::Movable`] where all that closed can still
    /// move; and those of [`solve`](Self::solve) for names and figures.
    pub fn modes(self, starts: usize) -> Result<AssemblyModes<M>, Error> {
        let mut problem = self.problem()?;
        let found = search::search(&problem.positions()?, starts)?;
        let modes = found.modes.into_iter().map(|found| finish(&mut problem, found)).collect();
        Ok(AssemblyModes { modes, unclosed: found.unclosed, nearest_miss: found.nearest_miss, movable: found.movable })
    }
}

/// Meets what was asked of velocities.
fn finish<M: ConstrainedSystem>(problem: &mut Problem<'_, M>, found: search::Mode) -> AssemblyMode<M> {
    let search::Mode { state, parameters, mut report, distance, starts, .. } = found;
    problem.move_to(state, parameters);
    let unmet = match problem.solve_velocities() {
        Ok(velocities) => {
            report.append(velocities);
            None
        }
        Err(error) => Some(error),
    };
    AssemblyMode { state: problem.state(), parameters: problem.parameters(), report, distance, starts, unmet }
}

// Derived ones would ask for that of the model.
impl<M: ConstrainedSystem> fmt::Debug for AssemblyModes<M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("AssemblyModes")
            .field("modes", &self.modes)
            .field("unclosed", &self.unclosed)
            .field("nearest_miss", &self.nearest_miss)
            .field("movable", &self.movable)
            .finish()
    }
}

impl<M: ConstrainedSystem> fmt::Debug for AssemblyMode<M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("AssemblyMode")
            .field("state", &self.state)
            .field("parameters", &self.parameters)
            .field("report", &self.report)
            .field("distance", &self.distance)
            .field("starts", &self.starts)
            .field("unmet", &self.unmet)
            .finish()
    }
}

/// The name of an entry of the state.
fn entry_name<M: ConstrainedSystem>(at: usize) -> &'static str {
    <M::State<f64> as Vector<f64>>::NAMES.get(at).copied().unwrap_or("state")
}
