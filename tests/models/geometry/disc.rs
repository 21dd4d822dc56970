//! Discs that roll on a plane.
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

/// The disk of Blajer (1992), section 6, formulation a: its contact point, and its speeds in the frame of its axis.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[frame(F = rotate(rotate(N, z, phi), x, PI/2 - theta))]
#[frame(D = rotate(F, z, psi))]
#[point(P = O + x*N.x + y*N.y + z*N.z)]
#[point(G = P + r*F.y)]
#[kinematics(
    v1 = dot(velocity(G), F.x),
    v2 = dot(velocity(G), F.y),
    v3 = dot(velocity(G), F.z),
    v4 = dot(angular_velocity(D), F.x),
    v5 = dot(angular_velocity(D), F.y),
    v6 = dot(angular_velocity(D), F.z),
)]
#[body(disk = { frame: D, center: G, mass: m, inertia: diag(j, j, 2*j) })]
#[gravity(-g*N.z)]
#[constraint(no_slip: velocity(P, disk) == 0, expressed = F)]
#[independent(v6, v5, v4)]
pub struct Disk {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(0.125)]
    pub j: f64,
    #[nominal(9.81)]
    pub g: f64,
}
