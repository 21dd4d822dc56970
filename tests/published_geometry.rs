//! Mechanisms of the literature from geometry alone, against numbers from outside: no M, no h*, no T is written for any of them.
//!
//! Accelerations and reactions at the stored states to a relative 1e-12 (1e-11 where the data are evaluations of other programs),
//! motions to 1e-9, as the same problems by equations.

mod claims;
#[path = "../examples/rolling_disk/geometry.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has it")]
mod disk;
#[path = "models/geometry/mod.rs"]
mod geometry;
#[path = "../examples/puma/models.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has it")]
mod puma;
#[path = "models/rolling_disk.rs"]
mod rolling_disk;
mod support;

use claims::evaluated::simplified;
use disk::Disk;
use geometry::arms::SevenJoints;
use geometry::bobs::{TenBobs, ThreeBobs, ThreeTiedBobs, TwentyBobs};
use geometry::disc::Disc;
use geometry::rods::{FiveRods, TenRods, TwentyRods, TwoRods};
use geometry::sleigh::BladedSleigh;
use geometry::top::PivotedTop;
use geometry::whipple::Whipple;
use holonomy::{ConstrainedSystem, Vector};
use puma::PumaArm;
use rolling_disk::RollingDisk;
use serde_json::Value;
use std::path::Path;
use support::declared;
use support::golden::{assert_close, assert_close_at, case, from_json, list, numbers, parse, picked};
use support::running::{Running, dense, entries};

const AT_A_STATE: f64 = 1e-12;
const EVALUATED: f64 = 1e-11;
const IN_MOTION: f64 = 1e-9;

fn times(rows: &[Value]) -> Vec<f64> {
    rows.iter().map(|row| row["t"].as_f64().expect("a time")).collect()
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().expect("a number")
}

/// λ of the named rows.
fn lambda<M: ConstrainedSystem>(running: &Running<M>, names: &[&str], t: f64, y: &[f64]) -> Vec<f64> {
    names.iter().map(|name| running.multiplier(name, t, y)).collect()
}

/// All outputs.
fn outputs<M: ConstrainedSystem>(running: &Running<M>, y: &[f64]) -> Vec<f64> {
    entries(&running.0.outputs(0.0, &running.state(y), &Vector::from_fn(|_| 0.0)))
}

#[test]
fn nothing_but_geometry_is_declared() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/geometry");
    let examples = ["bricard/models.rs", "flyball/models.rs", "puma/models.rs", "rolling_disk/geometry.rs"]
        .map(|file| folder.join("../../../examples").join(file));
    for file in declared::rust_files(&folder).into_iter().chain(examples) {
        let source = std::fs::read_to_string(&file).expect("the file is there");
        for statement in ["inertia(", "forces(", "kinetic_energy("] {
            assert!(!source.contains(statement), "{statement} in {file:?}");
        }
    }
}

#[test]
fn rods_in_a_row() {
    let golden = parse(include_str!("data/chain_n.json"));
    let [m, l, g] = ["m", "l", "g"].map(|name| number(&golden["params"], name));
    fn agrees<M: ConstrainedSystem>(chain: Running<M>, states: &[Value]) {
        let n = M::MODEL.state_coordinates.len();
        let mut seen = 0;
        for state in states.iter().filter(|state| state["n"] == n) {
            let found = chain.accelerations(0.0, &picked(state, &["q", "qd"]));
            assert_close(M::MODEL.name, &found, &numbers(&state["qdd"]), EVALUATED);
            seen += 1;
        }
        assert_eq!(seen, 6);
    }
    let states = list(&golden["states"]);
    agrees(Running::new(TwoRods { m, l, g }), states);
    agrees(Running::new(FiveRods { m, l, g }), states);
    agrees(Running::new(TenRods { m, l, g }), states);
    agrees(Running::new(TwentyRods { m, l, g }), states);
}

/// Hanging at rest, the tensions carry what is below, and the frequencies are those of Laguerre's polynomial.
fn hangs<M: ConstrainedSystem>(chain: &Running<M>, case: &Value) {
    let n = M::MODEL.state_coordinates.len();
    let rest = vec![0.0; 2 * n];
    assert_close("tensions", &outputs(chain, &rest), &numbers(&case["static_tensions"]), AT_A_STATE);
    let stiffness = -chain.jacobian(0.0, &rest).view((n, 0), (n, n)).into_owned();
    let mut squares: Vec<f64> = stiffness.complex_eigenvalues().iter().map(|e| e.re).collect();
    squares.sort_by(f64::total_cmp);
    let frequencies: Vec<f64> = squares.iter().map(|s| s.sqrt()).collect();
    // the eigenvalues of a matrix that is not symmetric lose its condition
    assert_close("frequencies", &frequencies, &numbers(&case["expected"]["frequencies_rad_s"]), 1e-11);
}

/// A chain that falls from the horizontal.
fn falls<M: ConstrainedSystem>(chain: &Running<M>, case: &Value, weight: f64) {
    let rows = list(&case["expected"]);
    let state = |row: &Value| picked(row, &["angles", "rates"]);
    for (y, row) in chain.run(&state(&rows[0]), &times(rows), 0.005).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        let at = state(row);
        assert_close(&place, &chain.accelerations(0.0, &at), &numbers(&row["angular_accelerations"]), AT_A_STATE);
        assert_close_at(&place, &outputs(chain, &at), &numbers(&row["tensions"]), AT_A_STATE, weight);
        assert_close_at(&place, y, &at, IN_MOTION, 1.0);
    }
}

#[test]
fn bobs_in_a_row() {
    let golden = parse(include_str!("data/pendulum_chain.json"));
    let [m, l, g] = ["m", "l", "g"].map(|name| number(&golden["parameters"], name));
    let (three, ten) = (Running::new(ThreeBobs { m, l, g }), Running::new(TenBobs { m, l, g }));
    falls(&three, case(&golden, "release_from_horizontal_n3"), 3.0 * m * g);
    falls(&ten, case(&golden, "release_from_horizontal_n10"), 10.0 * m * g);
    hangs(&three, case(&golden, "linearised_n3"));
    hangs(&ten, case(&golden, "linearised_n10"));
    hangs(&Running::new(TwentyBobs { m, l, g }), case(&golden, "linearised_n20"));
}

/// The same three in Cartesian coordinates, the links as rows.
#[test]
fn tied_bobs() {
    let golden = parse(include_str!("data/pendulum_chain.json"));
    let [m, l, g] = ["m", "l", "g"].map(|name| number(&golden["parameters"], name));
    let chain = Running::new(ThreeTiedBobs { m, l, g });
    for row in list(&case(&golden, "release_from_horizontal_n3")["expected"]) {
        let (angles, rates) = (numbers(&row["angles"]), numbers(&row["rates"]));
        let [mut x, mut v] = [[0.0; 6]; 2];
        for i in 0..3 {
            let (sin, cos) = angles[i].sin_cos();
            for j in i..3 {
                (x[j], x[j + 3]) = (x[j] + l * sin, x[j + 3] - l * cos);
                (v[j], v[j + 3]) = (v[j] + l * cos * rates[i], v[j + 3] + l * sin * rates[i]);
            }
        }
        // released from the horizontal, the emitted chart is singular: the full system serves any state
        let equations = chain.0.initial_equations(0.0, &Vector::from_fn(|i| x[i]), &Vector::from_fn(|i| v[i]), &[]);
        let (_, lambda) = equations.solve().expect("rows of rank three");
        let tensions: Vec<f64> = lambda.iter().map(|lambda| -lambda).collect();
        assert_close_at("tensions", &tensions, &numbers(&row["tensions"]), AT_A_STATE, 3.0 * m * g);
    }
}

fn puma(golden: &Value, motors: bool) -> Running<PumaArm> {
    let links = list(&golden["parameters"]);
    let of = |link: usize, name: &str| numbers(&links[link - 1][name]);
    let triple = |link: usize, name: &str| <[f64; 3]>::try_from(of(link, name)).expect("three numbers");
    let [[rx2, ry2, rz2], [rx3, ry3, rz3]] = [2, 3].map(|link| triple(link, "com"));
    let [[ix2, iy2, iz2], [ix3, iy3, iz3], [ix4, iy4, iz4], [ix5, iy5, iz5], [ix6, iy6, iz6]] =
        [2, 3, 4, 5, 6].map(|link| triple(link, "I_diag"));
    let [m2, m3, m4, m5, m6] = [2, 3, 4, 5, 6].map(|link| of(link, "m")[0]);
    let motor = |i: usize| if motors { of(i + 1, "G")[0].powi(2) * of(i + 1, "Jm")[0] } else { 0.0 };
    let (a2, a3, d3, d4) = (of(2, "a")[0], of(3, "a")[0], of(3, "d")[0], of(4, "d")[0]);
    let (ry4, rz6, iy1) = (of(4, "com")[1], of(6, "com")[2], of(1, "I_diag")[1]);
    let motor_inertia = std::array::from_fn(motor);
    #[rustfmt::skip]
    let arm = PumaArm {
        g: 9.81, a2, a3, d3, d4, m2, m3, m4, m5, m6, rx2, ry2, rz2, rx3, ry3, rz3, ry4, rz6, iy1, ix2, iy2, iz2, ix3, iy3,
        iz3, ix4, iy4, iz4, ix5, iy5, iz5, ix6, iy6, iz6, motor_inertia,
    };
    Running::new(arm)
}

#[test]
fn puma_at_states() {
    let golden = parse(include_str!("data/puma560.json"));
    let (arm, light) = (puma(&golden, true), puma(&golden, false));
    let rows = list(&case(&golden, "accelerations")["expected"]);
    let negative = |values: Vec<f64>| values.into_iter().map(|v| -v).collect::<Vec<_>>();
    let at_rest = [numbers(&rows[0]["q"]), vec![0.0; 6]].concat();
    let m = dense(&arm.0.mass_matrix(0.0, &arm.state(&at_rest))).transpose();
    assert_close("M", m.as_slice(), &numbers(&case(&golden, "inertia_at_qn")["expected"]["M"]), AT_A_STATE);
    let load = &case(&golden, "gravity_load_at_qn")["expected"]["holding_torque"];
    assert_close("holding torque", &negative(arm.forcing(0.0, &at_rest)), &numbers(load), AT_A_STATE);
    for row in rows {
        let y = picked(row, &["q", "qd"]);
        let torques = numbers(&row["joint_torques"]);
        assert_close("bias", &negative(arm.forcing(0.0, &y)), &numbers(&row["bias_torque"]), AT_A_STATE);
        for (arm, name) in [(&arm, "qdd"), (&light, "qdd_without_motors")] {
            let accelerations = arm.0.accelerations(0.0, &arm.state(&y), &Vector::from_fn(|i| torques[i]));
            // without motors M has the condition 1e5
            let values = dense(&arm.0.mass_matrix(0.0, &arm.state(&y))).singular_values();
            let tolerance = AT_A_STATE * (values.max() / values.min() / 100.0).max(1.0);
            assert_close(name, &entries(&accelerations), &numbers(&row[name]), tolerance);
        }
    }
}

#[test]
fn puma_falls() {
    let golden = parse(include_str!("data/puma560.json"));
    let arm = puma(&golden, true);
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

#[test]
fn seven_joints() {
    let golden = parse(include_str!("data/arm7.json"));
    let arm = Running::new(SevenJoints { g: number(&golden["params"], "g") });
    let torques: Vec<f64> = (1..=7).map(|i| number(&golden["params"], &format!("tau{i}"))).collect();
    for state in list(&golden["states"]) {
        let y = numbers(&state["x"]);
        let (rate, _) = arm.0.derivative(0.0, &arm.state(&y), &Vector::from_fn(|i| torques[i]));
        assert_close("ẋ", &entries(&rate), &numbers(&state["xdot"]), EVALUATED);
    }
}

/// The JSON's body axes, the one of the mass centre being this model's y.
fn top_agrees(top: &Running<PivotedTop>, y: &[f64], row: &Value, axis: usize, [still, moving]: [f64; 2]) {
    let PivotedTop { m, g, .. } = *top.0.system();
    let place = format!("at {}", row["t"]);
    let body = |values: Vec<f64>| [(axis + 2) % 3, axis, (axis + 1) % 3].map(|i| values[i]);
    let (v, rates) = (top.velocities(0.0, y), top.velocity_rates(0.0, y));
    assert_close(&place, &y[..3], &numbers(&row["com_position"]), moving);
    assert_close(&place, &v[..3], &numbers(&row["com_velocity"]), moving);
    assert_close(&place, &rates[..3], &numbers(&row["com_acceleration"]), still.max(moving));
    assert_close(&place, &v[3..], &body(numbers(&row["body_rates"])), moving);
    assert_close_at(&place, &rates[3..], &body(numbers(&row["body_rate_derivatives"])), still.max(moving), g);
    let force = lambda(top, &["pivot_x", "pivot_y", "pivot_z"], 0.0, y);
    assert_close_at(&place, &force, &numbers(&row["pivot_force_on_body"]), still.max(moving), m * g);
}

fn top_runs(case: &Value, axis: usize, angles: [f64; 3], step: f64) {
    let p = &case["parameters"];
    let (j, l) = (numbers(&p["Jc_diag"]), numbers(&p["com_in_body"])[axis]);
    let [m, g] = ["m", "g"].map(|name| number(p, name));
    let order = [(axis + 2) % 3, axis, (axis + 1) % 3];
    let [j1, j2, j3] = order.map(|i| j[i]);
    let top = Running::new(PivotedTop { m, g, j1, j2, j3, l });
    let rates = numbers(&case["initial"]["body_rates"]);
    let [a, b, _] = angles;
    let place = [-l * b.sin(), l * b.cos() * a.cos(), l * b.cos() * a.sin()];
    let start = [place.to_vec(), angles.to_vec(), order.map(|i| rates[i]).to_vec()].concat();
    let rows = list(&case["expected"]);
    for (y, row) in top.run(&start, &times(rows), step).iter().zip(rows) {
        let first = row["t"] == 0.0;
        top_agrees(&top, y, row, axis, [AT_A_STATE, if first { AT_A_STATE } else { IN_MOTION }]);
        let energy = number(row, "energy");
        // V is that of the height in both
        assert!((top.energy(0.0, y) - energy).abs() <= IN_MOTION * energy, "energy at {}", row["t"]);
    }
}

#[test]
fn heavy_top() {
    let golden = parse(include_str!("data/heavy_top.json"));
    top_runs(case(&golden, "fast_top"), 1, [0.0; 3], 0.001);
    // the JSON's body axes y, z, x are this model's x, y, z; R(0) tilts about x
    let precession = case(&golden, "steady_precession");
    let quarter = std::f64::consts::FRAC_PI_2;
    top_runs(precession, 2, [quarter + number(&precession["parameters"], "tilt"), 0.0, quarter], 0.002);
}

/// The state of the disc: centre and angles, then the angular velocity in the leaned frame.
fn disc_state(row: &Value) -> Vec<f64> {
    let [yaw, lean, spin] = ["yaw_rate", "lean_rate", "spin_rate"].map(|name| number(row, name));
    let angles = picked(row, &["centre", "yaw", "lean", "spin"]);
    let (sin, cos) = angles[4].sin_cos();
    [angles, vec![lean, spin + yaw * sin, yaw * cos]].concat()
}

/// What is published of a state of the disc.
fn disc_agrees(disc: &Running<Disc>, y: &[f64], row: &Value, tolerance: f64) {
    let Disc { m, g, r, .. } = *disc.0.system();
    let place = format!("at {}", row["t"]);
    let close = |name: &str, computed: &[f64]| {
        assert_close_at(&format!("{name} {place}"), computed, &numbers(&row[name]), tolerance, g.max(m * g));
    };
    let rate = disc.rate(0.0, y);
    let (sin, cos) = y[4].sin_cos();
    close("centre", &y[..3]);
    close("centre_velocity", &rate[..3]);
    close("centre_acceleration", &disc.velocity_rates(0.0, y)[..3]);
    assert_close_at(&place, &rate[3..6], &picked(row, &["yaw_rate", "lean_rate", "spin_rate"]), tolerance, 1.0);
    // w1 = lean', w2 = spin' + yaw' sin lean, w3 = yaw' cos lean, differentiated
    let (yaw_rate, lean_rate) = (rate[3], rate[4]);
    let yaw = (rate[8] + yaw_rate * lean_rate * sin) / cos;
    let spin = rate[7] - yaw * sin - yaw_rate * lean_rate * cos;
    let accelerations = picked(row, &["yaw_acceleration", "lean_acceleration", "spin_acceleration"]);
    assert_close_at(&place, &[yaw, rate[6], spin], &accelerations, tolerance, g / r);
    close("contact_force_on_disc", &lambda(disc, &["slip_x", "slip_y", "slip_z"], 0.0, y));
}

#[test]
fn rolling_disc() {
    let golden = parse(include_str!("data/rolling_disc.json"));
    for name in ["generic_state", "hante_arnold_data", "steady_turn"] {
        let case = case(&golden, name);
        let rows = list(if case["trajectory"].is_null() { &case["expected"] } else { &case["trajectory"] });
        let disc = from_json!(case["parameters"], Disc { m: "m", r: "r", g: "g", d: "A", a: "C" });
        let disc = Running::new(disc);
        for (y, row) in disc.run(&disc_state(&rows[0]), &times(rows), 0.0125).iter().zip(rows) {
            disc_agrees(&disc, &disc_state(row), row, AT_A_STATE);
            disc_agrees(&disc, y, row, IN_MOTION);
        }
    }
}

/// By geometry the disk of the paper has the accelerations and reactions that it has by the paper's equations, at no more operations.
#[test]
fn disk_of_the_paper() {
    let golden = parse(include_str!("data/rolling_disk.json"));
    for case in list(&golden["cases"]) {
        let p = &case["params"];
        let bodies = Running::new(from_json!(p, Disk { m: "m", r: "r", j: "J", g: "g" }));
        let equations = Running::new(from_json!(p, RollingDisk { m: "m", r: "r", j: "J", g: "g" }));
        let natural = number(p, "g").max(number(p, "m") * number(p, "g"));
        let (x, v) = (numbers(&case["quasi"]["x"]), numbers(&case["quasi"]["v"]));
        let y = equations.with_velocities(0.0, &x, &v);
        assert_close_at("ẏ", &bodies.rate(0.0, &y), &equations.rate(0.0, &y), 1e-13, natural);
        let lambda = [
            lambda(&bodies, &["no_slip_x", "no_slip_y", "no_slip_z"], 0.0, &y),
            lambda(&equations, &["no_slip_along", "no_slip_across", "contact"], 0.0, &y),
        ];
        assert_close_at("λ", &lambda[0], &lambda[1], 1e-13, natural);
    }
    let weight = |source: &str, name: &str| {
        let item = declared::models(source).into_iter().find(|item| item.ident == name).expect("the model is there");
        let equations = simplified(&quote::quote!(#item).to_string()).expect("a good model");
        let programs = holonomy_engine::program::programs(&equations).expect("every symbol is known");
        ["derivative", "multipliers"].map(|name| programs.function(name).expect("every model has it").count.weight())
    };
    let bodies = weight(include_str!("../examples/rolling_disk/geometry.rs"), "Disk");
    let equations = weight(include_str!("models/rolling_disk.rs"), "RollingDisk");
    println!("weights of derivative and multipliers: {bodies:?} by geometry, {equations:?} by equations");
    assert!(bodies[0] <= equations[0] && bodies[1] <= equations[1], "{bodies:?} {equations:?}");
}

#[test]
fn sleigh() {
    let golden = parse(include_str!("data/chaplygin_sleigh.json"));
    let case = case(&golden, "sleigh");
    let sleigh = Running::new(from_json!(case["parameters"], BladedSleigh { m: "m", i: "I", a: "a" }));
    let rows = list(&case["expected"]);
    let state = |row: &Value| picked(row, &["x", "y", "theta", "v", "omega"]);
    for (y, row) in sleigh.run(&state(&rows[0]), &times(rows), 0.02).iter().zip(rows) {
        let place = format!("at {}", row["t"]);
        let at = state(row);
        assert_close(&place, y, &at, IN_MOTION);
        assert_close(&place, &sleigh.accelerations(0.0, &at), &picked(row, &["vdot", "omegadot"]), AT_A_STATE);
        assert_close(&place, &[sleigh.multiplier("blade", 0.0, &at)], &picked(row, &["knife_force"]), AT_A_STATE);
    }
}

#[test]
fn bicycle_at_states() {
    let golden = parse(include_str!("data/bicycle.json"));
    #[rustfmt::skip]
    let bicycle = Running::new(from_json!(golden["params"], Whipple {
        g: "g", rr: "rR", rf: "rF", d1: "d1", d2: "d2", d3: "d3", l1: "lB1", l2: "lB3", l3: "lH1", l4: "lH3",
        mr: "mR", mb: "mB", mh: "mH", mf: "mF", irx: "IR1", iry: "IR2", ibx: "IB1", iby: "IB2", ibz: "IB3", ibxz: "IB13",
        ihx: "IH1", ihy: "IH2", ihz: "IH3", ihxz: "IH13", ifx: "IF1", ify: "IF2",
    }));
    for state in list(&golden["states"]) {
        let found = bicycle.rate(0.0, &numbers(&state["x"]));
        assert_close("ẋ", &found, &numbers(&state["xdot"]), EVALUATED);
    }
    let published = &golden["basu_mandal"];
    let found = bicycle.accelerations(0.0, &numbers(&published["x"]));
    // thirteen digits of a state are given, and twelve of the accelerations are left of them
    assert_close("ü", &found, &picked(&published["published"], &["phidd", "deltadd", "thetaRdd"]), 1e-12);
}

/// The bicycle from the parameters of the benchmark, all turned into the axes of the steering axis.
fn whipple(p: &Value) -> Whipple {
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
    #[rustfmt::skip]
    let bicycle = Whipple {
        g: of("g"), rr, rf, d1, d2, d3, l1, l2, l3, l4, mr, mb, mh, mf, irx, iry, ibx, iby, ibz, ibxz, ihx, ihy, ihz,
        ihxz, ifx, ify,
    };
    bicycle
}

#[test]
fn bicycle_has_the_published_eigenvalues() {
    let golden = parse(include_str!("data/whipple_linear.json"));
    let lean = number(&golden["parameters"], "lambda");
    let bicycle = Running::new(whipple(&golden["parameters"]));
    let Whipple { rr, .. } = *bicycle.0.system();
    let names: Vec<&str> =
        Whipple::MODEL.state_coordinates.iter().chain(Whipple::MODEL.state_speeds).copied().collect();
    let place = |name: &str| names.iter().position(|n| *n == name).expect("a name of the state");
    let lateral = ["phi", "delta", "dot_phi", "dot_delta"].map(place);
    for row in list(&case(&golden, "eigenvalues")["expected"]) {
        let speed = number(row, "v");
        let mut y = vec![0.0; names.len()];
        (y[place("theta")], y[place("dot_rear")]) = (lean, -speed / rr);
        assert_close_at("v̇", &bicycle.velocity_rates(0.0, &y), &[0.0; 8], AT_A_STATE, 10.0);
        let jacobian = bicycle.jacobian(0.0, &y);
        let found = nalgebra::DMatrix::from_fn(4, 4, |i, j| jacobian[(lateral[i], lateral[j])]);
        assert_close(&format!("A at {speed}"), found.transpose().as_slice(), &numbers(&row["A"]), AT_A_STATE);
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
    }
}
