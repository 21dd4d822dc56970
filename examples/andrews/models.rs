//! Andrews' squeezing mechanism.

use holonomy::ConstrainedSystem;

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
#[output(
    /// The pin at which the three loops meet.
    pin_x = dot(E2, N.x), pin_y = dot(E2, N.y),
    /// The end of the spring.
    end_x = dot(D, N.x), end_y = dot(D, N.y),
)]
#[independent(dot(beta))]
#[start(beta = -0.0617, theta = 0, gamma = 0.4553, phi = 0.2227, delta = 0.4874, omega = -0.2227, epsilon = 1.2305)]
#[allow(missing_docs)]
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

impl Squeezer {
    /// The parameters of the test set.
    pub const PUBLISHED: Squeezer = Squeezer {
        m1: 0.04325,
        m2: 0.00365,
        m3: 0.02373,
        m4: 0.00706,
        m5: 0.07050,
        m6: 0.00706,
        m7: 0.05498,
        i1: 2.194e-6,
        i2: 4.410e-7,
        i3: 5.255e-6,
        i4: 5.667e-7,
        i5: 1.169e-5,
        i6: 5.667e-7,
        i7: 1.912e-5,
        xa: -0.06934,
        ya: -0.00227,
        xb: -0.03635,
        yb: 0.03273,
        xc: 0.014,
        yc: 0.072,
        d: 0.028,
        da: 0.0115,
        e: 0.02,
        ea: 0.01421,
        zf: 0.02,
        zt: 0.04,
        fa: 0.01421,
        rr: 0.007,
        ra: 0.00092,
        ss: 0.035,
        sa: 0.01874,
        sb: 0.01043,
        sc: 0.018,
        sd: 0.02,
        ta: 0.02308,
        tb: 0.00916,
        u: 0.04,
        ua: 0.01228,
        ub: 0.00449,
        c0: 4530.0,
        l0: 0.07785,
        mom: 0.033,
    };
}
