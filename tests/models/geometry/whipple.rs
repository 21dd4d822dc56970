//! Whipple's bicycle.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// Rear contact (x, y), yaw, roll, pitch of the steering axis, steer, and the wheels' turns against their frames.
///
/// x ahead, y to the right, z down. `C` is the rear frame, its z axis the steering axis, `E` the front frame. The steering axis lies
/// d1 ahead of the rear hub, d2 along it lies the front hub, d3 ahead of it. The front wheel touches the ground at its lowest point.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, psi, phi, theta, delta, rear, front)]
#[frame(A = rotate(N, z, psi), B = rotate(A, x, phi), C = rotate(B, y, theta), E = rotate(C, z, delta))]
#[frame(R = rotate(C, y, rear), F = rotate(E, y, front))]
#[point(P = O + x*N.x + y*N.y)]
#[point(Hub = P - rr*B.z)]
#[point(FrontHub = Hub + d1*C.x + d2*E.z + d3*E.x)]
#[point(Q = FrontHub + rf*unit(N.z - dot(N.z, E.y)*E.y))]
#[body(rear_wheel = { frame: R, center: Hub, mass: mr, inertia: diag(irx, iry, irx) })]
#[body(rider = {
    frame: C, center: Hub + l1*C.x + l2*C.z, mass: mb, inertia: matrix([ibx, 0, ibxz], [_, iby, 0], [_, _, ibz])
})]
#[body(fork = {
    frame: E, center: FrontHub + l3*E.x + l4*E.z, mass: mh, inertia: matrix([ihx, 0, ihxz], [_, ihy, 0], [_, _, ihz])
})]
#[body(front_wheel = { frame: F, center: FrontHub, mass: mf, inertia: diag(ifx, ify, ifx) })]
#[gravity(g*N.z)]
#[constraint(contact: dot(Q, N.z) == 0)]
#[constraint(rear_roll: velocity(P, rear_wheel) == 0)]
#[constraint(front_roll: velocity(Q, front_wheel) == 0)]
#[independent(dot(phi), dot(delta), dot(rear))]
#[start(theta = 0.3141592653589793)]
pub struct Whipple {
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.3)]
    pub rr: f64,
    #[nominal(0.35)]
    pub rf: f64,
    #[nominal(0.953457)]
    pub d1: f64,
    #[nominal(0.267645)]
    pub d2: f64,
    #[nominal(0.032071)]
    pub d3: f64,
    #[nominal(0.470727)]
    pub l1: f64,
    #[nominal(-0.477929)]
    pub l2: f64,
    #[nominal(-0.005971)]
    pub l3: f64,
    #[nominal(-0.369952)]
    pub l4: f64,
    #[nominal(2)]
    pub mr: f64,
    #[nominal(85)]
    pub mb: f64,
    #[nominal(4)]
    pub mh: f64,
    #[nominal(3)]
    pub mf: f64,
    #[nominal(0.0603)]
    pub irx: f64,
    #[nominal(0.12)]
    pub iry: f64,
    #[nominal(7.17817)]
    pub ibx: f64,
    #[nominal(11)]
    pub iby: f64,
    #[nominal(4.82183)]
    pub ibz: f64,
    #[nominal(3.82255)]
    pub ibxz: f64,
    #[nominal(0.058413)]
    pub ihx: f64,
    #[nominal(0.06)]
    pub ihy: f64,
    #[nominal(0.007587)]
    pub ihz: f64,
    #[nominal(0.009119)]
    pub ihxz: f64,
    #[nominal(0.1405)]
    pub ifx: f64,
    #[nominal(0.28)]
    pub ify: f64,
}
