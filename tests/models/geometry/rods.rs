//! Chains of uniform rods by families: absolute angles from the direction of gravity.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// Two of them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 2)]
#[coordinates(q[n])]
#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
#[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) } for i in 0..n)]
#[gravity(g*N.x)]
pub struct TwoRods {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Five of them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 5)]
#[coordinates(q[n])]
#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
#[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) } for i in 0..n)]
#[gravity(g*N.x)]
pub struct FiveRods {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Ten of them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 10)]
#[coordinates(q[n])]
#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
#[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) } for i in 0..n)]
#[gravity(g*N.x)]
pub struct TenRods {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Ten of them, eliminated joint by joint though M_d as a whole is quicker.
#[derive(ConstrainedSystem, Clone, Debug)]
#[holonomy(elimination = recursive)]
#[size(n = 10)]
#[coordinates(q[n])]
#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
#[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) } for i in 0..n)]
#[gravity(g*N.x)]
pub struct TenRodsByJoints {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Twenty of them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 20)]
#[coordinates(q[n])]
#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
#[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) } for i in 0..n)]
#[gravity(g*N.x)]
pub struct TwentyRods {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}
