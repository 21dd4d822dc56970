//! A stone that turns one way only.

use holonomy::ConstrainedSystem;

/// A rattleback: an ellipsoid that rolls on a plane, its mass centre below its middle and its principal axes turned a little against
/// its geometry. The point of contact is where the ellipsoid's normal points down.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, spin, roll, pitch)]
#[frame(B = rotate(rotate(rotate(N, z, spin), x, roll), y, pitch))]
#[point(C = O + x*N.x + y*N.y + z*N.z)]
#[define(nx = dot(N.z, B.x), ny = dot(N.z, B.y), nz = dot(N.z, B.z))]
#[define(reach = sqrt(powi(a*nx, 2) + powi(b*ny, 2) + powi(c*nz, 2)))]
#[point(Q = C - powi(a, 2)*nx/reach*B.x - powi(b, 2)*ny/reach*B.y - powi(c, 2)*nz/reach*B.z)]
#[body(stone = {
    frame: B, center: C - h*B.z, mass: m,
    inertia: matrix([ixx, ixy, 0], [_, iyy, 0], [_, _, izz])
})]
#[gravity(-g*N.z)]
#[constraint(contact: z == reach)]
#[constraint(roll: velocity(Q, stone) == 0)]
#[independent(dot(spin), dot(roll), dot(pitch))]
#[output(normal = reaction(roll_z), turning = dot(angular_velocity(B), N.z))]
pub struct Rattleback {
    /// Mass.
    #[unit(kg)]
    #[nominal(1)]
    pub m: f64,
    /// Semi-axis along B.x.
    #[unit(m)]
    #[nominal(0.2)]
    pub a: f64,
    /// Along B.y.
    #[unit(m)]
    #[nominal(0.03)]
    pub b: f64,
    /// Along B.z.
    #[unit(m)]
    #[nominal(0.02)]
    pub c: f64,
    /// How far the mass centre lies below the middle.
    #[unit(m)]
    #[nominal(0.01)]
    pub h: f64,
    /// Moments of inertia about the mass centre.
    #[unit(kg*m*m)]
    #[nominal(2e-4)]
    pub ixx: f64,
    #[allow(missing_docs)]
    #[unit(kg*m*m)]
    #[nominal(1.6e-3)]
    pub iyy: f64,
    #[allow(missing_docs)]
    #[unit(kg*m*m)]
    #[nominal(1.7e-3)]
    pub izz: f64,
    /// The tensor's entry that turns the principal axes against the ellipsoid's.
    #[unit(kg*m*m)]
    #[nominal(-2e-5)]
    pub ixy: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}
