//! Bodies in space and chains: a heavy top with its pivot, the flyball governor, pendulums in a row.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// A body with one fixed point, by its mass centre, the angles of R = Rx(a) Rz(b) Ry(c), and its angular velocity in body axes.
///
/// The mass centre lies on the body's y axis at the distance l from the pivot: at l (-sin b, cos b cos a, cos b sin a). The angles
/// fail where that axis lies along x, where cos b vanishes. λ is the pivot's force.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, a, b, c)]
#[speeds(vx, vy, vz, w1, w2, w3)]
#[kinematics(
    vx = dot(x),
    vy = dot(y),
    vz = dot(z),
    w1 = dot(a)*cos(b)*cos(c) - dot(b)*sin(c),
    w2 = dot(c) - dot(a)*sin(b),
    w3 = dot(a)*cos(b)*sin(c) + dot(b)*cos(c),
)]
#[inertia(diag(m, m, m, j1, j2, j3))]
#[forces(0, 0, -m*g, (j2 - j3)*w2*w3, (j3 - j1)*w3*w1, (j1 - j2)*w1*w2)]
#[potential_energy(m*g*z)]
#[constraint(pivot_x: x == -l*sin(b))]
#[constraint(pivot_y: y == l*cos(b)*cos(a))]
#[constraint(pivot_z: z == l*cos(b)*sin(a))]
#[independent(w1, w2, w3)]
pub struct HeavyTop {
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

/// The flyball governor of the benchmark library: shaft angle, height of the slider, the angles of the two rods.
///
/// The shaft's angular momentum is `turning`·ph', and `g1`, `g2` are the halves of the derivatives of `turning` by the rod angles.
/// Each rod's middle hangs on a spring and damper at the slider, of length `d1`, `d2`.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(ph, s, a1, a2)]
#[define(
    jt = m_rod*(powi(w_rod, 2) + powi(l_rod, 2))/12,
    jl = m_rod*powi(w_rod, 2)/6,
    rod = m_rod*powi(l_rod, 2)/4 + jt + m_ball*powi(l_rod, 2),
    about1 = m_rod*powi(off + l_rod/2*sin(a1), 2) + jl*powi(cos(a1), 2) + jt*powi(sin(a1), 2)
        + m_ball*powi(off + l_rod*sin(a1), 2),
    about2 = m_rod*powi(off + l_rod/2*sin(a2), 2) + jl*powi(cos(a2), 2) + jt*powi(sin(a2), 2)
        + m_ball*powi(off + l_rod*sin(a2), 2),
    turning = m_rod*powi(w_rod, 2)/6 + m_slider*powi(b_slider, 2)/6 + about1 + about2,
    g1 = (m_rod*(off + l_rod/2*sin(a1))*l_rod/2 + (jt - jl)*sin(a1) + m_ball*(off + l_rod*sin(a1))*l_rod)*cos(a1),
    g2 = (m_rod*(off + l_rod/2*sin(a2))*l_rod/2 + (jt - jl)*sin(a2) + m_ball*(off + l_rod*sin(a2))*l_rod)*cos(a2),
    d1 = sqrt(powi(l_rod/2*sin(a1), 2) + powi(l_rod - s - l_rod/2*cos(a1), 2)),
    d2 = sqrt(powi(l_rod/2*sin(a2), 2) + powi(l_rod - s - l_rod/2*cos(a2), 2)),
    by_a1 = l_rod/2*sin(a1)*(l_rod - s)/d1,
    by_a2 = l_rod/2*sin(a2)*(l_rod - s)/d2,
    by_s1 = -(l_rod - s - l_rod/2*cos(a1))/d1,
    by_s2 = -(l_rod - s - l_rod/2*cos(a2))/d2,
    pull1 = k*(d1 - l0) + cd*(by_a1*dot(a1) + by_s1*dot(s)),
    pull2 = k*(d2 - l0) + cd*(by_a2*dot(a2) + by_s2*dot(s)),
    weight = (m_rod/2 + m_ball)*g*l_rod,
)]
#[inertia(diag(turning, m_slider, rod, rod))]
#[forces(
    -2*dot(ph)*(g1*dot(a1) + g2*dot(a2)),
    -m_slider*g - pull1*by_s1 - pull2*by_s2,
    g1*powi(dot(ph), 2) - weight*sin(a1) - pull1*by_a1,
    g2*powi(dot(ph), 2) - weight*sin(a2) - pull2*by_a2,
)]
pub struct Flyball {
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(8e5)]
    pub k: f64,
    #[nominal(4e4)]
    pub cd: f64,
    #[nominal(0.5)]
    pub l0: f64,
    #[nominal(0.3)]
    pub m_rod: f64,
    #[nominal(1)]
    pub l_rod: f64,
    #[nominal(0.01)]
    pub w_rod: f64,
    #[nominal(0.05)]
    pub off: f64,
    #[nominal(5)]
    pub m_ball: f64,
    #[nominal(3)]
    pub m_slider: f64,
    #[nominal(0.1)]
    pub b_slider: f64,
}

/// Three equal pendulums in a row, Cartesian coordinates by absolute angles, the links kept for their tensions.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, y1, x2, y2, x3, y3)]
#[inertia(diag(m, m, m, m, m, m))]
#[forces(0, -m*g, 0, -m*g, 0, -m*g)]
#[potential_energy(m*g*(y1 + y2 + y3))]
#[configuration(
    of(a1, a2, a3),
    x1 = l*sin(a1),
    y1 = -l*cos(a1),
    x2 = l*(sin(a1) + sin(a2)),
    y2 = -l*(cos(a1) + cos(a2)),
    x3 = l*(sin(a1) + sin(a2) + sin(a3)),
    y3 = -l*(cos(a1) + cos(a2) + cos(a3)),
)]
#[constraint(link1: (powi(x1, 2) + powi(y1, 2) - powi(l, 2))/2 == 0)]
#[constraint(link2: (powi(x2 - x1, 2) + powi(y2 - y1, 2) - powi(l, 2))/2 == 0)]
#[constraint(link3: (powi(x3 - x2, 2) + powi(y3 - y2, 2) - powi(l, 2))/2 == 0)]
pub struct TriplePendulum {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}
