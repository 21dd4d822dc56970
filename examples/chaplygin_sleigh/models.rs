//! Chaplygin's sleigh in body components.

use holonomy::ConstrainedSystem;

/// In body components: u forward, w to the left, o the turning rate, all of the blade's point. The mass centre is at the
/// distance a ahead of the blade, i is the moment of inertia about it.
///
/// With the momenta p1 = m u, p2 = m (w + a o) and p3 = m a (w + a o) + i o about the moving point, p1' = o p2, p2' = -o p1 and
/// p3' = -u p2 + w p1 = -m a u o: the forces below.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y, phi)]
#[speeds(u, w, o)]
#[kinematics(
    dot(x) = u*cos(phi) - w*sin(phi),
    dot(y) = u*sin(phi) + w*cos(phi),
    dot(phi) = o,
)]
#[inertia(matrix([m, 0, 0], [_, m, m*a], [_, _, i + m*powi(a, 2)]))]
#[forces(m*o*(w + a*o), -m*o*u, -m*a*u*o)]
#[potential_energy(0)]
#[constraint(blade: w == 0)]
#[independent(u, o)]
pub struct Sleigh {
    /// Mass.
    pub m: f64,
    /// Moment of inertia about the mass centre.
    pub i: f64,
    /// From the blade to the mass centre.
    pub a: f64,
}
