//! Closed loops of the literature from geometry alone, against numbers from outside, as the same mechanisms by equations.

#[path = "../examples/bricard/models.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has it")]
mod bricard;
#[path = "../examples/flyball/models.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has it")]
mod flyball;
#[path = "models/geometry/loops.rs"]
mod loops;
mod support;

use bricard::Bricard;
use differential_equations::methods::ImplicitRungeKutta;
use flyball::Governor;
use holonomy::Error;
use holonomy::differential_equations::Equations;
use holonomy::prelude::*;
use loops::{Axle, CrankAndSlider, CrankAndSliderState, FourBarOfRods, SixHinges, Squeezer};
use serde_json::Value;
use support::andrews::andrews;
use support::golden::{assert_close, assert_close_at, case, from_json, list, numbers, parse, picked};
use support::running::{Running, entries};

const AT_A_STATE: f64 = 1e-12;
/// Where the data are evaluations of other programs.
const EVALUATED: f64 = 1e-11;
const IN_MOTION: f64 = 1e-9;

fn times(rows: &[Value]) -> Vec<f64> {
    rows.iter().map(|row| row["t"].as_f64().expect("a time")).collect()
}

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

/// Five rods in space whose sixth hinge repeats one of its rows wherever the loop is closed: two periods, dead centres among the
/// stored states.
#[test]
fn bricards_mechanism() {
    let golden = parse(include_str!("data/bricard.json"));
    let mechanism = Running::new(from_json!(golden["parameters"], Bricard { m: "m", l: "l", b: "b", g: "g" }));
    let rows = list(&case(&golden, "library_run")["expected"]);
    let state = |row: &Value| [numbers(&row["joint_angles_1_to_5"]), vec![numbers(&row["joint_rates"])[0]]].concat();
    let (start, times) = (state(&rows[0]), times(rows));
    let simulation = mechanism.0.simulate(mechanism.state(&start)).tolerance(1e-13, 1e-13);
    let run = simulation.until(times[times.len() - 1]);
    let run = run.unwrap_or_else(|stop| panic!("stopped at {:?}: {}", stop.trajectory.last().0, stop.error));
    assert_eq!(run.statistics().chart_changes, 0);
    for ((t, y), row) in times.iter().zip(mechanism.run(&start, &times, 0.01)).zip(rows) {
        let place = format!("at {t}");
        let at = state(row);
        let rates = numbers(&row["joint_rates"]);
        assert_close_at(&place, &mechanism.velocities(0.0, &at), &rates, AT_A_STATE, 1.0);
        let accelerations = numbers(&row["joint_accelerations"]);
        assert_close(&place, &mechanism.velocity_rates(0.0, &at), &accelerations, AT_A_STATE);
        let reaction = numbers(&row["generalised_reaction"]);
        assert_close(&place, mechanism.reaction(0.0, &at).as_slice(), &reaction, AT_A_STATE);
        let [place_of, velocity] = ["P3", "P3_velocity"].map(|name| numbers(&row[name]));
        let told = mechanism.0.outputs(0.0, &mechanism.state(&at), &[]);
        assert_close_at(&place, &[told.x_2, told.y_2, told.z_2], &place_of, AT_A_STATE, 1.0);
        assert_close_at(&place, &[told.vx, told.vy, told.vz], &velocity, AT_A_STATE, 1.0);
        let state = run.at(*t).expect("a time of the run");
        for moved in [y, entries(&state)] {
            let (x, v) = (mechanism.coordinates(0.0, &moved), mechanism.velocities(0.0, &moved));
            // the angles swing between 0 and π, the rates reach 2.2
            for (found, expected) in x.iter().chain(&v).zip(at[..5].iter().chain(&rates)) {
                assert!((found - expected).abs() <= IN_MOTION, "{found} instead of {expected} {place}");
            }
            // with the row that is not written
            let told = mechanism.0.outputs(0.0, &mechanism.state(&moved), &[]);
            assert!(told.axis_y.abs().max(told.axis_z.abs()) <= IN_MOTION, "the axis {place}");
        }
    }
}

/// The same by its six hinges: the engine finds the row that is one too many, and the reactions are those of least norm.
#[test]
fn bricards_mechanism_by_its_hinges() {
    let golden = parse(include_str!("data/bricard.json"));
    let mechanism = Running::new(from_json!(golden["parameters"], SixHinges { m: "m", l: "l", b: "b", g: "g" }));
    let redundant: Vec<&str> = SixHinges::MODEL.rows.iter().filter(|row| row.redundant).map(|row| row.name).collect();
    assert_eq!((SixHinges::MODEL.rows.len(), redundant.len()), (5, 1), "{redundant:?}");
    let rows = list(&case(&golden, "library_run")["expected"]);
    let state = |row: &Value| [numbers(&row["joint_angles_1_to_5"]), vec![numbers(&row["joint_rates"])[0]]].concat();
    let (start, times) = (state(&rows[0]), times(rows));
    for ((t, y), row) in times.iter().zip(mechanism.run(&start, &times, 0.01)).zip(rows) {
        let place = format!("at {t}");
        let at = state(row);
        let rates = numbers(&row["joint_rates"]);
        assert_close_at(&place, &mechanism.velocities(0.0, &at), &rates, AT_A_STATE, 1.0);
        let accelerations = numbers(&row["joint_accelerations"]);
        assert_close(&place, &mechanism.velocity_rates(0.0, &at), &accelerations, AT_A_STATE);
        let reaction = numbers(&row["generalised_reaction"]);
        assert_close(&place, mechanism.reaction(0.0, &at).as_slice(), &reaction, AT_A_STATE);
        let (x, v) = (mechanism.coordinates(0.0, &y), mechanism.velocities(0.0, &y));
        for (found, expected) in x.iter().chain(&v).zip(at[..5].iter().chain(&rates)) {
            assert!((found - expected).abs() <= IN_MOTION, "{found} instead of {expected} {place}");
        }
    }
}

/// Springs and dampers so stiff that they are nearly rods close the governor's two loops.
#[test]
fn flyball_governor() {
    let golden = parse(include_str!("data/flyball.json"));
    let model = from_json!(
        golden["parameters"],
        Governor {
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
    let Governor { k, cd, l0, m_slider, .. } = model;
    let governor = Running::new(model);
    let rows = list(&case(&golden, "library_run")["expected"]);
    let state = |row: &Value| picked(row, &["shaft_angle", "s", "rod_angles", "shaft_rate", "s_rate", "rod_rates"]);
    let (start, times) = (state(&rows[0]), times(rows));
    // the springs' forces are differences of lengths, and the dampers' of rates, known to rounding of k l0 and of cd
    let rounding = 4.0 * f64::EPSILON * (k * l0 + cd);
    let within = |what: &str, found: &[f64], expected: &[f64], rounding: f64| {
        let bound = AT_A_STATE * expected.iter().fold(0.0_f64, |a, e| a.max(e.abs())) + rounding;
        for (a, e) in found.iter().zip(expected) {
            assert!((a - e).abs() <= bound, "{what}: {a} instead of {e}, bound {bound:e}");
        }
    };
    for ((t, y), row) in times.iter().zip(governor.run(&start, &times, 5e-4)).zip(rows) {
        let place = format!("at {t}");
        let at = state(row);
        let expected = picked(row, &["shaft_acceleration", "s_acceleration", "rod_accelerations"]);
        within(&place, &governor.velocity_rates(*t, &at), &expected, rounding / m_slider);
        let found = governor.0.outputs(*t, &governor.state(&at), &[]);
        within(&place, &[found.tension1, found.tension2], &numbers(&row["spring_tensions"]), rounding);
        let turning = numbers(&row["vertical_angular_momentum"]);
        assert_close(&place, &[found.turning], &turning, AT_A_STATE);
        assert_close(&place, &y, &at, IN_MOTION);
        let moved = governor.0.outputs(*t, &governor.state(&y), &[]);
        assert_close(&place, &[moved.turning], &turning, IN_MOTION);
    }
    // the way for stiff systems: a tenth of the steps of an explicit method
    let method = ImplicitRungeKutta::radau5().rtol([1e-13; 8]).atol([1e-13; 8]);
    let equations = Equations::new(&governor.0).expect("the parameters are good");
    let span = (times[0], times[times.len() - 1]);
    let states = equations.solve(method, governor.state(&start), span).expect("a regular motion");
    let (_, end) = states.last().expect("an end");
    assert_close("by Radau5", &entries(end), &state(&rows[rows.len() - 1]), IN_MOTION);
    assert!(states.len() < 500, "{} steps", states.len());
}

/// The road moves one end of a spring, and with it both rows.
#[test]
fn car_axis() {
    let golden = parse(include_str!("data/caraxis.json"));
    let model = from_json!(golden["parameters"], Axle { eps: "eps", m: "M", l: "L", l0: "L0", r: "r", w: "w", g: "g" });
    let axle = Running::new(model);
    let rows = list(&case(&golden, "recomputed_trajectory")["expected"]);
    let times = times(rows);
    let at = |t: f64, row: &Value| axle.with_velocities(t, &numbers(&row["q"]), &numbers(&row["qd"]));
    let run = axle.run(&at(0.0, &rows[0]), &times, 0.005);
    for ((t, y), row) in times.iter().zip(&run).zip(rows) {
        let place = format!("at {t}");
        let state = at(*t, row);
        let multipliers = axle.multipliers(*t, &state);
        // at rest relative to the springs everything but g cancels
        assert_close_at(&place, &axle.velocity_rates(*t, &state), &numbers(&row["qdd"]), AT_A_STATE, 1.0);
        assert_close_at(&place, &multipliers, &numbers(&row["lam"]), AT_A_STATE, 5e-4);
        assert_close_at(&place, axle.reaction(*t, &state).as_slice(), &numbers(&row["reaction"]), AT_A_STATE, 5e-4);
        assert_close(&place, &axle.coordinates(*t, y), &numbers(&row["q"]), IN_MOTION);
        assert_close(&place, &axle.velocities(*t, y), &numbers(&row["qd"]), IN_MOTION);
    }
    // what the test set prints, of the multipliers to as many digits as it is confirmed
    let (end, expected) = (run.last().expect("an end"), &case(&golden, "published_end_state")["expected"]);
    assert_close("end", &axle.coordinates(3.0, end), &numbers(&expected["q"]), IN_MOTION);
    assert_close("end", &axle.velocities(3.0, end), &numbers(&expected["qd"]), IN_MOTION);
    assert_close("end", &axle.multipliers(3.0, end), &numbers(&expected["lam"]), 1e-7);
}

/// What a derivative costs, beside the same mechanism by equations as `data/decisions` has it: nobody shall pay for geometry.
#[test]
fn geometry_costs_little() {
    fn costs<M: ConstrainedSystem>([most, sincos]: [usize; 2], by_equations: usize) {
        let cost = M::MODEL.operations.iter().find(|cost| cost.function == "derivative").expect("every model has one");
        let found = cost.additions + cost.multiplications + cost.divisions + cost.roots;
        println!("{:16} {found:4} + {}, by equations {by_equations}", M::MODEL.name, cost.sincos);
        assert!(found <= most && cost.sincos <= sincos, "{}: {found} + {}", M::MODEL.name, cost.sincos);
    }
    costs::<FourBarOfRods>([77, 3], 77);
    costs::<CrankAndSlider>([46, 2], 46);
    costs::<Squeezer>([319, 7], 309);
    costs::<Axle>([119, 1], 119);
    costs::<Governor>([114, 2], 105);
    costs::<Bricard>([796, 5], 1452);
}

/// The equal slider-crank in motion, through the positions in which crank and rod lie on each other and branches meet: forwards,
/// backwards in time, and with the speed reversed; at the instant of the first passage too.
#[test]
fn slider_crank_of_equal_lengths_through_its_crossings() {
    let golden = parse(include_str!("data/slider_crank_equal.json"));
    let model = from_json!(golden["parameters"], CrankAndSlider { l: "l", m1: "m1", m2: "m2", m3: "m3", g: "g" });
    let model = model.prepare().expect("the parameters are good");
    let rows = list(&case(&golden, "smooth_branch")["expected"]);
    let figure = |row: &Value, name: &str| numbers(&row[name])[0];
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
