//! Constraints that are nonlinear in the velocities or stated for accelerations, against closed forms and published motions.
//!
//! Accelerations and reactions at a state to a relative 1e-12; motions, by an extrapolation integrator of order 16, to 1e-9.

mod models;
mod support;

use holonomy::{ConstrainedSystem, Error};
use models::{
    AppellHamel, AppellHamelState, ConstantSpeed, ConstantSpeedState, CurvedPath, Prescribed, Pushed, SteadySlope,
    TripleRod, TripleRodState,
};
use serde_json::Value;
use support::golden::{assert_close, list, parse, picked, text};
use support::running::Running;
use support::special::gudermannian;

const APPELL_HAMEL: &str = include_str!("data/appell_hamel.json");
const CURVATURE: &str = include_str!("data/curvature_constraint.json");
const AT_A_STATE: f64 = 1e-12;
const IN_MOTION: f64 = 1e-9;
const G: f64 = 9.81;

/// v̇ and λ also solve the full equations (2.8), by dense algebra over the pieces of the initial system.
fn agrees_with_the_full_equations<M: ConstrainedSystem<Inputs<f64> = [f64; 0]>>(model: &Running<M>, t: f64, y: &[f64]) {
    let full = model.0.initial_equations_at(t, &model.state(y), &[]);
    let (rates, lambda) = full.solve().expect("the rows are independent");
    let name = M::MODEL.name;
    assert_close(&format!("{name}: v̇"), &model.velocity_rates(t, y), rates.as_slice(), AT_A_STATE);
    assert_close(&format!("{name}: λ"), &model.multipliers(t, y), lambda.as_slice(), AT_A_STATE);
}

#[test]
fn p6_constant_speed() {
    let (m, c) = (1.4, 2.5);
    let model = Running::new(ConstantSpeed { m, g: G, c });
    let v = |t: f64| [c / (G * t / c).cosh(), -c * (G * t / c).tanh()];
    let times: Vec<f64> = (0..=10).map(|i| 0.1 * f64::from(i)).collect();
    for (t, y) in times.iter().zip(model.run(&[0.0, 0.0, c, 0.0], &times, 0.02)) {
        let x = [c * c / G * gudermannian(G * t / c), -c * c / G * (G * t / c).cosh().ln()];
        assert_close("x", &y[..2], &x, IN_MOTION);
        assert_close("v", &y[2..], &v(*t), IN_MOTION);
        // λ as the emitted code has it, at the exact velocities
        let exact = [x, v(*t)].concat();
        let lambda = -(m * G / c) * (G * t / c).tanh();
        let error = (model.multiplier("speed", *t, &exact) - lambda).abs();
        assert!(error <= AT_A_STATE * m * G / c, "λ at {t}: off by {error:e}");
        agrees_with_the_full_equations(&model, *t, &exact);
        // the work of the reaction keeps the speed
        assert!((model.energy(*t, &exact) - m * (c * c / 2.0 + G * x[1])).abs() < 1e-12 * m * c * c);
    }
}

/// The pivot of M_d may vanish without the constraint failing: the emitted motion goes on there.
#[test]
fn p6_in_every_direction() {
    let model = Running::new(ConstantSpeed { m: 1.4, g: G, c: 2.5 });
    for i in 0..64 {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / 64.0).sin_cos();
        let y = [0.3, -0.2, 2.5 * cos, 2.5 * sin];
        agrees_with_the_full_equations(&model, 0.0, &y);
    }
    let level = [0.0, 0.0, 0.0, -2.5];
    assert_close("v̇ straight down", &model.velocity_rates(0.0, &level), &[0.0, 0.0], AT_A_STATE);
}

#[test]
fn p7_steady_slope_on_both_branches() {
    let (m, a) = (0.9, 1.3);
    let model = Running::new(SteadySlope { m, g: G, a });
    let fall = -G / (1.0 + a * a);
    for (rate, direction) in [(-0.7, 0.4_f64), (6.0, -2.0)] {
        let (sin, cos) = direction.sin_cos();
        let times: Vec<f64> = (0..=8).map(|i| 0.2 * f64::from(i)).collect();
        let start = [0.1, 0.2, 0.3, a * rate * cos, a * rate * sin, rate];
        for (t, y) in times.iter().zip(model.run(&start, &times, 0.05)) {
            let fallen = rate * t + fall * t * t / 2.0;
            let moved = [0.1 + a * fallen * cos, 0.2 + a * fallen * sin, 0.3 + fallen];
            let z = rate + fall * t;
            let exact = [moved[0], moved[1], moved[2], a * z * cos, a * z * sin, z];
            assert_close("state", &y, &exact, IN_MOTION);
            let rates = [a * fall * cos, a * fall * sin, fall];
            assert_close("v̇", &model.velocity_rates(*t, &exact), &rates, AT_A_STATE);
            assert_close("λ", &model.multipliers(*t, &exact), &[-m * G / ((1.0 + a * a) * z)], AT_A_STATE);
            agrees_with_the_full_equations(&model, *t, &exact);
        }
    }
}

#[test]
fn p8_pushed() {
    let (m, k) = (1.7, 0.6);
    let model = Running::new(Pushed { m, g: G, k });
    let by = |t: f64| (t.cos() + k * G) / (1.0 + k * k);
    let times: Vec<f64> = (0..=8).map(|i| 0.5 * f64::from(i)).collect();
    for (t, y) in times.iter().zip(model.run(&[0.2, 0.1, 0.5, -0.3], &times, 0.05)) {
        assert_close("λ", &model.multipliers(*t, &y), &[m * by(*t)], AT_A_STATE);
        assert_close("v̇", &model.velocity_rates(*t, &y), &[by(*t), -G + k * by(*t)], AT_A_STATE);
        let (whole, half) =
            ((t.sin() + k * G * t) / (1.0 + k * k), (1.0 - t.cos() + k * G * t * t / 2.0) / (1.0 + k * k));
        let exact =
            [0.2 + 0.5 * t + half, 0.1 - 0.3 * t - G * t * t / 2.0 + k * half, 0.5 + whole, -0.3 - G * t + k * whole];
        assert_close("state", &y, &exact, IN_MOTION);
        agrees_with_the_full_equations(&model, *t, &y);
    }
}

#[test]
fn all_of_a_motion_can_be_prescribed() {
    let w = 1.3;
    let model = Running::new(Prescribed { m: 0.8, g: G, w });
    assert_eq!(model.accelerations(0.4, &[0.1, 0.2, 0.3, 0.4]).len(), 1);
    assert!(Prescribed::MODEL.reduced_speeds.is_empty());
    let times: Vec<f64> = (0..=6).map(|i| 0.5 * f64::from(i)).collect();
    for (t, y) in times.iter().zip(model.run(&[0.0, -1.0, -1.0, 0.0], &times, 0.05)) {
        // x = sin wt, y' = w x, z'' = w y'
        let (sin, cos) = (w * t).sin_cos();
        assert_close("state", &y, &[sin, -cos, -sin - 1.0 + w * t, w - w * cos], IN_MOTION);
        let expected = [-0.8 * w * w * sin, 0.8 * w * w * cos, 0.8 * (G + w * w * sin)];
        assert_close("λ", &model.multipliers(*t, &[sin, -cos, 0.0, 0.0]), &expected, AT_A_STATE);
    }
}

fn numbers_of(golden: &Value, names: &[&str]) -> Vec<f64> {
    picked(&golden["parameters"], names)
}

/// Coordinates, velocities, accelerations, λ and reactions at every published state, and the motion through them.
fn published<M: ConstrainedSystem<Inputs<f64> = [f64; 0]>>(
    model: &Running<M>,
    case: &Value,
    [coordinates, velocities, accelerations, reactions]: [&[&str]; 4],
    step: f64,
) {
    let rows = list(&case["expected"]);
    let times: Vec<f64> = rows.iter().map(|row| row["t"].as_f64().expect("a time")).collect();
    let start = picked(&rows[0], &[coordinates, velocities].concat());
    for (row, y) in rows.iter().zip(model.run(&start, &times, step)) {
        let t = row["t"].as_f64().expect("a time");
        let place = format!("{} {} at {t}", M::MODEL.name, case["name"]);
        let exact = picked(row, &[coordinates, velocities].concat());
        assert_close(&format!("{place}: v̇"), &model.velocity_rates(t, &exact), &picked(row, accelerations), AT_A_STATE);
        assert_close(&format!("{place}: λ"), &model.multipliers(t, &exact), &picked(row, &["lam"]), AT_A_STATE);
        let reaction = model.reaction(t, &exact);
        assert_close(&format!("{place}: Cᵀ λ"), reaction.as_slice(), &picked(row, reactions), AT_A_STATE);
        agrees_with_the_full_equations(model, t, &exact);
        let (x, v) = y.split_at(coordinates.len());
        assert_close(&format!("{place}: x"), x, &picked(row, coordinates), IN_MOTION);
        assert_close(&format!("{place}: v"), v, &picked(row, velocities), IN_MOTION);
    }
}

#[test]
fn appell_hamel_follows_the_published_motions() {
    let golden = parse(APPELL_HAMEL);
    let [m1, m2, g, c] = numbers_of(&golden, &["m1", "m2", "g", "c"])[..] else { panic!("four parameters") };
    let model = Running::new(AppellHamel { m1, m2, g, c });
    let cases = list(&golden["cases"]);
    let names: Vec<&str> = cases.iter().map(|case| text(&case["name"])).collect();
    assert_eq!(names, ["descending", "ascending"]);
    for case in cases {
        let read: [&[&str]; 4] = [
            &["x", "y", "z"],
            &["xd", "yd", "zd"],
            &["xdd", "ydd", "zdd"],
            &["reaction_x", "reaction_y", "reaction_z"],
        ];
        published(&model, case, read, 0.05);
    }
}

#[test]
fn a_path_of_given_curvature_follows_the_published_motion() {
    let golden = parse(CURVATURE);
    let [m, g, kappa] = numbers_of(&golden, &["m", "g", "kappa"])[..] else { panic!("three parameters") };
    let model = Running::new(CurvedPath { m, g, kappa });
    let read: [&[&str]; 4] = [&["x", "y"], &["xd", "yd"], &["xdd", "ydd"], &["reaction_x", "reaction_y"]];
    published(&model, &list(&golden["cases"])[0], read, 0.01);
}

#[test]
fn velocities_are_solved_for_on_the_branch_of_the_guess() {
    let (m1, m2, g, c) = (1.3, 0.7, G, 1.6);
    let model = AppellHamel { m1, m2, g, c }.prepare().expect("the parameters are good");
    for sign in [1.0, -1.0] {
        let guess = AppellHamelState { dot_x: 1.0, dot_y: -2.0, dot_z: 0.1 * sign, ..Default::default() };
        let found = model.solve_velocities(0.0, &guess, &["dot_x", "dot_y"]).expect("a branch near the guess");
        assert_close("z'", &[found.dot_z], &[sign * 5.0_f64.sqrt() / c], AT_A_STATE);
        assert_close("x', y'", &[found.dot_x, found.dot_y], &[1.0, -2.0], 0.0);
        // nothing held: the shortest way onto the cone
        let free = model.solve_velocities(0.0, &guess, &[]).expect("a branch near the guess");
        assert!(model.velocity_residual_at(0.0, &free)[0].abs() < 1e-14, "{free:?}");
        assert!(free.dot_z * sign > 0.1 && free.dot_x * guess.dot_x > 0.0, "{free:?}");
    }
}

#[test]
fn velocities_that_cannot_be_met_are_an_error_that_names_the_row() {
    let model = ConstantSpeed { m: 1.0, g: G, c: 2.0 }.prepare().expect("the parameters are good");
    let fast = ConstantSpeedState { dot_x: 3.0, dot_y: 1.0, ..Default::default() };
    let error = model.solve_velocities(0.0, &fast, &["dot_x"]).expect_err("too fast already");
    let Error::Assembly { constraint, residual, .. } = &error else { panic!("{error}") };
    assert_eq!(*constraint, "speed");
    assert!((residual - 2.5).abs() < 1e-6, "{error}");
    // at rest the row has no direction
    let rest = model.solve_velocities(0.0, &Default::default(), &[]).expect_err("no direction");
    assert!(matches!(rest, Error::Assembly { constraint: "speed", residual: -2.0, .. }), "{rest}");
    let unknown = model.solve_velocities(0.0, &fast, &["x"]).expect_err("no speed");
    assert_eq!(unknown, Error::UnknownName { name: "x".into(), known: vec!["dot_x", "dot_y"] });
}

/// P14: the motion and Cᵀ λ are those of one rod, λ the shortest: 1/6, 1/6 and 2/6 of it (C is doubled in the last row).
#[test]
fn p14_rods_stated_thrice() {
    let (m, l) = (1.5, 0.8);
    let model = Running::new(TripleRod { m, g: G, l });
    let (sin, cos) = 0.6_f64.sin_cos();
    let rate = 0.9;
    let y = [l * sin, -l * cos, l * rate * cos];
    let lambda = -(m / (l * l)) * (l * l * rate * rate + G * l * cos);
    assert_close("λ", &model.multipliers(0.0, &y), &[lambda / 6.0, lambda / 6.0, lambda / 3.0], AT_A_STATE);
    let reaction = model.reaction(0.0, &y);
    assert_close("Cᵀ λ", reaction.as_slice(), &[lambda * l * sin, -lambda * l * cos], AT_A_STATE);
    let swing = -G / l * 0.6_f64.sin();
    let rates = [l * (swing * cos - rate * rate * sin), l * (swing * sin + rate * rate * cos)];
    assert_close("v̇", &model.velocity_rates(0.0, &y), &rates, AT_A_STATE);
    let start = TripleRodState { x: y[0], y: y[1], dot_x: y[2] };
    let run = model.0.simulate(start).tolerance(1e-10, 1e-10).until(0.4).expect("the rods hold");
    let (t, end) = run.last();
    assert!(model.0.position_residual_at(t, end).iter().all(|f| f.abs() < 1e-14));
    assert!((model.0.energy(t, end) - model.0.energy(0.0, &start)).abs() < 1e-8);
}
