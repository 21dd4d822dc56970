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

/// Five of them with their last end pinned, once more than needed, driven at the first and damped between the last two; eliminated joint
/// by joint, in two charts.
#[derive(ConstrainedSystem, Clone, Debug)]
#[holonomy(elimination = recursive)]
#[size(n = 5, ends = 6)]
#[coordinates(q[n])]
#[inputs(tau)]
#[frame(L[i] = rotate(N, z, q[i]) for i in 0..n)]
#[point(P[0] = O, P[i] = P[i - 1] + l*L[i - 1].x for i in 1..ends)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: rod(m, l, x) } for i in 0..n)]
#[gravity(g*N.x)]
#[torque(drive = { on: L[0], value: tau*N.z })]
#[damper(last = { of: q[4] - q[3], coefficient: c })]
#[constraint(pin: P[5] == O + 2*l*N.y)]
#[constraint(again: dot(P[5], N.x + N.y) == 2*l, redundant)]
#[release(hook = { point: P[0], along: N.x })]
#[output(held = reaction(hook), pull = reaction(pin_x) + reaction(again))]
#[start(q[0] = 0.2, q[1] = 0.9, q[2] = 1.6, q[3] = 2.2, q[4] = 2.9)]
#[independent(dot(q[0]), dot(q[1]), dot(q[2]))]
#[independent(dot(q[4]), bend = dot(q[2]) - dot(q[1]), dot(q[3]))]
pub struct PinnedRodsByJoints {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(0.1)]
    pub c: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Two rods on balls, the end of the second one held at a distance; eliminated joint by joint.
#[derive(ConstrainedSystem, Clone, Debug)]
#[holonomy(elimination = recursive)]
#[coordinates(a0, a1, a2, a3, b0, b1, b2, b3)]
#[frame(A = quaternion(N, a0, a1, a2, a3), B = quaternion(A, b0, b1, b2, b3))]
#[point(P = O + l*A.z, Q = P + l*B.z)]
#[body(upper = { frame: A, center: O + l/2*A.z, mass: m, inertia: cylinder(m, r, l, z) })]
#[body(lower = { frame: B, center: P + l/2*B.z, mass: m, inertia: cylinder(m, r, l, z) })]
#[gravity(-g*N.z)]
#[constraint(held: dot(Q - 3/2*l*N.x, Q - 3/2*l*N.x) == powi(l, 2))]
#[start(a0 = 0.9, a1 = 0.1, a2 = 0.4, a3 = 0.2, b0 = 0.8, b1 = 0.3, b2 = 0.5, b3 = 0.1)]
pub struct HeldRodsByJoints {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(0.1)]
    pub r: f64,
    #[nominal(9.81)]
    pub g: f64,
}
