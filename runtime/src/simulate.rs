//! Simulation: integrating the minimal equations, watching the guards, staying on the constraints.

mod charts;
mod checks;
mod collocation;
mod control;
mod course;
mod crossing;
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
mod passage;
mod points;
mod readings;
mod redundancy;
mod simulation;
mod stages;
mod start;
mod tableau;
#[cfg(test)]
mod tests;
mod trajectory;

pub(crate) use emitted::check_inputs;
pub(crate) use guards::Watch;
pub(crate) use start::{check_position, check_velocity};

pub use charts::{Chart, Charts, FLAT, STEEP};
pub use crossing::Crossing;
pub use events::{Event, Occurrence};
pub use guards::SINGULAR;
pub use inputs::{InputSource, NoInputs, Sampled};
pub use readings::Residuals;
pub use simulation::Simulation;
pub use start::START_TOLERANCE;
pub use trajectory::{Interrupted, Statistics, Trajectory};

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
