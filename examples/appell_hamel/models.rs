//! A particle whose velocity keeps its angle with the vertical.

#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// The horizontal speed is a times the vertical one, up or down. The constraint's reaction is along ∂φ/∂v (Chetaev).
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(angle: (powi(dot(x), 2) + powi(dot(y), 2) - powi(a, 2)*powi(dot(z), 2))/2 == 0)]
pub struct SteadySlope {
    /// Mass.
    #[unit(kg)]
    pub m: f64,
    /// Acceleration due to gravity.
    #[unit(m/s/s)]
    pub g: f64,
    /// Tangent of the angle.
    #[unit(1)]
    pub a: f64,
}
