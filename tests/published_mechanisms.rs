//! Mechanisms of the literature with numbers from outside: loops, bodies in space, chains.
//!
//! Accelerations and reactions at the stored states to a relative 1e-12, motions to 1e-9, where the numbers are trusted that far.

#[path = "models/bodies.rs"]
mod bodies;
#[path = "models/linkages.rs"]
mod linkages;
mod support;

use bodies::{Flyball, HeavyTop, TriplePendulum};
use holonomy::prelude::*;
use linkages::{Andrews, CarAxis, FourBar, SliderCrank, SliderCrankOnBranch};
use serde_json::Value;
use support::andrews::andrews;
use support::golden::{assert_close, assert_close_at, case, from_json, list, numbers, parse, picked};
use support::running::{Running, entries};

const AT_A_STATE: f64 = 1e-12;
const IN_MOTION: f64 = 1e-9;

fn times(rows: &[Value]) -> Vec<f64> {
    rows.iter().map(|row| row["t"].as_f64().expect("a time")).collect()
}

/// Entry by entry, with the digits to which each is confirmed.
fn agree_to(what: &str, computed: &[f64], expected: &[f64], digits: &[f64]) {
    for (i, ((c, e), digits)) in computed.iter().zip(expected).zip(digits).enumerate() {
        // half a digit for how the agreement was rounded
        let bound = 10.0_f64.powf(0.5 - digits) * e.abs();
        assert!((c - e).abs() <= bound, "{what}[{i}]: {c:e} instead of {e:e} to {digits} digits");
    }
}

/// λ of the named rows.
fn lambda<M: ConstrainedSystem>(running: &Running<M>, names: &[&str], t: f64, y: &[f64]) -> Vec<f64> {
    names.iter().map(|name| running.multiplier(name, t, y)).collect()
}

#[test]
fn car_axis() {
    let golden = parse(include_str!("data/caraxis.json"));
    let model =
        from_json!(golden["parameters"], CarAxis { eps: "eps", m: "M", l: "L", l0: "L0", r: "r", w: "w", g: "g" });
    let axis = Running::new(model);
    let rows = list(&case(&golden, "recomputed_trajectory")["expected"]);
    let at = |row: &Value| {
        axis.with_velocities(row["t"].as_f64().expect("a time"), &numbers(&row["q"]), &numbers(&row["qd"]))
    };
    let times = times(rows);
    let run = axis.run(&at(&rows[0]), &times, 0.005);
    for ((t, y), row) in times.iter().zip(&run).zip(rows) {
        let place = format!("at {t}");
        // at the doubles of the stored state; at rest relative to the springs everything but g cancels
        let state = at(row);
        assert_close_at(&place, &axis.velocity_rates(*t, &state), &numbers(&row["qdd"]), AT_A_STATE, 1.0);
        assert_close_at(&place, &lambda(&axis, &["foot", "axle"], *t, &state), &numbers(&row["lam"]), AT_A_STATE, 5e-4);
        assert_close_at(&place, axis.reaction(*t, &state).as_slice(), &numbers(&row["reaction"]), AT_A_STATE, 5e-4);
        assert_close(&place, &axis.coordinates(*t, y), &numbers(&row["q"]), IN_MOTION);
        assert_close(&place, &axis.velocities(*t, y), &numbers(&row["qd"]), IN_MOTION);
    }
    let published = case(&golden, "published_end_state");
    let (end, expected) = (run.last().expect("an end"), &published["expected"]);
    let computed = [axis.coordinates(3.0, end), axis.velocities(3.0, end), lambda(&axis, &["foot", "axle"], 3.0, end)];
    let digits = numbers(&published["agreement_digits_per_component"]);
    // the run itself is trusted to nine digits
    let digits: Vec<f64> = digits.iter().map(|d| d.min(10.0)).collect();
    agree_to("end", &computed.concat(), &picked(expected, &["q", "qd", "lam"]), &digits);
}

#[test]
fn four_bar() {
    let golden = parse(include_str!("data/four_bar.json"));
    let model = from_json!(
        golden["params"],
        FourBar { l1: "l1", l2: "l2", l3: "l3", d: "d", m1: "m1", m2: "m2", m3: "m3", g: "g", tau: "tau" }
    );
    let bar = Running::new(model);
    for state in list(&golden["states"]) {
        let y = picked(state, &["q", "u1"]);
        assert_close("q'", &bar.velocities(0.0, &y), &numbers(&state["qd"]), AT_A_STATE);
        assert_close("q''", &bar.velocity_rates(0.0, &y), &numbers(&state["qdd"]), 1e-11);
        assert_close("λ", &lambda(&bar, &["loop_x", "loop_y"], 0.0, &y), &numbers(&state["lambda"]), 1e-11);
    }
}

const LOOPS: [&str; 6] = ["b_x", "b_y", "delta_x", "delta_y", "epsilon_x", "epsilon_y"];

/// The test set writes M a = f - Gᵀ λ.
fn negative(values: Vec<f64>) -> Vec<f64> {
    values.into_iter().map(|v| -v).collect()
}

#[test]
fn andrews_at_states() {
    let golden = parse(include_str!("data/andrews_states.json"));
    let mechanism = Running::new(andrews!(Andrews, golden["params"]));
    for state in list(&golden["states"]) {
        let y = picked(state, &["q", "v1"]);
        // accelerations at rest are of the size of the torque on the crank
        assert_close_at("q'", &mechanism.velocities(0.0, &y), &numbers(&state["qd"]), 1e-11, 1.0);
        assert_close("q''", &mechanism.velocity_rates(0.0, &y), &numbers(&state["qdd"]), 1e-11);
        assert_close("λ", &negative(lambda(&mechanism, &LOOPS, 0.0, &y)), &numbers(&state["lambda"]), 1e-11);
    }
}

#[test]
fn andrews_in_motion() {
    let golden = parse(include_str!("data/andrews.json"));
    let mechanism = Running::new(andrews!(Andrews, golden["parameters"]));
    let rows = list(&case(&golden, "recomputed_trajectory")["expected"]);
    let start = [numbers(&golden["initial"]["q"]), vec![0.0]].concat();
    let initial = &case(&golden, "initial_acceleration")["expected"];
    assert_close("q''", &mechanism.velocity_rates(0.0, &start), &numbers(&initial["qdd"]), AT_A_STATE);
    let close = |what: &str, computed: Vec<f64>, expected: &Value, tolerance: f64| {
        assert_close(what, &computed, &numbers(expected), tolerance);
    };
    close("λ", negative(lambda(&mechanism, &LOOPS, 0.0, &start)), &initial["lam"], AT_A_STATE);
    let times = [vec![0.0], times(rows)].concat();
    for ((t, y), row) in times.iter().zip(mechanism.run(&start, &times, 2e-4)).skip(1).zip(rows) {
        let place = format!("at {t}");
        close(&place, mechanism.coordinates(*t, &y), &row["q"], IN_MOTION);
        // a relative change of the torque by 1e-12 moves the velocities by 4e-9
        close(&place, mechanism.velocities(*t, &y), &row["qd"], 1e-8);
        let state = [numbers(&row["q"]), vec![numbers(&row["qd"])[0]]].concat();
        close(&place, mechanism.velocity_rates(*t, &state), &row["qdd"], 1e-11);
        close(&place, negative(lambda(&mechanism, &LOOPS, *t, &state)), &row["lam"], 1e-11);
    }
}

#[test]
fn slider_crank_of_equal_lengths() {
    let golden = parse(include_str!("data/slider_crank_equal.json"));
    let model = from_json!(golden["parameters"], SliderCrank { l: "l", m1: "m1", m2: "m2", m3: "m3", g: "g" });
    let crank = Running::new(model.clone());
    let rows = list(&case(&golden, "smooth_branch")["expected"]);
    for row in rows.iter().filter(|row| row["singular"].is_null()) {
        let y = picked(row, &["alpha", "beta", "x", "alpha_rate"]);
        let rates = crank.velocity_rates(0.0, &y);
        let [turn, slide] = ["alpha_acceleration", "x_acceleration"].map(|name| numbers(&row[name])[0]);
        // after many turns the angles are doubles of 24 with their rounding
        let tolerance = AT_A_STATE * (1.0 + y[0].abs());
        assert_close("accelerations", &rates, &[turn, turn, slide], tolerance);
        assert_close("λ", &lambda(&crank, &["loop_x", "loop_y"], 0.0, &y), &numbers(&row["lam"]), tolerance);
        let reaction = numbers(&row["generalised_reaction"]);
        assert_close("Cᵀ λ", crank.reaction(0.0, &y).as_slice(), &reaction, tolerance);
    }
    let start = picked(&rows[0], &["alpha", "beta", "x", "alpha_rate"]);
    let end = &crank.run(&start, &[0.0, 0.1], 0.005)[1];
    assert_close("motion", end, &picked(&rows[1], &["alpha", "beta", "x", "alpha_rate"]), IN_MOTION);
    // at alpha = π/2 the rows lose rank and another branch crosses: a run goes through smoothly or says where it stops
    let prepared = model.prepare().expect("good parameters");
    match prepared.simulate(crank.state(&start)).until(0.5) {
        Ok(run) => {
            let row = rows.iter().find(|row| row["t"] == 0.5).expect("a row");
            let end = entries(run.last().1);
            assert_close("motion", &end, &picked(row, &["alpha", "beta", "x", "alpha_rate"]), 1e-6);
        }
        Err(stop) => {
            let crossing = golden["singular_at"]["time"].as_f64().expect("a time");
            let stopped = stop.trajectory.last().0;
            assert!(
                stopped > crossing - 0.1 && stopped < crossing + 0.05,
                "stopped at {stopped}, singular at {crossing}: {}",
                stop.error
            );
        }
    }
}

/// On its branch the motion passes the singular position like any other: five seconds, seven passages.
#[test]
fn slider_crank_passes_its_singular_position() {
    let golden = parse(include_str!("data/slider_crank_equal.json"));
    let model = from_json!(golden["parameters"], SliderCrankOnBranch { l: "l", m1: "m1", m2: "m2", m3: "m3", g: "g" });
    let crank = Running::new(model);
    let rows = list(&case(&golden, "smooth_branch")["expected"]);
    let start = picked(&rows[0], &["alpha", "alpha_rate"]);
    let simulation = crank.0.simulate(crank.state(&start)).tolerance(1e-13, 1e-13);
    let run = simulation.until(5.0).expect("a regular motion");
    for (y, row) in crank.run(&start, &times(rows), 0.005).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        let at = picked(row, &["alpha", "alpha_rate"]);
        // after many turns the angles are doubles of 24 with their rounding
        let tolerance = AT_A_STATE * (1.0 + at[0].abs());
        let [turn, slide] = ["alpha_acceleration", "x_acceleration"].map(|name| numbers(&row[name])[0]);
        // upright, nothing accelerates it
        assert_close_at(&place, &crank.velocity_rates(0.0, &at), &[turn, turn, slide], tolerance, 9.81);
        let rates = picked(row, &["alpha_rate", "alpha_rate", "x_rate"]);
        assert_close(&place, &crank.velocities(0.0, &at), &rates, tolerance);
        if row["singular"].is_null() {
            assert_close(&place, &lambda(&crank, &["loop_x", "loop_y"], 0.0, &at), &numbers(&row["lam"]), tolerance);
            let reaction = crank.reaction(0.0, &at);
            assert_close(&place, reaction.as_slice(), &numbers(&row["generalised_reaction"]), tolerance);
        }
        assert_close(&place, y, &at, IN_MOTION);
        let t = row["t"].as_f64().expect("a time");
        assert_close(&place, &entries(&run.at(t).expect("a time of the run")), &at, IN_MOTION);
    }
}

#[test]
fn flyball_governor() {
    let golden = parse(include_str!("data/flyball.json"));
    let model = from_json!(
        golden["parameters"],
        Flyball {
            g: "g",
            k: "K",
            cd: "Cd",
            l0: "L0",
            m_rod: "m_rod",
            l_rod: "L_rod",
            w_rod: "w_rod",
            off: "off",
            m_ball: "m_ball",
            m_slider: "m_slider",
            b_slider: "b_slider",
        }
    );
    let Flyball { k, cd, l0, m_slider, .. } = model;
    let governor = Running::new(model);
    let case = case(&golden, "library_run");
    let rows = list(&case["expected"]);
    let state = |row: &Value| picked(row, &["shaft_angle", "s", "rod_angles", "shaft_rate", "s_rate", "rod_rates"]);
    let times = times(rows);
    for ((t, y), row) in times.iter().zip(governor.run(&state(&rows[0]), &times, 5e-4)).zip(rows) {
        let place = format!("at {t}");
        let rates = governor.velocity_rates(*t, &state(row));
        let expected = picked(row, &["shaft_acceleration", "s_acceleration", "rod_accelerations"]);
        // the springs' forces are differences of lengths, and the dampers' of rates, known to rounding of k l0 and of cd
        let rounding = 4.0 * f64::EPSILON * (k * l0 + cd) / m_slider;
        let bound = AT_A_STATE * expected.iter().fold(0.0_f64, |a, e| a.max(e.abs())) + rounding;
        for (a, e) in rates.iter().zip(&expected) {
            assert!((a - e).abs() <= bound, "{place}: {a} instead of {e}, bound {bound:e}");
        }
        assert_close(&place, &y, &state(row), IN_MOTION);
    }
}

/// Everything that is published of a state of the top; the JSON's axis `axis` of the body is the model's y, the next ones follow.
fn top_agrees(top: &Running<HeavyTop>, y: &[f64], row: &Value, axis: usize, [still, moving]: [f64; 2]) {
    let HeavyTop { m, g, .. } = *top.0.system();
    let place = format!("at {}", row["t"]);
    let body = |values: Vec<f64>| {
        let [x, y, z] = [(axis + 2) % 3, axis, (axis + 1) % 3];
        vec![values[x], values[y], values[z]]
    };
    let v = top.velocities(0.0, y);
    let rates = top.velocity_rates(0.0, y);
    assert_close(&place, &y[..3], &numbers(&row["com_position"]), moving);
    assert_close(&place, &v[..3], &numbers(&row["com_velocity"]), moving);
    assert_close(&place, &rates[..3], &numbers(&row["com_acceleration"]), still.max(moving));
    assert_close(&place, &v[3..], &body(numbers(&row["body_rates"])), moving);
    assert_close_at(&place, &rates[3..], &body(numbers(&row["body_rate_derivatives"])), still.max(moving), g);
    let force = lambda(top, &["pivot_x", "pivot_y", "pivot_z"], 0.0, y);
    assert_close_at(&place, &force, &numbers(&row["pivot_force_on_body"]), still.max(moving), m * g);
}

fn top(case: &Value, axis: usize) -> Running<HeavyTop> {
    let p = &case["parameters"];
    let j = numbers(&p["Jc_diag"]);
    let [m, g] = ["m", "g"].map(|name| p[name].as_f64().expect("a number"));
    let l = numbers(&p["com_in_body"])[axis];
    Running::new(HeavyTop { m, g, j1: j[(axis + 2) % 3], j2: j[axis], j3: j[(axis + 1) % 3], l })
}

/// The top's state from the angles and the body rates in the JSON's axes.
fn top_start(l: f64, [a, b, c]: [f64; 3], rates: &[f64], axis: usize) -> Vec<f64> {
    let (sin, cos) = b.sin_cos();
    let rates = [rates[(axis + 2) % 3], rates[axis], rates[(axis + 1) % 3]];
    let place = [-l * sin, l * cos * a.cos(), l * cos * a.sin()];
    [place.to_vec(), vec![a, b, c], rates.to_vec()].concat()
}

#[test]
fn heavy_top_spins_fast() {
    let golden = parse(include_str!("data/heavy_top.json"));
    let case = case(&golden, "fast_top");
    let top = top(case, 1);
    let rows = list(&case["expected"]);
    let start = top_start(1.0, [0.0; 3], &numbers(&case["initial"]["body_rates"]), 1);
    for (y, row) in top.run(&start, &times(rows), 0.001).iter().zip(rows) {
        let first = row["t"] == 0.0;
        top_agrees(&top, y, row, 1, [AT_A_STATE, if first { AT_A_STATE } else { IN_MOTION }]);
        let energy = row["energy"].as_f64().expect("a number");
        assert!((top.energy(0.0, y) - energy).abs() <= IN_MOTION * energy, "energy at {}", row["t"]);
    }
}

#[test]
fn heavy_top_precesses_steadily() {
    let golden = parse(include_str!("data/heavy_top.json"));
    let case = case(&golden, "steady_precession");
    let top = top(case, 2);
    let rows = list(&case["expected"]);
    // the JSON's body axes y, z, x are this model's x, y, z; R(0) tilts about x
    let quarter = std::f64::consts::FRAC_PI_2;
    let tilt = case["parameters"]["tilt"].as_f64().expect("a number");
    let l = top.0.system().l;
    let start = top_start(l, [quarter + tilt, 0.0, quarter], &numbers(&case["initial"]["body_rates"]), 2);
    for (y, row) in top.run(&start, &times(rows), 0.002).iter().zip(rows) {
        let first = row["t"] == 0.0;
        top_agrees(&top, y, row, 2, [AT_A_STATE, if first { AT_A_STATE } else { IN_MOTION }]);
    }
}

#[test]
fn three_pendulums_in_a_row() {
    let golden = parse(include_str!("data/pendulum_chain.json"));
    let model = from_json!(golden["parameters"], TriplePendulum { m: "m", l: "l", g: "g" });
    let TriplePendulum { m, l, g } = model;
    let chain = Running::new(model);
    let tensions = |y: &[f64]| -> Vec<f64> {
        lambda(&chain, &["link1", "link2", "link3"], 0.0, y).iter().map(|lambda| -lambda * l).collect()
    };
    let rows = list(&case(&golden, "release_from_horizontal_n3")["expected"]);
    let state = |row: &Value| picked(row, &["angles", "rates"]);
    for (y, row) in chain.run(&state(&rows[0]), &times(rows), 0.005).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        let at = state(row);
        assert_close(&place, &chain.accelerations(0.0, &at), &numbers(&row["angular_accelerations"]), AT_A_STATE);
        assert_close_at(&place, &tensions(&at), &numbers(&row["tensions"]), AT_A_STATE, 3.0 * m * g);
        assert_close_at(&place, y, &at, IN_MOTION, 1.0);
    }
    // hanging at rest: the tensions carry what is below, and the frequencies are those of Laguerre's polynomial
    let linearised = case(&golden, "linearised_n3");
    let rest = [0.0; 6];
    assert_close("tensions", &tensions(&rest), &numbers(&linearised["static_tensions"]), AT_A_STATE);
    let stiffness = -chain.jacobian(0.0, &rest).view((3, 0), (3, 3)).into_owned();
    let mut squares: Vec<f64> = stiffness.complex_eigenvalues().iter().map(|e| e.re).collect();
    squares.sort_by(f64::total_cmp);
    let frequencies: Vec<f64> = squares.iter().map(|s| s.sqrt()).collect();
    assert_close("frequencies", &frequencies, &numbers(&linearised["expected"]["frequencies_rad_s"]), 1e-11);
}
