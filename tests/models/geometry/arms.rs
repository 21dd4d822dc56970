//! An open chain in space.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// An arm with seven joints, in the modified frames (Craig): joint i turns about the z axis of frame i; a motor turns each link
/// against the one before it.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q[7])]
#[inputs(tau[7])]
#[frame(
    F1 = rotate(N, z, q[0]),
    F2 = rotate(rotate(F1, x, -PI/2), z, q[1]),
    F3 = rotate(rotate(F2, x, PI/2), z, q[2]),
    F4 = rotate(rotate(F3, x, PI/2), z, q[3]),
    F5 = rotate(rotate(F4, x, -PI/2), z, q[4]),
    F6 = rotate(rotate(F5, x, PI/2), z, q[5]),
    F7 = rotate(rotate(F6, x, PI/2), z, q[6]),
)]
#[point(
    P1 = O + 0.333*F1.z,
    P2 = P1,
    P3 = P2 + 0.316*F3.z,
    P4 = P3 + 0.0825*F3.x,
    P5 = P4 - 0.0825*F4.x + 0.384*F5.z,
    P6 = P5,
    P7 = P6 + 0.088*F6.x,
)]
#[body(
    link1 = { frame: F1, center: P1 - 0.03*F1.y - 0.12*F1.z, mass: 3.0, inertia: diag(0.03, 0.028, 0.01) },
    link2 = { frame: F2, center: P2 - 0.07*F2.y + 0.03*F2.z, mass: 3.0, inertia: diag(0.028, 0.011, 0.026) },
    link3 = { frame: F3, center: P3 + 0.04*F3.x + 0.03*F3.y - 0.06*F3.z, mass: 2.5, inertia: diag(0.02, 0.018, 0.009) },
    link4 = { frame: F4, center: P4 - 0.04*F4.x + 0.05*F4.y + 0.02*F4.z, mass: 2.5, inertia: diag(0.018, 0.009, 0.019) },
    link5 = { frame: F5, center: P5 + 0.04*F5.y - 0.12*F5.z, mass: 2.0, inertia: diag(0.022, 0.02, 0.006) },
    link6 = { frame: F6, center: P6 + 0.05*F6.x + 0.01*F6.y + 0.01*F6.z, mass: 1.5, inertia: diag(0.005, 0.007, 0.008) },
    link7 = { frame: F7, center: P7 + 0.01*F7.x + 0.08*F7.z, mass: 0.7, inertia: diag(0.002, 0.0025, 0.0015) },
)]
#[gravity(-g*N.z)]
#[torque(
    motor1 = { on: link1, value: tau[0]*F1.z },
    motor2 = { on: link2, value: tau[1]*F2.z, from: link1 },
    motor3 = { on: link3, value: tau[2]*F3.z, from: link2 },
    motor4 = { on: link4, value: tau[3]*F4.z, from: link3 },
    motor5 = { on: link5, value: tau[4]*F5.z, from: link4 },
    motor6 = { on: link6, value: tau[5]*F6.z, from: link5 },
    motor7 = { on: link7, value: tau[6]*F7.z, from: link6 },
)]
pub struct SevenJoints {
    #[nominal(9.81)]
    pub g: f64,
}
