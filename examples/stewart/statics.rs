//! What is known of the platform without equations of motion: the legs of a pose in closed form, and the forces in them that hold it,
//! by the equilibrium of each leg and of the platform.

use crate::models::{Stewart, StewartState};
use holonomy::Vector;
use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3, Vector6};

/// x, y, z, yaw, pitch, roll.
pub type Pose = [f64; 6];

/// A leg: its tilts, its length, its direction, and the arm at which it holds the platform.
pub struct Leg {
    pub tilts: [f64; 2],
    pub length: f64,
    pub direction: Vector3<f64>,
    arm: Vector3<f64>,
}

/// The legs of a pose, each the way from where it stands to where it holds the platform: its direction turned from the vertical first
/// about x, then about y, is (sin b, -sin a cos b, cos a cos b).
pub fn legs(model: &Stewart, pose: &Pose) -> [Leg; 6] {
    let [x, y, z, yaw, pitch, roll] = *pose;
    let turned: Matrix3<f64> = Rotation3::from_euler_angles(roll, pitch, yaw).into_inner();
    std::array::from_fn(|i| {
        let arm = turned * Vector3::new(model.px[i], model.py[i], 0.0);
        let way = Vector3::new(x - model.bx[i], y - model.by[i], z) + arm;
        let (length, direction) = (way.norm(), way.normalize());
        Leg { tilts: [(-direction.y).atan2(direction.z), direction.x.asin()], length, direction, arm }
    })
}

/// The state of a pose and its rates.
pub fn state(model: &Stewart, pose: &Pose, rates: &Pose) -> StewartState {
    let legs = legs(model, pose);
    StewartState::from_fn(|i| match i {
        0..6 => pose[i],
        6..12 => legs[i - 6].tilts[0],
        12..18 => legs[i - 12].tilts[1],
        18..24 => legs[i - 18].length,
        _ => rates[i - 24],
    })
}

/// The forces in the legs that hold a pose at rest, and what the legs then exert on the platform.
///
/// A leg rests about its foot if what it exerts across itself is the share of its weight that the foot does not carry, μ g with
/// μ s = mc l/2 + mr (s - l/2); and its rod rests along it if it exerts f + k (s0 - s) less the weight of the rod along the leg. Forces
/// and moments on the platform about its centre make six equations for the six f.
pub fn holding(model: &Stewart, pose: &Pose) -> Option<([f64; 6], [Vector3<f64>; 6])> {
    let Stewart { m, mc, mr, l, k, s0, g, .. } = *model;
    let legs = legs(model, pose);
    let down = Vector3::new(0.0, 0.0, -g);
    let passive = |leg: &Leg| {
        let (u, s) = (leg.direction, leg.length);
        let share = (mc * l / 2.0 + mr * (s - l / 2.0)) / s;
        share * (down - u * down.dot(&u)) + u * (k * (s0 - s) + mr * down.dot(&u))
    };
    let wrench = |force: Vector3<f64>, arm: Vector3<f64>| {
        let moment = arm.cross(&force);
        Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
    };
    let ways = Matrix6::from_columns(&legs.each_ref().map(|leg| wrench(leg.direction, leg.arm)));
    let carried = legs.iter().map(|leg| wrench(passive(leg), leg.arm)).sum::<Vector6<f64>>();
    let forces = ways.lu().solve(&-(carried + wrench(m * down, Vector3::zeros())))?;
    let exerted = std::array::from_fn(|i| passive(&legs[i]) + forces[i] * legs[i].direction);
    Some((forces.into(), exerted))
}
