//! A loop of rods in space, from geometry alone.

use holonomy::ConstrainedSystem;

/// Bricard's mechanism: five rods in a row on five hinges, J[0] … J[4], and a sixth hinge, J[5], that closes them to the ground.
///
/// The sixth hinge is `revolute(J[5], S, E.x, N.x)`: its place, and two rows that keep its axis. These five are of rank four wherever
/// the loop is closed, and of rank five elsewhere. With `redundant` behind it the row too many is found at the start, and shares in
/// the reactions; here the four rows stand that are enough, in axes in which they are cheapest.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 6)]
#[coordinates(a1, a2, a3, a4, a5)]
#[frame(A = revolute(N, y, a1), B = revolute(A, z, a2), C = revolute(B, x, a3), D = revolute(C, y, a4))]
#[frame(E = revolute(D, z, a5))]
#[point(J[0] = O, J[1] = J[0] + l*A.x, J[2] = J[1] - l*B.y, J[3] = J[2] + l*C.z, J[4] = J[3] - l*D.x, J[5] = J[4] + l*E.y)]
#[point(S = O + l*N.z)]
#[body(
    first = { frame: A, center: J[0] + l/2*A.x, mass: m, inertia: cuboid(m, l, b, b) },
    second = { frame: B, center: J[1] - l/2*B.y, mass: m, inertia: cuboid(m, b, l, b) },
    third = { frame: C, center: J[2] + l/2*C.z, mass: m, inertia: cuboid(m, b, b, l) },
    fourth = { frame: D, center: J[3] - l/2*D.x, mass: m, inertia: cuboid(m, l, b, b) },
    fifth = { frame: E, center: J[4] + l/2*E.y, mass: m, inertia: cuboid(m, b, l, b) },
)]
#[gravity(-g*N.y)]
#[constraint(sixth: J[5] == S, expressed = C)]
#[constraint(sixth_axis: dot(E.x - N.x, C.z) == 0)]
#[independent(dot(a1))]
#[start(a1 = 0.5, a2 = -0.33, a3 = 0.5, a4 = -0.33, a5 = 0.5)]
#[output(x[i] = dot(J[i], N.x) for i in 0..n, y[i] = dot(J[i], N.y) for i in 0..n, z[i] = dot(J[i], N.z) for i in 0..n)]
#[output(vx = dot(velocity(J[2]), N.x), vy = dot(velocity(J[2]), N.y), vz = dot(velocity(J[2]), N.z))]
#[output(axis_y = dot(E.x, N.y), axis_z = dot(E.x, N.z))]
pub struct Bricard {
    /// Mass of a rod.
    #[unit(kg)]
    #[nominal(1)]
    pub m: f64,
    /// Its length.
    #[unit(m)]
    #[nominal(1)]
    pub l: f64,
    /// The side of its square section.
    #[unit(m)]
    #[nominal(0.1)]
    pub b: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}
