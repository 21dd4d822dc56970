//! Equilibria and steady motions.

mod problem;
mod wishes;

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::assemble::{Met, check_finite};
use crate::simulate::{Watch, check_inputs};
use crate::{ConstrainedSystem, Error, Prepared, Vector};

use wishes::{Rate, Wish};

/// A steady motion in the making; from [`Prepared::trim`].
///
/// ```
/// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
/// use holonomy::{ConstrainedSystem, Error, State};
///
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(a)]
/// #[inertia(diag(m*l*l))]
/// #[forces(torque - m*g*l*sin(a))]
/// #[inputs(torque)]
/// struct Arm {
///     m: f64,
///     l: f64,
///     g: f64,
/// }
///
/// // Which torque holds the arm level?
/// let arm = Arm { m: 2.0, l: 0.5, g: 10.0 }.prepare()?;
/// let level = State::<Arm> { a: std::f64::consts::FRAC_PI_2, ..Default::default() };
/// let held = arm.trim(level).rest().hold("a").free("torque").solve()?;
/// assert!((held.inputs.torque - 10.0).abs() < 1e-12);
///
/// // And where does it rest under half of that?
/// let held = arm.trim(State::<Arm>::default()).rest().set("torque", 5.0).solve()?;
/// assert!((held.state.a - 0.5_f64.asin()).abs() < 1e-12);
///
/// // Twice as much carries it over the top: the error tells what is left.
/// let error = arm.trim(State::<Arm>::default()).rest().set("torque", 20.0).solve().unwrap_err();
/// assert!(matches!(&error, Error::NotSteady { name: "dot_a", residual, .. } if *residual > 19.0), "{error}");
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "derive"))] fn main() {}
/// ```
#[derive(Clone)]
pub struct Trim<'a, M: ConstrainedSystem> {
    model: &'a Prepared<M>,
    guess: M::State<f64>,
    inputs: M::Inputs<f64>,
    time: f64,
    wishes: Vec<Wish>,
    free: Vec<String>,
    rates: Vec<Rate>,
    rest: bool,
}

/// A steady motion; from [`Trim::solve`].
#[derive(Clone)]
pub struct Trimmed<M: ConstrainedSystem> {
    /// The state.
    pub state: M::State<f64>,
    /// The inputs.
    pub inputs: M::Inputs<f64>,
    /// The state's rate: what was asked for, and what else goes on.
    pub rate: M::State<f64>,
    /// What was met, and how well.
    pub report: TrimReport,
}

/// What was asked of a steady motion, and what became of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TrimReport {
    /// The constraints that bind entries of the state.
    pub constraints: Vec<Met>,
    /// The rates of the state, by the names of its entries.
    pub rates: Vec<Met>,
    /// The other quantities.
    pub quantities: Vec<Met>,
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// Finds a state in which nothing accelerates, near a guess: the rates of all speeds vanish and the constraints are met; see
    /// [`Trim`].
    ///
    /// Without further words speeds may be anything that stays as it is, a disk that rolls in a circle, say;
    /// [`rest`](Trim::rest) asks for an equilibrium. All entries of the state are free unless they are held, and move as
    /// little as Newton's method needs; all inputs are held, at zero or as given, unless they are freed.
    pub fn trim(&self, guess: M::State<f64>) -> Trim<'_, M> {
        Trim {
            model: self,
            guess,
            inputs: M::Inputs::<f64>::from_fn(|_| 0.0),
            time: 0.0,
            wishes: Vec::new(),
            free: Vec::new(),
            rates: Vec::new(),
            rest: false,
        }
    }
}

impl<M: ConstrainedSystem> Trim<'_, M> {
    /// Keeps an entry of the state, or another quantity, at its value in the guess: a coordinate or a velocity that depends on the
    /// state, or an output, reactions and accelerations among them.
    #[must_use]
    pub fn hold(self, name: &str) -> Self {
        self.wish(name, None)
    }

    /// Asks for a value of an entry of the state, of an input or of another quantity; see [`hold`](Self::hold).
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::{ConstrainedSystem, State};
    ///
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, y)]
    /// #[inertia(diag(m, m))]
    /// #[forces(push, -m*g)]
    /// #[inputs(push)]
    /// #[constraint(rod: x*x + y*y == l*l)]
    /// #[output(tension = -2*l*reaction(rod))]
    /// struct Bob {
    ///     m: f64,
    ///     l: f64,
    ///     g: f64,
    /// }
    ///
    /// // How strongly must it be pushed aside, and where is it then, if the rod shall carry 25 N?
    /// let bob = Bob { m: 2.0, l: 0.5, g: 10.0 }.prepare()?;
    /// let guess = State::<Bob> { x: 0.2, y: -0.45, ..Default::default() };
    /// let found = bob.trim(guess).rest().free("push").set("tension", 25.0).solve()?;
    /// assert!((found.inputs.push - 15.0).abs() < 1e-12);
    /// assert!((found.state.x - 0.3).abs() < 1e-14 && (found.state.y + 0.4).abs() < 1e-14);
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    #[must_use]
    pub fn set(self, name: &str, value: f64) -> Self {
        self.wish(name, Some(value))
    }

    /// Lets an input change.
    #[must_use]
    pub fn free(mut self, input: &str) -> Self {
        self.free.push(input.into());
        self
    }

    /// The values of the inputs; those of the freed ones are where the search starts. All are zero otherwise.
    #[must_use]
    pub fn inputs(mut self, inputs: M::Inputs<f64>) -> Self {
        self.inputs = inputs;
        self
    }

    /// Asks for the rate of an entry of the state: of a coordinate, or of a speed, whose rate is zero otherwise.
    #[must_use]
    pub fn rate(self, entry: &str, value: f64) -> Self {
        self.rate_of(entry, Some(value))
    }

    /// Asks nothing of the rate of an entry of the state.
    #[must_use]
    pub fn any_rate(self, entry: &str) -> Self {
        self.rate_of(entry, None)
    }

    /// Asks for rest: the rates of all coordinates vanish too, but for those of which [`rate`](Self::rate) or
    /// [`any_rate`](Self::any_rate) say otherwise.
    #[must_use]
    pub fn rest(mut self) -> Self {
        self.rest = true;
        self
    }

    /// The time at which the motion is to be steady, for models that depend on it; zero otherwise.
    #[must_use]
    pub fn at_time(mut self, t: f64) -> Self {
        self.time = t;
        self
    }

    /// A state and inputs that meet all to rounding, or [`Error::NotSteady`] with what could not be met and by how much.
    ///
    /// Newton's method with the shortest steps in the free entries, by least squares where there are more equations than these;
    /// all derivatives are exact, by dual numbers.
    pub fn solve(self) -> Result<Trimmed<M>, Error> {
        check_finite::<M>(self.time, &self.guess)?;
        check_inputs::<M>(&self.inputs)?;
        let (model, time) = (self.model, self.time);
        let (state, inputs, report) = problem::solve(model, time, self.sort()?)?;
        Watch::new(model, 0, time, &state)?;
        let rate = model.derivative(time, &state, &inputs).0;
        Ok(Trimmed { state, inputs, rate, report })
    }

    /// The last word on a name counts.
    fn wish(mut self, name: &str, value: Option<f64>) -> Self {
        self.wishes.retain(|wish| wish.name != name);
        self.wishes.push(Wish { name: name.into(), value });
        self
    }

    fn rate_of(mut self, entry: &str, value: Option<f64>) -> Self {
        self.rates.retain(|rate| rate.entry != entry);
        self.rates.push(Rate { entry: entry.into(), value });
        self
    }
}

impl TrimReport {
    /// What is not met, with what remains: constraints, then rates, then other quantities.
    pub fn unmet(&self) -> impl Iterator<Item = &Met> {
        self.constraints.iter().chain(&self.rates).chain(&self.quantities).filter(|entry| !entry.met)
    }
}

// A derived one would ask for that of the model.
impl<M: ConstrainedSystem> fmt::Debug for Trimmed<M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Trimmed")
            .field("state", &self.state)
            .field("inputs", &self.inputs)
            .field("rate", &self.rate)
            .field("report", &self.report)
            .finish()
    }
}

impl<M: ConstrainedSystem> fmt::Debug for Trim<'_, M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Trim")
            .field("guess", &self.guess)
            .field("inputs", &self.inputs)
            .field("time", &self.time)
            .field("wishes", &self.wishes)
            .field("free", &self.free)
            .field("rates", &self.rates)
            .field("rest", &self.rest)
            .finish_non_exhaustive()
    }
}
