//! The rolling disk of Blajer (1992), section 6, in the paper's three formulations and two neighbours.
//!
//! x = (x, y, z, phi, theta, psi): the contact point P and the angles; v1..v3 the velocity of the centre G and v4..v6 the
//! angular velocity, both in the frame G-xi-eta-zeta. Kinematics (6.3), M (6.9), h* (6.10); J is the moment of inertia about a
//! diameter, 2J the one about the axis.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// Formulation a: six quasi-velocities and the rolling condition in the disk's own frame (6.5).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[inertia(diag(m, m, m, j, j, 2*j))]
#[forces(
    m*v5*(v2*tan(theta) - v3),
    m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)),
    m*(v5*v1 - v4*v2 - g*sin(theta)),
    j*v5*(v5*tan(theta) - 2*v6),
    j*v4*(2*v6 - v5*tan(theta)),
    0,
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
#[constraint(no_slip_along: v1 + r*v6 == 0)]
#[constraint(no_slip_across: v2 == 0)]
#[constraint(contact: v3 - r*v4 == 0)]
#[independent(v6, v5, v4)]
pub struct RollingDisk {
    #[unit(kg)]
    #[nominal(2.0)]
    pub m: f64,
    #[unit(m)]
    #[nominal(0.5)]
    pub r: f64,
    #[unit(kg*m*m)]
    #[nominal(0.125)]
    pub j: f64,
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}

/// Formulation a with the height of the contact point as well.
///
/// dz/dt = cos(theta) v2 + sin(theta) (v3 - r v4) is a combination of two rolling rows, so the height adds no row to C.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[inertia(diag(m, m, m, j, j, 2*j))]
#[forces(
    m*v5*(v2*tan(theta) - v3),
    m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)),
    m*(v5*v1 - v4*v2 - g*sin(theta)),
    j*v5*(v5*tan(theta) - 2*v6),
    j*v4*(2*v6 - v5*tan(theta)),
    0,
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
#[constraint(height: z == 0)]
#[constraint(no_slip_along: v1 + r*v6 == 0)]
#[constraint(no_slip_across: v2 == 0)]
#[constraint(contact: v3 - r*v4 == 0)]
#[independent(v6, v5, v4)]
pub struct RollingDiskOnFloor {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(0.125)]
    pub j: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Formulation b: the contact (6.1c) eliminated by x = g(q), a disk on a smooth floor (6.14)-(6.20).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[inertia(diag(m, m, m, j, j, 2*j))]
#[forces(
    m*v5*(v2*tan(theta) - v3),
    m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)),
    m*(v5*v1 - v4*v2 - g*sin(theta)),
    j*v5*(v5*tan(theta) - 2*v6),
    j*v4*(2*v6 - v5*tan(theta)),
    0,
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
#[configuration(z = 0)]
#[constraint(contact: z == 0)]
pub struct SlidingDisk {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(0.125)]
    pub j: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Formulation c, both stages in one model: the contact by x = g(q), then the rolling rows (6.1a), (6.1b) down to three rates.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[inertia(diag(m, m, m, j, j, 2*j))]
#[forces(
    m*v5*(v2*tan(theta) - v3),
    m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)),
    m*(v5*v1 - v4*v2 - g*sin(theta)),
    j*v5*(v5*tan(theta) - 2*v6),
    j*v4*(2*v6 - v5*tan(theta)),
    0,
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
#[configuration(z = 0)]
#[constraint(rolling_x: dot(x) + r*dot(psi)*cos(phi) == 0)]
#[constraint(rolling_y: dot(y) + r*dot(psi)*sin(phi) == 0)]
#[constraint(contact: z == 0)]
#[independent(dot(phi), dot(theta), dot(psi))]
pub struct RollingDiskInStages {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(0.125)]
    pub j: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The second stage of formulation c by itself: M_d (6.17) and h_u* (6.18) are the inertia and forces of a system in q, u = dq/dt.
///
/// The fourth entry of h_u* is d/dtheta of the kinetic and potential energy, (m r^2 + J) phi'^2 s c + 2 J phi' psi' c + m g r s:
/// the printed one does not hold.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi, theta, psi)]
#[define(s = sin(theta), c = cos(theta), i_p = m*powi(r, 2) + j)]
#[inertia(matrix(
    [m, 0, -m*r*s*cos(phi), -m*r*c*sin(phi), 0],
    [_, m, -m*r*s*sin(phi), m*r*c*cos(phi), 0],
    [_, _, i_p*powi(s, 2) + j, 0, 2*j*s],
    [_, _, _, i_p, 0],
    [_, _, _, _, 2*j],
))]
#[forces(
    -m*r*((powi(dot(phi), 2) + powi(dot(theta), 2))*s*sin(phi) - 2*dot(phi)*dot(theta)*c*cos(phi)),
    m*r*((powi(dot(phi), 2) + powi(dot(theta), 2))*s*cos(phi) + 2*dot(phi)*dot(theta)*c*sin(phi)),
    -2*i_p*dot(phi)*dot(theta)*s*c - 2*j*dot(psi)*dot(theta)*c,
    i_p*powi(dot(phi), 2)*s*c + 2*j*dot(phi)*dot(psi)*c + m*g*r*s,
    -2*j*dot(phi)*dot(theta)*c,
)]
#[potential_energy(m*g*r*c)]
#[constraint(rolling_x: dot(x) + r*dot(psi)*cos(phi) == 0)]
#[constraint(rolling_y: dot(y) + r*dot(psi)*sin(phi) == 0)]
#[independent(dot(phi), dot(theta), dot(psi))]
pub struct RollingDiskSecondStage {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(0.125)]
    pub j: f64,
    #[nominal(9.81)]
    pub g: f64,
}
