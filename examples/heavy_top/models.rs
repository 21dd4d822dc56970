//! A top on a point, its attitude by three angles or by a unit quaternion.

use holonomy::ConstrainedSystem;

/// By angles: heading, lean of the axis from the horizontal plane, and spin about the axis. They fail where the axis is vertical.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(heading, rise, spin)]
#[frame(T = rotate(rotate(rotate(N, z, heading), x, rise), y, spin))]
#[point(C = O + l*T.y)]
#[body(top = { frame: T, center: C, mass: m, inertia: diag(across, axial, across) })]
#[gravity(-g*N.z)]
#[release(fx = { point: C, along: N.x }, fy = { point: C, along: N.y }, fz = { point: C, along: N.z })]
#[output(height = dot(C, N.z), swing = dot(angular_momentum(top, O), N.z))]
#[output(hold = norm(reaction(fx)*N.x + reaction(fy)*N.y + reaction(fz)*N.z))]
pub struct AngledTop {
    /// Mass.
    #[unit(kg)]
    #[nominal(15)]
    pub m: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
    /// Distance of the mass centre from the point.
    #[unit(m)]
    #[nominal(1)]
    pub l: f64,
    /// Moment of inertia about the axis.
    #[unit(kg*m*m)]
    #[nominal(0.46875)]
    pub axial: f64,
    /// Moment of inertia across it, about the mass centre.
    #[unit(kg*m*m)]
    #[nominal(0.234375)]
    pub across: f64,
}

/// By a unit quaternion: no attitude is singular, and the speeds are the angular velocity in the top's axes.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(e0, e1, e2, e3)]
#[frame(T = quaternion(N, e0, e1, e2, e3))]
#[point(C = O + l*T.y)]
#[body(top = { frame: T, center: C, mass: m, inertia: diag(across, axial, across) })]
#[gravity(-g*N.z)]
#[release(fx = { point: C, along: N.x }, fy = { point: C, along: N.y }, fz = { point: C, along: N.z })]
#[output(height = dot(C, N.z), swing = dot(angular_momentum(top, O), N.z), x = dot(C, N.x), y = dot(C, N.y))]
#[output(hold = norm(reaction(fx)*N.x + reaction(fy)*N.y + reaction(fz)*N.z))]
pub struct FreeTop {
    /// Mass.
    #[unit(kg)]
    #[nominal(15)]
    pub m: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
    /// Distance of the mass centre from the point.
    #[unit(m)]
    #[nominal(1)]
    pub l: f64,
    /// Moment of inertia about the axis.
    #[unit(kg*m*m)]
    #[nominal(0.46875)]
    pub axial: f64,
    /// Moment of inertia across it, about the mass centre.
    #[unit(kg*m*m)]
    #[nominal(0.234375)]
    pub across: f64,
}
