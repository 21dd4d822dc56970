//! Particles under constraints that bind no speed of the state: nonlinear in the velocities, or stated for accelerations.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// A particle in a vertical plane whose speed is c.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(speed: (powi(dot(x), 2) + powi(dot(y), 2) - powi(c, 2))/2 == 0)]
#[output(thrust = c*reaction(speed), climb = dot(y)/c, turn = dot(x)*ddot(y) - dot(y)*ddot(x))]
pub struct ConstantSpeed {
    pub m: f64,
    pub g: f64,
    pub c: f64,
}

/// A particle whose velocity keeps its angle with the vertical (Appell, Hamel).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(angle: (powi(dot(x), 2) + powi(dot(y), 2) - powi(a, 2)*powi(dot(z), 2))/2 == 0)]
pub struct SteadySlope {
    pub m: f64,
    pub g: f64,
    pub a: f64,
}

/// The published form of the same: two masses, and the constraint without the half.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m1, m1, m2))]
#[forces(0, 0, -m2*g)]
#[potential_energy(m2*g*z)]
#[constraint(cone: powi(dot(x), 2) + powi(dot(y), 2) - powi(c, 2)*powi(dot(z), 2) == 0)]
pub struct AppellHamel {
    pub m1: f64,
    pub m2: f64,
    pub g: f64,
    pub c: f64,
}

/// A particle whose accelerations are tied to each other and to the time.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(push: ddot(x) + k*ddot(y) - cos(t) == 0)]
pub struct Pushed {
    pub m: f64,
    pub g: f64,
    pub k: f64,
}

/// A particle in a vertical plane whose path has the curvature kappa.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[define(speed = sqrt(powi(dot(x), 2) + powi(dot(y), 2)))]
#[output(speed, steer = speed*reaction(path))]
#[constraint(path: dot(x)*ddot(y) - dot(y)*ddot(x) - kappa*powi(speed, 3) == 0)]
pub struct CurvedPath {
    pub m: f64,
    pub g: f64,
    pub kappa: f64,
}

/// A pendulum whose rod is stated twice, the second time doubled.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[constraint(twin: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0, redundant)]
#[constraint(double: powi(x, 2) + powi(y, 2) == powi(l, 2), redundant)]
#[output(tension = -l*(reaction(rod) + reaction(twin) + 2*reaction(double)))]
#[independent(dot(x))]
pub struct TripleRod {
    pub m: f64,
    pub g: f64,
    pub l: f64,
}

/// Two particles: one prescribed altogether by a row of each level, one free.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(guide: x == sin(w*t))]
#[constraint(rate: dot(y) == w*x)]
#[constraint(lift: ddot(z) == w*dot(y))]
#[output(effort = reaction(guide)*dot(x) + reaction(rate)*dot(y) + reaction(lift)*dot(z), jolt = ddot(z)/2 + t)]
pub struct Prescribed {
    pub m: f64,
    pub g: f64,
    pub w: f64,
}
