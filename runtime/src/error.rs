//! What can go wrong, as values that name the culprit.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::{AssemblyReport, TrimReport};

mod obstacle;

pub use obstacle::Obstacle;

/// Why a model could not be prepared, assembled or simulated.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::Pendulum;
/// use holonomy::prelude::*;
///
/// let error = Pendulum { m: 2.0, l: f64::NAN, g: 9.81 }.prepare().unwrap_err();
/// assert_eq!(error, Error::NonFinite { name: "l" });
/// assert_eq!(error.to_string(), "`l` is not a finite number");
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A parameter, an entry of the start, an input or a time is infinite or not a number.
    NonFinite {
        /// Its name.
        name: &'static str,
    },
    /// The inertia is not positive definite.
    Indefinite {
        /// The pivot of M or of M_d that is not positive.
        pivot: &'static str,
        /// Its value.
        value: f64,
        /// When, if it depends on the state.
        time: Option<f64>,
    },
    /// A figure of the parameters by which the equations divide is zero.
    SingularParameter {
        /// The figure.
        guard: &'static str,
        /// Where it comes from.
        origin: &'static str,
    },
    /// The coordinates or the independent speeds break down in this state, though the mechanism need not.
    ChartSingularity {
        /// The figure that vanished or changed its sign.
        guard: &'static str,
        /// Its value.
        value: f64,
        /// When.
        time: f64,
    },
    /// A start, or the state of a linearisation, does not satisfy a constraint.
    Unmet {
        /// The constraint's name.
        constraint: &'static str,
        /// f or φ: left side minus right side.
        residual: f64,
    },
    /// The coordinates could not be brought back onto a position constraint after a step.
    Projection {
        /// The constraint's name.
        constraint: &'static str,
        /// f: left side minus right side.
        residual: f64,
        /// When.
        time: f64,
    },
    /// No state that meets the constraints, and what else was asked for, was found.
    Assembly {
        /// The constraint or quantity that is missed most, relative to the size of its terms.
        constraint: &'static str,
        /// What remains of it at the nearest state found: left side minus right side.
        residual: f64,
        /// All that was asked for, with what remains, and what is in the way.
        report: Box<AssemblyReport>,
    },
    /// The mechanism closes, but what is held does not hold it: there are no single modes of assembly.
    Movable {
        /// How many more coordinates must be held.
        freedom: usize,
        /// The entries of the state that still move.
        among: Vec<&'static str>,
    },
    /// No state and inputs with the rates asked for were found.
    NotSteady {
        /// What is missed most, relative to the size of its terms: `the constraint`, `the rate of`, or `the quantity`.
        what: &'static str,
        /// Its name.
        name: &'static str,
        /// What remains of it at the nearest state found: left side minus right side, or the value minus the one asked for.
        residual: f64,
        /// All that was asked for, with what remains.
        report: Box<TrimReport>,
    },
    /// No inputs give the independent speeds the rates asked for.
    NotHeld {
        /// The speed that is missed most, relative to the size of the terms of its equation.
        speed: &'static str,
        /// The generalised force along it that is missing.
        residual: f64,
        /// When.
        time: f64,
    },
    /// Inputs do not act on the motion in this state: what they give is taken up by the constraints, or it is nothing.
    NoEffect {
        /// Their names.
        inputs: Vec<&'static str>,
        /// When.
        time: f64,
    },
    /// A rate or an output has no finite value or no finite derivative in this state, or a constraint has none.
    NotDifferentiable {
        /// The entry of the state whose rate it is, the output, or the constraint.
        name: &'static str,
        /// The entry of the state, or the input, along which there is none.
        along: &'static str,
        /// When.
        time: f64,
    },
    /// A derivative needs one more derivative of a function of the model's own than the model gives.
    MissingOrder {
        /// The entry of the state whose rate depends on the function, or the output that does.
        name: &'static str,
    },
    /// An iteration of linear algebra did not converge.
    NoConvergence {
        /// What it was to find.
        of: &'static str,
    },
    /// An output cannot be asked for in an assembly, which knows states only.
    CannotHold {
        /// The output.
        name: &'static str,
        /// What it depends on beyond them.
        on: &'static str,
    },
    /// A define was asked for that has no value at run time.
    NotAnOutput {
        /// Its name.
        define: &'static str,
    },
    /// An output has no finite value in this state.
    Undefined {
        /// The output.
        output: &'static str,
        /// What it divides by, other than guards.
        divisors: &'static [&'static str],
        /// When.
        time: f64,
    },
    /// An entry of the state left the finite numbers.
    Diverged {
        /// The entry's name.
        name: &'static str,
        /// The last time at which the state was finite.
        time: f64,
    },
    /// A step is so small that it hardly changes the time.
    StepTooSmall {
        /// The step.
        step: f64,
        /// When.
        time: f64,
    },
    /// The run needs more steps than allowed.
    TooManySteps {
        /// The number allowed.
        steps: usize,
        /// How far the run came.
        time: f64,
    },
    /// A step, a spacing or a tolerance that must be positive is not.
    NotPositive {
        /// What it is.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The model has inputs, and the simulation was given none.
    MissingInputs {
        /// Their names.
        inputs: &'static [&'static str],
    },
    /// No entry has that name.
    UnknownName {
        /// The name.
        name: String,
        /// The names that there are.
        known: Vec<&'static str>,
    },
    /// Constraints depend on each other in this state: their reactions cannot be told apart, and directions that they should
    /// bind are free.
    Dependent {
        /// The rows of C that take part.
        rows: Vec<&'static str>,
        /// The smallest singular value of C relative to the largest, rows scaled to one size; in a run what is left of the smallest
        /// pivot of C, or of the length of a row, relative to the largest value that it had, and zero where the rows have turned over.
        value: f64,
        /// The guard of the model that vanishes with the rank, if one does.
        guard: Option<&'static str>,
        /// When, if that is known.
        time: Option<f64>,
    },
    /// A run starts, or came to a point, where constraints depend on each other, and does not go on from there.
    Impassable {
        /// The rows of C that take part.
        rows: Vec<&'static str>,
        /// The guard of the model that vanishes with the rank, if one does.
        guard: Option<&'static str>,
        /// What is in the way.
        obstacle: Obstacle,
        /// When.
        time: f64,
    },
    /// Rows that the model marks `redundant` do not follow from the others in this state, or with these parameters: they bind motions
    /// that the equations leave free.
    NotRedundant {
        /// The rows of C that are marked.
        rows: Vec<&'static str>,
        /// The sine of the largest angle that is left between a row and the others, or what is left of C v̇ + c0* in a row, relative to its
        /// terms and weighted by the square of the smallest pivot of C.
        value: f64,
        /// When.
        time: f64,
    },
    /// Constraints that depend on each other demand different things.
    Inconsistent {
        /// The rows of C that take part.
        rows: Vec<&'static str>,
        /// What remains of C v̇ + c0* in the row that is missed most.
        residual: f64,
    },
    /// A D or an a that was given for a projection leaves a constraint.
    NotTangent {
        /// The row of C.
        constraint: &'static str,
        /// What remains of D Cᵀ or of C a + c0* in it.
        value: f64,
    },
    /// A system of linear equations has no unique solution.
    SingularMatrix {
        /// Which matrix.
        matrix: &'static str,
        /// The smallest pivot relative to the largest, after scaling.
        pivot: f64,
    },
    /// A matrix has not the shape that the equation needs.
    Shape {
        /// Which matrix.
        matrix: &'static str,
        /// (rows, columns) needed.
        needed: (usize, usize),
        /// (rows, columns) given.
        given: (usize, usize),
    },
    /// A method of another crate gave up.
    Solver {
        /// What it says.
        reason: String,
        /// The last time that it reached.
        time: f64,
    },
    /// A trajectory was asked for a time that it does not cover.
    OutOfRange {
        /// The time.
        time: f64,
        /// Where the trajectory starts.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// A trajectory without dense output was asked for a time between its states.
    NoDenseOutput {
        /// The time.
        time: f64,
    },
}

impl Error {
    /// The guard that vanished, where one did.
    pub(crate) fn guard(&self) -> Option<&'static str> {
        match self {
            Error::ChartSingularity { guard, .. } => Some(guard),
            _ => None,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::NonFinite { name } => write!(out, "`{name}` is not a finite number"),
            Error::Indefinite { pivot, value, time: None } => write!(
                out,
                "the inertia is not positive definite: {pivot} is {value:e} and must be positive; check masses and moments of inertia"
            ),
            Error::Indefinite { pivot, value, time: Some(time) } => write!(
                out,
                "the mass matrix is not positive definite at t = {time}: {pivot} is {value:e} and must be positive; check masses and moments of inertia"
            ),
            Error::SingularParameter { guard, origin } => {
                write!(out, "the parameters make {guard} zero, and the equations divide by it ({origin})")
            }
            Error::ChartSingularity { guard, value, time } => write!(
                out,
                "the coordinates or independent speeds of the model break down at t = {time}: {guard} is {value:e} and must neither vanish nor change its sign; \
                 choose other coordinates or other independent speeds for this motion, or give all `velocities` of a start there"
            ),
            Error::Unmet { constraint, residual } => write!(
                out,
                "the state does not satisfy the constraint `{constraint}`: left minus right is {residual:e}; `assemble` finds one that does"
            ),
            Error::Projection { constraint, residual, time } => write!(
                out,
                "at t = {time} the coordinates could not be brought back onto the constraint `{constraint}`: left minus right is {residual:e}; \
                 take a smaller step or tolerance, or look for a configuration where the constraints depend on each other"
            ),
            Error::Assembly { constraint, residual, report } => {
                write!(
                    out,
                    "no state was found that meets the constraint `{constraint}`: left minus right remains {residual:e}; "
                )?;
                if !report.conflicts.is_empty() {
                    out.write_str("in its way are the values asked for ")?;
                    list(out, &report.conflicts)?;
                    out.write_str("; ")?;
                }
                out.write_str("start from another guess, hold fewer coordinates, or check the dimensions")
            }
            Error::Movable { freedom, among } => {
                write!(
                    out,
                    "the mechanism can still move in {freedom} independent ways: hold or set {freedom} more of "
                )?;
                list(out, among)?;
                out.write_str(", or ask for as many other quantities with `meet`")
            }
            Error::NotSteady { what, name, residual, .. } => write!(
                out,
                "no steady motion was found: {what} `{name}` remains off by {residual:e}; free another entry of the state or another \
                 input, ask for fewer rates, or start from another guess"
            ),
            Error::NotHeld { speed, residual, time } => write!(
                out,
                "no inputs give the rates asked for at t = {time}: along `{speed}` a generalised force of {residual:e} is missing; ask \
                 for another rate of it, give the model an input that acts there, or, where forces are not linear in the inputs, \
                 start from another guess"
            ),
            Error::NoEffect { inputs, time } => {
                out.write_str("the motion does not depend on the inputs ")?;
                list(out, inputs)?;
                write!(
                    out,
                    " at t = {time}: the constraints take up what they give; ask in another state, or leave them out"
                )
            }
            Error::NotDifferentiable { name, along, time } => write!(
                out,
                "`{name}` or its derivative along `{along}` is not finite at t = {time}; check forces, inputs and functions there, roots \
                 at zero among them"
            ),
            Error::MissingOrder { name } => write!(
                out,
                "`{name}` depends on a function of the model whose next derivative is needed; add it to `derivatives` in `#[function(..)]`"
            ),
            Error::NoConvergence { of } => write!(out, "{of} could not be found: the iteration does not converge"),
            Error::CannotHold { name, on } => write!(
                out,
                "the output `{name}` depends on {on} and cannot be held: an assembly moves coordinates and speeds only; \
                 `meet` takes any quantity of the state"
            ),
            Error::NotAnOutput { define } => write!(
                out,
                "the define `{define}` has no value at run time; write `#[output({define})]` in the model to hold it"
            ),
            Error::Undefined { output, divisors, time } => {
                write!(out, "the output `{output}` has no finite value at t = {time}")?;
                if !divisors.is_empty() {
                    out.write_str("; it divides by ")?;
                    list(out, divisors)?;
                }
                Ok(())
            }
            Error::Diverged { name, time } => write!(
                out,
                "`{name}` is no longer finite after t = {time}; take a smaller step, and check forces and inputs"
            ),
            Error::StepTooSmall { step, time } => write!(
                out,
                "a step of {step:e} at t = {time} is too small to go on; the motion may be singular or stiff there, or the tolerance, the step or the spacing of the output too fine"
            ),
            Error::TooManySteps { steps, time } => write!(
                out,
                "the run reached only t = {time} in {steps} steps; allow more with `max_steps`, or loosen the tolerance"
            ),
            Error::NotPositive { name, value } => {
                write!(out, "the {name} must be positive and is {value}")
            }
            Error::MissingInputs { inputs } => {
                write!(out, "the model has inputs; give them with `.inputs(|t, s| ..)`: ")?;
                list(out, inputs)
            }
            Error::UnknownName { name, known } => {
                write!(out, "there is no `{name}`; there are ")?;
                list(out, known)
            }
            Error::Dependent { rows, value, guard, time } => {
                out.write_str("the rows of C depend on each other")?;
                if let Some(time) = time {
                    write!(out, " at t = {time}")?;
                }
                out.write_str(": ")?;
                list(out, rows)?;
                write!(out, " (smallest relative singular value {value:e}")?;
                if let Some(guard) = guard {
                    write!(out, ", where {guard} vanishes")?;
                }
                out.write_str("); leave one out, mark it `redundant` if it always depends on the others, or keep away from such configurations")
            }
            Error::Impassable { rows, guard, obstacle, time } => {
                write!(out, "at t = {time} the rows of C depend on each other, and the run does not go on: ")?;
                list(out, rows)?;
                if let Some(guard) = guard {
                    write!(out, ", where {guard} vanishes")?;
                }
                write!(out, "; {obstacle}")
            }
            Error::NotRedundant { rows, value, time } => {
                write!(out, "at t = {time} rows that are marked `redundant` do not follow from the others: ")?;
                list(out, rows)?;
                write!(
                    out,
                    " (what is left of them is {value:e}); with these parameters, or in this configuration, they bind \
                     motions of their own: correct the parameters, or leave `redundant` away"
                )
            }
            Error::Inconsistent { rows, residual } => {
                out.write_str("constraints that depend on each other contradict each other: ")?;
                list(out, rows)?;
                write!(out, "; C v̇ + c0* remains {residual:e}; check their terms and their time dependence")
            }
            Error::NotTangent { constraint, value } => write!(
                out,
                "the projection does not satisfy the constraint `{constraint}`: D Cᵀ or C a + c0* is {value:e} and must be zero; \
                 eliminate the rows that D is orthogonal to, and take a from the same state"
            ),
            Error::SingularMatrix { matrix, pivot } => write!(
                out,
                "{matrix} is singular (relative pivot {pivot:e}): constraints depend on each other, or the inertia is singular"
            ),
            Error::Shape { matrix, needed, given } => write!(
                out,
                "{matrix} must have {} rows and {} columns and has {} and {}",
                needed.0, needed.1, given.0, given.1
            ),
            Error::Solver { reason, time } => write!(
                out,
                "the method gave up after t = {time}: {reason}; loosen its tolerance, allow it more steps, or take another method"
            ),
            Error::OutOfRange { time, from, to } => {
                write!(out, "t = {time} lies outside of the trajectory, which covers {from} to {to}")
            }
            Error::NoDenseOutput { time } => write!(
                out,
                "the trajectory has no state at t = {time}, and dense output was switched off; leave it on, or ask for that output with `every`"
            ),
        }
    }
}

/// Names in backquotes, separated by commas.
fn list(out: &mut fmt::Formatter<'_>, names: &[&str]) -> fmt::Result {
    if names.is_empty() {
        return out.write_str("none");
    }
    for (i, name) in names.iter().enumerate() {
        write!(out, "{}`{name}`", if i == 0 { "" } else { ", " })?;
    }
    Ok(())
}

impl core::error::Error for Error {}
