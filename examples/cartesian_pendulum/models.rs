//! A pendulum in the plane, in x and y.

use holonomy::ConstrainedSystem;

/// The rod is a constraint: its pull is the multiplier.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x))]
#[independent(dot(y))]
#[output(
    /// The pull of the rod on the mass.
    tension = -l*reaction(rod),
)]
pub struct CartesianPendulum {
    /// Mass.
    #[unit(kg)]
    pub m: f64,
    /// Length of the rod.
    #[unit(m)]
    pub l: f64,
    /// Gravity.
    #[unit(m/s/s)]
    pub g: f64,
}
