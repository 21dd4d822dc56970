//! Large problems of the literature with numbers from outside: chains of ten and twenty pendulums, an arm of six bodies, a loop in
//! space, a bicycle.
//!
//! Accelerations and reactions at the stored states to a relative 1e-12, motions to 1e-9, where the numbers are trusted that far.

#[path = "models/arm.rs"]
mod arm;
#[path = "models/bicycle.rs"]
mod bicycle;
#[path = "models/bricard.rs"]
mod bricard;
#[path = "models/chains.rs"]
mod chains;
mod support;

use arm::Puma;
use bicycle::Bicycle;
use bricard::Bricard;
use chains::{TenPendulums, TwentyPendulums};
use holonomy::prelude::*;
use serde_json::Value;
use support::golden::{assert_close, assert_close_at, case, list, numbers, parse, picked};
use support::running::{Running, dense, entries};

const AT_A_STATE: f64 = 1e-12;
const IN_MOTION: f64 = 1e-9;

fn times(rows: &[Value]) -> Vec<f64> {
    rows.iter().map(|row| row["t"].as_f64().expect("a time")).collect()
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().expect("a number")
}

/// The links' tensions: their rows are halves of squares, so that λ times the length is the push.
fn tensions<M: ConstrainedSystem>(chain: &Running<M>, l: f64, y: &[f64]) -> Vec<f64> {
    chain.multipliers(0.0, y).iter().map(|lambda| -lambda * l).collect()
}

/// Hanging at rest, the tensions carry what is below, and the frequencies are those of Laguerre's polynomial.
fn hangs<M: ConstrainedSystem>(chain: &Running<M>, l: f64, case: &Value) {
    let n = M::MODEL.state_coordinates.len();
    let rest = vec![0.0; 2 * n];
    assert_close("tensions", &tensions(chain, l, &rest), &numbers(&case["static_tensions"]), AT_A_STATE);
    let stiffness = -chain.jacobian(0.0, &rest).view((n, 0), (n, n)).into_owned();
    let mut squares: Vec<f64> = stiffness.complex_eigenvalues().iter().map(|e| e.re).collect();
    squares.sort_by(f64::total_cmp);
    let frequencies: Vec<f64> = squares.iter().map(|s| s.sqrt()).collect();
    // the eigenvalues of a matrix that is not symmetric lose its condition
    assert_close("frequencies", &frequencies, &numbers(&case["expected"]["frequencies_rad_s"]), 1e-11);
}

#[test]
fn ten_pendulums_in_a_row() {
    let golden = parse(include_str!("data/pendulum_chain.json"));
    let [m, l, g] = ["m", "l", "g"].map(|name| number(&golden["parameters"], name));
    let chain = Running::new(TenPendulums { m, l, g });
    let rows = list(&case(&golden, "release_from_horizontal_n10")["expected"]);
    let state = |row: &Value| picked(row, &["angles", "rates"]);
    for (y, row) in chain.run(&state(&rows[0]), &times(rows), 0.005).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        let at = state(row);
        assert_close(&place, &chain.accelerations(0.0, &at), &numbers(&row["angular_accelerations"]), AT_A_STATE);
        assert_close_at(&place, &tensions(&chain, l, &at), &numbers(&row["tensions"]), AT_A_STATE, 10.0 * m * g);
        assert_close_at(&place, y, &at, IN_MOTION, 1.0);
    }
    hangs(&chain, l, case(&golden, "linearised_n10"));
}

#[test]
fn twenty_pendulums_in_a_row() {
    let golden = parse(include_str!("data/pendulum_chain.json"));
    let [m, l, g] = ["m", "l", "g"].map(|name| number(&golden["parameters"], name));
    hangs(&Running::new(TwentyPendulums { m, l, g }), l, case(&golden, "linearised_n20"));
}

fn puma(golden: &Value, g: f64, motors: bool) -> Running<Puma> {
    let links = list(&golden["parameters"]);
    let of = |link: usize, name: &str| numbers(&links[link - 1][name]);
    let [d3, d4] = [3, 4].map(|link| of(link, "d")[0]);
    let [a2, a3] = [2, 3].map(|link| of(link, "a")[0]);
    let [m2, m3, m4, m5, m6] = [2, 3, 4, 5, 6].map(|link| of(link, "m")[0]);
    let inertia = |link: usize| <[f64; 3]>::try_from(of(link, "I_diag")).expect("three inertias");
    let center = |link: usize| <[f64; 3]>::try_from(of(link, "com")).expect("a place");
    let motor = |i: usize| if motors { of(i + 1, "G")[0].powi(2) * of(i + 1, "Jm")[0] } else { 0.0 };
    let [[rx2, ry2, rz2], [rx3, ry3, rz3]] = [2, 3].map(center);
    let [_, iy1, _] = inertia(1);
    let [[ix2, iy2, iz2], [ix3, iy3, iz3], [ix4, iy4, iz4], [ix5, iy5, iz5], [ix6, iy6, iz6]] =
        [2, 3, 4, 5, 6].map(inertia);
    Running::new(Puma {
        g,
        a2,
        a3,
        d3,
        d4,
        m2,
        m3,
        m4,
        m5,
        m6,
        rx2,
        ry2,
        rz2,
        rx3,
        ry3,
        rz3,
        ry4: center(4)[1],
        rz6: center(6)[2],
        iy1,
        ix2,
        iy2,
        iz2,
        ix3,
        iy3,
        iz3,
        ix4,
        iy4,
        iz4,
        ix5,
        iy5,
        iz5,
        ix6,
        iy6,
        iz6,
        motor: std::array::from_fn(motor),
    })
}

const G: f64 = 9.81;

#[test]
fn puma_at_states() {
    let golden = parse(include_str!("data/puma560.json"));
    let (arm, light) = (puma(&golden, G, true), puma(&golden, G, false));
    let rows = list(&case(&golden, "accelerations")["expected"]);
    let still = |q: &[f64]| [q.to_vec(), vec![0.0; 6]].concat();
    let negative = |values: Vec<f64>| values.into_iter().map(|v| -v).collect::<Vec<_>>();
    let close_to_printed = |what: &str, computed: &[f64], printed: &Value| {
        for (c, p) in computed.iter().zip(numbers(printed)) {
            // half a unit of the last decimal, and what the doubles of both are off
            assert!((c - p).abs() <= 5e-5 + 1e-12, "{what}: {c} instead of {p}");
        }
    };
    let at_rest = still(&numbers(&rows[0]["q"]));
    let inertia = case(&golden, "inertia_at_qn");
    let m = dense(&arm.0.mass_matrix(0.0, &arm.state(&at_rest))).transpose();
    assert_close("M", m.as_slice(), &numbers(&inertia["expected"]["M"]), AT_A_STATE);
    close_to_printed("M", m.as_slice(), &inertia["published"]);
    let load = case(&golden, "gravity_load_at_qn");
    let holding = negative(arm.forcing(0.0, &at_rest));
    assert_close("holding torque", &holding, &numbers(&load["expected"]["holding_torque"]), AT_A_STATE);
    close_to_printed("holding torque", &holding, &load["published"]);
    let turning = case(&golden, "velocity_torque_at_qn");
    let floating = puma(&golden, 0.0, true);
    let torque = negative(floating.forcing(0.0, &picked(&rows[0], &["q", "qd"])));
    assert_close("velocity torque", &torque, &numbers(&turning["expected"]["velocity_torque"]), AT_A_STATE);
    for row in rows {
        let y = picked(row, &["q", "qd"]);
        let torques = numbers(&row["joint_torques"]);
        let bias = negative(arm.forcing(0.0, &y));
        assert_close("bias torque", &bias, &numbers(&row["bias_torque"]), AT_A_STATE);
        for (arm, name) in [(&arm, "qdd"), (&light, "qdd_without_motors")] {
            let accelerations = arm.0.accelerations(0.0, &arm.state(&y), &Vector::from_fn(|i| torques[i]));
            // without motors M has the condition 1e5
            let values = dense(&arm.0.mass_matrix(0.0, &arm.state(&y))).singular_values();
            let condition = values.max() / values.min();
            let tolerance = AT_A_STATE * (condition / 100.0).max(1.0);
            assert_close(name, &entries(&accelerations), &numbers(&row[name]), tolerance);
        }
    }
}

#[test]
fn puma_falls() {
    let golden = parse(include_str!("data/puma560.json"));
    let arm = puma(&golden, G, true);
    let rows = list(&case(&golden, "unpowered_fall")["expected"]);
    let state = |row: &Value| picked(row, &["q", "qd"]);
    let energy = arm.energy(0.0, &state(&rows[0]));
    for (y, row) in arm.run(&state(&rows[0]), &times(rows), 0.005).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        assert_close(&place, &arm.accelerations(0.0, &state(row)), &numbers(&row["qdd"]), AT_A_STATE);
        assert_close(&place, y, &state(row), IN_MOTION);
        assert!((arm.energy(0.0, y) - energy).abs() <= IN_MOTION * energy.abs(), "energy {place}");
    }
}

/// The emitted chart eliminates the loop's four rows one after another, by pivots of which some vanish where the loop is closed: the
/// states are judged by (2.8), and the run works in the general form (3.5).
#[test]
fn bricards_mechanism() {
    let golden = parse(include_str!("data/bricard.json"));
    let [m, l, b, g] = ["m", "l", "b", "g"].map(|name| number(&golden["parameters"], name));
    let mechanism = Bricard { m, l, b, g }.prepare().expect("the parameters are good");
    let rows = list(&case(&golden, "library_run")["expected"]);
    let times = times(rows);
    let of = |row: &Value| (numbers(&row["joint_angles_1_to_5"]), numbers(&row["joint_rates"]));
    let (angles, rates) = of(&rows[0]);
    let start = Vector::from_fn(|i| angles.get(i).copied().unwrap_or(rates[0]));
    let simulation = mechanism.simulate(start).velocities(Vector::from_fn(|i| rates[i])).starting_at(times[0]);
    let run = simulation.tolerance(1e-13, 1e-13).until(times[rows.len() - 1]);
    let run = run.unwrap_or_else(|stop| panic!("stopped at {:?}: {}", stop.trajectory.last().0, stop.error));
    println!("{:?}", run.statistics());
    for row in rows {
        let place = format!("at {}", row["t"]);
        let (angles, rates) = of(row);
        let (x, v) = (Vector::from_fn(|i| angles[i]), Vector::from_fn(|i| rates[i]));
        let equations = mechanism.initial_equations(0.0, &x, &v, &[]);
        let (accelerations, lambda) = equations.solve().expect("rows of rank four");
        assert_close(&place, accelerations.as_slice(), &numbers(&row["joint_accelerations"]), AT_A_STATE);
        let reaction = equations.constraint_matrix.transpose() * lambda;
        assert_close(&place, reaction.as_slice(), &numbers(&row["generalised_reaction"]), AT_A_STATE);
        let t = number(row, "t");
        let (found, v) = (run.at(t).expect("a time of the run"), run.velocities_at(t).expect("a time of the run"));
        // the angles swing between 0 and π, the rates reach 2.2
        for (found, expected) in entries(&found)[..5].iter().chain(&entries(&v)).zip(angles.iter().chain(&rates)) {
            assert!((found - expected).abs() <= IN_MOTION, "{found} instead of {expected} {place}");
        }
        // the row that the model leaves out
        let [(s1, c1), (s2, _), (s3, c3), _, (s5, _)] =
            [found.a1, found.a2, found.a3, found.a4, found.a5].map(f64::sin_cos);
        assert!((s3 * s1 - c3 * s2 * c1 - s5).abs() <= IN_MOTION, "the axis {place}");
    }
}

/// The bicycle from the parameters of the benchmark, all turned into the axes of the steering axis.
fn bicycle(p: &Value) -> Bicycle {
    let of = |name: &str| number(p, name);
    let (s, c) = of("lambda").sin_cos();
    // ahead of the steering axis and along it
    let turned = |x: f64, z: f64| [x * c - z * s, x * s + z * c];
    let inertia = |body: &str| {
        let [x, z, xz] = ["xx", "zz", "xz"].map(|axes| of(&format!("I{body}{axes}")));
        [
            x * c * c - 2.0 * xz * s * c + z * s * s,
            x * s * s + 2.0 * xz * s * c + z * c * c,
            (x - z) * s * c + xz * (c * c - s * s),
        ]
    };
    let (rr, rf, w) = (of("rR"), of("rF"), of("w"));
    let ([d1, _], [d3, _]) = (turned(w + of("c"), rr), turned(-of("c"), -rf));
    let [_, d2] = turned(w, rr - rf);
    let ([l1, l2], [l3, l4]) = (turned(of("xB"), of("zB") + rr), turned(of("xH") - w, of("zH") + rf));
    let ([ibx, ibz, ibxz], [ihx, ihz, ihxz]) = (inertia("B"), inertia("H"));
    let [mr, mb, mh, mf] = ["mR", "mB", "mH", "mF"].map(of);
    let [irx, iry, iby, ihy, ifx, ify] = ["IRxx", "IRyy", "IByy", "IHyy", "IFxx", "IFyy"].map(of);
    let g = of("g");
    Bicycle {
        g,
        rr,
        rf,
        d1,
        d2,
        d3,
        l1,
        l2,
        l3,
        l4,
        mr,
        mb,
        mh,
        mf,
        irx,
        iry,
        ibx,
        iby,
        ibz,
        ibxz,
        ihx,
        ihy,
        ihz,
        ihxz,
        ifx,
        ify,
    }
}

#[test]
fn the_bicycle_has_the_published_eigenvalues() {
    let golden = parse(include_str!("data/whipple_linear.json"));
    let lean = number(&golden["parameters"], "lambda");
    let bicycle = Running::new(bicycle(&golden["parameters"]));
    let Bicycle { rr, rf, .. } = *bicycle.0.system();
    let names: Vec<&str> =
        Bicycle::MODEL.state_coordinates.iter().chain(Bicycle::MODEL.state_speeds).copied().collect();
    let place = |name: &str| names.iter().position(|n| *n == name).expect("a name of the state");
    let lateral = ["phi", "delta", "rolling", "steering"].map(place);
    for row in list(&case(&golden, "eigenvalues")["expected"]) {
        let speed = number(row, "v");
        let mut y = vec![0.0; names.len()];
        (y[place("theta")], y[place("spin_r")]) = (lean, -speed / rr);
        // upright and straight, the bicycle runs on
        let velocities = bicycle.velocities(0.0, &y);
        let expected = [speed, 0.0, 0.0, 0.0, 0.0, 0.0, -speed / rr, -speed / rf];
        assert_close_at("v", &velocities, &expected, AT_A_STATE, 1.0);
        assert_close_at("v̇", &bicycle.velocity_rates(0.0, &y), &[0.0; 8], AT_A_STATE, 10.0);
        let jacobian = bicycle.jacobian(0.0, &y);
        let found = nalgebra::DMatrix::from_fn(4, 4, |i, j| jacobian[(lateral[i], lateral[j])]);
        assert_close(&format!("A at {speed}"), found.transpose().as_slice(), &numbers(&row["A"]), AT_A_STATE);
        // nothing else enters the lateral motion
        for i in lateral {
            let others = (0..y.len()).filter(|j| !lateral.contains(j));
            others.for_each(|j| assert!(jacobian[(i, j)].abs() <= 1e-10, "{} by {}", names[i], names[j]));
        }
        let mut eigenvalues: Vec<(f64, f64)> = found.complex_eigenvalues().iter().map(|e| (e.re, e.im)).collect();
        for published in list(&row["published"]) {
            let [re, im] = <[f64; 2]>::try_from(numbers(published)).expect("two parts");
            let distance = |e: &(f64, f64)| (e.0 - re).hypot(e.1 - im);
            let nearest = (0..eigenvalues.len())
                .min_by(|a, b| distance(&eigenvalues[*a]).total_cmp(&distance(&eigenvalues[*b])))
                .expect("four of them");
            let off = distance(&eigenvalues.swap_remove(nearest));
            assert!(off <= 1e-11, "{re} + {im}i at {speed} is off by {off:e}");
        }
        // The linearisation of the whole has these and otherwise zeros: where the bicycle is and goes, its speed, its pitch.
        let linear = bicycle.0.linearize(0.0, &bicycle.state(&y), &[]).expect("a steady motion");
        let mut eigenvalues = linear.eigenvalues().expect("they are found");
        for published in list(&row["published"]) {
            let [re, im] = <[f64; 2]>::try_from(numbers(published)).expect("two parts");
            let distance = |e: &nalgebra::Complex<f64>| (e.re - re).hypot(e.im - im);
            let nearest = (0..eigenvalues.len())
                .min_by(|a, b| distance(&eigenvalues[*a]).total_cmp(&distance(&eigenvalues[*b])))
                .expect("enough of them");
            let off = distance(&eigenvalues.swap_remove(nearest));
            assert!(off <= 1e-11, "{re} + {im}i at {speed} is off by {off:e} in the whole");
        }
        // The wheels on the ground leave the pitch no choice.
        assert_eq!((&linear.dependents[..], eigenvalues.len()), (&["theta"][..], names.len() - 5));
        assert!(eigenvalues.iter().all(|value| value.norm_sqr() < 1e-20), "{speed}: {eigenvalues:?}");
    }
}
