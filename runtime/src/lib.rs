//! Equations of motion of constrained mechanisms, derived by the compiler.
//!
//! The derive macro turns a declared mechanism into an implementation of [`ConstrainedSystem`]: straight-line functions for the
//! minimal equations of motion `M_d u̇ = h_u*`, the constraints, the multipliers and the energies. This crate runs them:
//!
//! * [`ConstrainedSystem::prepare`] checks the parameters and gives a [`Prepared`] model, on which all methods live;
//! * [`Prepared::outputs`] gives the quantities that the model declares besides its motion;
//! * [`Prepared::assemble`] closes the constraints from a guess, with whatever else is asked for, and [`Assembly::modes`] in all
//!   ways that are found from many starts;
//! * [`Prepared::project_positions`] and [`Prepared::project_velocities`] take x and v back onto the constraints;
//! * [`Prepared::simulate`] integrates, watches the guards, and stays on the constraint manifold;
//! * [`Prepared::linearize`] gives the linear equations of small deviations from a motion, with eigenvalues and modes;
//! * [`Prepared::trim`] finds equilibria and steady motions;
//! * [`Prepared::inverse_dynamics`] gives the forces that a motion needs, [`Prepared::inputs_for`] the inputs;
//! * [`equations`] has the derived equations as formulas and in LaTeX: `println!("{}", Pendulum::MODEL.latex())`;
//! * [`forms`] has the unreduced forms of the equations, for oracles and for study.
//!
//! Equation numbers refer to W. Blajer, "A generalized projection method for the dynamic analysis of constrained mechanical
//! systems" (Journal of Theoretical and Applied Mechanics 2, 30, 1992). The names follow the paper: `x` the initial coordinates,
//! `v` the initial velocities, `u` the independent speeds, `C` the constraint matrix, `D` its complement (`D Cᵀ = 0`),
//! `λ` the multipliers, with the sign of `M v̇ = h* + Cᵀ λ`: the force that the constraint exerts on the system.
//!
//! ```
//! # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
//! # use models::{Pendulum, PendulumState};
//! use holonomy::prelude::*;
//!
//! # fn main() -> Result<(), holonomy::Error> {
//! let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
//! let start = pendulum.assemble(PendulumState { x: 0.2, y: -0.4, dot_x: 0.0 }).hold("x").solve()?;
//! let run = pendulum.simulate(start).until(1.0)?;
//! let (t, end) = run.last();
//! assert!((pendulum.energy(t, end) - pendulum.energy(0.0, &start)).abs() < 1e-6);
//! println!("tension {}", pendulum.multipliers(t, end, &[]).rod);
//! # Ok(())
//! # }
//! ```
//!
//! Features: `std` (default) or `libm` for the elementary functions, `derive` (default) for the macro;
//! `differential-equations` for the implicit methods of the crate of that name; `serde` for [`Description`] in JSON and its like.

#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

#[cfg(any(feature = "std", feature = "libm"))]
extern crate alloc;
// The models of the tests name this crate as users do.
#[cfg(test)]
#[allow(unused_extern_crates)]
extern crate self as holonomy;
#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
// Everything below is left out then, so that only this error shows.
compile_error!("holonomy needs elementary functions: enable the feature `std` (default) or `libm`");

#[cfg(any(feature = "std", feature = "libm"))]
mod assemble;
#[cfg(any(feature = "std", feature = "libm"))]
mod carriers;
#[cfg(feature = "differential-equations")]
pub mod differential_equations;
#[cfg(any(feature = "std", feature = "libm"))]
mod drift;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod equations;
#[cfg(any(feature = "std", feature = "libm"))]
mod error;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod forms;
#[cfg(any(feature = "std", feature = "libm"))]
mod linearize;
#[cfg(any(feature = "std", feature = "libm"))]
mod manifold;
#[cfg(any(feature = "std", feature = "libm"))]
mod math;
#[cfg(any(feature = "std", feature = "libm"))]
mod matrix;
#[cfg(any(feature = "std", feature = "libm"))]
mod prepared;
#[cfg(any(feature = "std", feature = "libm"))]
mod projection;
#[cfg(any(feature = "std", feature = "libm"))]
mod scalar;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod simulate;
#[cfg(any(feature = "std", feature = "libm"))]
mod system;
#[cfg(any(feature = "std", feature = "libm"))]
mod tangent;
#[cfg(any(feature = "std", feature = "libm"))]
mod trim;
#[cfg(any(feature = "std", feature = "libm"))]
mod vector;

#[cfg(any(feature = "std", feature = "libm"))]
pub use assemble::{Assembled, Assembly, AssemblyMode, AssemblyModes, AssemblyReport, Met};
#[cfg(any(feature = "std", feature = "libm"))]
pub use error::{Error, Obstacle};
#[cfg(any(feature = "std", feature = "libm"))]
pub use linearize::{Linearization, Mode};
#[cfg(any(feature = "std", feature = "libm"))]
pub use math::sin_cos_lanes;
#[cfg(any(feature = "std", feature = "libm"))]
pub use matrix::Matrix;
/// A complex number, as eigenvalues are.
#[cfg(any(feature = "std", feature = "libm"))]
pub use nalgebra::Complex;
#[cfg(any(feature = "std", feature = "libm"))]
pub use prepared::{Prepared, Reactions};
#[cfg(any(feature = "std", feature = "libm"))]
pub use projection::{Projected, ProjectedPositions, ProjectedVelocities};
#[cfg(any(feature = "std", feature = "libm"))]
pub use scalar::{Dual, Scalar};
#[cfg(any(feature = "std", feature = "libm"))]
pub use simulate::{Interrupted, Method, Simulation, Trajectory};
#[cfg(any(feature = "std", feature = "libm"))]
pub use system::{
    ChartInfo, ConstrainedSystem, Description, Equation, FunctionCost, GuardInfo, GuardKind, Level, MultiplierInfo,
    OutputInfo, RowInfo, State, UnitInfo, UnitKind,
};
#[cfg(any(feature = "std", feature = "libm"))]
pub use trim::{Trim, TrimReport, Trimmed};
#[cfg(any(feature = "std", feature = "libm"))]
pub use vector::Vector;

#[cfg(all(feature = "derive", any(feature = "std", feature = "libm")))]
pub use holonomy_derive::ConstrainedSystem;

#[doc(hidden)]
#[cfg(any(feature = "std", feature = "libm"))]
pub mod __private;

#[cfg(test)]
#[path = "../tests/models/mod.rs"]
mod models;

/// What a program that runs models needs: `use holonomy::prelude::*;`.
#[cfg(any(feature = "std", feature = "libm"))]
pub mod prelude {
    pub use crate::{ConstrainedSystem, Error, Matrix, Method, Prepared, Scalar, Vector};
}

/// The README's model runs as it stands there.
#[cfg(all(doctest, feature = "derive"))]
#[doc = include_str!("../../README.md")]
struct Readme;
