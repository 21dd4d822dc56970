//! Closed loops of the literature from geometry alone, against numbers from outside, as the same mechanisms by equations.

#[path = "models/geometry/loops.rs"]
mod loops;
mod support;

use holonomy::Error;
use holonomy::prelude::*;
use loops::{CrankAndSlider, CrankAndSliderState, FourBarOfRods, Squeezer};
use support::andrews::andrews;
use support::golden::{assert_close, assert_close_at, case, from_json, list, numbers, parse, picked};
use support::running::Running;

const AT_A_STATE: f64 = 1e-12;
/// Where the data are evaluations of other programs.
const EVALUATED: f64 = 1e-11;
const IN_MOTION: f64 = 1e-9;

/// λ of the named rows.
fn lambda<M: ConstrainedSystem>(running: &Running<M>, names: &[&str], y: &[f64]) -> Vec<f64> {
    names.iter().map(|name| running.multiplier(name, 0.0, y)).collect()
}

#[test]
fn four_bar() {
    let golden = parse(include_str!("data/four_bar.json"));
    let model = from_json!(
        golden["params"],
        FourBarOfRods { l1: "l1", l2: "l2", l3: "l3", d: "d", m1: "m1", m2: "m2", m3: "m3", g: "g", tau: "tau" }
    );
    let bar = Running::new(model);
    for state in list(&golden["states"]) {
        let y = picked(state, &["q", "u1"]);
        assert_close("q'", &bar.velocities(0.0, &y), &numbers(&state["qd"]), AT_A_STATE);
        assert_close("q''", &bar.velocity_rates(0.0, &y), &numbers(&state["qdd"]), EVALUATED);
        assert_close("λ", &lambda(&bar, &["closure_x", "closure_y"], &y), &numbers(&state["lambda"]), EVALUATED);
    }
}

const LOOPS: [&str; 6] = ["b_x", "b_y", "delta_tip_x", "delta_tip_y", "epsilon_tip_x", "epsilon_tip_y"];

/// The test set writes M a = f - Gᵀ λ.
fn negative(values: Vec<f64>) -> Vec<f64> {
    values.into_iter().map(|v| -v).collect()
}

#[test]
fn andrews_at_states() {
    let golden = parse(include_str!("data/andrews_states.json"));
    let mechanism = Running::new(andrews!(Squeezer, golden["params"]));
    for state in list(&golden["states"]) {
        let y = picked(state, &["q", "v1"]);
        // accelerations at rest are of the size of the torque on the crank
        assert_close_at("q'", &mechanism.velocities(0.0, &y), &numbers(&state["qd"]), EVALUATED, 1.0);
        assert_close("q''", &mechanism.velocity_rates(0.0, &y), &numbers(&state["qdd"]), EVALUATED);
        assert_close("λ", &negative(lambda(&mechanism, &LOOPS, &y)), &numbers(&state["lambda"]), EVALUATED);
    }
}

#[test]
fn andrews_in_motion() {
    let golden = parse(include_str!("data/andrews.json"));
    let mechanism = Running::new(andrews!(Squeezer, golden["parameters"]));
    let rows = list(&case(&golden, "recomputed_trajectory")["expected"]);
    let start = [numbers(&golden["initial"]["q"]), vec![0.0]].concat();
    let initial = &case(&golden, "initial_acceleration")["expected"];
    assert_close("q''", &mechanism.velocity_rates(0.0, &start), &numbers(&initial["qdd"]), AT_A_STATE);
    assert_close("λ", &negative(lambda(&mechanism, &LOOPS, &start)), &numbers(&initial["lam"]), AT_A_STATE);
    let times: Vec<f64> = std::iter::once(0.0).chain(rows.iter().map(|row| numbers(&row["t"])[0])).collect();
    for ((t, y), row) in times.iter().zip(mechanism.run(&start, &times, 2e-4)).skip(1).zip(rows) {
        let place = format!("at {t}");
        assert_close(&place, &mechanism.coordinates(*t, &y), &numbers(&row["q"]), IN_MOTION);
        // a relative change of the torque by 1e-12 moves the velocities by 4e-9
        assert_close(&place, &mechanism.velocities(*t, &y), &numbers(&row["qd"]), 1e-8);
        let state = [numbers(&row["q"]), vec![numbers(&row["qd"])[0]]].concat();
        assert_close(&place, &mechanism.velocity_rates(*t, &state), &numbers(&row["qdd"]), EVALUATED);
        assert_close(&place, &negative(lambda(&mechanism, &LOOPS, &state)), &numbers(&row["lam"]), EVALUATED);
    }
}

#[test]
fn slider_crank_of_equal_lengths() {
    let golden = parse(include_str!("data/slider_crank_equal.json"));
    let model = from_json!(golden["parameters"], CrankAndSlider { l: "l", m1: "m1", m2: "m2", m3: "m3", g: "g" });
    let crank = Running::new(model);
    let rows = list(&case(&golden, "smooth_branch")["expected"]);
    for row in rows.iter().filter(|row| row["singular"].is_null()) {
        let y = picked(row, &["alpha", "beta", "x", "alpha_rate"]);
        let [turn, slide] = ["alpha_acceleration", "x_acceleration"].map(|name| numbers(&row[name])[0]);
        // after many turns the angles are doubles of 24 with their rounding
        let tolerance = AT_A_STATE * (1.0 + y[0].abs());
        assert_close("accelerations", &crank.velocity_rates(0.0, &y), &[turn, turn, slide], tolerance);
        let reaction = numbers(&row["generalised_reaction"]);
        assert_close("Cᵀ λ", crank.reaction(0.0, &y).as_slice(), &reaction, tolerance);
    }
}

/// The same in motion: through the positions in which crank and rod stand on top of each other, where its branches meet, forwards,
/// backwards in time, and with the speed reversed; at the instant of the first passage too.
#[test]
fn slider_crank_of_equal_lengths_through_its_crossings() {
    let golden = parse(include_str!("data/slider_crank_equal.json"));
    let model = from_json!(golden["parameters"], CrankAndSlider { l: "l", m1: "m1", m2: "m2", m3: "m3", g: "g" });
    let model = model.prepare().expect("the parameters are good");
    let rows = list(&case(&golden, "smooth_branch")["expected"]);
    let figure = |row: &serde_json::Value, name: &str| numbers(&row[name])[0];
    let start = |row, sign: f64| CrankAndSliderState {
        alpha: figure(row, "alpha"),
        beta: figure(row, "beta"),
        x: figure(row, "x"),
        dot_alpha: sign * figure(row, "alpha_rate"),
    };
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    let end = figure(last, "t");
    for (name, from, to, row, sign) in
        [("forwards", 0.0, end, first, 1.0), ("backwards", end, 0.0, last, 1.0), ("reversed", -end, 0.0, last, -1.0)]
    {
        let run = model.simulate(start(row, sign)).starting_at(from).tolerance(1e-12, 1e-12);
        let run = run.until(to).unwrap_or_else(|stopped| panic!("{name}: {stopped}"));
        // From α = 0.5 to 24: past π/2, 3π/2, …, 15π/2.
        assert_eq!(run.statistics().crossings, 8, "{name}: {:?}", run.statistics());
        let (mut worst, mut reaction) = (0.0_f64, 0.0_f64);
        for row in rows {
            let t = sign * figure(row, "t");
            let (s, v) = (run.at(t).expect("within"), run.velocities_at(t).expect("within"));
            let found = [s.alpha, s.beta, s.x, sign * v.dot_alpha, sign * v.dot_x];
            let expected = ["alpha", "beta", "x", "alpha_rate", "x_rate"].map(|name| figure(row, name));
            let errors = found.iter().zip(expected).map(|(found, expected)| (found - expected).abs());
            let error = errors.fold(0.0, f64::max);
            assert!(error < 1e-8, "{name} at {t}: {error:e}");
            worst = worst.max(error);
            // Reactions have a limit at the crossing, but C alone does not tell them there.
            let reactions = run.multipliers_at(t, &[]);
            match row["singular"].is_null() {
                true => {
                    let reactions = reactions.expect("regular");
                    let [x, y] = [reactions.closure_x, reactions.closure_y];
                    let lam = numbers(&row["lam"]);
                    reaction = reaction.max((x - lam[0]).abs().max((y - lam[1]).abs()));
                }
                false => {
                    assert!(matches!(reactions, Err(Error::Dependent { value, .. }) if value < 1e-3), "{reactions:?}")
                }
            }
        }
        assert!(reaction < 1e-8, "{name}: {reaction:e}");
        println!("{name}: {worst:.1e}, reactions {reaction:.1e}, {:?}", run.statistics());
    }
}
