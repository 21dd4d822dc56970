//! Assembly: what is held, what is met, what cannot be met.

mod models;

use holonomy::Error;
use holonomy::prelude::*;
use models::*;

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

#[test]
fn the_nearest_configuration_is_found_and_speeds_are_kept() {
    let start = pendulum().assemble(PendulumState { x: 0.6, y: -0.8, dot_x: 0.7 }).solve().unwrap();
    assert!((start.x - 0.3).abs() < 1e-15 && (start.y + 0.4).abs() < 1e-15);
    assert_eq!(start.dot_x, 0.7);
}

#[test]
fn a_configuration_that_fits_is_not_touched() {
    let guess = PendulumState { x: 0.3, y: -0.4, dot_x: 0.7 };
    assert_eq!(pendulum().assemble(guess).solve().unwrap(), guess);
    let free = OscillatorState { x: 0.3, dot_x: 0.4 };
    let oscillator = Oscillator { m: 1.0, a: 0.0, k: 1.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    assert_eq!(oscillator.assemble(free).solve().unwrap(), free);
}

#[test]
fn held_coordinates_stay_exactly() {
    let far = PendulumState { x: 0.1, y: 80.0, dot_x: 0.0 };
    let start = pendulum().assemble(far).hold("x").hold("dot_x").solve().unwrap();
    assert_eq!(start.x, 0.1);
    assert!((start.y - 0.24f64.sqrt()).abs() < 1e-15);
}

#[test]
fn a_double_root_is_met() {
    // The circle touches the line x = l.
    let start = pendulum().assemble(PendulumState { x: 0.5, y: -0.3, dot_x: 0.0 }).hold("x").solve().unwrap();
    assert!(start.y.abs() < 1e-7);
}

#[test]
fn constraints_that_move_are_met_at_their_time_and_dependent_rows_do_no_harm() {
    let bead = Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare().unwrap();
    let start = bead.assemble(BeadState { x: 1.0, y: 0.0, dot_x: 0.0 }).hold("x").at_time(1.0).solve().unwrap();
    assert!((start.y - 0.8f64.tan()).abs() < 1e-15);
    let nearest = bead.assemble(BeadState { x: 1.0, y: 0.0, dot_x: 0.0 }).at_time(1.0).solve().unwrap();
    assert!((nearest.x - 0.8f64.cos().powi(2)).abs() < 1e-14);
}

#[test]
fn what_cannot_be_met_is_told_with_its_residual() {
    let error = pendulum().assemble(PendulumState { x: 0.7, y: -0.3, dot_x: 0.0 }).hold("x").solve().unwrap_err();
    match error {
        // f = (x² + y² − l²)/2 is least at y = 0.
        Error::Assembly { constraint: "rod", residual } => assert!((residual - 0.12).abs() < 1e-9),
        other => panic!("{other:?}"),
    }
    // Nothing is free.
    let guess = PendulumState { x: 0.3, y: -0.3, dot_x: 0.0 };
    let held = pendulum().assemble(guess).hold("x").hold("y").solve();
    assert!(matches!(held, Err(Error::Assembly { constraint: "rod", .. })));
    // At the pivot point no direction leads to the circle.
    let lost = pendulum().assemble(PendulumState::default()).solve();
    assert!(matches!(lost, Err(Error::Assembly { constraint: "rod", .. })));
}

#[test]
fn wrong_names_and_figures_are_told() {
    let guess = PendulumState { x: 0.3, y: -0.3, dot_x: 0.0 };
    let error = pendulum().assemble(guess).hold("z").solve().unwrap_err();
    assert_eq!(error, Error::UnknownName { name: "z".into(), known: vec!["x", "y", "dot_x"] });
    assert_eq!(error.to_string(), "there is no `z`; there are `x`, `y`, `dot_x`");
    let error = pendulum().assemble(PendulumState { y: f64::INFINITY, ..guess }).solve();
    assert_eq!(error, Err(Error::NonFinite { name: "y" }));
    let error = pendulum().assemble(guess).at_time(f64::NAN).solve();
    assert_eq!(error, Err(Error::NonFinite { name: "t" }));
    // Too large for squares.
    let error = pendulum().assemble(PendulumState { x: 1e200, ..guess }).solve();
    assert!(matches!(error, Err(Error::Assembly { .. })));
}
