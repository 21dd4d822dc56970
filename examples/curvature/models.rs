//! A particle whose path is steered to a curvature.

use holonomy::ConstrainedSystem;

/// x' y'' - y' x'' = kappa v³: the row C = [-y', x'] is across the path, and so is its reaction.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[define(speed = sqrt(powi(dot(x), 2) + powi(dot(y), 2)))]
#[constraint(path: dot(x)*ddot(y) - dot(y)*ddot(x) == kappa*powi(speed, 3))]
pub struct SteeredParticle {
    /// Mass.
    #[unit(kg)]
    pub m: f64,
    /// Acceleration due to gravity.
    #[unit(m/s/s)]
    pub g: f64,
    /// Curvature of the path.
    #[unit(1/m)]
    pub kappa: f64,
}
