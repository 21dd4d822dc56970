//! Linearisation and steady motions of the models written by hand: inputs, time, constraints that move or stand twice.

mod models;

use holonomy::prelude::*;
use holonomy::{Error, Linearization, Trimmed};
use models::*;

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs().max(1.0), "{found:e} instead of {expected:e}");
}

fn matrix(linear: &Linearization, expected: [[f64; 2]; 2]) {
    (0..2).for_each(|i| (0..2).for_each(|j| close(linear.a[(i, j)], expected[i][j])));
}

#[test]
fn an_oscillator_about_a_state_that_is_no_equilibrium() {
    let model = Oscillator { m: 2.0, a: 0.1, k: 3.0, c: 0.7, b: 0.4 }.prepare().unwrap();
    let (t, s, tau) = (0.8, OscillatorState { x: 0.9, dot_x: -1.3 }, 0.25);
    let linear = model.linearize(t, &s, &OscillatorInputs { tau }).unwrap();
    assert_eq!((&linear.states[..], &linear.inputs[..]), (&["x", "dot_x"][..], &["tau"][..]));
    assert!(linear.dependents.is_empty() && linear.outputs.is_empty());
    let (force, mass) = (0.4 * t.sin() + tau - s.x * (3.0 + 0.7 * s.x * s.x), 2.0 * (1.0 + 0.1 * s.x));
    let slope = -(3.0 + 3.0 * 0.7 * s.x * s.x) / mass - force * 0.2 / (mass * mass);
    matrix(&linear, [[0.0, 1.0], [slope, 0.0]]);
    close(linear.b[(0, 0)], 0.0);
    close(linear.b[(1, 0)], 1.0 / mass);
    close(linear.rate[0], s.dot_x);
    close(linear.rate[1], force / mass);
}

/// One pendulum three ways: in the coordinates x and y the second one follows; its equations are those of the angle.
#[test]
fn a_pendulum_in_two_coordinates_is_that_of_the_angle() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let (alpha, w): (f64, f64) = (0.4, 1.7);
    let (sin, cos) = alpha.sin_cos();
    let swing = Swing { m, l, g }.prepare().unwrap();
    let linear = swing.linearize(0.0, &SwingState { alpha, dot_alpha: w }, &[]).unwrap();
    matrix(&linear, [[0.0, 1.0], [-g / l * cos, 0.0]]);

    let pendulum = Pendulum { m, l, g }.prepare().unwrap();
    let s = PendulumState { x: l * sin, y: -l * cos, dot_x: l * cos * w };
    let linear = pendulum.linearize(0.0, &s, &[]).unwrap();
    assert_eq!((&linear.states[..], &linear.dependents[..]), (&["x", "dot_x"][..], &["y"][..]));
    // (x, ẋ) = (l sin α, l cos α w): with T its derivative by (α, w), A = (Ṫ + T A_α) T⁻¹.
    let t = nalgebra::Matrix2::new(l * cos, 0.0, -l * sin * w, l * cos);
    let acceleration = -g / l * sin;
    let rate = nalgebra::Matrix2::new(-l * sin * w, 0.0, -l * (cos * w * w + sin * acceleration), -l * sin * w);
    let of_angle = nalgebra::Matrix2::new(0.0, 1.0, -g / l * cos, 0.0);
    let expected = (rate + t * of_angle) * t.try_inverse().unwrap();
    matrix(&linear, [[expected.m11, expected.m12], [expected.m21, expected.m22]]);
    // δy = tan α δx
    let tangent: Vec<f64> = linear.tangent.row(1).iter().copied().collect();
    close(tangent[0], sin / cos);
    close(tangent[1], 0.0);
}

/// The row of the turning rod stands twice in f, and moves: ρ̈ = w² ρ − g sin wt for the distance ρ.
#[test]
fn a_constraint_that_moves_and_stands_twice() {
    let (m, w, g) = (1.5, 0.9, 9.81);
    let bead = Bead { m, w, g }.prepare().unwrap();
    let t = 0.7;
    let ((sin, cos), (rho, rate)) = ((w * t).sin_cos(), (0.8, 0.3));
    let s = BeadState { x: rho * cos, y: rho * sin, dot_x: rate * cos - rho * w * sin };
    let linear = bead.linearize(t, &s, &[]).unwrap();
    assert_eq!((&linear.states[..], &linear.dependents[..]), (&["x", "dot_x"][..], &["y"][..]));
    // x = ρ cos wt: ẍ = −2 w tan wt ẋ − (2 w² tan² wt) x − g sin wt cos wt.
    let tan = sin / cos;
    matrix(&linear, [[0.0, 1.0], [-2.0 * w * w * tan * tan, -2.0 * w * tan]]);
    close(linear.rate[1], -2.0 * w * tan * s.dot_x - 2.0 * w * w * tan * tan * s.x - g * sin * cos);
}

#[test]
fn a_steady_spring_carries_its_load() {
    let model = Oscillator { m: 2.0, a: 0.0, k: 3.0, c: 1.0, b: 0.0 }.prepare().unwrap();
    // 3 x + x³ = 4 at x = 1.
    let found = model.trim(OscillatorState { x: 0.3, dot_x: 0.0 }).rest().set("tau", 4.0).solve().unwrap();
    close(found.state.x, 1.0);
    assert_eq!((found.state.dot_x, found.inputs.tau), (0.0, 4.0));
    let held = model.trim(OscillatorState { x: 2.0, dot_x: 0.0 }).rest().hold("x").free("tau").solve().unwrap();
    close(held.inputs.tau, 14.0);
    // A given acceleration: 2 ẍ = tau.
    let pushed = model.trim(OscillatorState::default()).hold("x").hold("dot_x").rate("dot_x", 1.5).free("tau");
    let pushed = pushed.solve().unwrap();
    close(pushed.inputs.tau, 3.0);
    close(pushed.rate.dot_x, 1.5);
    // Nothing is free, and the load is not carried.
    let error = model.trim(OscillatorState::default()).hold("x").hold("dot_x").set("tau", 4.0).solve().unwrap_err();
    let Error::NotSteady { what: "the rate of", name: "dot_x", residual, report } = &error else { panic!("{error}") };
    assert_eq!((*residual, report.unmet().count()), (2.0, 1));
    assert!(error.to_string().contains("the rate of `dot_x` remains off by 2e0"), "{error}");
}

#[test]
fn a_pendulum_in_two_coordinates_hangs() {
    let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let found = pendulum.trim(PendulumState { x: 0.2, y: -0.6, dot_x: 0.1 }).rest().solve().unwrap();
    assert!(found.state.x.abs() < 1e-15 && found.state.dot_x.abs() < 1e-15, "{:?}", found.state);
    close(found.state.y, -0.5);
    assert_eq!(found.report.constraints[0].name, "rod");
    let names: Vec<_> = found.report.rates.iter().map(|rate| rate.name).collect();
    assert_eq!(names, ["x", "y", "dot_x"]);
    // Held aside it does not rest; what binds it is told first where that is missed.
    let error = pendulum.trim(PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }).rest().hold("x").solve().unwrap_err();
    assert!(matches!(error, Error::NotSteady { name: "dot_x", .. }), "{error}");
}

#[test]
fn what_is_wrong_has_a_name() {
    let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let linearize = |s: &PendulumState| pendulum.linearize(0.0, s, &[]).unwrap_err();
    assert_eq!(linearize(&PendulumState { y: f64::NAN, ..s }), Error::NonFinite { name: "y" });
    assert!(matches!(linearize(&PendulumState { y: -0.5, ..s }), Error::Unmet { constraint: "rod", .. }));
    let level = linearize(&PendulumState { x: 0.5, y: 0.0, dot_x: 0.0 });
    assert!(matches!(level, Error::ChartSingularity { guard: "y", .. }), "{level}");
    assert_eq!(pendulum.linearize(f64::NAN, &s, &[]).unwrap_err(), Error::NonFinite { name: "t" });
    let oscillator = Oscillator { m: 2.0, a: 1.0, k: 3.0, c: 1.0, b: 0.0 }.prepare().unwrap();
    let error = |x, tau| oscillator.linearize(0.0, &OscillatorState { x, dot_x: 0.0 }, &OscillatorInputs { tau });
    assert_eq!(error(0.0, f64::INFINITY).unwrap_err(), Error::NonFinite { name: "tau" });
    assert!(matches!(error(-2.0, 0.0).unwrap_err(), Error::Indefinite { .. }));

    let trim = || oscillator.trim(OscillatorState::default());
    let unknown = |result: Result<Trimmed<Oscillator>, Error>| match result {
        Err(Error::UnknownName { name, known }) => (name, known),
        other => panic!("{other:?}"),
    };
    assert_eq!(unknown(trim().free("x").solve()), ("x".into(), vec!["tau"]));
    assert_eq!(unknown(trim().rate("tau", 1.0).solve()), ("tau".into(), vec!["x", "dot_x"]));
    assert_eq!(unknown(trim().hold("z").solve()), ("z".into(), vec!["x", "dot_x", "tau"]));
    assert_eq!(trim().set("tau", f64::NAN).solve().unwrap_err(), Error::NonFinite { name: "tau" });
    assert_eq!(trim().rate("dot_x", f64::NAN).solve().unwrap_err(), Error::NonFinite { name: "dot_x" });
}
