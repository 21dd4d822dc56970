//! A disc that rolls on a plane.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// The published disc: centre, orientation Rz(yaw) Rx(lean) Ry(spin), angular velocity in the leaned frame.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(cx, cy, cz, yaw, lean, spin)]
#[speeds(vx, vy, vz, w1, w2, w3)]
#[frame(L = rotate(rotate(N, z, yaw), x, lean))]
#[frame(D = rotate(L, y, spin))]
#[point(C = O + cx*N.x + cy*N.y + cz*N.z)]
#[point(K = C - r*L.z)]
#[define(w = angular_velocity(D))]
#[kinematics(vx = dot(cx), vy = dot(cy), vz = dot(cz), w1 = dot(w, L.x), w2 = dot(w, L.y), w3 = dot(w, L.z))]
#[body(disc = { frame: D, center: C, mass: m, inertia: diag(d, a, d) })]
#[gravity(-g*N.z)]
#[constraint(height: dot(K, N.z) == 0)]
#[constraint(slip: velocity(K, disc) == 0)]
#[independent(w1, w2, w3)]
pub struct Disc {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(9.81)]
    pub g: f64,
    /// Moment of inertia about a diameter.
    #[nominal(0.125)]
    pub d: f64,
    /// Moment of inertia about the axis.
    #[nominal(0.25)]
    pub a: f64,
}
