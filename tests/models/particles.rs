//! Particles with exact solutions: pendulums, a bead on a turning rod, Atwood's machine.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// A pendulum in x, y, with the complement of its rod: (x', y') = (-y, x) u, so that u is the angular velocity.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[complement(swing = [-y, x])]
#[output(tension = -l*reaction(rod), height = y + l)]
pub struct Pendulum {
    #[nominal(1.5)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The same pendulum in the chart of its horizontal velocity, which ends where the rod is level.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x))]
#[start(x = 0.1, y = -0.79)]
#[define(speed = sqrt(powi(dot(x), 2) + powi(dot(y), 2)))]
#[output(speed, tension = -l*reaction(rod), steepness = dot(y)/dot(x))]
pub struct HangingPendulum {
    #[nominal(1.5)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The same pendulum by its angle (4.2), the rod kept for its force.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[potential_energy(m*g*y)]
#[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[output(tension = -l*reaction(rod), momentum = m*powi(l, 2)*dot(alpha), torque = m*powi(l, 2)*ddot(alpha), y = m*ddot(y))]
pub struct PendulumByAngle {
    #[nominal(1.5)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// A bead on a rod that turns at the rate w in a vertical plane: a position row that depends on time.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(rod: y*cos(w*t) - x*sin(w*t) == 0)]
#[complement(along = [cos(w*t), sin(w*t)])]
#[output(
    /// From the pivot to the bead.
    distance = x*cos(w*t) + y*sin(w*t),
    /// What turns the rod.
    torque = distance*reaction(rod),
)]
pub struct BeadOnRod {
    #[nominal(0.7)]
    pub m: f64,
    #[nominal(1.25)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The same bead by its distance from the pivot: a configuration that depends on time.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[configuration(of(rho), x = rho*cos(w*t), y = rho*sin(w*t))]
#[constraint(rod: y*cos(w*t) - x*sin(w*t) == 0)]
pub struct BeadByDistance {
    #[nominal(0.7)]
    pub m: f64,
    #[nominal(1.25)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// A particle on a sphere and on a horizontal plane below its centre: the conical pendulum.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(sphere: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(r, 2))/2 == 0)]
#[constraint(plane: z == -r*cos(opening))]
#[complement(turn = [-y, x, 0])]
pub struct ConicalPendulum {
    #[nominal(1.2)]
    pub m: f64,
    #[nominal(2.0)]
    pub r: f64,
    #[nominal(0.6)]
    pub opening: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Two masses on a string over a pulley.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(y1, y2)]
#[inertia(diag(m1, m2))]
#[forces(-m1*g, -m2*g)]
#[potential_energy(m1*g*y1 + m2*g*y2)]
#[constraint(string: y1 + y2 == c)]
#[independent(dot(y1))]
#[output(tension = reaction(string), gain = ddot(y1)/g, bound = if tension < m1*g { tension } else { m1*g })]
pub struct Atwood {
    #[nominal(2.0)]
    pub m1: f64,
    #[nominal(3.5)]
    pub m2: f64,
    #[nominal(-4.0)]
    pub c: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Two pendulums in a row, four Cartesian coordinates by two absolute angles.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, y1, x2, y2)]
#[inertia(diag(m1, m1, m2, m2))]
#[forces(0, -m1*g, 0, -m2*g)]
#[potential_energy(m1*g*y1 + m2*g*y2)]
#[configuration(
    of(a1, a2),
    x1 = l1*sin(a1),
    y1 = -l1*cos(a1),
    x2 = l1*sin(a1) + l2*sin(a2),
    y2 = -l1*cos(a1) - l2*cos(a2),
)]
#[constraint(upper: (powi(x1, 2) + powi(y1, 2) - powi(l1, 2))/2 == 0)]
#[constraint(lower: (powi(x2 - x1, 2) + powi(y2 - y1, 2) - powi(l2, 2))/2 == 0)]
pub struct DoublePendulum {
    #[nominal(2.0)]
    pub m1: f64,
    #[nominal(1.25)]
    pub m2: f64,
    #[nominal(0.9)]
    pub l1: f64,
    #[nominal(0.6)]
    pub l2: f64,
    #[nominal(9.81)]
    pub g: f64,
}
