//! The disk of Blajer (1992), section 6, declared three times.
//!
//! x, y, z is the contact point P; phi the heading of the contact tangent, theta the lean, psi the angle of rolling.
//! v1, v2, v3 is the velocity of the centre G and v4, v5, v6 the angular velocity, both along the tangent ξ, the line η
//! from P to G and the axle ζ. j is the moment of inertia about a diameter, 2 j about the axle.

use holonomy::ConstrainedSystem;

/// (6.2)-(6.13): six quasi-velocities bound by the rolling conditions in the disk's own frame (6.5).
#[derive(ConstrainedSystem, Clone)]
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
#[constraint(height: z == 0)]
#[independent(v6, v5, v4)]
#[define(
    normal = reaction(no_slip_across)*cos(theta) + reaction(contact)*sin(theta),
    across = reaction(no_slip_across)*sin(theta) - reaction(contact)*cos(theta),
)]
#[output(
    /// The least coefficient of friction for which the disk does not slip.
    friction = sqrt(powi(reaction(no_slip_along), 2) + powi(across, 2))/normal,
)]
pub struct RollingDisk {
    /// Mass.
    #[unit(kg)]
    pub m: f64,
    /// Radius.
    #[unit(m)]
    pub r: f64,
    /// Moment of inertia about a diameter.
    #[unit(kg*m*m)]
    pub j: f64,
    /// Acceleration due to gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}

/// (6.14)-(6.20): the contact eliminated by z = 0, five generalised coordinates. The floor is smooth; `fx` and `fy` are
/// forces on the disk's lowest point, so that friction, if there is any, comes from outside.
#[derive(ConstrainedSystem, Clone)]
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
#[inputs(fx, fy)]
#[define(along = fx*cos(phi) + fy*sin(phi), left = fy*cos(phi) - fx*sin(phi))]
#[forces(
    m*v5*(v2*tan(theta) - v3) + along,
    m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)) + left*sin(theta),
    m*(v5*v1 - v4*v2 - g*sin(theta)) - left*cos(theta),
    j*v5*(v5*tan(theta) - 2*v6) + r*left*cos(theta),
    j*v4*(2*v6 - v5*tan(theta)),
    r*along,
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
#[configuration(z = 0)]
#[constraint(contact: z == 0)]
pub struct FloorDisk {
    /// Mass.
    pub m: f64,
    /// Radius.
    pub r: f64,
    /// Moment of inertia about a diameter.
    pub j: f64,
    /// Acceleration due to gravity.
    pub g: f64,
}

/// (6.21)-(6.29): the contact by z = 0 first, then the rolling conditions (6.1a), (6.1b) down to three rates.
#[derive(ConstrainedSystem, Clone)]
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
pub struct StagedDisk {
    /// Mass.
    pub m: f64,
    /// Radius.
    pub r: f64,
    /// Moment of inertia about a diameter.
    pub j: f64,
    /// Acceleration due to gravity.
    pub g: f64,
}
