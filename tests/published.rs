//! Problems of the literature with numbers from outside: the rolling disc, Chaplygin's sleigh, the knife edge on an incline.

mod models;
mod support;

use holonomy::ConstrainedSystem;
use models::{KnifeEdge, RollingDisc, Sleigh, SleighInPlane};
use nalgebra::DVector;
use serde_json::Value;
use support::golden::{assert_close, assert_close_at, case, list, numbers, parse, picked};
use support::running::Running;

const DISC: &str = include_str!("data/rolling_disc.json");
const SLEIGH: &str = include_str!("data/chaplygin_sleigh.json");
const AT_A_STATE: f64 = 1e-12;
const IN_MOTION: f64 = 1e-9;

fn times(rows: &[Value]) -> Vec<f64> {
    rows.iter().map(|row| row["t"].as_f64().expect("a time")).collect()
}

fn disc(case: &Value) -> Running<RollingDisc> {
    let [m, r, g, d, a] = ["m", "r", "g", "A", "C"].map(|p| case["parameters"][p].as_f64().expect("a number"));
    Running::new(RollingDisc { m, r, g, d, a })
}

/// The state of the disc: centre and angles, then the angular velocity in the leaned frame.
fn disc_state(row: &Value) -> Vec<f64> {
    let [yaw, lean, spin] = ["yaw_rate", "lean_rate", "spin_rate"].map(|name| row[name].as_f64().expect("a rate"));
    let angles = picked(row, &["centre", "yaw", "lean", "spin"]);
    let (sin, cos) = angles[4].sin_cos();
    [angles, vec![lean, spin + yaw * sin, yaw * cos]].concat()
}

/// Everything that is published of a state of the disc.
fn disc_agrees(disc: &Running<RollingDisc>, y: &[f64], row: &Value, tolerance: f64) {
    let RollingDisc { m, g, r, .. } = *disc.0.system();
    let place = format!("at {}", row["t"]);
    let close = |name: &str, computed: &[f64]| {
        assert_close_at(&format!("{name} {place}"), computed, &numbers(&row[name]), tolerance, g.max(m * g));
    };
    let rate = disc.rate(0.0, y);
    let (sin, cos) = y[4].sin_cos();
    close("centre", &y[..3]);
    assert_close_at(&place, &y[3..6], &picked(row, &["yaw", "lean", "spin"]), tolerance, 1.0);
    close("centre_velocity", &rate[..3]);
    assert_close_at(&place, &rate[3..6], &picked(row, &["yaw_rate", "lean_rate", "spin_rate"]), tolerance, 1.0);
    close("centre_acceleration", &disc.velocity_rates(0.0, y)[..3]);
    // w1 = lean', w2 = spin' + yaw' sin lean, w3 = yaw' cos lean, differentiated
    let (yaw_rate, lean_rate) = (rate[3], rate[4]);
    let yaw = (rate[8] + yaw_rate * lean_rate * sin) / cos;
    let spin = rate[7] - yaw * sin - yaw_rate * lean_rate * cos;
    let accelerations = picked(row, &["yaw_acceleration", "lean_acceleration", "spin_acceleration"]);
    assert_close_at(&place, &[yaw, rate[6], spin], &accelerations, tolerance, g / r);
    let force = ["slip_x", "slip_y", "slip_z"].map(|name| disc.multiplier(name, 0.0, y));
    close("contact_force_on_disc", &force);
    // from the base of the speeds to that of the coordinates' rates
    let r = disc.reaction(0.0, y);
    close("generalised_reaction", &[r[0], r[1], r[2], sin * r[4] + cos * r[5], r[3], r[4]]);
}

#[test]
fn rolling_disc_follows_the_published_motions() {
    let golden = parse(DISC);
    for name in ["generic_state", "hante_arnold_data", "steady_turn"] {
        let case = case(&golden, name);
        let rows = list(if case["trajectory"].is_null() { &case["expected"] } else { &case["trajectory"] });
        let disc = disc(case);
        let start = disc_state(&rows[0]);
        disc_agrees(&disc, &start, &rows[0], AT_A_STATE);
        for (y, row) in disc.run(&start, &times(rows), 0.0125).iter().zip(rows) {
            disc_agrees(&disc, &disc_state(row), row, AT_A_STATE_OF_DOUBLES);
            disc_agrees(&disc, y, row, IN_MOTION);
        }
    }
}

/// Later rows are doubles rounded from a motion: the heading turns by tens of radians, and its rounding enters the directions.
const AT_A_STATE_OF_DOUBLES: f64 = 1e-12;

#[test]
fn rolling_disc_turns_steadily() {
    let golden = parse(DISC);
    let case = case(&golden, "steady_turn");
    let disc = disc(case);
    let [lean, turning] = ["lean", "yaw_rate"].map(|name| case["inputs"][name].as_f64().expect("a number"));
    let expected = |name: &str| case["expected"][name].as_f64().expect("a number");
    let RollingDisc { r, .. } = *disc.0.system();
    let y = [0.0, 0.0, r * lean.cos(), 0.0, lean, 0.0, 0.0, expected("axial_rate"), turning * lean.cos()];
    let rate = disc.rate(0.0, &y);
    assert_close("rates", &rate[3..6], &[turning, 0.0, expected("spin_rate")], AT_A_STATE);
    // equilibrium: the terms that cancel in the accelerations are of the size of g/r
    assert_close_at("accelerations", &rate[6..], &[0.0; 3], AT_A_STATE, 9.81 / r);
    assert_close("speed", &[rate[0].hypot(rate[1])], &[expected("centre_speed")], AT_A_STATE);
    assert_close("radius", &[rate[0].hypot(rate[1]) / turning], &[expected("centre_path_radius")], AT_A_STATE);
    let force = [disc.multiplier("slip_y", 0.0, &y), disc.multiplier("slip_z", 0.0, &y)];
    assert_close("force", &force, &[expected("lateral_contact_force"), expected("vertical_contact_force")], AT_A_STATE);
}

#[test]
fn rolling_disc_upright_has_the_published_eigenvalues() {
    let golden = parse(DISC);
    let case = case(&golden, "upright_stability");
    let disc = disc(case);
    let RollingDisc { m, r, g, d, .. } = *disc.0.system();
    let squared = |w: f64| {
        let jacobian = disc.jacobian(0.0, &[0.0, 0.0, r, 0.0, 0.0, 0.0, 0.0, w, 0.0]);
        (&jacobian * &jacobian).trace() / 2.0
    };
    let scale = m * g * r / (d + m * r * r);
    for row in list(&case["expected"]["eigenvalues"]) {
        let [w, expected] = ["axial_rate", "lambda_squared"].map(|name| row[name].as_f64().expect("a number"));
        assert!((squared(w) - expected).abs() <= AT_A_STATE * expected.abs().max(scale), "{w}: {}", squared(w));
    }
    let critical = case["expected"]["critical_axial_rate"].as_f64().expect("a number");
    assert!(squared(critical).abs() <= AT_A_STATE * scale, "{}", squared(critical));
}

/// The sleigh in both formulations; `velocities` from forward speed, turning rate and heading.
fn sleigh_agrees<M: ConstrainedSystem>(model: M, rows: &[Value], velocities: impl Fn(f64, f64, f64) -> [f64; 3]) {
    let sleigh = Running::new(model);
    let of = |row: &Value| {
        let [theta, v, omega] = ["theta", "v", "omega"].map(|name| row[name].as_f64().expect("a number"));
        velocities(v, omega, theta)
    };
    let at = |row: &Value| sleigh.with_velocities(0.0, &picked(row, &["x", "y", "theta"]), &of(row));
    let start = at(&rows[0]);
    for (y, row) in sleigh.run(&start, &times(rows), 0.02).iter().zip(rows) {
        let place = format!("{} at {}", M::MODEL.name, row["t"]);
        assert_close(&place, &y[..3], &picked(row, &["x", "y", "theta"]), IN_MOTION);
        assert_close(&place, &sleigh.velocities(0.0, y), &of(row), IN_MOTION);
        let force = sleigh.multiplier("blade", 0.0, &at(row));
        assert_close(&place, &[force], &picked(row, &["knife_force"]), AT_A_STATE);
    }
}

#[test]
fn sleigh_follows_the_published_motion() {
    let golden = parse(SLEIGH);
    let case = case(&golden, "sleigh");
    let [m, i, a] = ["m", "I", "a"].map(|p| case["parameters"][p].as_f64().expect("a number"));
    let rows = list(&case["expected"]);
    sleigh_agrees(Sleigh { m, i, a }, rows, |v, omega, _| [v, 0.0, omega]);
    sleigh_agrees(SleighInPlane { m, i, a }, rows, |v, omega, theta| [v * theta.cos(), v * theta.sin(), omega]);
    // in body components the accelerations are the published ones
    let sleigh = Running::new(Sleigh { m, i, a });
    for row in rows {
        let y = picked(row, &["x", "y", "theta", "v", "omega"]);
        assert_close("u̇", &sleigh.accelerations(0.0, &y), &picked(row, &["vdot", "omegadot"]), AT_A_STATE);
    }
}

#[test]
fn knife_edge_follows_the_published_motion() {
    let golden = parse(SLEIGH);
    let case = case(&golden, "knife_edge_on_incline");
    let [m, i, g, incline] = ["m", "I", "g", "incline"].map(|p| case["parameters"][p].as_f64().expect("a number"));
    let blade = Running::new(KnifeEdge { m, i, g, incline });
    let rows = list(&case["expected"]);
    let start = blade.with_velocities(0.0, &[0.0; 3], &picked(&rows[0], &["xd", "yd", "phid"]));
    for (y, row) in blade.run(&start, &times(rows), 0.02).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        assert_close_at(&place, &y[..3], &picked(row, &["x", "y", "phi"]), IN_MOTION, 1.0);
        assert_close(&place, &blade.velocities(0.0, y), &picked(row, &["xd", "yd", "phid"]), IN_MOTION);
        let force = DVector::from_vec(vec![blade.multiplier("blade", 0.0, y) - picked(row, &["blade_force"])[0]]);
        assert!(force.amax() <= IN_MOTION * 2.0 * m * g, "{place}: {force}");
    }
}
