//! A platform on six legs.

use holonomy::ConstrainedSystem;

/// The Stewart platform: each leg is a cylinder on a universal joint of the base and a rod that slides in it, whose end is held by a ball
/// joint of the platform. Springs in the legs carry the platform, forces in them move it.
///
/// Of the 24 coordinates the six of the platform are independent, and each leg is solved for by its own three rows.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 6)]
#[coordinates(
    /// The platform's centre.
    x, y, z,
    /// Its attitude.
    yaw, pitch, roll,
    /// Tilts of the legs.
    a[n], b[n],
    /// Their lengths.
    s[n],
)]
#[inputs(f[n])]
#[frame(T = rotate(rotate(rotate(N, z, yaw), y, pitch), x, roll))]
#[frame(L[i] = universal(N, x, a[i], y, b[i]) for i in 0..n)]
#[point(C = O + x*N.x + y*N.y + z*N.z)]
#[point(P[i] = C + px[i]*T.x + py[i]*T.y for i in 0..n)]
#[point(B[i] = O + bx[i]*N.x + by[i]*N.y for i in 0..n)]
#[point(E[i] = prismatic(B[i], L[i].z, s[i]) for i in 0..n)]
#[body(platform = { frame: T, center: C, mass: m, inertia: disk(m, r, z) })]
#[body(cylinder[i] = { frame: L[i], center: B[i] + l/2*L[i].z, mass: mc, inertia: rod(mc, l, z) } for i in 0..n)]
#[body(rod[i] = { frame: L[i], center: E[i] - l/2*L[i].z, mass: mr, inertia: rod(mr, l, z) } for i in 0..n)]
#[gravity(-g*N.z)]
#[spring(carry[i] = { of: s[i], stiffness: k, length: s0 } for i in 0..n)]
#[generalized_force(s[i] = f[i] for i in 0..n)]
#[constraint(leg[i]: spherical(P[i], E[i]) for i in 0..n)]
#[independent(dot(x), dot(y), dot(z), dot(yaw), dot(pitch), dot(roll))]
pub struct Stewart {
    /// Where the legs stand.
    #[unit(m)]
    #[nominal(0.97, -0.26, -0.71, -0.71, -0.26, 0.97)]
    pub bx: [f64; 6],
    /// Where the legs stand.
    #[unit(m)]
    #[nominal(0.26, 0.97, 0.71, -0.71, -0.97, -0.26)]
    pub by: [f64; 6],
    /// Where they hold the platform.
    #[unit(m)]
    #[nominal(0.35, 0.13, -0.48, -0.48, 0.13, 0.35)]
    pub px: [f64; 6],
    /// Where they hold the platform.
    #[unit(m)]
    #[nominal(0.35, 0.48, 0.13, -0.13, -0.48, -0.35)]
    pub py: [f64; 6],
    /// Mass of the platform.
    #[unit(kg)]
    #[nominal(20)]
    pub m: f64,
    /// Its radius.
    #[unit(m)]
    #[nominal(0.6)]
    pub r: f64,
    /// Mass of a cylinder.
    #[unit(kg)]
    #[nominal(2)]
    pub mc: f64,
    /// Mass of a rod.
    #[unit(kg)]
    #[nominal(1)]
    pub mr: f64,
    /// Length of cylinders and rods.
    #[unit(m)]
    #[nominal(0.7)]
    pub l: f64,
    /// Stiffness of a spring.
    #[unit(kg/s/s)]
    #[nominal(4000)]
    pub k: f64,
    /// Length of a leg whose spring is slack.
    #[unit(m)]
    #[nominal(1.1)]
    pub s0: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}
