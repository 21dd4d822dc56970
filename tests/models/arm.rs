//! The Puma 560, six bodies in an open chain in space, by its energies in the joint angles.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// The arm in the standard frames of Denavit and Hartenberg: joint i turns about the z axis of frame i - 1.
///
/// `w` is the angular velocity of each link in its own axes, the one before it turned and the joint's rate added, `v` the velocity
/// of the frame's origin alike; links 4 to 6 have one origin. Mass centres are `r` in the link's axes, inertias about them are
/// diagonal, and each motor adds `motor` = G² J to the inertia of its joint. V leaves out the height of the shoulder.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q[6])]
#[inputs(tau[6])]
#[define(s[i] = sin(q[i]) for i in 1..6, c[i] = cos(q[i]) for i in 1..6)]
#[define(
    w1x = s[1]*dot(q[0]),
    w1y = c[1]*dot(q[0]),
    w1z = dot(q[1]),
    w2x = c[2]*w1x + s[2]*w1y,
    w2y = -w1z - dot(q[2]),
    w2z = -s[2]*w1x + c[2]*w1y,
    w3x = c[3]*w2x + s[3]*w2y,
    w3y = w2z + dot(q[3]),
    w3z = s[3]*w2x - c[3]*w2y,
    w4x = c[4]*w3x + s[4]*w3y,
    w4y = -w3z - dot(q[4]),
    w4z = -s[4]*w3x + c[4]*w3y,
    w5x = c[5]*w4x + s[5]*w4y,
    w5y = -s[5]*w4x + c[5]*w4y,
    w5z = w4z + dot(q[5]),
)]
#[define(
    v1y = a2*w1z,
    v1z = -a2*w1y,
    v2x = s[2]*v1y + d3*w2z,
    v2y = -v1z + a3*w2z,
    v2z = c[2]*v1y - d3*w2x - a3*w2y,
    v3x = c[3]*v2x + s[3]*v2y - d4*w3z,
    v3y = v2z,
    v3z = s[3]*v2x - c[3]*v2y + d4*w3x,
    v4x = c[4]*v3x + s[4]*v3y,
    v4y = -v3z,
    v4z = -s[4]*v3x + c[4]*v3y,
)]
#[kinetic_energy(
    (iy1*powi(dot(q[0]), 2)
    + m2*(powi(w1y*rz2 - w1z*ry2, 2) + powi(v1y + w1z*rx2 - w1x*rz2, 2) + powi(v1z + w1x*ry2 - w1y*rx2, 2))
    + ix2*powi(w1x, 2) + iy2*powi(w1y, 2) + iz2*powi(w1z, 2)
    + m3*(powi(v2x + w2y*rz3 - w2z*ry3, 2) + powi(v2y + w2z*rx3 - w2x*rz3, 2) + powi(v2z + w2x*ry3 - w2y*rx3, 2))
    + ix3*powi(w2x, 2) + iy3*powi(w2y, 2) + iz3*powi(w2z, 2)
    + m4*(powi(v3x - w3z*ry4, 2) + powi(v3y, 2) + powi(v3z + w3x*ry4, 2))
    + ix4*powi(w3x, 2) + iy4*powi(w3y, 2) + iz4*powi(w3z, 2)
    + m5*(powi(v4x, 2) + powi(v4y, 2) + powi(v4z, 2))
    + ix5*powi(w4x, 2) + iy5*powi(w4y, 2) + iz5*powi(w4z, 2)
    + m6*(powi(v4x + w4y*rz6, 2) + powi(v4y - w4x*rz6, 2) + powi(v4z, 2))
    + ix6*powi(w5x, 2) + iy6*powi(w5y, 2) + iz6*powi(w5z, 2)
    + sum(0..6, |i| motor[i]*powi(dot(q[i]), 2)))/2
)]
#[define(
    s23 = c[2]*s[1] + s[2]*c[1],
    c23 = c[2]*c[1] - s[2]*s[1],
    up5 = -s[4]*c[3]*s23 + c[4]*c23,
)]
#[potential_energy(
    g*(m2*(a2*s[1] + rx2*s[1] + ry2*c[1])
    + m3*(a2*s[1] + (a3 + rx3)*s23 + rz3*c23)
    + (m4 + m5 + m6)*(a2*s[1] + a3*s23 + d4*c23)
    + m4*ry4*c23
    + m6*rz6*up5)
)]
#[forces(tau[i] for i in 0..6)]
pub struct Puma {
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.4318)]
    pub a2: f64,
    #[nominal(0.0203)]
    pub a3: f64,
    #[nominal(0.15005)]
    pub d3: f64,
    #[nominal(0.4318)]
    pub d4: f64,
    #[nominal(17.4)]
    pub m2: f64,
    #[nominal(4.8)]
    pub m3: f64,
    #[nominal(0.82)]
    pub m4: f64,
    #[nominal(0.34)]
    pub m5: f64,
    #[nominal(0.09)]
    pub m6: f64,
    #[nominal(-0.3638)]
    pub rx2: f64,
    #[nominal(0.006)]
    pub ry2: f64,
    #[nominal(0.2275)]
    pub rz2: f64,
    #[nominal(-0.0203)]
    pub rx3: f64,
    #[nominal(-0.0141)]
    pub ry3: f64,
    #[nominal(0.07)]
    pub rz3: f64,
    #[nominal(0.019)]
    pub ry4: f64,
    #[nominal(0.032)]
    pub rz6: f64,
    #[nominal(0.35)]
    pub iy1: f64,
    #[nominal(0.13)]
    pub ix2: f64,
    #[nominal(0.524)]
    pub iy2: f64,
    #[nominal(0.539)]
    pub iz2: f64,
    #[nominal(0.066)]
    pub ix3: f64,
    #[nominal(0.086)]
    pub iy3: f64,
    #[nominal(0.0125)]
    pub iz3: f64,
    #[nominal(1.8e-3)]
    pub ix4: f64,
    #[nominal(1.3e-3)]
    pub iy4: f64,
    #[nominal(1.8e-3)]
    pub iz4: f64,
    #[nominal(0.3e-3)]
    pub ix5: f64,
    #[nominal(0.4e-3)]
    pub iy5: f64,
    #[nominal(0.3e-3)]
    pub iz5: f64,
    #[nominal(0.15e-3)]
    pub ix6: f64,
    #[nominal(0.15e-3)]
    pub iy6: f64,
    #[nominal(0.04e-3)]
    pub iz6: f64,
    #[nominal(0.5)]
    pub motor: [f64; 6],
}
