//! Bricard's mechanism: five rods in a loop in space, movable although counting its joints says that it is not.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// The loop by the angles of its first five joints, about the axes y, z, x, y, z at the start; the sixth joint closes it.
///
/// Angular velocities `w` and the velocities of the rods' ends, `n` before and `v` after the rod, are in the axes of each rod, those
/// of the ground at the start. The loop is closed in the axes of the third rod: the tip comes to the sixth joint, whose axis keeps
/// its direction. Two rows say the latter, of rank four with the others wherever the loop is closed: of the two, `axis_y` is left out.
///
/// The rows have another solution than the loop: on the surface a1 = a3 = a5 = -pi/2 they lose their rank. States are closed from
/// the given start, which is near the loop's own motion.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a1, a2, a3, a4, a5)]
#[define(
    jl = m*powi(b, 2)/6, jt = m*(powi(l, 2) + powi(b, 2))/12,
    s1 = sin(a1), c1 = cos(a1), s2 = sin(a2), c2 = cos(a2), s3 = sin(a3), c3 = cos(a3),
    s4 = sin(a4), c4 = cos(a4), s5 = sin(a5), c5 = cos(a5),
)]
#[define(
    w1y = dot(a1),
    w2x = s2*w1y,
    w2y = c2*w1y,
    w2z = dot(a2),
    w3x = w2x + dot(a3),
    w3y = c3*w2y + s3*w2z,
    w3z = -s3*w2y + c3*w2z,
    w4x = c4*w3x - s4*w3z,
    w4y = w3y + dot(a4),
    w4z = s4*w3x + c4*w3z,
    w5x = c5*w4x + s5*w4y,
    w5y = -s5*w4x + c5*w4y,
    w5z = w4z + dot(a5),
)]
#[define(
    v1z = -l*w1y,
    v2x = l*w2z,
    v2z = v1z - l*w2x,
    n3y = s3*v2z,
    n3z = c3*v2z,
    v3x = v2x + l*w3y,
    v3y = n3y - l*w3x,
    v3z = n3z,
    n4x = c4*v3x - s4*v3z,
    n4z = s4*v3x + c4*v3z,
    v4y = v3y - l*w4z,
    v4z = n4z + l*w4y,
    n5x = c5*n4x + s5*v4y,
    n5y = -s5*n4x + c5*v4y,
)]
#[kinetic_energy(
    (m*(powi(v1z/2, 2)
    + powi(l/2*w2z, 2) + powi(v1z - l/2*w2x, 2)
    + powi(v2x + l/2*w3y, 2) + powi(n3y - l/2*w3x, 2) + powi(n3z, 2)
    + powi(n4x, 2) + powi(v3y - l/2*w4z, 2) + powi(n4z + l/2*w4y, 2)
    + powi(n5x - l/2*w5z, 2) + powi(n5y, 2) + powi(v4z + l/2*w5x, 2))
    + jt*powi(w1y, 2)
    + jt*(powi(w2x, 2) + powi(w2z, 2)) + jl*powi(w2y, 2)
    + jt*(powi(w3x, 2) + powi(w3y, 2)) + jl*powi(w3z, 2)
    + jt*(powi(w4y, 2) + powi(w4z, 2)) + jl*powi(w4x, 2)
    + jt*(powi(w5x, 2) + powi(w5z, 2)) + jl*powi(w5y, 2))/2
)]
#[potential_energy(
    m*g*l*(-7*c2 - 5*s3*c2 - 3*(c4*s2 + s4*s3*c2) - s5*(c4*s2 + s4*s3*c2) + c5*c3*c2)/2
)]
#[constraint(close_x: c2*(1 + s1) == c4*(1 + s5))]
#[constraint(close_y: c5 == c3*(s2*(1 + s1) + 1) + s3*c1)]
#[constraint(close_z: s3*(s2*(1 + s1) + 1) + s4*(1 + s5) == c3*c1 - 1)]
#[constraint(axis_z: c3*s1 + s3*s2*c1 + s4*c5 == 0)]
#[independent(dot(a1))]
#[start(a1 = 0.5, a2 = -0.33, a3 = 0.5, a4 = -0.33, a5 = 0.5)]
pub struct Bricard {
    #[nominal(1)]
    pub m: f64,
    #[nominal(1)]
    pub l: f64,
    #[nominal(0.1)]
    pub b: f64,
    #[nominal(9.81)]
    pub g: f64,
}
