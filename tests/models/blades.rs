//! Blades that cannot move sideways: Chaplygin's sleigh and the knife edge on an incline.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// Chaplygin's sleigh in body components: u forward, w to the left, o the turning rate, all of the blade's point.
///
/// The mass centre is at the distance a ahead of the blade, i is the moment of inertia about it. With the momenta
/// p1 = m u, p2 = m (w + a o) and p3 = m a (w + a o) + i o about the moving point: p1' = o p2, p2' = -o p1 and
/// p3' = -u p2 + w p1 = -m a u o, which are the forces below.
#[derive(ConstrainedSystem, Clone, Debug)]
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
    #[nominal(2.5)]
    pub m: f64,
    #[nominal(0.3)]
    pub i: f64,
    #[nominal(0.4)]
    pub a: f64,
}

/// The same sleigh in x', y', phi': M depends on the heading and is full.
///
/// From T = m/2 ((x' - a phi' sin phi)^2 + (y' + a phi' cos phi)^2) + i/2 phi'^2; the terms of Lagrange's third equation that
/// are quadratic in the velocities cancel.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi)]
#[inertia(matrix(
    [m, 0, -m*a*sin(phi)],
    [_, m, m*a*cos(phi)],
    [_, _, i + m*powi(a, 2)],
))]
#[forces(m*a*powi(dot(phi), 2)*cos(phi), m*a*powi(dot(phi), 2)*sin(phi), 0)]
#[constraint(blade: -dot(x)*sin(phi) + dot(y)*cos(phi) == 0)]
#[complement(forward = [cos(phi), sin(phi), 0], turn = [0, 0, 1])]
pub struct SleighInPlane {
    #[nominal(2.5)]
    pub m: f64,
    #[nominal(0.3)]
    pub i: f64,
    #[nominal(0.4)]
    pub a: f64,
}

/// A knife edge under the mass centre on a plane that slopes down along x; cos(phi) passes through zero, so D is given.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi)]
#[inertia(diag(m, m, i))]
#[forces(m*g*sin(incline), 0, 0)]
#[potential_energy(-m*g*sin(incline)*x)]
#[constraint(blade: -dot(x)*sin(phi) + dot(y)*cos(phi) == 0)]
#[complement(along = [cos(phi), sin(phi), 0], turn = [0, 0, 1])]
pub struct KnifeEdge {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.7)]
    pub i: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.5235987755982989)]
    pub incline: f64,
}
