//! Every error has its own value, and its message names the culprit.

mod models;

use holonomy::Error;
use holonomy::forms::NullSpaceMethod;
use holonomy::prelude::*;
use models::*;

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

/// The error has a message that contains all of these.
fn tells(error: &Error, parts: &[&str]) {
    let message = error.to_string();
    for part in parts {
        assert!(message.contains(part), "`{message}` does not name {part}");
    }
    assert!(!message.contains('\n') && !message.contains("  "), "`{message}`");
}

#[test]
fn parameters() {
    let error = Pendulum { m: 2.0, l: f64::INFINITY, g: 9.81 }.prepare().unwrap_err();
    assert_eq!(error, Error::NonFinite { name: "l" });
    tells(&error, &["`l`", "finite"]);
    for m in [0.0, -2.0] {
        let error = Pendulum { m, l: 0.5, g: 9.81 }.prepare().unwrap_err();
        assert_eq!(error, Error::Indefinite { pivot: "m", value: m, time: None });
        tells(&error, &["m is", "positive definite", "masses"]);
    }
    let error = Oscillator { m: 0.0, a: 0.0, k: 1.0, c: 0.0, b: 0.0 }.prepare().unwrap_err();
    assert_eq!(error, Error::SingularParameter { guard: "m", origin: "divided by" });
    tells(&error, &["m zero", "divided by"]);
}

#[test]
fn starts_that_are_not_finite() {
    for (start, name) in [
        (PendulumState { x: f64::NAN, y: -0.4, dot_x: 0.0 }, "x"),
        (PendulumState { x: 0.3, y: -0.4, dot_x: f64::INFINITY }, "dot_x"),
    ] {
        let interrupted = pendulum().simulate(start).until(1.0).unwrap_err();
        assert_eq!(interrupted.error, Error::NonFinite { name });
        assert_eq!(interrupted.trajectory.times(), [0.0]);
        assert_eq!(Error::from(interrupted), Error::NonFinite { name });
    }
    let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let error = pendulum().simulate(start).until(f64::NAN).unwrap_err().error;
    assert_eq!(error, Error::NonFinite { name: "end" });
    let error = pendulum().simulate(start).starting_at(f64::INFINITY).until(1.0).unwrap_err().error;
    assert_eq!(error, Error::NonFinite { name: "t" });
}

#[test]
fn options_that_are_not_positive() {
    let model = pendulum();
    let run = || model.simulate(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 });
    for (simulation, name) in [
        (run().method(Method::Rk4 { step: 0.0 }), "step"),
        (run().method(Method::Rk4 { step: f64::NAN }), "step"),
        (run().tolerance(-1e-9, 1e-9), "relative tolerance"),
        (run().tolerance(1e-9, 0.0), "absolute tolerance"),
        (run().every(-0.1), "spacing of the output"),
        (run().max_step(0.0), "longest step"),
    ] {
        match simulation.until(1.0).unwrap_err().error {
            error @ Error::NotPositive { name: found, .. } => {
                assert_eq!(found, name);
                tells(&error, &[name, "must be positive"]);
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn steps_that_lead_nowhere() {
    let model = pendulum();
    let run = || model.simulate(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 });
    let error = run().every(1e-300).until(1.0).unwrap_err().error;
    assert_eq!(error, Error::StepTooSmall { step: 1e-300, time: 0.0 });
    tells(&error, &["1e-300", "t = 0", "too small"]);
    let fixed = run().starting_at(1.0).method(Method::Rk4 { step: 1e-17 });
    let error = fixed.until(2.0).unwrap_err().error;
    assert!(matches!(error, Error::StepTooSmall { time: 1.0, .. }), "{error:?}");
}

#[test]
fn inconsistent_starts() {
    let error = pendulum().simulate(PendulumState { x: 0.3, y: -0.5, dot_x: 0.0 }).until(1.0).unwrap_err().error;
    match error {
        Error::Unmet { constraint: "rod", residual } => assert!((residual - 0.045).abs() < 1e-15),
        other => panic!("{other:?}"),
    }
    tells(&error, &["`rod`", "assemble", "e-2"]);
    // Nine digits are enough, and are completed in the first step.
    let rounded = PendulumState { x: 0.25, y: -0.433012701892, dot_x: 0.0 };
    let run = pendulum().simulate(rounded).until(0.1).unwrap();
    assert!(pendulum().position_residual_at(0.1, run.last().1)[0].abs() < 1e-16);
    let rounded = PendulumState { y: -0.4330127, ..rounded };
    assert!(matches!(pendulum().simulate(rounded).until(0.1).unwrap_err().error, Error::Unmet { .. }));
}

#[test]
fn chart_singularities_at_the_start() {
    // Exactly, and up to the rounding of a cosine at a right angle.
    for y in [0.0, 0.5 * std::f64::consts::FRAC_PI_2.cos(), -1e-17] {
        let start = PendulumState { x: 0.5, y, dot_x: 0.0 };
        let error = pendulum().simulate(start).until(1.0).unwrap_err().error;
        assert_eq!(error, Error::ChartSingularity { guard: "y", value: y, time: 0.0 });
        tells(&error, &["y is", "t = 0", "sign"]);
    }
    // A guard of the time alone.
    let bead = Bead { m: 1.5, w: 1.0, g: 9.81 }.prepare().unwrap();
    let time = std::f64::consts::FRAC_PI_2;
    let start = BeadState { x: 0.0, y: 1.0, dot_x: -1.0 };
    let error = bead.simulate(start).starting_at(time).until(2.0).unwrap_err().error;
    let value = time.cos();
    assert_eq!(error, Error::ChartSingularity { guard: "cos(w*t)", value, time });
}

#[test]
fn times_outside_of_a_trajectory() {
    let run =
        pendulum().simulate(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }).every(0.5).dense(false).until(1.0).unwrap();
    assert_eq!(run.at(1.5), Err(Error::OutOfRange { time: 1.5, from: 0.0, to: 1.0 }));
    assert!(matches!(run.at(f64::NAN), Err(Error::OutOfRange { .. })));
    assert_eq!(run.at(0.3), Err(Error::NoDenseOutput { time: 0.3 }));
    tells(&run.at(0.3).unwrap_err(), &["t = 0.3", "every"]);
    assert!(run.at(0.5).is_ok());
}

#[test]
fn errors_travel_as_standard_errors() {
    fn run() -> Result<(), Box<dyn std::error::Error>> {
        pendulum().simulate(PendulumState { x: 0.3, y: -0.5, dot_x: 0.0 }).until(1.0)?;
        Ok(())
    }
    fn converted() -> Result<(), Error> {
        pendulum().simulate(PendulumState { x: 0.3, y: -0.5, dot_x: 0.0 }).until(1.0)?;
        Ok(())
    }
    assert!(run().unwrap_err().to_string().contains("`rod`"));
    assert!(matches!(converted(), Err(Error::Unmet { .. })));
}

#[test]
fn ranks_that_are_lost_and_projections_that_leave_a_constraint() {
    let error = pendulum().check_rank(2.0, &PendulumState::default()).unwrap_err();
    tells(&error, &["`rod`", "y vanishes", "t = 2", "0e0", "redundant"]);
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
    let full = pendulum().initial_equations_at(0.0, &s, &[]);
    let mut twice = full.clone();
    twice.rows = vec!["rod", "again"];
    twice.constraint_matrix = full.constraint_matrix.clone().insert_row(1, 0.0);
    let row = full.constraint_matrix.row(0).into_owned();
    twice.constraint_matrix.set_row(1, &row);
    twice.constraint_bias = full.constraint_bias.push(full.constraint_bias[0] + 1.0);
    tells(&twice.solve().unwrap_err(), &["`rod`, `again`", "depend"]);
    let error = twice.solve_by(NullSpaceMethod::Svd).unwrap_err();
    tells(&error, &["`rod`, `again`", "contradict", "5e-1"]);
    // Along the rod instead of across it.
    let a = nalgebra::DVector::zeros(2);
    let error = full.stages().project(&["rod"], &full.constraint_matrix, &a).unwrap_err();
    assert!(matches!(error, Error::NotTangent { constraint: "rod", value } if (value - 0.25).abs() < 1e-15));
    tells(&error, &["`rod`", "2.5e-1", "D Cᵀ"]);
}

#[test]
fn assemblies_that_fail() {
    let error = pendulum().assemble(PendulumState { x: 0.7, y: -0.3, dot_x: 0.0 }).hold("x").solve().unwrap_err();
    tells(&error, &["`rod`", "1.2", "in its way", "`x`"]);
    // Nothing is in the way where nothing was asked for.
    let error = pendulum().assemble(PendulumState::default()).solve().unwrap_err();
    tells(&error, &["`rod`", "-1.25e-1", "another guess"]);
    assert!(!error.to_string().contains("in its way"));
}
