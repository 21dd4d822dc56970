//! Speeds of the model's own choice behind the initial ones: quasi-velocities of a configuration, and v = g(u, x, t).
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// A particle in a vertical plane whose speed is c, by the direction of its motion (P6, C13).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(speed: (powi(dot(x), 2) + powi(dot(y), 2) - powi(c, 2))/2 == 0)]
#[velocities(of(u), dot(x) = c*cos(u), dot(y) = c*sin(u))]
#[output(heading = u, thrust = c*reaction(speed), turn = ddot(x)*sin(u))]
pub struct ConstantSpeedByDirection {
    #[nominal(1.5)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(3.0)]
    pub c: f64,
}

/// A spherical pendulum with the angular momentum about the vertical, over the mass, as a speed: it stands still.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[kinetic_energy(m/2*(powi(dot(x), 2) + powi(dot(y), 2) + powi(dot(z), 2)))]
#[potential_energy(m*g*z)]
#[configuration(
    of(a, b),
    x = l*sin(a)*cos(b),
    y = l*sin(a)*sin(b),
    z = -l*cos(a),
    speeds(p, h),
    p = l*dot(a),
    h = powi(l*sin(a), 2)*dot(b),
)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[output(tension = -l*reaction(rod), momentum = m*h, turning = dot(b), sinking = ddot(a))]
pub struct PendulumByMomentum {
    #[nominal(1.5)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.8)]
    pub l: f64,
}

/// Two masses on a wire each, a massless clip between them: M is singular, D M Dᵀ is not.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b, clip)]
#[inertia(diag(m1, m2, 0))]
#[forces(-s*a, -s*b, pull)]
#[constraint(on_first: clip - a == 0)]
#[constraint(on_second: clip + b*b/2 - 3*a/2 == 0)]
pub struct Clip {
    #[nominal(1.2)]
    pub m1: f64,
    #[nominal(0.7)]
    pub m2: f64,
    #[nominal(30.0)]
    pub s: f64,
    #[nominal(2.0)]
    pub pull: f64,
}
