//! An arm of six axes.

use holonomy::ConstrainedSystem;

/// The Puma 560 in the frames of Denavit and Hartenberg: joint i turns about the z axis of frame i - 1. Motors add G² J.
/// SI units.
///
/// Of the first link only the inertia about the vertical is known, and nothing else of it matters. The third link has no nominal
/// inertia: the published one, 0.066, 0.086 and 0.0125, is none that a body can have, its second entry being more than the others
/// together.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q[6])]
#[inputs(tau[6])]
#[frame(
    F1 = rotate(rotate(N, z, q[0]), x, PI/2),
    F2 = rotate(F1, z, q[1]),
    F3 = rotate(rotate(F2, z, q[2]), x, -PI/2),
    F4 = rotate(rotate(F3, z, q[3]), x, PI/2),
    F5 = rotate(rotate(F4, z, q[4]), x, -PI/2),
    F6 = rotate(F5, z, q[5]),
)]
#[point(
    P2 = O + a2*F2.x,
    P3 = P2 + d3*F2.z + a3*F3.x,
    P4 = P3 + d4*F3.z,
)]
#[body(
    link1 = { frame: F1, center: O, mass: 1, inertia: diag(iy1, iy1, iy1) },
    link2 = { frame: F2, center: P2 + rx2*F2.x + ry2*F2.y + rz2*F2.z, mass: m2, inertia: diag(ix2, iy2, iz2) },
    link3 = { frame: F3, center: P3 + rx3*F3.x + ry3*F3.y + rz3*F3.z, mass: m3, inertia: diag(ix3, iy3, iz3) },
    link4 = { frame: F4, center: P4 + ry4*F4.y, mass: m4, inertia: diag(ix4, iy4, iz4) },
    link5 = { frame: F5, center: P4, mass: m5, inertia: diag(ix5, iy5, iz5) },
    link6 = { frame: F6, center: P4 + rz6*F6.z, mass: m6, inertia: diag(ix6, iy6, iz6) },
)]
#[gravity(-g*N.z)]
#[armature(motor[i] = { of: q[i], inertia: motor_inertia[i] } for i in 0..6)]
#[generalized_force(q[i] = tau[i] for i in 0..6)]
pub struct PumaArm {
    /// Gravity.
    #[nominal(9.81)]
    pub g: f64,
    /// Offset of the third axis along the upper arm.
    #[nominal(0.4318)]
    pub a2: f64,
    /// Offset of the fourth axis across the forearm.
    #[nominal(0.0203)]
    pub a3: f64,
    /// Offset of the arm from the base's axis.
    #[nominal(0.15005)]
    pub d3: f64,
    /// Length of the forearm.
    #[nominal(0.4318)]
    pub d4: f64,
    /// Mass of link 2.
    #[nominal(17.4)]
    pub m2: f64,
    /// Mass of link 3.
    #[nominal(4.8)]
    pub m3: f64,
    /// Mass of link 4.
    #[nominal(0.82)]
    pub m4: f64,
    /// Mass of link 5.
    #[nominal(0.34)]
    pub m5: f64,
    /// Mass of link 6.
    #[nominal(0.09)]
    pub m6: f64,
    /// Mass centre of link 2 along x.
    #[nominal(-0.3638)]
    pub rx2: f64,
    /// Mass centre of link 2 along y.
    #[nominal(0.006)]
    pub ry2: f64,
    /// Mass centre of link 2 along z.
    #[nominal(0.2275)]
    pub rz2: f64,
    /// Mass centre of link 3 along x.
    #[nominal(-0.0203)]
    pub rx3: f64,
    /// Mass centre of link 3 along y.
    #[nominal(-0.0141)]
    pub ry3: f64,
    /// Mass centre of link 3 along z.
    #[nominal(0.07)]
    pub rz3: f64,
    /// Mass centre of link 4 along y.
    #[nominal(0.019)]
    pub ry4: f64,
    /// Mass centre of link 6 along z.
    #[nominal(0.032)]
    pub rz6: f64,
    /// Inertia of link 1 about y.
    #[nominal(0.35)]
    pub iy1: f64,
    /// Inertia of link 2 about x.
    #[nominal(0.13)]
    pub ix2: f64,
    /// Inertia of link 2 about y.
    #[nominal(0.524)]
    pub iy2: f64,
    /// Inertia of link 2 about z.
    #[nominal(0.539)]
    pub iz2: f64,
    /// Inertia of link 3 about x.
    pub ix3: f64,
    /// Inertia of link 3 about y.
    pub iy3: f64,
    /// Inertia of link 3 about z.
    pub iz3: f64,
    /// Inertia of link 4 about x.
    #[nominal(1.8e-3)]
    pub ix4: f64,
    /// Inertia of link 4 about y.
    #[nominal(1.3e-3)]
    pub iy4: f64,
    /// Inertia of link 4 about z.
    #[nominal(1.8e-3)]
    pub iz4: f64,
    /// Inertia of link 5 about x.
    #[nominal(0.3e-3)]
    pub ix5: f64,
    /// Inertia of link 5 about y.
    #[nominal(0.4e-3)]
    pub iy5: f64,
    /// Inertia of link 5 about z.
    #[nominal(0.3e-3)]
    pub iz5: f64,
    /// Inertia of link 6 about x.
    #[nominal(0.15e-3)]
    pub ix6: f64,
    /// Inertia of link 6 about y.
    #[nominal(0.15e-3)]
    pub iy6: f64,
    /// Inertia of link 6 about z.
    #[nominal(0.04e-3)]
    pub iz6: f64,
    /// Inertia of the motors as their joints feel it.
    #[nominal(0.5)]
    pub motor_inertia: [f64; 6],
}

impl PumaArm {
    /// Corke and Armstrong-Helouvry 1994, as their parameters stand in the Robotics Toolbox.
    #[rustfmt::skip]
    pub const UNIMATE: PumaArm = PumaArm {
        g: 9.81, a2: 0.4318, a3: 0.0203, d3: 0.15005, d4: 0.4318,
        m2: 17.4, m3: 4.8, m4: 0.82, m5: 0.34, m6: 0.09,
        rx2: -0.3638, ry2: 0.006, rz2: 0.2275, rx3: -0.0203, ry3: -0.0141, rz3: 0.07, ry4: 0.019, rz6: 0.032,
        iy1: 0.35, ix2: 0.13, iy2: 0.524, iz2: 0.539, ix3: 0.066, iy3: 0.086, iz3: 0.0125, ix4: 1.8e-3, iy4: 1.3e-3,
        iz4: 1.8e-3, ix5: 0.3e-3, iy5: 0.4e-3, iz5: 0.3e-3, ix6: 0.15e-3, iy6: 0.15e-3, iz6: 0.04e-3,
        // Gear ratio squared, times the motor's own.
        motor_inertia: [
            62.6111 * 62.6111 * 0.0002,
            107.815 * 107.815 * 0.0002,
            53.7063 * 53.7063 * 0.0002,
            76.0364 * 76.0364 * 3.3e-05,
            71.923 * 71.923 * 3.3e-05,
            76.686 * 76.686 * 3.3e-05,
        ],
    };
}
