//! Mechanisms with closed loops: the car axis, a four-bar, Andrews' squeezing mechanism, a slider-crank of equal lengths.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// Two masses on springs, joined by a massless axle; the right foot (xb, yb) is driven, so both rows depend on time.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(xl, yl, xr, yr)]
#[define(
    k = m*powi(eps, 2)/2,
    yb = r*sin(w*t),
    xb = sqrt(powi(l, 2) - powi(yb, 2)),
    left = sqrt(powi(xl, 2) + powi(yl, 2)),
    right = sqrt(powi(xr - xb, 2) + powi(yr - yb, 2)),
)]
#[inertia(diag(k, k, k, k))]
#[forces(
    (l0 - left)*xl/left,
    (l0 - left)*yl/left - k*g,
    (l0 - right)*(xr - xb)/right,
    (l0 - right)*(yr - yb)/right - k*g,
)]
#[constraint(foot: xb*xl + yb*yl == 0)]
#[constraint(axle: powi(xl - xr, 2) + powi(yl - yr, 2) - powi(l, 2) == 0)]
#[independent(dot(yl), dot(yr))]
#[start(xl = 0, yl = 0.5, xr = 1, yr = 0.5)]
pub struct CarAxis {
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

/// A four-bar of uniform rods with absolute angles, a torque on the crank.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3)]
#[define(h = m2*l1*l2/2)]
#[inertia(matrix(
    [(m1/3 + m2)*powi(l1, 2), h*cos(q1 - q2), 0],
    [_, m2*powi(l2, 2)/3, 0],
    [_, _, m3*powi(l3, 2)/3],
))]
#[forces(
    tau - g*(m1/2 + m2)*l1*cos(q1) - h*sin(q1 - q2)*powi(dot(q2), 2),
    h*sin(q1 - q2)*powi(dot(q1), 2) - g*m2*l2/2*cos(q2),
    -g*m3*l3/2*cos(q3),
)]
#[potential_energy(g*((m1/2 + m2)*l1*sin(q1) + m2*l2/2*sin(q2) + m3*l3/2*sin(q3)) - tau*q1)]
#[constraint(loop_x: l1*cos(q1) + l2*cos(q2) - l3*cos(q3) == d)]
#[constraint(loop_y: l1*sin(q1) + l2*sin(q2) - l3*sin(q3) == 0)]
#[independent(dot(q1))]
#[start(q1 = 0.1, q2 = 0.6, q3 = 1.9)]
pub struct FourBar {
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

/// A slider-crank whose crank and rod are equally long; the rod at the angle beta below the x axis.
///
/// With T = (m1/3 + m2) l² alpha'²/2 + m2 l²/6 beta'² - m2 l²/2 cos(alpha + beta) alpha' beta' + m3 x'²/2 by Lagrange's equations.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(alpha, beta, x)]
#[define(h = m2*powi(l, 2)/2)]
#[inertia(matrix(
    [(m1/3 + m2)*powi(l, 2), -h*cos(alpha + beta), 0],
    [_, m2*powi(l, 2)/3, 0],
    [_, _, m3],
))]
#[forces(
    -h*sin(alpha + beta)*powi(dot(beta), 2) - g*(m1/2 + m2)*l*cos(alpha),
    -h*sin(alpha + beta)*powi(dot(alpha), 2) + g*m2*l/2*cos(beta),
    0,
)]
#[potential_energy(g*((m1/2 + m2)*l*sin(alpha) - m2*l/2*sin(beta)))]
#[constraint(loop_x: l*cos(alpha) + l*cos(beta) - x == 0)]
#[constraint(loop_y: l*sin(alpha) - l*sin(beta) == 0)]
#[independent(dot(alpha))]
#[start(alpha = 0.5, beta = 0.5, x = 1.755)]
pub struct SliderCrank {
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

/// The same on the branch on which the rod stays parallel to the crank's mirror image: there the motion is regular, and only the
/// reactions are lost where the crank stands upright, since the rows depend on each other.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(alpha, beta, x)]
#[define(h = m2*powi(l, 2)/2)]
#[inertia(matrix(
    [(m1/3 + m2)*powi(l, 2), -h*cos(alpha + beta), 0],
    [_, m2*powi(l, 2)/3, 0],
    [_, _, m3],
))]
#[forces(
    -h*sin(alpha + beta)*powi(dot(beta), 2) - g*(m1/2 + m2)*l*cos(alpha),
    -h*sin(alpha + beta)*powi(dot(alpha), 2) + g*m2*l/2*cos(beta),
    0,
)]
#[potential_energy(g*((m1/2 + m2)*l*sin(alpha) - m2*l/2*sin(beta)))]
#[constraint(loop_x: l*cos(alpha) + l*cos(beta) - x == 0)]
#[constraint(loop_y: l*sin(alpha) - l*sin(beta) == 0)]
#[configuration(beta = alpha, x = 2*l*cos(alpha))]
pub struct SliderCrankOnBranch {
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

/// Andrews' squeezing mechanism: M, the forces and the loops as the test set for initial value problems prints them, λ with the
/// other sign.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(beta, theta, gamma, phi, delta, omega, epsilon)]
#[define(
    ee = e - ea,
    fz = zf - fa,
    xd = sd*cos(gamma) + sc*sin(gamma) + xb,
    yd = sd*sin(gamma) - sc*cos(gamma) + yb,
    length = sqrt(powi(xd - xc, 2) + powi(yd - yc, 2)),
    pull = -c0*(length - l0)/length,
    fx = pull*(xd - xc),
    fy = pull*(yd - yc),
    tip_x = rr*cos(beta) - d*cos(beta + theta),
    tip_y = rr*sin(beta) - d*sin(beta + theta),
)]
#[inertia(matrix(
    [
        m1*powi(ra, 2) + m2*(powi(rr, 2) - 2*da*rr*cos(theta) + powi(da, 2)) + i1 + i2,
        m2*(powi(da, 2) - da*rr*cos(theta)) + i2, 0, 0, 0, 0, 0
    ],
    [_, m2*powi(da, 2) + i2, 0, 0, 0, 0, 0],
    [_, _, m3*(powi(sa, 2) + powi(sb, 2)) + i3, 0, 0, 0, 0],
    [_, _, _, m4*powi(ee, 2) + i4, m4*(powi(ee, 2) + zt*ee*sin(phi)) + i4, 0, 0],
    [
        _, _, _, _,
        m4*(powi(zt, 2) + 2*zt*ee*sin(phi) + powi(ee, 2)) + m5*(powi(ta, 2) + powi(tb, 2)) + i4 + i5, 0, 0
    ],
    [_, _, _, _, _, m6*powi(fz, 2) + i6, m6*(powi(fz, 2) - u*fz*sin(omega)) + i6],
    [
        _, _, _, _, _, _,
        m6*(powi(fz, 2) - 2*u*fz*sin(omega) + powi(u, 2)) + m7*(powi(ua, 2) + powi(ub, 2)) + i6 + i7
    ],
))]
#[forces(
    mom - m2*da*rr*dot(theta)*(dot(theta) + 2*dot(beta))*sin(theta),
    m2*da*rr*powi(dot(beta), 2)*sin(theta),
    fx*(sc*cos(gamma) - sd*sin(gamma)) + fy*(sd*cos(gamma) + sc*sin(gamma)),
    m4*zt*ee*powi(dot(delta), 2)*cos(phi),
    -m4*zt*ee*dot(phi)*(dot(phi) + 2*dot(delta))*cos(phi),
    -m6*u*fz*powi(dot(epsilon), 2)*cos(omega),
    m6*u*fz*dot(omega)*(dot(omega) + 2*dot(epsilon))*cos(omega),
)]
#[potential_energy(c0*powi(length - l0, 2)/2 - mom*beta)]
#[constraint(b_x: tip_x == xb + ss*sin(gamma))]
#[constraint(b_y: tip_y == yb - ss*cos(gamma))]
#[constraint(delta_x: tip_x == xa + zt*cos(delta) + e*sin(phi + delta))]
#[constraint(delta_y: tip_y == ya + zt*sin(delta) - e*cos(phi + delta))]
#[constraint(epsilon_x: tip_x == xa + u*sin(epsilon) + zf*cos(omega + epsilon))]
#[constraint(epsilon_y: tip_y == ya - u*cos(epsilon) + zf*sin(omega + epsilon))]
#[independent(dot(beta))]
#[start(beta = -0.0617, theta = 0, gamma = 0.4553, phi = 0.2227, delta = 0.4874, omega = -0.2227, epsilon = 1.2305)]
pub struct Andrews {
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
