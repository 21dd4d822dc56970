//! Assembly: what is held, what is met, what cannot be met.

mod models;

use holonomy::prelude::*;
use holonomy::{Dual, Error};
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
        Error::Assembly { constraint: "rod", residual, .. } => assert!((residual - 0.12).abs() < 1e-9),
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
    assert_eq!(error, Error::UnknownName { name: "z".into(), known: vec!["x", "y", "dot_x", "dot_y"] });
    assert_eq!(error.to_string(), "there is no `z`; there are `x`, `y`, `dot_x`, `dot_y`");
    let error = pendulum().assemble(guess).solve_for("length").solve().unwrap_err();
    assert_eq!(error, Error::UnknownName { name: "length".into(), known: vec!["m", "l", "g"] });
    let error = pendulum().assemble(guess).set("dot_y", f64::NAN).solve().unwrap_err();
    assert_eq!(error, Error::NonFinite { name: "dot_y" });
    let error = pendulum().assemble(guess).meet("height", f64::INFINITY, |_, _, s| s.y).solve().unwrap_err();
    assert_eq!(error, Error::NonFinite { name: "height" });
    let error = pendulum().assemble(PendulumState { y: f64::INFINITY, ..guess }).solve();
    assert_eq!(error, Err(Error::NonFinite { name: "y" }));
    let error = pendulum().assemble(guess).at_time(f64::NAN).solve();
    assert_eq!(error, Err(Error::NonFinite { name: "t" }));
    // Too large for squares.
    let error = pendulum().assemble(PendulumState { x: 1e200, ..guess }).solve();
    assert!(matches!(error, Err(Error::Assembly { .. })));
}

fn swing() -> Prepared<Swing> {
    Swing { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

#[test]
fn dependent_coordinates_and_velocities_are_held_at_values() {
    // x = l sin α, ẏ = l sin α α̇
    let guess = SwingState { alpha: 0.2, dot_alpha: 0.0 };
    let start = swing().assemble(guess).set("x", 0.3).set("dot_y", 0.6).solve().unwrap();
    assert!((start.alpha - 0.6f64.asin()).abs() < 1e-14 && (start.dot_alpha - 2.0).abs() < 1e-14);
    // Kept as the guess has it.
    let start = swing().assemble(SwingState { dot_alpha: 1.0, ..start }).hold("dot_x").set("y", -0.3).solve().unwrap();
    assert!((swing().velocities(0.0, &start).dot_x - 0.4).abs() < 1e-15 && (start.alpha.cos() - 0.6).abs() < 1e-15);
    // A constraint that moves: ẏ = ẋ tan wt + …
    let bead = Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare().unwrap();
    let guess = BeadState { x: 1.0, y: 0.0, dot_x: 0.0 };
    let start = bead.assemble(guess).at_time(1.0).hold("x").set("dot_y", 0.0).solve().unwrap();
    assert!(bead.velocities(1.0, &start).dot_y.abs() < 1e-15 && start.dot_x.abs() > 0.1 && start.x == 1.0);
    // Entries of the state take their values exactly, and the last word counts.
    let model = pendulum();
    let start = model.assemble(PendulumState::default()).set("x", 9.0).set("x", 0.3).set("dot_x", 0.7);
    let start = start.meet("below", -0.4, |_, _, s| s.y).solve().unwrap();
    assert!(start.x == 0.3 && start.dot_x == 0.7 && (start.y + 0.4).abs() < 1e-15);
}

#[test]
fn velocities_that_a_chart_does_not_give_are_told_with_its_guard() {
    // The rod is level: ẋ says nothing about ẏ.
    let guess = PendulumState { x: 0.5, y: 0.0, dot_x: 0.0 };
    let error = pendulum().assemble(guess).hold("y").set("dot_y", 1.0).solve().unwrap_err();
    assert_eq!(error, Error::ChartSingularity { guard: "y", value: 0.0, time: 0.0 });
}

#[test]
fn quantities_of_positions_move_coordinates_and_those_of_speeds_speeds() {
    let guess = PendulumState { x: 0.1, y: -0.4, dot_x: 2.0 };
    let start = pendulum()
        .assemble(guess)
        .meet("height", 0.1, |model, t, s| model.coordinates(t, s)[1] + Dual::constant(0.5))
        .meet("kinetic energy", 0.25, |model, t, s| {
            model.kinetic_energy(t, &model.coordinates(t, s), &model.velocities(t, s))
        })
        .solve()
        .unwrap();
    assert!((start.y + 0.4).abs() < 1e-15 && (start.x - 0.3).abs() < 1e-14);
    let v = pendulum().velocities(0.0, &start);
    assert!((v.dot_x * v.dot_x + v.dot_y * v.dot_y - 0.25).abs() < 1e-14 && v.dot_x > 0.0);
    // From rest the energy does not tell which way to go, and that is said.
    let rest = PendulumState { dot_x: 0.0, ..start };
    let error = pendulum().assemble(rest).meet("energy", 1.0, |model, t, s| model.energy(t, s)).solve().unwrap_err();
    let energy = -2.0 * 9.81 * 0.4;
    match error {
        Error::Assembly { constraint: "energy", residual, report } => {
            assert!((residual - energy + 1.0).abs() < 1e-12);
            let names: Vec<&str> = report.entries.iter().map(|entry| entry.name).collect();
            assert_eq!((names, report.conflicts), (vec!["energy"], vec!["energy"]));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_report_tells_what_was_met_what_not_and_what_is_in_the_way() {
    let guess = PendulumState { x: 0.3, y: -0.3, dot_x: 0.0 };
    let found = pendulum().assemble(guess).hold("x").set("dot_y", 0.1).solve_all().unwrap();
    assert_eq!(found.parameters, *pendulum().parameters());
    assert_eq!(found.report.unmet().count(), 0);
    let [rod] = found.report.entries[..1] else { panic!("{:?}", found.report) };
    assert!(rod.name == "rod" && rod.met && rod.residual.abs() < 1e-15 && rod.size > 0.1);
    // Two quantities and the rod cannot be met by two coordinates.
    let error = pendulum()
        .assemble(guess)
        .meet("right", 0.4, |_, _, s| s.x)
        .meet("down", -0.6, |_, _, s| s.y)
        .solve()
        .unwrap_err();
    let text = error.to_string();
    match error {
        Error::Assembly { report, .. } => {
            assert_eq!(report.conflicts, ["right", "down"]);
            assert_eq!(report.unmet().count(), 3);
            assert!(text.contains("`right`, `down`"), "{text}");
        }
        other => panic!("{other:?}"),
    }
    // At the lowest point the held y is in the way and x is not: the circle is level there.
    let below = PendulumState { x: 0.0, y: -0.6, dot_x: 0.0 };
    match pendulum().assemble(below).hold("x").hold("y").solve().unwrap_err() {
        Error::Assembly { constraint: "rod", report, .. } => assert_eq!(report.conflicts, ["y"]),
        other => panic!("{other:?}"),
    }
}

#[test]
fn parameters_are_solved_for_and_given_back() {
    let guess = PendulumState { x: 0.3, y: -0.3, dot_x: 0.0 };
    let found = pendulum().assemble(guess).hold("x").hold("y").solve_for("l").solve_all().unwrap();
    assert!((found.parameters.l - 0.18f64.sqrt()).abs() < 1e-15);
    assert_eq!((found.parameters.m, found.parameters.g, found.state), (2.0, 9.81, guess));
    // Without the parameter the same cannot be met.
    assert!(pendulum().assemble(guess).hold("x").hold("y").solve().is_err());
    // A mass that does not enter is left alone; one that would have to be negative is not found.
    let found = pendulum().assemble(guess).hold("x").solve_for("m").solve_all().unwrap();
    assert!(found.parameters.m == 2.0 && (found.state.y + 0.4).abs() < 1e-15);
    let model = pendulum();
    let light = model.assemble(guess).hold("x").solve_for("m");
    let light = light.meet("weight", -1.0, |model, _, _| model.parameters().m * model.parameters().g).solve();
    assert!(matches!(light, Err(Error::Assembly { constraint: "weight", .. })));
}
