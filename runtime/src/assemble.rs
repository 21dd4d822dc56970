//! Assembly: closing the constraints from a guess, with whatever else is asked for.

mod conditions;
mod metric;
mod modes;
pub(crate) mod newton;
mod problem;
mod report;

use alloc::rc::Rc;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::{ConstrainedSystem, Dual, Error, Prepared, Vector};

use conditions::{Meeting, Wish, sort};
use problem::Problem;

pub(crate) use conditions::entries;
pub use modes::{AssemblyMode, AssemblyModes};
pub use report::{AssemblyReport, Met};

/// A configuration in the making; from [`Prepared::assemble`].
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let guess = PendulumState { x: 0.3, y: -1.0, dot_x: 0.0 };
/// let start = pendulum.assemble(guess).hold("x").solve()?;
/// assert_eq!(start.x, 0.3);
/// assert!((start.y + 0.4).abs() < 1e-15);
///
/// // Any coordinate and any velocity may be asked for: ẏ = 0.6 makes ẋ = 0.8.
/// let start = pendulum.assemble(guess).set("x", 0.3).set("dot_y", 0.6).solve()?;
/// assert!((start.dot_x - 0.8).abs() < 1e-15);
///
/// // So may any quantity, written over dual numbers: a speed for an energy.
/// let guess = PendulumState { dot_x: 1.0, ..guess };
/// let start = pendulum.assemble(guess).hold("x").meet("energy", 0.0, |model, t, s| model.energy(t, s)).solve()?;
/// assert!(pendulum.energy(0.0, &start).abs() < 1e-14);
///
/// // The rod is too short for x = 0.7. The error tells by how much, and what is in the way.
/// let error = pendulum.assemble(guess).set("x", 0.7).solve().unwrap_err();
/// let Error::Assembly { constraint: "rod", residual, report } = error else { panic!("{error}") };
/// assert!((residual - 0.12).abs() < 1e-9);
/// assert_eq!(report.conflicts, ["x"]);
///
/// // A longer one is found if it may change.
/// let found = pendulum.assemble(guess).set("x", 0.7).hold("y").solve_for("l").solve_all()?;
/// assert!((found.parameters.l - 0.7_f64.hypot(1.0)).abs() < 1e-14);
/// let longer = Prepared::with_parameters(Pendulum { m: 2.0, l: 0.5, g: 9.81 }, found.parameters)?;
/// assert!(longer.position_residual_at(0.0, &found.state)[0].abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct Assembly<'a, M: ConstrainedSystem> {
    model: &'a Prepared<M>,
    guess: M::State<f64>,
    time: f64,
    wishes: Vec<Wish>,
    meetings: Vec<Meeting<M>>,
    parameters: Vec<String>,
    mass_weighted: bool,
}

/// What an assembly found; from [`Assembly::solve_all`].
#[derive(Clone, Debug, PartialEq)]
pub struct Assembled<M: ConstrainedSystem> {
    /// The state.
    pub state: M::State<f64>,
    /// The parameters: those of the model, but for the ones solved for. Prepare the model with them
    /// ([`Prepared::with_parameters`]) where there are such; the state belongs to them.
    pub parameters: M::Parameters<f64>,
    /// What was met, and how well.
    pub report: AssemblyReport,
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// Closes the constraints by moving a guess as little as Newton's method needs; see [`Assembly`].
    ///
    /// First the coordinates are moved until all position constraints and what was asked of positions are met. Then the speeds
    /// of the state are, but only if something was asked of velocities or a constraint is nonlinear in them: with any other
    /// speeds all velocities satisfy the constraints by construction.
    pub fn assemble(&self, guess: M::State<f64>) -> Assembly<'_, M> {
        Assembly {
            model: self,
            guess,
            time: 0.0,
            wishes: Vec::new(),
            meetings: Vec::new(),
            parameters: Vec::new(),
            mass_weighted: false,
        }
    }
}

impl<M: ConstrainedSystem> Assembly<'_, M> {
    /// Keeps a coordinate, a velocity or an output at its value in the guess: an entry of the state, one of x or v that depends
    /// on it, or an output that depends on these alone. Where names coincide, this is the order in which they count.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::{ConstrainedSystem, State};
    ///
    /// /// Two points on a line; the middle between them is a define, which is given out.
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(a, b)]
    /// #[inertia(diag(m, m))]
    /// #[forces(0, 0)]
    /// #[constraint(distance: b - a == l)]
    /// #[define(middle = (a + b)/2)]
    /// #[output(middle, momentum = m*(dot(a) + dot(b)))]
    /// struct Points {
    ///     m: f64,
    ///     l: f64,
    /// }
    ///
    /// let points = Points { m: 2.0, l: 1.0 }.prepare()?;
    /// let guess = State::<Points> { a: 0.4, b: 0.6, ..Default::default() };
    /// let start = points.assemble(guess).hold("middle").set("momentum", 6.0).solve()?;
    /// assert!((start.a - 0.0).abs() < 1e-15 && (start.b - 1.0).abs() < 1e-15);
    /// assert!((points.outputs(0.0, &start, &[]).momentum - 6.0).abs() < 1e-14);
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    #[must_use]
    pub fn hold(self, name: &str) -> Self {
        self.wish(name, None)
    }

    /// Asks for a value of a coordinate, of a velocity or of an output; see [`hold`](Self::hold).
    #[must_use]
    pub fn set(self, name: &str, value: f64) -> Self {
        self.wish(name, Some(value))
    }

    /// Asks for a value of any quantity of time and state, which is given over dual numbers. `name` names it in the report.
    ///
    /// Where it depends on speeds they are solved for, otherwise the coordinates.
    #[must_use]
    pub fn meet<F>(mut self, name: &'static str, value: f64, quantity: F) -> Self
    where
        F: Fn(&Prepared<M, Dual>, Dual, &M::State<Dual>) -> Dual + 'static,
    {
        self.meetings.retain(|meeting| meeting.name != name);
        self.meetings.push(Meeting { name, value, quantity: Rc::new(quantity) });
        self
    }

    /// Lets a parameter change, in proportion to its value, as the coordinates may. Use [`solve_all`](Self::solve_all), which
    /// gives it back.
    #[must_use]
    pub fn solve_for(mut self, parameter: &str) -> Self {
        self.parameters.push(parameter.into());
        self
    }

    /// Measures the change of coordinates and of speeds by the kinetic energy of a motion along it, instead of by the sum of
    /// squares: heavy parts move less, and units do not matter.
    #[must_use]
    pub fn mass_weighted(mut self) -> Self {
        self.mass_weighted = true;
        self
    }

    /// The time at which the constraints are to be met, for constraints that move; zero otherwise.
    #[must_use]
    pub fn at_time(mut self, t: f64) -> Self {
        self.time = t;
        self
    }

    /// A state that meets all to rounding, or [`Error::Assembly`] with a report of what could not be met and by how much.
    pub fn solve(self) -> Result<M::State<f64>, Error> {
        Ok(self.solve_all()?.state)
    }

    /// The same with the parameters, and the report.
    pub fn solve_all(self) -> Result<Assembled<M>, Error> {
        let mut problem = self.problem()?;
        let mut report = problem.solve_positions()?;
        report.append(problem.solve_velocities()?);
        Ok(Assembled { state: problem.state(), parameters: problem.parameters(), report })
    }

    /// The last word on a name counts.
    fn wish(mut self, name: &str, value: Option<f64>) -> Self {
        self.wishes.retain(|wish| wish.name != name);
        self.wishes.push(Wish { name: name.into(), value });
        self
    }
}

impl<'a, M: ConstrainedSystem> Assembly<'a, M> {
    /// What was asked for, as equations.
    fn problem(self) -> Result<Problem<'a, M>, Error> {
        check_finite::<M>(self.time, &self.guess)?;
        for (name, value) in self.meetings.iter().map(|meeting| (meeting.name, meeting.value)) {
            if !value.is_finite() {
                return Err(Error::NonFinite { name });
            }
        }
        let sorted = sort(self.model, self.time, &self.guess, self.wishes, self.meetings, &self.parameters)?;
        Problem::new(self.model, self.time, sorted, self.mass_weighted)
    }
}

impl<M: ConstrainedSystem> fmt::Debug for Assembly<'_, M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Assembly")
            .field("guess", &self.guess)
            .field("time", &self.time)
            .field("wishes", &self.wishes)
            .field("solve_for", &self.parameters)
            .finish_non_exhaustive()
    }
}

/// A time and a state that a caller gave must be finite.
pub(crate) fn check_finite<M: ConstrainedSystem>(t: f64, s: &M::State<f64>) -> Result<(), Error> {
    if !t.is_finite() {
        return Err(Error::NonFinite { name: "t" });
    }
    match first_non_finite::<M>(s) {
        Some(name) => Err(Error::NonFinite { name }),
        None => Ok(()),
    }
}

/// The name of the first entry of a state that is infinite or not a number.
pub(crate) fn first_non_finite<M: ConstrainedSystem>(s: &M::State<f64>) -> Option<&'static str> {
    let array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
    let at = array.as_ref().iter().position(|entry| !entry.is_finite())?;
    Some(<M::State<f64> as Vector<f64>>::NAMES.get(at).copied().unwrap_or("state"))
}
