//! Chaplygin's sleigh.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// Its speeds are those of the blade's point, forward and sideways, and the turning rate.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi)]
#[speeds(u, w, o)]
#[frame(A = rotate(N, z, phi))]
#[point(P = O + x*N.x + y*N.y)]
#[kinematics(u = dot(velocity(P), A.x), w = dot(velocity(P), A.y), o = dot(angular_velocity(A), N.z))]
#[body(sleigh = { frame: A, center: P + a*A.x, mass: m, inertia: planar(i) })]
#[constraint(blade: dot(velocity(P), A.y) == 0)]
#[independent(u, o)]
pub struct BladedSleigh {
    #[nominal(2.5)]
    pub m: f64,
    #[nominal(0.3)]
    pub i: f64,
    #[nominal(0.4)]
    pub a: f64,
}
