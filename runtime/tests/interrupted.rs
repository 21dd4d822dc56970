//! Runs that end early: each for its own reason, with the trajectory so far.

mod models;

use holonomy::Error;
use holonomy::prelude::*;
use holonomy::simulate::Charts;
use models::*;

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

fn oscillator(a: f64, k: f64, c: f64) -> Prepared<Oscillator> {
    Oscillator { m: 1.0, a, k, c, b: 0.0 }.prepare().unwrap()
}

fn undriven(_: f64, _: &OscillatorState) -> OscillatorInputs {
    OscillatorInputs { tau: 0.0 }
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
fn chart_singularities_on_the_way_end_every_method() {
    let start = PendulumState { x: 0.0, y: -0.5, dot_x: 4.0 };
    for method in [Method::Rk4 { step: 1e-3 }, Method::Rk4 { step: 0.03 }, Method::DormandPrince, Method::Dop853] {
        let model = pendulum();
        let interrupted = model.simulate(start).charts(Charts::Stay).method(method).until(10.0).unwrap_err();
        match interrupted.error {
            Error::ChartSingularity { guard: "y", time, .. } => {
                assert!((0.1..0.3).contains(&time), "{method:?}: {time}")
            }
            ref other => panic!("{method:?}: {other:?}"),
        }
        let run = &interrupted.trajectory;
        assert!(run.times().len() > 3 && run.iter().all(|(_, s)| s.y < 0.0 && s.dot_x.is_finite()), "{method:?}");
    }
}

#[test]
fn a_constraint_that_moves_leaves_its_chart() {
    // cos wt passes through zero smoothly: only the change of sign tells.
    let bead = Bead { m: 1.5, w: 1.0, g: 0.0 }.prepare().unwrap();
    let start = BeadState { x: 1.0, y: 0.0, dot_x: 0.0 };
    for method in [Method::Rk4 { step: 0.01 }, Method::DormandPrince, Method::Dop853] {
        let run = bead.simulate(start).charts(Charts::Stay).method(method).until(3.0);
        let error = run.unwrap_err().error;
        match error {
            Error::ChartSingularity { guard: "cos(w*t)", time, .. } => assert!((time - 1.57).abs() < 0.3, "{time}"),
            other => panic!("{method:?}: {other:?}"),
        }
    }
}

#[test]
fn fixed_steps_judge_the_guards_of_every_stage() {
    // cos wt is positive at both ends of the one step, and negative at the stages in its middle.
    let bead = Bead { m: 1.5, w: 1.0, g: 0.0 }.prepare().unwrap();
    let start = BeadState { x: 1.0, y: 0.0, dot_x: 0.0 };
    let step = 1.6 * std::f64::consts::PI;
    let run = bead.simulate(start).charts(Charts::Stay).method(Method::Rk4 { step }).until(step);
    let interrupted = run.unwrap_err();
    match interrupted.error {
        Error::ChartSingularity { guard: "cos(w*t)", time, value } => {
            assert!(time == 0.5 * step && value < 0.0, "{value} at {time}")
        }
        other => panic!("{other:?}"),
    }
    assert_eq!(interrupted.trajectory.times(), [0.0]);
}

#[test]
fn indefinite_inertia() {
    // m (1 + a x) < 0 at the start …
    let start = OscillatorState { x: -3.0, dot_x: 0.0 };
    let error = oscillator(0.5, 1.0, 0.0).simulate(start).inputs(undriven).until(1.0).unwrap_err().error;
    assert_eq!(error, Error::Indefinite { pivot: "m*(1 + a*x)", value: -0.5, time: Some(0.0) });
    tells(&error, &["m*(1 + a*x)", "t = 0", "positive"]);
    // … and on the way, where a fixed step jumps over the zero.
    let start = OscillatorState { x: 0.0, dot_x: -10.0 };
    let model = oscillator(0.5, 0.0, 0.0);
    let error = model.simulate(start).inputs(undriven).method(Method::Rk4 { step: 0.03 }).until(1.0).unwrap_err().error;
    assert!(matches!(error, Error::Indefinite { time: Some(t), .. } if (0.2..0.25).contains(&t)), "{error:?}");
}

#[test]
fn inputs() {
    let model = oscillator(0.0, 1.0, 0.0);
    let start = OscillatorState { x: 1.0, dot_x: 0.0 };
    let error = model.simulate(start).until(1.0).unwrap_err().error;
    assert_eq!(error, Error::MissingInputs { inputs: &["tau"] });
    tells(&error, &["`tau`", "inputs"]);
    for method in [Method::Rk4 { step: 0.01 }, Method::DormandPrince, Method::Dop853] {
        for when in [0.0, 0.5] {
            let source = |t: f64, _: &OscillatorState| OscillatorInputs { tau: if t < when { 0.0 } else { f64::NAN } };
            let interrupted = model.simulate(start).method(method).inputs(source).until(1.0).unwrap_err();
            let (t, last) = interrupted.trajectory.last();
            assert!(last.x.is_finite() && t <= when);
            match interrupted.error {
                Error::NonFinite { name: "tau" } => {}
                other => panic!("{method:?}: {other:?}"),
            }
        }
    }
}

#[test]
fn divergence() {
    // x¨ = x³ reaches infinity in finite time.
    let model = oscillator(0.0, 0.0, -1.0);
    let start = OscillatorState { x: 1.0, dot_x: 1.0 };
    let fixed = model.simulate(start).inputs(undriven).method(Method::Rk4 { step: 0.1 }).until(10.0).unwrap_err();
    assert!(matches!(fixed.error, Error::Diverged { .. }), "{:?}", fixed.error);
    tells(&fixed.error, &["no longer finite", "smaller step"]);
    assert!(fixed.trajectory.iter().all(|(_, s)| s.x.is_finite() && s.dot_x.is_finite()));
    for method in [Method::DormandPrince, Method::Dop853] {
        let error = model.simulate(start).inputs(undriven).method(method).until(10.0).unwrap_err().error;
        assert!(matches!(error, Error::StepTooSmall { .. } | Error::Diverged { .. }), "{error:?}");
        tells(&error, &["t = 1."]);
    }
}

#[test]
fn too_many_steps() {
    let model = pendulum();
    let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    for method in [Method::Rk4 { step: 1e-3 }, Method::DormandPrince, Method::Dop853] {
        let interrupted = model.simulate(start).method(method).max_steps(7).until(10.0).unwrap_err();
        let (t, _) = interrupted.trajectory.last();
        assert_eq!(interrupted.error, Error::TooManySteps { steps: 7, time: t });
        tells(&interrupted.error, &["7 steps", "max_steps"]);
        assert!(t > 0.0 && interrupted.trajectory.at(t / 2.0).is_ok());
    }
}
