//! The disk from its frames, points and body: no M, no h* and no constraint by components.

use holonomy::ConstrainedSystem;

/// The disk of Blajer (1992), section 6, formulation a: its contact point, and its speeds in the frame of its axis.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[frame(F = rotate(rotate(N, z, phi), x, PI/2 - theta))]
#[frame(D = rotate(F, z, psi))]
#[point(P = O + x*N.x + y*N.y + z*N.z)]
#[point(G = P + r*F.y)]
#[kinematics(
    v1 = dot(velocity(G), F.x),
    v2 = dot(velocity(G), F.y),
    v3 = dot(velocity(G), F.z),
    v4 = dot(angular_velocity(D), F.x),
    v5 = dot(angular_velocity(D), F.y),
    v6 = dot(angular_velocity(D), F.z),
)]
#[body(disk = { frame: D, center: G, mass: m, inertia: diag(j, j, 2*j) })]
#[gravity(-g*N.z)]
#[constraint(no_slip: velocity(P, disk) == 0, expressed = F)]
#[independent(v6, v5, v4)]
pub struct Disk {
    /// Mass.
    #[nominal(2)]
    pub m: f64,
    /// Radius.
    #[nominal(0.5)]
    pub r: f64,
    /// Moment of inertia about a diameter.
    #[nominal(0.125)]
    pub j: f64,
    /// Gravity.
    #[nominal(9.81)]
    pub g: f64,
}
