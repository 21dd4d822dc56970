//! The rolling disc of the published set, by its centre.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// A thin disc that rolls on the plane z = 0: centre (cx, cy, cz), orientation Rz(yaw) Rx(lean) Ry(spin).
///
/// Speeds: the centre's velocity in the inertial frame and the angular velocity w = (lean', spin' + yaw' sin lean,
/// yaw' cos lean) in the leaned frame e1 (heading), e2 (disc axis), e3 (from the contact to the centre). That frame turns with
/// f = (w1, w3 tan lean, w3), and Euler's equations J w' = -f x J w with J = diag(d, a, d) give the last three forces.
/// The contact point is at -r e3 from the centre; it rests: V = r (w2 e1 - w1 e2). The third of these rows is the derivative of
/// the height cz = r cos lean.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(cx, cy, cz, yaw, lean, spin)]
#[speeds(vx, vy, vz, w1, w2, w3)]
#[kinematics(
    vx = dot(cx),
    vy = dot(cy),
    vz = dot(cz),
    w1 = dot(lean),
    w2 = dot(spin) + dot(yaw)*sin(lean),
    w3 = dot(yaw)*cos(lean),
)]
#[inertia(diag(m, m, m, d, a, d))]
#[forces(0, 0, -m*g, a*w2*w3 - d*powi(w3, 2)*tan(lean), 0, d*w1*w3*tan(lean) - a*w1*w2)]
#[potential_energy(m*g*cz)]
#[constraint(height: cz == r*cos(lean))]
#[constraint(slip_x: vx - r*(w2*cos(yaw) + w1*sin(yaw)*cos(lean)) == 0)]
#[constraint(slip_y: vy - r*(w2*sin(yaw) - w1*cos(yaw)*cos(lean)) == 0)]
#[constraint(slip_z: vz + r*w1*sin(lean) == 0)]
#[independent(w1, w2, w3)]
#[output(
    /// The least coefficient of friction for which the disc does not slip.
    friction = sqrt(powi(reaction(slip_x), 2) + powi(reaction(slip_y), 2))/abs(reaction(slip_z)),
    turning = w3*cos(lean) + w2*sin(lean),
    curving = dot(w3),
)]
pub struct RollingDisc {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(9.81)]
    pub g: f64,
    /// Moment of inertia about a diameter.
    #[nominal(0.125)]
    pub d: f64,
    /// Moment of inertia about the axis.
    #[nominal(0.25)]
    pub a: f64,
}
