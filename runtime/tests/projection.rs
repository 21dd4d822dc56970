//! Back onto the constraints: the nearest point in the kinetic metric, with the residuals before and after.

mod models;

use holonomy::Error;
use holonomy::prelude::*;
use models::*;

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

#[test]
fn what_is_on_the_constraints_is_not_touched() {
    let back = pendulum().project_positions(0.0, &[0.3, -0.4]).unwrap();
    assert_eq!((back.value, back.before, back.after), ([0.3, -0.4], [0.0], [0.0]));
    let v = PendulumVelocities { dot_x: 0.8, dot_y: 0.6 };
    let back = pendulum().project_velocities(0.0, &[0.3, -0.4], &v).unwrap();
    assert_eq!(back.value, v);
}

#[test]
fn far_away_points_come_back_too() {
    let back = pendulum().project_positions(0.0, &[30.0, -40.0]).unwrap();
    assert!((back.value[0] - 0.3).abs() < 1e-14 && (back.value[1] + 0.4).abs() < 1e-14);
    assert_eq!(back.before, [0.5 * (2500.0 - 0.25)]);
}

#[test]
fn moving_constraints_and_rows_that_stand_twice() {
    let bead = Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare().unwrap();
    let (t, s) = (0.6, BeadState { x: 1.3, y: 1.3 * 0.48f64.tan(), dot_x: -0.4 });
    let v = bead.velocities(t, &s);
    let (sin, cos) = 0.48f64.sin_cos();
    // Across the rod by 0.1.
    let back = bead.project_positions(t, &[s.x - 0.1 * sin, s.y + 0.1 * cos]).unwrap();
    assert!((back.value[0] - s.x).abs() < 1e-14 && (back.value[1] - s.y).abs() < 1e-14);
    assert!((back.before[0] - 0.1).abs() < 1e-14 && (back.before[1] - 0.3).abs() < 1e-14);
    let off = BeadVelocities { dot_x: v.dot_x - 0.1 * sin, dot_y: v.dot_y + 0.1 * cos };
    let back = bead.project_velocities(t, &[s.x, s.y], &off).unwrap();
    assert!((back.value.dot_x - v.dot_x).abs() < 1e-14 && (back.value.dot_y - v.dot_y).abs() < 1e-14);
    assert!((back.before[0] - 0.1).abs() < 1e-14);
}

#[test]
fn what_has_no_way_back_is_told() {
    // No direction leads from the centre to the circle.
    let error = pendulum().project_positions(2.0, &[0.0, 0.0]).unwrap_err();
    assert_eq!(error, Error::Projection { constraint: "rod", residual: -0.125, time: 2.0 });
    assert_eq!(pendulum().project_positions(2.0, &[0.0, f64::NAN]), Err(Error::NonFinite { name: "y" }));
    assert_eq!(pendulum().project_positions(f64::NAN, &[0.0, 0.5]), Err(Error::NonFinite { name: "t" }));
    let v = PendulumVelocities { dot_x: 0.0, dot_y: f64::INFINITY };
    let error = pendulum().project_velocities(0.0, &[0.3, -0.4], &v).unwrap_err();
    assert_eq!(error, Error::NonFinite { name: "dot_y" });
}
