//! Joints in short.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// A bar in space whose end a hinge holds, its axis level.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, e0, e1, e2, e3)]
#[frame(B = spherical(N, e0, e1, e2, e3))]
#[point(G = O + x*N.x + y*N.y + z*N.z)]
#[body(bar = { frame: B, center: G, mass: m, inertia: cuboid(m, l, w, w) })]
#[gravity(-g*N.z)]
#[force(side = { at: G, value: f*N.y })]
#[constraint(hinge: revolute(G - l/2*B.x, O, B.y, N.y))]
#[independent(omega_B_y)]
pub struct Hinged {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(0.1)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(3)]
    pub f: f64,
}

/// The same bar on a rail that rises: it cannot turn.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, e0, e1, e2, e3)]
#[frame(B = spherical(N, e0, e1, e2, e3), R = weld(rotate(N, y, -slope)))]
#[point(G = O + x*N.x + y*N.y + z*N.z)]
#[body(bar = { frame: B, center: G, mass: m, inertia: cuboid(m, l, w, w) })]
#[gravity(-g*N.z)]
#[force(push = { at: G + l/2*B.y, value: f*R.x })]
#[constraint(rail: prismatic(O, G, R.x, B))]
pub struct OnARail {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(0.1)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(3)]
    pub f: f64,
    #[nominal(0.3)]
    pub slope: f64,
}

/// A bar that sticks in a wall, or so it seems: a hinge lets it turn, and a seam does not.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, x, y, z, e0, e1, e2, e3)]
#[frame(A = revolute(N, z, a), B = spherical(N, e0, e1, e2, e3))]
#[point(G = O + x*N.x + y*N.y + z*N.z)]
#[body(arm = { frame: A, center: O, mass: m, inertia: cuboid(m, l, w, w) })]
#[body(bar = { frame: B, center: G, mass: m, inertia: cuboid(m, l, w, w) })]
#[gravity(-g*N.z)]
#[constraint(seam: weld(G - l/2*B.x, O + l/2*A.x, B, A))]
#[independent(dot(a))]
pub struct Seamed {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(0.1)]
    pub w: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Two shafts at an angle, joined by a cross.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b)]
#[frame(A = revolute(N, x, a), B = revolute(weld(rotate(N, z, bend)), x, b))]
#[body(first = { frame: A, center: O - N.x, mass: 1, inertia: cylinder(1, r, 1, x) })]
#[body(second = { frame: B, center: O + B.x, mass: 1, inertia: cylinder(1, r, 1, x) })]
#[constraint(cross: universal(O, O, A.y, B.z))]
#[independent(dot(a))]
#[start(a = 0, b = 0)]
pub struct Cardan {
    #[nominal(0.1)]
    pub r: f64,
    #[nominal(0.5)]
    pub bend: f64,
}

/// A ball on a turntable.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3), T = rotate(N, z, omega*t))]
#[point(G = O + x*N.x + y*N.y + r*N.z)]
#[body(ball = { frame: B, center: G, mass: m, inertia: sphere(m, r) })]
#[body(table = { frame: T, center: O, mass: m, inertia: disk(m, r, z) })]
#[constraint(roll: rolling(G - r*N.z, ball, table))]
#[independent(dot(x), dot(y), omega_B_z)]
pub struct Turntable {
    #[nominal(1)]
    pub m: f64,
    #[nominal(0.1)]
    pub r: f64,
    #[nominal(2)]
    pub omega: f64,
}

/// A four-bar linkage in space: a crank that turns about the vertical, a rocker about a level axis, a rod with a ball at both ends.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, rocker, e0, e1, e2, e3)]
#[frame(A = revolute(N, z, crank), C = revolute(N, x, rocker), B = spherical(A, e0, e1, e2, e3))]
#[point(P = O + a*A.x, Q = P + b*B.x, S = O + d*N.y + c*C.z)]
#[body(crank_bar = { frame: A, center: O + a/2*A.x, mass: m, inertia: rod(m, a, x) })]
#[body(coupler = { frame: B, center: P + b/2*B.x, mass: m, inertia: cylinder(m, w, b, x) })]
#[body(rocker_bar = { frame: C, center: O + d*N.y + c/2*C.z, mass: m, inertia: rod(m, c, z) })]
#[gravity(-g*N.z)]
#[constraint(closing: spherical(Q, S))]
#[independent(dot(crank), omega_B_x)]
#[start(crank = 0.4, rocker = 0.1, e0 = 0.7, e1 = 0, e2 = -0.3, e3 = 0.5)]
pub struct SpatialFourBar {
    #[nominal(0.2)]
    pub a: f64,
    #[nominal(0.9)]
    pub b: f64,
    #[nominal(0.6)]
    pub c: f64,
    #[nominal(0.7)]
    pub d: f64,
    #[nominal(0.05)]
    pub w: f64,
    #[nominal(1)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
}
