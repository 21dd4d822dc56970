//! The spherical pendulum: in x, y, z with one chart and with three, and in angles.

use holonomy::ConstrainedSystem;

/// One choice of independent speeds: z is its pivot, which vanishes with the rod level.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x), dot(y))]
pub struct OneChart {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

/// Three choices: somewhere on the sphere each of them breaks down, and nowhere all.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x), dot(y))]
#[independent(dot(y), dot(z))]
#[independent(dot(z), dot(x))]
pub struct ThreeCharts {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

/// In the angle from the lowest point and the azimuth: x = l sin θ cos φ, y = l sin θ sin φ, z = -l cos θ.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(theta, phi)]
#[inertia(diag(m*powi(l, 2), m*powi(l*sin(theta), 2)))]
#[forces(
    m*powi(l, 2)*sin(theta)*cos(theta)*powi(dot(phi), 2) - m*g*l*sin(theta),
    -2*m*powi(l, 2)*sin(theta)*cos(theta)*dot(theta)*dot(phi),
)]
#[potential_energy(-m*g*l*cos(theta))]
pub struct InAngles {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}
