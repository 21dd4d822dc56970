//! The way back onto the constraints.

use super::*;
use crate::drift::Drift;
use crate::models::{Bead, BeadState, Pendulum, PendulumState};

#[test]
fn the_way_back_is_the_shortest_one() {
    let model = Pendulum { m: 1.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let near = PendulumState { x: 0.3, y: -0.4, dot_x: 1.0 };
    let mut manifold = Manifold::new(&model, 0.0, &near).unwrap();
    let mut s = PendulumState { x: 0.3 + 3e-7, y: -0.4 - 4e-7, dot_x: 1.0 };
    assert!(manifold.restore(&model, 0.0, &mut s).unwrap());
    assert!((s.x - 0.3).abs() < 1e-15 && (s.y + 0.4).abs() < 1e-15 && s.dot_x == 1.0);
    assert!(!manifold.restore(&model, 0.0, &mut s).unwrap());
}

#[test]
fn dependent_rows_are_met_together() {
    let model = Bead { m: 1.0, w: 0.5, g: 9.81 }.prepare().unwrap();
    let mut s = BeadState { x: 1.0, y: 0.001, dot_x: 0.0 };
    let mut manifold = Manifold::new(&model, 0.0, &s).unwrap();
    assert!(manifold.restore(&model, 0.0, &mut s).unwrap());
    assert_eq!(s, BeadState { x: 1.0, y: 0.0, dot_x: 0.0 });
}

#[test]
fn no_way_back_is_an_error() {
    let model = Pendulum { m: 1.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let near = PendulumState { x: 0.3, y: -0.4, dot_x: 1.0 };
    let mut manifold = Manifold::new(&model, 0.0, &near).unwrap();
    // The gradient of the constraint vanishes here.
    let mut s = PendulumState { x: 0.0, y: 0.0, dot_x: 1.0 };
    let error = manifold.restore(&model, 2.0, &mut s).unwrap_err();
    assert_eq!(error, Error::Projection { constraint: "rod", residual: -0.125, time: 2.0 });
    let mut s = PendulumState { x: f64::NAN, y: 0.0, dot_x: 1.0 };
    assert!(matches!(manifold.restore(&model, 2.0, &mut s), Err(Error::Projection { .. })));
}

/// The general chart's velocities go back along M⁻¹ Cᵀ, which for equal masses is the normal.
#[test]
fn velocities_go_back_by_the_least_change() {
    let model = Pendulum { m: 1.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 1.0 };
    let v = model.velocities(0.0, &s);
    let mut drift = Drift::new(&model, Carriers::General, 0.0, &[0.3, -0.4], &v).unwrap().unwrap();
    let mut w = [v.dot_x + 3e-6, v.dot_y - 4e-6];
    assert!(drift.restore(&model, 0.0, &s, &mut w).unwrap());
    assert!((w[0] - v.dot_x).abs() < 1e-15 && (w[1] - v.dot_y).abs() < 1e-15, "{w:?} {v:?}");
    assert!(drift.last < 1e-15 && !drift.restore(&model, 0.0, &s, &mut w).unwrap());
    // The speeds of the emitted chart satisfy the row by construction.
    assert!(Drift::new(&model, Carriers::Chart(0), 0.0, &[0.3, -0.4], &v).unwrap().is_none());
}
