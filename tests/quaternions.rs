//! Frames by unit quaternions: against the same mechanisms by angles, against published figures and exact answers, and in motion.

#[path = "models/geometry/balls.rs"]
mod balls;
mod support;
#[path = "models/geometry/top.rs"]
mod top;

use balls::{BallTop, HangingRods, KanesRock, PivotedBall, Precession, Rock, RollingBall};
use holonomy::prelude::*;
use holonomy::simulate::Charts;
use holonomy::{Error, Method, State};
use serde_json::Value;
use std::f64::consts::FRAC_PI_3;
use support::golden::{assert_close, assert_close_at, list, numbers, parse, text};
use support::running::{Running, entries};
use support::splitmix::SplitMix;
use top::PivotedTop;

const AT_A_STATE: f64 = 1e-12;
const IN_MOTION: f64 = 1e-9;

/// A turn about one axis of the frame.
fn about(axis: usize, angle: f64) -> [f64; 4] {
    let mut e = [(angle / 2.0).cos(), 0.0, 0.0, 0.0];
    e[axis + 1] = (angle / 2.0).sin();
    e
}

/// One rotation after the other, about axes that turn along.
fn then(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

/// A vector of the body's axes in those of the base: v + 2 e0 (n × v) + 2 n × (n × v), n the vector part.
fn turned(e: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let cross = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let n = [e[1], e[2], e[3]];
    let once = cross(n, v);
    let twice = cross(n, once);
    std::array::from_fn(|i| v[i] + 2.0 * e[0] * once[i] + 2.0 * twice[i])
}

fn drawn(random: &mut SplitMix) -> [f64; 4] {
    let e = random.vector(4, -1.0, 1.0);
    let length = e.iter().map(|e| e * e).sum::<f64>().sqrt();
    std::array::from_fn(|i| e[i] / length)
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().expect("a number")
}

fn golden() -> Value {
    parse(include_str!("data/heavy_top.json"))
}

fn outputs<M: ConstrainedSystem>(model: &Running<M>, y: &[f64]) -> Vec<f64> {
    entries(&model.0.outputs(0.0, &model.state(y), &Vector::from_fn(|_| 0.0)))
}

#[test]
fn the_state_holds_angular_velocities_and_nothing_holds_the_norm_by_force() {
    let names = [PivotedBall::MODEL.state_speeds, BallTop::MODEL.state_speeds];
    assert!(names.iter().all(|names| *names == ["omega_T_x", "omega_T_y", "omega_T_z"]));
    assert_eq!(BallTop::MODEL.position_rows, ["norm_T"]);
    assert_eq!(PivotedBall::MODEL.position_rows, ["pivot_x", "pivot_y", "pivot_z", "norm_T"]);
    assert!(BallTop::MODEL.multipliers.is_empty());
    let multipliers: Vec<&str> = PivotedBall::MODEL.multipliers.iter().map(|entry| entry.name).collect();
    assert_eq!(multipliers, ["pivot_x", "pivot_y", "pivot_z"]);
    assert_eq!(HangingRods::MODEL.state_speeds[3], "omega_L_1_x");
    // Nothing is divided by that depends on the attitude.
    let divides = |guards: &[holonomy::GuardInfo]| guards.iter().map(|guard| guard.name).collect::<Vec<_>>();
    assert_eq!(divides(BallTop::MODEL.guards), Vec::<&str>::new());
    assert_eq!(divides(Rock::MODEL.guards), Vec::<&str>::new());
}

/// The top by angles, R = Rx(a) Rz(b) Ry(c), and the two by quaternions, at random states.
#[test]
fn the_heavy_top_by_angles_and_by_quaternions() {
    let (m, g, l, [j1, j2, j3]) = (15.0, 9.81, 1.1, [0.25, 0.45, 0.3]);
    let angles = Running::new(PivotedTop { m, g, j1, j2, j3, l });
    let (c1, c2, c3) = (0.0, l, 0.0);
    let pivoted = Running::new(PivotedBall { m, g, j1, j2, j3, c1, c2, c3 });
    let tree = Running::new(BallTop { m, g, j1, j2, j3, c1, c2, c3 });
    let mut random = SplitMix::new(5);
    for _ in 0..50 {
        let [a, b, c] = [3.0, 1.2, 3.0].map(|most| random.between(-most, most));
        let omega = random.vector(3, -4.0, 4.0);
        let e = then(then(about(0, a), about(2, b)), about(1, c));
        let place = turned(e, [0.0, l, 0.0]);
        let by_angles = [place.to_vec(), vec![a, b, c], omega.clone()].concat();
        let by_numbers = [place.to_vec(), e.to_vec(), omega.clone()].concat();
        let (expected, found) = (angles.velocity_rates(0.0, &by_angles), pivoted.velocity_rates(0.0, &by_numbers));
        let force = ["pivot_x", "pivot_y", "pivot_z"];
        let of = |name: &&str| (angles.multiplier(name, 0.0, &by_angles), pivoted.multiplier(name, 0.0, &by_numbers));
        let (held, holds): (Vec<f64>, Vec<f64>) = force.iter().map(of).unzip();
        assert_close_at("ω̇", &found[3..6], &expected[3..], AT_A_STATE, g);
        assert_close_at("a", &found[..3], &expected[..3], AT_A_STATE, g);
        assert_close_at("λ", &holds, &held, AT_A_STATE, m * g);
        let y = [e.to_vec(), omega].concat();
        let told = outputs(&tree, &y);
        assert_close_at("ω̇", &tree.accelerations(0.0, &y), &expected[3..], AT_A_STATE, g);
        assert_close_at("a", &told[..3], &expected[..3], AT_A_STATE, g);
        assert_close_at("R", &told[3..6], &held, AT_A_STATE, m * g);
    }
}

/// The published figures, to the digits that the models by angles have.
#[test]
fn the_published_tops() {
    let golden = golden();
    for (name, start, step) in
        [("fast_top", [1.0, 0.0, 0.0, 0.0], 0.001), ("steady_precession", about(0, FRAC_PI_3), 0.002)]
    {
        let case = list(&golden["cases"]).iter().find(|case| text(&case["name"]) == name).expect("the case is there");
        let p = &case["parameters"];
        let (j, c) = (numbers(&p["Jc_diag"]), numbers(&p["com_in_body"]));
        let ([m, g], [j1, j2, j3], [c1, c2, c3]) =
            (["m", "g"].map(|name| number(p, name)), [j[0], j[1], j[2]], [c[0], c[1], c[2]]);
        let pivoted = Running::new(PivotedBall { m, g, j1, j2, j3, c1, c2, c3 });
        let tree = Running::new(BallTop { m, g, j1, j2, j3, c1, c2, c3 });
        let rates = numbers(&case["initial"]["body_rates"]);
        let place = turned(start, [c1, c2, c3]);
        let first = [place.to_vec(), start.to_vec(), rates].concat();
        let rows = list(&case["expected"]);
        let times: Vec<f64> = rows.iter().map(|row| number(row, "t")).collect();
        for (y, row) in pivoted.run(&first, &times, step).iter().zip(rows) {
            let place = format!("{name} at {}", row["t"]);
            let (v, rates) = (pivoted.velocities(0.0, y), pivoted.velocity_rates(0.0, y));
            let told = outputs(&tree, &y[3..]);
            for (acceleration, force) in [
                (&rates[..3], ["pivot_x", "pivot_y", "pivot_z"].map(|row| pivoted.multiplier(row, 0.0, y))),
                (&told[..3], [told[3], told[4], told[5]]),
            ] {
                assert_close(&place, acceleration, &numbers(&row["com_acceleration"]), IN_MOTION);
                assert_close_at(&place, &force, &numbers(&row["pivot_force_on_body"]), IN_MOTION, m * g);
            }
            assert_close(&place, &y[..3], &numbers(&row["com_position"]), IN_MOTION);
            assert_close(&place, &v[..3], &numbers(&row["com_velocity"]), IN_MOTION);
            assert_close(&place, &v[3..6], &numbers(&row["body_rates"]), IN_MOTION);
            assert_close_at(&place, &rates[3..6], &numbers(&row["body_rate_derivatives"]), IN_MOTION, g);
            assert_close(&place, &told[6..7], &[number(row, "vertical_angular_momentum")], IN_MOTION);
            let energy = number(row, "energy");
            assert!((pivoted.energy(0.0, y) - energy).abs() <= IN_MOTION * energy, "{place}");
        }
    }
}

/// The start of a tumbling rock: next to the axis about which it cannot turn steadily.
fn tumbling() -> State<Rock> {
    State::<Rock> { e0: 1.0, dot_x: 0.3, omega_B_x: 0.1, omega_B_y: 2.0, omega_B_z: 0.05, ..Default::default() }
}

fn rock() -> Rock {
    Rock { m: 2.0, j1: 0.3, j2: 0.4, j3: 0.5, k: 0.02 }
}

/// A free rock tumbles for 50 s: angular momentum in N, energy, and the norm at every step.
#[test]
fn a_free_rock_keeps_what_it_has() -> Result<(), Error> {
    let rock = rock().prepare()?;
    let start = tumbling();
    let run = rock.simulate(start).method(Method::Dop853).tolerance(1e-10, 1e-12).until(50.0)?;
    assert!(run.times().len() > 100);
    let momentum = |t: f64, s: &State<Rock>| entries(&rock.outputs(t, s, &[]));
    let (first, energy) = (momentum(0.0, &start), rock.energy(0.0, &start));
    let mut turned = false;
    for (t, s) in run.iter() {
        let norm = s.e0 * s.e0 + s.e1 * s.e1 + s.e2 * s.e2 + s.e3 * s.e3;
        assert!((norm - 1.0).abs() < 1e-12, "|e|² = {norm} at {t}");
        let now = momentum(t, s);
        assert!(now.iter().zip(&first).all(|(a, b)| (a - b).abs() < 1e-8), "{now:?} at {t}, {first:?} first");
        assert!((rock.energy(t, s) - energy).abs() < 1e-8 * energy, "{} at {t}", rock.energy(t, s));
        turned |= s.omega_B_y < -1.0;
    }
    // It turns over, as a tennis racket does.
    assert!(turned);
    Ok(())
}

/// Speeds of the model's own give the same motion.
#[test]
fn kanes_speeds_beside_a_quaternion() {
    let Rock { m, j1, j2, j3, k } = rock();
    let (plain, own) = (Running::new(rock()), Running::new(KanesRock { m, j1, j2, j3, k }));
    assert_eq!(KanesRock::MODEL.state_speeds, ["u1", "u2", "u3", "vx", "vy", "vz"]);
    let mut random = SplitMix::new(8);
    for _ in 0..20 {
        let (e, place, omega, v) =
            (drawn(&mut random), random.vector(3, -1.0, 1.0), random.vector(3, -3.0, 3.0), random.vector(3, -3.0, 3.0));
        let u = [0.6 * omega[0] + 0.8 * omega[1], 0.6 * omega[1] - 0.8 * omega[0], omega[2]];
        let body = [v[0], v[1], v[2]];
        let y = [place.clone(), e.to_vec(), turned(e, body).to_vec(), omega.clone()].concat();
        let mine = [place, e.to_vec(), u.to_vec(), v].concat();
        let (rate, own_rate) = (plain.rate(0.0, &y), own.rate(0.0, &mine));
        assert_close_at("ẋ", &own_rate[..7], &rate[..7], AT_A_STATE, 1.0);
        let a = &rate[10..];
        let expected = [0.6 * a[0] + 0.8 * a[1], 0.6 * a[1] - 0.8 * a[0], a[2]];
        assert_close_at("u̇", &own_rate[7..10], &expected, AT_A_STATE, 1.0);
        // d/dt of components in the body's axes where nothing accelerates: v × ω
        let w = omega;
        let carried =
            [body[1] * w[2] - body[2] * w[1], body[2] * w[0] - body[0] * w[2], body[0] * w[1] - body[1] * w[0]];
        assert_close_at("v̇", &own_rate[10..], &carried, AT_A_STATE, 1.0);
        assert_close_at("T", &[own.energy(0.0, &mine)], &[plain.energy(0.0, &y)], AT_A_STATE, 1.0);
    }
}

/// Three rods fall from the side: energy and the angular momentum about the vertical.
#[test]
fn rods_on_ball_joints() -> Result<(), Error> {
    let rods = HangingRods { m: 0.8, l: 0.5, r: 0.1, g: 9.81 }.prepare()?;
    let mut random = SplitMix::new(21);
    let e: Vec<[f64; 4]> = (0..3).map(|_| drawn(&mut random)).collect();
    let omega = random.vector(9, -2.0, 2.0);
    let coordinates: Vec<f64> = (0..4).flat_map(|i| e.iter().map(move |e| e[i])).collect();
    let y = [coordinates, omega].concat();
    let start = State::<HangingRods>::from_fn(|i| y[i]);
    let told = |t: f64, s: &State<HangingRods>| (rods.energy(t, s), rods.outputs(t, s, &[]).vertical);
    let (energy, vertical) = told(0.0, &start);
    let run = rods.simulate(start).method(Method::Dop853).tolerance(1e-11, 1e-12).until(3.0)?;
    assert!(run.largest_residuals().position < 1e-12);
    for (t, s) in run.iter() {
        let now = told(t, s);
        assert!((now.0 - energy).abs() < 1e-8 && (now.1 - vertical).abs() < 1e-8, "{now:?} at {t}");
    }
    Ok(())
}

/// A solid ball on a slope: 5/7 of g sin α, the friction 2/7 of m g sin α, and its spin about the normal stays (Routh).
#[test]
fn a_ball_rolls_down_a_slope() -> Result<(), Error> {
    let (m, r, g, slope) = (1.2, 0.3, 9.81, 0.2_f64);
    let ball = RollingBall { m, r, g, slope }.prepare()?;
    let guess = State::<RollingBall> { z: r, e0: 1.0, dot_y: 0.7, omega_B_z: 3.0, ..Default::default() };
    let start = ball.assemble(guess).solve()?;
    let multipliers = ball.multipliers(0.0, &start, &[]);
    assert!((multipliers.roll_x + 2.0 / 7.0 * m * g * slope.sin()).abs() < 1e-12);
    assert!((multipliers.roll_z - m * g * slope.cos()).abs() < 1e-12 && multipliers.roll_y.abs() < 1e-12);
    assert_eq!(multipliers.contact, multipliers.roll_z);
    let run = ball.simulate(start).tolerance(1e-11, 1e-12).until(2.0)?;
    let (t, end) = run.last();
    assert!((end.x - 5.0 / 14.0 * g * slope.sin() * t * t).abs() < 1e-8, "{}", end.x);
    assert!((end.y - 0.7 * t).abs() < 1e-8 && (end.z - r).abs() < 1e-12);
    // ω in N: across the way v/r, about the normal what it was.
    let w = turned([end.e0, end.e1, end.e2, end.e3], body_rates(&ball, t, end));
    let v = 5.0 / 7.0 * g * slope.sin() * t;
    assert!((w[1] - v / r).abs() < 1e-7 && (w[0] + 0.7 / r).abs() < 1e-7 && (w[2] - 3.0).abs() < 1e-7, "{w:?}");
    Ok(())
}

fn body_rates(ball: &Prepared<RollingBall>, t: f64, s: &State<RollingBall>) -> [f64; 3] {
    let v = ball.velocities(t, s);
    ["omega_B_x", "omega_B_y", "omega_B_z"].map(|name| v.get(name).expect("a speed"))
}

/// About its axis of symmetry a free body turns with 0 and ± i Ω (J3 - J1)/J1, and its attitude with ± i Ω/2 besides.
#[test]
fn a_spinning_rotor_linearised() -> Result<(), Error> {
    let rotor = Rock { m: 2.0, j1: 0.3, j2: 0.3, j3: 0.5, k: 0.0 }.prepare()?;
    let spin = 3.0;
    let state = State::<Rock> { e0: 1.0, omega_B_z: spin, ..Default::default() };
    let linear = rotor.linearize(0.0, &state, &[])?;
    assert_eq!(linear.states.len(), 12);
    assert!(!linear.states.contains(&"e0") && linear.states.contains(&"e3"));
    let mut found = linear.eigenvalues()?;
    found.sort_by(|a, b| a.im.total_cmp(&b.im));
    let (slow, nutation) = (spin / 2.0, spin * 0.2 / 0.3);
    let expected = [-nutation, -slow, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, slow, nutation];
    for (found, expected) in found.iter().zip(expected) {
        // Of the double zeros half the digits are left.
        let close = if expected == 0.0 { 1e-6 } else { 1e-10 };
        assert!(found.re.abs() < close && (found.im - expected).abs() < close, "{found} {expected}");
    }
    Ok(())
}

/// A top that hangs: it is found from a tilt, and swings with √(m g l/J) in both planes.
#[test]
fn a_hanging_top_is_found_and_swings() -> Result<(), Error> {
    let (m, g, j, l) = (15.0, 9.81, 0.25, 1.0);
    let top = BallTop { m, g, j1: j, j2: j, j3: 0.3, c1: 0.0, c2: 0.0, c3: -l }.prepare()?;
    let [e0, e1, e2, e3] = then(about(0, 0.4), about(1, -0.3));
    let guess = State::<BallTop> { e0, e1, e2, e3, ..Default::default() };
    let rest = top.trim(guess).rest().solve()?.state;
    assert!(
        rest.e1.abs() < 1e-12 && rest.e2.abs() < 1e-12 && (rest.e0 * rest.e0 + rest.e3 * rest.e3 - 1.0).abs() < 1e-12
    );
    let mut found = top.linearize(0.0, &rest, &[])?.eigenvalues()?;
    found.sort_by(|a, b| a.im.total_cmp(&b.im));
    let swing = (m * g * l / (j + m * l * l)).sqrt();
    for (found, expected) in found.iter().zip([-swing, -swing, 0.0, 0.0, swing, swing]) {
        assert!(found.re.abs() < 1e-6 && (found.im - expected).abs() < 1e-6, "{found} {expected}");
    }
    Ok(())
}

/// The published precession as a steady motion of a frame that precesses along: its spin is found.
#[test]
fn a_precession_is_found() -> Result<(), Error> {
    let golden = golden();
    let case =
        list(&golden["cases"]).iter().find(|case| text(&case["name"]) == "steady_precession").expect("it is there");
    let p = &case["parameters"];
    let (j, c) = (numbers(&p["Jc_diag"])[0], numbers(&p["com_in_body"])[2]);
    let rate = number(p, "precession_rate");
    let model = Precession { m: number(p, "m"), g: number(p, "g"), j, l: c, rate }.prepare()?;
    let [e0, e1, e2, e3] = about(0, number(p, "tilt"));
    let guess = State::<Precession> { e0, e1, e2, e3, dot_psi: 100.0, ..Default::default() };
    let held = ["e0", "e1", "e2", "e3", "psi", "omega_L_x", "omega_L_y"];
    let trim = held.iter().fold(model.trim(guess).any_rate("psi"), |trim, name| trim.hold(name));
    let steady = trim.solve()?.state;
    assert!((steady.dot_psi - number(p, "spin_rate")).abs() < 1e-8, "{}", steady.dot_psi);
    Ok(())
}

/// The forms of the paper hold with all of v: the full system, M⁻¹, Gauss, the null space.
#[test]
fn the_forms_of_the_paper_know_quaternions() -> Result<(), Error> {
    let top = PivotedBall { m: 15.0, g: 9.81, j1: 0.25, j2: 0.45, j3: 0.3, c1: 0.1, c2: 1.0, c3: 0.2 }.prepare()?;
    let [e0, e1, e2, e3] = drawn(&mut SplitMix::new(3));
    let [x, y, z] = turned([e0, e1, e2, e3], [0.1, 1.0, 0.2]);
    let guess = State::<PivotedBall> { x, y, z, e0, e1, e2, e3, omega_T_x: 1.0, omega_T_y: -3.0, omega_T_z: 2.0 };
    let s = top.assemble(guess).solve()?;
    let full = top.initial_equations_at(0.0, &s, &[]);
    let own = entries(&top.velocity_rates(0.0, &s, &[]));
    let held = top.multipliers(0.0, &s, &[]);
    let (rates, multipliers) = full.solve()?;
    assert_close_at("v̇ (2.8)", rates.as_slice(), &own, 1e-11, 1.0);
    let expected = [held.pivot_x, held.pivot_y, held.pivot_z, 0.0];
    assert_close_at("λ (2.8)", multipliers.as_slice(), &expected, 1e-11, 100.0);
    assert_close_at("λ (3.6)", full.multipliers()?.as_slice(), &expected, 1e-11, 100.0);
    let tangent = full.tangent_rates(&top.complement_at(0.0, &s))?;
    assert_close_at("v̇ (3.4)", tangent.as_slice(), &own, 1e-11, 1.0);
    Ok(())
}

/// In all velocities with the null space of C the rock tumbles as it does in its speeds.
#[test]
fn a_rock_in_the_general_chart() -> Result<(), Error> {
    let rock = rock().prepare()?;
    let run = |charts| rock.simulate(tumbling()).charts(charts).tolerance(1e-11, 1e-12).until(3.0);
    let (own, general) = (run(Charts::Stay)?, run(Charts::General)?);
    let ((_, a), (_, b)) = (own.last(), general.last());
    assert_close_at("the end", &entries(b), &entries(a), 1e-8, 1.0);
    Ok(())
}

/// No rotation is e0 = 1: zeros everywhere are no attitude, and nothing becomes of them in silence.
#[test]
fn zeros_are_no_attitude() -> Result<(), Error> {
    let rock = rock().prepare()?;
    let nowhere = State::<Rock> { dot_x: 1.0, ..Default::default() };
    let error = Error::from(rock.simulate(nowhere).until(1.0).expect_err("no attitude"));
    assert!(matches!(error, Error::Unmet { constraint: "norm_B", .. }), "{error}");
    let error = rock.assemble(nowhere).solve().expect_err("nowhere to go");
    assert!(matches!(&error, Error::Assembly { constraint: "norm_B", .. }), "{error}");
    // Anything else is turned into an attitude, along itself.
    let rough = State::<Rock> { e0: 0.9, e2: -0.3, ..Default::default() };
    let s = rock.assemble(rough).solve()?;
    assert!((s.e0 * s.e0 + s.e2 * s.e2 - 1.0).abs() < 1e-14 && s.e1 == 0.0 && s.e3 == 0.0);
    Ok(())
}
