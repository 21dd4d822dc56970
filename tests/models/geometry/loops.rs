//! Closed loops in the plane: bodies, joints as vector equations, nothing else.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// A four-bar of uniform rods, a torque on the crank.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3)]
#[frame(A = rotate(N, z, q1), B = rotate(N, z, q2), C = rotate(N, z, q3))]
#[point(P = O + l1*A.x, Q = P + l2*B.x, G = O + d*N.x, S = G + l3*C.x)]
#[body(
    crank = { frame: A, center: O + l1/2*A.x, mass: m1, inertia: rod(m1, l1, x) },
    coupler = { frame: B, center: P + l2/2*B.x, mass: m2, inertia: rod(m2, l2, x) },
    rocker = { frame: C, center: G + l3/2*C.x, mass: m3, inertia: rod(m3, l3, x) },
)]
#[gravity(-g*N.y)]
#[torque(drive = { on: A, value: tau*N.z })]
#[constraint(closure: Q == S)]
#[independent(dot(q1))]
#[start(q1 = 0.1, q2 = 0.6, q3 = 1.9)]
pub struct FourBarOfRods {
    #[nominal(0.5)]
    pub l1: f64,
    #[nominal(1.8)]
    pub l2: f64,
    #[nominal(1.2)]
    pub l3: f64,
    #[nominal(2)]
    pub d: f64,
    #[nominal(0.5)]
    pub m1: f64,
    #[nominal(1.8)]
    pub m2: f64,
    #[nominal(1.2)]
    pub m3: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(2)]
    pub tau: f64,
}

/// Andrews' squeezing mechanism: seven bodies by the angles of the test set, three loops that meet at one pin, a spring, a motor.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(beta, theta, gamma, phi, delta, omega, epsilon)]
#[frame(K1 = rotate(N, z, beta), K2 = rotate(K1, z, theta), K3 = rotate(N, z, gamma), K5 = rotate(N, z, delta))]
#[frame(K4 = rotate(K5, z, phi), K7 = rotate(N, z, epsilon), K6 = rotate(K7, z, omega))]
#[point(A = O + xa*N.x + ya*N.y, B = O + xb*N.x + yb*N.y, C = O + xc*N.x + yc*N.y)]
#[point(P = O + rr*K1.x, D = B + sd*K3.x - sc*K3.y, F = A + zt*K5.x, H = A - u*K7.y)]
#[point(E2 = P - d*K2.x, E3 = B - ss*K3.y, E4 = F - e*K4.y, E6 = H + zf*K6.x)]
#[body(
    k1 = { frame: K1, center: O + ra*K1.x, mass: m1, inertia: planar(i1) },
    k2 = { frame: K2, center: P - da*K2.x, mass: m2, inertia: planar(i2) },
    k3 = { frame: K3, center: B + sb*K3.x - sa*K3.y, mass: m3, inertia: planar(i3) },
    k4 = { frame: K4, center: F - (e - ea)*K4.y, mass: m4, inertia: planar(i4) },
    k5 = { frame: K5, center: A + ta*K5.x + tb*K5.y, mass: m5, inertia: planar(i5) },
    k6 = { frame: K6, center: H + (zf - fa)*K6.x, mass: m6, inertia: planar(i6) },
    k7 = { frame: K7, center: A - ub*K7.x - ua*K7.y, mass: m7, inertia: planar(i7) },
)]
#[torque(drive = { on: K1, value: mom*N.z })]
#[spring(pull = { from: C, to: D, stiffness: c0, length: l0 })]
#[constraint(b: E2 == E3)]
#[constraint(delta_tip: E2 == E4)]
#[constraint(epsilon_tip: E2 == E6)]
#[independent(dot(beta))]
#[start(beta = -0.0617, theta = 0, gamma = 0.4553, phi = 0.2227, delta = 0.4874, omega = -0.2227, epsilon = 1.2305)]
pub struct Squeezer {
    #[nominal(0.04325)]
    pub m1: f64,
    #[nominal(0.00365)]
    pub m2: f64,
    #[nominal(0.02373)]
    pub m3: f64,
    #[nominal(0.00706)]
    pub m4: f64,
    #[nominal(0.07050)]
    pub m5: f64,
    #[nominal(0.00706)]
    pub m6: f64,
    #[nominal(0.05498)]
    pub m7: f64,
    #[nominal(2.194e-6)]
    pub i1: f64,
    #[nominal(4.410e-7)]
    pub i2: f64,
    #[nominal(5.255e-6)]
    pub i3: f64,
    #[nominal(5.667e-7)]
    pub i4: f64,
    #[nominal(1.169e-5)]
    pub i5: f64,
    #[nominal(5.667e-7)]
    pub i6: f64,
    #[nominal(1.912e-5)]
    pub i7: f64,
    #[nominal(-0.06934)]
    pub xa: f64,
    #[nominal(-0.00227)]
    pub ya: f64,
    #[nominal(-0.03635)]
    pub xb: f64,
    #[nominal(0.03273)]
    pub yb: f64,
    #[nominal(0.014)]
    pub xc: f64,
    #[nominal(0.072)]
    pub yc: f64,
    #[nominal(0.028)]
    pub d: f64,
    #[nominal(0.0115)]
    pub da: f64,
    #[nominal(0.02)]
    pub e: f64,
    #[nominal(0.01421)]
    pub ea: f64,
    #[nominal(0.02)]
    pub zf: f64,
    #[nominal(0.04)]
    pub zt: f64,
    #[nominal(0.01421)]
    pub fa: f64,
    #[nominal(0.007)]
    pub rr: f64,
    #[nominal(0.00092)]
    pub ra: f64,
    #[nominal(0.035)]
    pub ss: f64,
    #[nominal(0.01874)]
    pub sa: f64,
    #[nominal(0.01043)]
    pub sb: f64,
    #[nominal(0.018)]
    pub sc: f64,
    #[nominal(0.02)]
    pub sd: f64,
    #[nominal(0.02308)]
    pub ta: f64,
    #[nominal(0.00916)]
    pub tb: f64,
    #[nominal(0.04)]
    pub u: f64,
    #[nominal(0.01228)]
    pub ua: f64,
    #[nominal(0.00449)]
    pub ub: f64,
    #[nominal(4530)]
    pub c0: f64,
    #[nominal(0.07785)]
    pub l0: f64,
    #[nominal(0.033)]
    pub mom: f64,
}

/// A slider-crank whose crank and rod are equally long; the rod at the angle beta below the x axis.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(alpha, beta, x)]
#[frame(A = rotate(N, z, alpha), B = rotate(N, -z, beta))]
#[point(P = O + l*A.x, S = O + x*N.x)]
#[body(
    crank = { frame: A, center: O + l/2*A.x, mass: m1, inertia: rod(m1, l, x) },
    rod = { frame: B, center: P + l/2*B.x, mass: m2, inertia: rod(m2, l, x) },
)]
#[particle(slider = { at: S, mass: m3 })]
#[gravity(-g*N.y)]
#[constraint(closure: P + l*B.x == S)]
#[independent(dot(alpha))]
#[start(alpha = 0.5, beta = 0.5, x = 1.755)]
pub struct CrankAndSlider {
    #[nominal(1)]
    pub l: f64,
    #[nominal(1)]
    pub m1: f64,
    #[nominal(1)]
    pub m2: f64,
    #[nominal(2)]
    pub m3: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Two masses on springs, joined by a massless axle; the road moves the right foot, and the wheel base stays at right angles to the
/// left spring. Both rows depend on time.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(xl, yl, xr, yr)]
#[define(k = m*powi(eps, 2)/2, yb = r*sin(w*t))]
#[point(L = O + xl*N.x + yl*N.y, R = O + xr*N.x + yr*N.y, Foot = O + sqrt(powi(l, 2) - powi(yb, 2))*N.x + yb*N.y)]
#[particle(left = { at: L, mass: k }, right = { at: R, mass: k })]
#[gravity(-g*N.y)]
#[spring(
    left_spring = { from: O, to: L, stiffness: 1, length: l0 },
    right_spring = { from: Foot, to: R, stiffness: 1, length: l0 },
)]
#[constraint(foot: dot(L, Foot) == 0)]
#[constraint(axle: dot(L - R, L - R) == powi(l, 2))]
#[independent(dot(yl), dot(yr))]
#[start(xl = 0, yl = 0.5, xr = 1, yr = 0.5)]
pub struct Axle {
    #[nominal(0.01)]
    pub eps: f64,
    #[nominal(10)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(0.5)]
    pub l0: f64,
    #[nominal(0.1)]
    pub r: f64,
    #[nominal(10)]
    pub w: f64,
    #[nominal(1)]
    pub g: f64,
}

/// Bricard's mechanism as one says it: five rods on five hinges, the sixth of which closes the loop. One of its rows says nothing new
/// wherever it is closed; that is found at the start.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 6)]
#[coordinates(a1, a2, a3, a4, a5)]
#[frame(A = revolute(N, y, a1), B = revolute(A, z, a2), C = revolute(B, x, a3), D = revolute(C, y, a4))]
#[frame(E = revolute(D, z, a5))]
#[point(J[0] = O, J[1] = J[0] + l*A.x, J[2] = J[1] - l*B.y, J[3] = J[2] + l*C.z, J[4] = J[3] - l*D.x, J[5] = J[4] + l*E.y)]
#[body(
    first = { frame: A, center: J[0] + l/2*A.x, mass: m, inertia: cuboid(m, l, b, b) },
    second = { frame: B, center: J[1] - l/2*B.y, mass: m, inertia: cuboid(m, b, l, b) },
    third = { frame: C, center: J[2] + l/2*C.z, mass: m, inertia: cuboid(m, b, b, l) },
    fourth = { frame: D, center: J[3] - l/2*D.x, mass: m, inertia: cuboid(m, l, b, b) },
    fifth = { frame: E, center: J[4] + l/2*E.y, mass: m, inertia: cuboid(m, b, l, b) },
)]
#[gravity(-g*N.y)]
#[constraint(sixth: revolute(J[5], O + l*N.z, E.x, N.x), redundant)]
#[independent(dot(a1))]
#[start(a1 = 0.5, a2 = -0.33, a3 = 0.5, a4 = -0.33, a5 = 0.5)]
pub struct SixHinges {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(0.1)]
    pub b: f64,
    #[nominal(9.81)]
    pub g: f64,
}
