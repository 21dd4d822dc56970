//! Systems stated by their energies: M, and the terms of h* that are quadratic in the velocities, follow.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// Chaplygin's sleigh in body components, by its energy.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi)]
#[speeds(u, w, o)]
#[kinematics(
    u = dot(x)*cos(phi) + dot(y)*sin(phi),
    w = -dot(x)*sin(phi) + dot(y)*cos(phi),
    o = dot(phi),
)]
#[kinetic_energy(m/2*(powi(u, 2) + powi(w + a*o, 2)) + i/2*powi(o, 2))]
#[constraint(blade: w == 0)]
#[independent(u, o)]
pub struct SleighByEnergy {
    #[nominal(2.5)]
    pub m: f64,
    #[nominal(0.3)]
    pub i: f64,
    #[nominal(0.4)]
    pub a: f64,
}

/// The rolling disk of section 6 by its energies: (6.9) and (6.10) follow.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[inertia(diag(m, m, m, j, j, 2*j))]
#[kinetic_energy(
    m/2*(powi(v1, 2) + powi(v2, 2) + powi(v3, 2)) + j/2*(powi(v4, 2) + powi(v5, 2) + 2*powi(v6, 2))
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
#[constraint(no_slip_along: v1 + r*v6 == 0)]
#[constraint(no_slip_across: v2 == 0)]
#[constraint(contact: v3 - r*v4 == 0)]
#[independent(v6, v5, v4)]
pub struct RollingDiskByEnergy {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(0.125)]
    pub j: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// A heavy body about a fixed point: Euler's angles 3-1-3 and the body's angular velocity, the weight at (0, 0, l) in it.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(psi, theta, phi)]
#[speeds(w1, w2, w3)]
#[kinematics(
    w1 = dot(psi)*sin(theta)*sin(phi) + dot(theta)*cos(phi),
    w2 = dot(psi)*sin(theta)*cos(phi) - dot(theta)*sin(phi),
    w3 = dot(psi)*cos(theta) + dot(phi),
)]
#[kinetic_energy((j1*powi(w1, 2) + j2*powi(w2, 2) + j3*powi(w3, 2))/2)]
#[potential_energy(m*g*l*cos(theta))]
#[forces(-d*w1, -d*w2, -d*w3)]
pub struct HeavyBody {
    #[nominal(0.9)]
    pub j1: f64,
    #[nominal(0.7)]
    pub j2: f64,
    #[nominal(0.4)]
    pub j3: f64,
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.3)]
    pub l: f64,
    #[nominal(0.2)]
    pub d: f64,
}

/// A bead on a rod that is turned at the rate W in a vertical plane, by the energy in the rod's frame: T has terms without
/// the speed and V depends on the time (P2).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(rho)]
#[kinetic_energy(m/2*(powi(dot(rho), 2) + powi(w*rho, 2)))]
#[potential_energy(m*g*rho*sin(w*t))]
pub struct BeadByEnergy {
    #[nominal(1.3)]
    pub m: f64,
    #[nominal(0.8)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The same bead in the plane with the rod as a constraint, in a frame that turns with it: A and a0 depend on the time.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[speeds(along, across)]
#[kinematics(
    dot(x) = cos(w*t)*along - sin(w*t)*across - w*y,
    dot(y) = sin(w*t)*along + cos(w*t)*across + w*x,
)]
#[kinetic_energy(m/2*(powi(dot(x), 2) + powi(dot(y), 2)))]
#[potential_energy(m*g*y)]
#[constraint(rod: y*cos(w*t) - x*sin(w*t) == 0)]
#[independent(along)]
pub struct BeadInFrame {
    #[nominal(1.3)]
    pub m: f64,
    #[nominal(0.8)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The double pendulum (P16) by its energies, in the angles.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a1, a2)]
#[kinetic_energy(
    (m1 + m2)/2*powi(l1*dot(a1), 2) + m2/2*powi(l2*dot(a2), 2) + m2*l1*l2*cos(a1 - a2)*dot(a1)*dot(a2)
)]
#[potential_energy(-(m1 + m2)*g*l1*cos(a1) - m2*g*l2*cos(a2))]
pub struct DoublePendulumByEnergy {
    #[nominal(1.2)]
    pub m1: f64,
    #[nominal(0.8)]
    pub m2: f64,
    #[nominal(0.7)]
    pub l1: f64,
    #[nominal(0.5)]
    pub l2: f64,
    #[nominal(9.81)]
    pub g: f64,
}
