//! A body with one fixed point.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// The heavy top by its mass centre and the angles of R = Rx(a) Rz(b) Ry(c); the mass centre lies on the body's y axis.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, a, b, c)]
#[speeds(vx, vy, vz, w1, w2, w3)]
#[frame(T = rotate(rotate(rotate(N, x, a), z, b), y, c))]
#[point(C = O + x*N.x + y*N.y + z*N.z)]
#[point(Pivot = C - l*T.y)]
#[define(w = angular_velocity(T))]
#[kinematics(vx = dot(x), vy = dot(y), vz = dot(z), w1 = dot(w, T.x), w2 = dot(w, T.y), w3 = dot(w, T.z))]
#[body(top = { frame: T, center: C, mass: m, inertia: diag(j1, j2, j3) })]
#[gravity(-g*N.z)]
#[constraint(pivot: Pivot == O)]
#[independent(w1, w2, w3)]
pub struct PivotedTop {
    #[nominal(15)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.234375)]
    pub j1: f64,
    #[nominal(0.46875)]
    pub j2: f64,
    #[nominal(0.234375)]
    pub j3: f64,
    #[nominal(1)]
    pub l: f64,
}
