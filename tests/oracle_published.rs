//! The oracle by itself on mechanisms of the literature from geometry alone: models and oracle against numbers from outside.

mod support;

use oracle::{Declaration, Motion, System, read_models};
use support::golden::{assert_close, assert_close_at, case, list, numbers, parse, picked};

/// All accelerations and forces are solved for at once, which loses some digits.
const TOLERANCE: f64 = 1e-11;
/// The full system of a longer chain is not worth its time here.
const MANY: usize = 20;

fn model(source: &str, name: &str) -> Declaration {
    read_models(source).into_iter().find(|model| model.name == name).expect("the model is declared")
}

fn system(model: &Declaration, parameters: Vec<f64>, inputs: Vec<f64>) -> System<'_> {
    assert_eq!((parameters.len(), inputs.len()), (model.parameters.len(), model.inputs.len()), "{}", model.name);
    System { model, parameters, inputs }
}

/// λ of the named rows.
fn multipliers(system: &System<'_>, motion: &Motion, names: &[&str]) -> Vec<f64> {
    let row = |name: &&str| system.model.constraints.iter().position(|row| row.name == **name).expect("a row");
    names.iter().map(|name| motion.multipliers[row(name)]).collect()
}

#[test]
fn rods() {
    let golden = parse(include_str!("data/chain_n.json"));
    let source = include_str!("models/geometry/rods.rs");
    let mut seen = Vec::new();
    for state in list(&golden["states"]) {
        let (q, qd) = (numbers(&state["q"]), numbers(&state["qd"]));
        if q.len() > MANY || q.len() == MANY && seen.contains(&MANY) {
            continue;
        }
        seen.push(q.len());
        let models = read_models(source);
        let model = models.iter().find(|model| model.coordinates.len() == q.len()).expect("a chain of that many");
        let system = system(model, picked(&golden["params"], &["m", "l", "g"]), Vec::new());
        let motion = system.motion(0.0, &q, &qd);
        assert_close(&model.name, motion.acceleration.as_slice(), &numbers(&state["qdd"]), TOLERANCE);
    }
    assert_eq!(seen.len(), 19);
}

#[test]
fn bobs() {
    let golden = parse(include_str!("data/pendulum_chain.json"));
    let source = include_str!("models/geometry/bobs.rs");
    let parameters = picked(&golden["parameters"], &["m", "l", "g"]);
    let [m, l, g] = <[f64; 3]>::try_from(parameters.clone()).expect("three of them");
    for (name, case_name) in [("ThreeBobs", "release_from_horizontal_n3"), ("TenBobs", "release_from_horizontal_n10")] {
        let model = model(source, name);
        let system = system(&model, parameters.clone(), Vec::new());
        for row in list(&case(&golden, case_name)["expected"]) {
            let motion = system.motion(0.0, &numbers(&row["angles"]), &numbers(&row["rates"]));
            assert_close(name, motion.acceleration.as_slice(), &numbers(&row["angular_accelerations"]), TOLERANCE);
        }
    }
    let model = model(source, "ThreeTiedBobs");
    let system = system(&model, parameters.clone(), Vec::new());
    for row in list(&case(&golden, "release_from_horizontal_n3")["expected"]) {
        let (angles, rates) = (numbers(&row["angles"]), numbers(&row["rates"]));
        let sums = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
            (0..3)
                .scan(0.0, |sum, i| {
                    Some({
                        *sum += of(i);
                        *sum
                    })
                })
                .collect()
        };
        let x = [sums(&|i| l * angles[i].sin()), sums(&|i| -l * angles[i].cos())].concat();
        let v = [sums(&|i| l * angles[i].cos() * rates[i]), sums(&|i| l * angles[i].sin() * rates[i])].concat();
        let motion = system.motion(0.0, &x, &v);
        let tensions: Vec<f64> = motion.multipliers.iter().map(|lambda| -lambda).collect();
        assert_close_at("tensions", &tensions, &numbers(&row["tensions"]), TOLERANCE, 3.0 * m * g);
    }
}

#[test]
fn puma() {
    let golden = parse(include_str!("data/puma560.json"));
    let model = model(include_str!("../examples/puma/models.rs"), "PumaArm");
    let links = list(&golden["parameters"]);
    let of = |link: usize, name: &str| numbers(&links[link - 1][name]);
    let motor = |i: usize| of(i, "G")[0].powi(2) * of(i, "Jm")[0];
    for row in list(&case(&golden, "accelerations")["expected"]) {
        for (name, motors) in [("qdd", 1.0), ("qdd_without_motors", 0.0)] {
            let mut parameters = vec![9.81, of(2, "a")[0], of(3, "a")[0], of(3, "d")[0], of(4, "d")[0]];
            parameters.extend((2..=6).map(|link| of(link, "m")[0]));
            parameters.extend([of(2, "com"), of(3, "com"), vec![of(4, "com")[1], of(6, "com")[2]]].concat());
            parameters.push(of(1, "I_diag")[1]);
            parameters.extend((2..=6).flat_map(|link| of(link, "I_diag")));
            parameters.extend((1..=6).map(|i| motors * motor(i)));
            let system = system(&model, parameters, numbers(&row["joint_torques"]));
            let motion = system.motion(0.0, &numbers(&row["q"]), &numbers(&row["qd"]));
            let tolerance = if motors > 0.0 { TOLERANCE } else { 100.0 * TOLERANCE };
            assert_close(name, motion.acceleration.as_slice(), &numbers(&row[name]), tolerance);
        }
    }
}

#[test]
fn seven_joints() {
    let golden = parse(include_str!("data/arm7.json"));
    let model = model(include_str!("models/geometry/arms.rs"), "SevenJoints");
    let torques: Vec<f64> = (1..=7).flat_map(|i| numbers(&golden["params"][format!("tau{i}")])).collect();
    let system = system(&model, picked(&golden["params"], &["g"]), torques);
    for state in list(&golden["states"]) {
        let (x, rate) = (numbers(&state["x"]), numbers(&state["xdot"]));
        let motion = system.motion(0.0, &x[..7], &x[7..]);
        assert_close("q̈", motion.acceleration.as_slice(), &rate[7..], TOLERANCE);
    }
}

#[test]
fn heavy_top() {
    let golden = parse(include_str!("data/heavy_top.json"));
    let model = model(include_str!("models/geometry/top.rs"), "PivotedTop");
    let case = case(&golden, "fast_top");
    let p = &case["parameters"];
    let parameters = [picked(p, &["m", "g", "Jc_diag"]), vec![1.0]].concat();
    let system = system(&model, parameters, Vec::new());
    for row in list(&case["expected"]) {
        let r = numbers(&row["rotation_matrix"]);
        let angles = vec![r[7].atan2(r[4]), -r[1].asin(), r[2].atan2(r[0])];
        let x = [numbers(&row["com_position"]), angles].concat();
        let v = picked(row, &["com_velocity", "body_rates"]);
        let motion = system.motion(0.0, &x, &v);
        let expected = picked(row, &["com_acceleration", "body_rate_derivatives"]);
        // stored to the doubles of a matrix, from which the angles follow: the spin of 150 multiplies what they are off
        assert_close("v̇", motion.acceleration.as_slice(), &expected, TOLERANCE);
        let force = multipliers(&system, &motion, &["pivot_x", "pivot_y", "pivot_z"]);
        assert_close("pivot", &force, &numbers(&row["pivot_force_on_body"]), TOLERANCE);
    }
}

#[test]
fn rolling_disc() {
    let golden = parse(include_str!("data/rolling_disc.json"));
    let model = model(include_str!("models/geometry/disc.rs"), "Disc");
    for name in ["generic_state", "hante_arnold_data", "steady_turn"] {
        let case = case(&golden, name);
        let rows = list(if case["trajectory"].is_null() { &case["expected"] } else { &case["trajectory"] });
        let parameters = picked(&case["parameters"], &["m", "r", "g", "A", "C"]);
        let natural = parameters[2].max(parameters[0] * parameters[2]);
        let system = system(&model, parameters, Vec::new());
        for row in rows {
            let x = picked(row, &["centre", "yaw", "lean", "spin"]);
            let [yaw, lean, spin] = ["yaw_rate", "lean_rate", "spin_rate"].map(|rate| numbers(&row[rate])[0]);
            let (sin, cos) = x[4].sin_cos();
            let v = [numbers(&row["centre_velocity"]), vec![lean, spin + yaw * sin, yaw * cos]].concat();
            let motion = system.motion(0.0, &x, &v);
            let expected = numbers(&row["centre_acceleration"]);
            assert_close_at(name, &motion.acceleration.as_slice()[..3], &expected, TOLERANCE, natural);
            // the height's row repeats one of the others: the reactions of both together
            let mut force = multipliers(&system, &motion, &["slip_x", "slip_y", "slip_z"]);
            force[2] += multipliers(&system, &motion, &["height"])[0];
            assert_close_at(name, &force, &numbers(&row["contact_force_on_disc"]), TOLERANCE, natural);
        }
    }
}

#[test]
fn sleigh() {
    let golden = parse(include_str!("data/chaplygin_sleigh.json"));
    let case = case(&golden, "sleigh");
    let model = model(include_str!("models/geometry/sleigh.rs"), "BladedSleigh");
    let system = system(&model, picked(&case["parameters"], &["m", "I", "a"]), Vec::new());
    for row in list(&case["expected"]) {
        let [v, omega] = ["v", "omega"].map(|name| numbers(&row[name])[0]);
        let motion = system.motion(0.0, &picked(row, &["x", "y", "theta"]), &[v, 0.0, omega]);
        let found = [motion.acceleration[0], motion.acceleration[2]];
        assert_close("v̇", &found, &picked(row, &["vdot", "omegadot"]), TOLERANCE);
        assert_close("blade", motion.multipliers.as_slice(), &numbers(&row["knife_force"]), TOLERANCE);
    }
}

#[test]
fn bicycle() {
    let golden = parse(include_str!("data/bicycle.json"));
    let model = model(include_str!("models/geometry/whipple.rs"), "Whipple");
    let names = [
        "g", "rR", "rF", "d1", "d2", "d3", "lB1", "lB3", "lH1", "lH3", "mR", "mB", "mH", "mF", "IR1", "IR2", "IB1",
        "IB2", "IB3", "IB13", "IH1", "IH2", "IH3", "IH13", "IF1", "IF2",
    ];
    let system = system(&model, picked(&golden["params"], &names), Vec::new());
    for state in list(&golden["states"]) {
        let (x, rate) = (numbers(&state["x"]), numbers(&state["xdot"]));
        let motion = system.motion(0.0, &x[..8], &rate[..8]);
        let found = [3, 5, 6].map(|i| motion.acceleration[i]);
        assert_close("u̇", &found, &rate[8..], TOLERANCE);
        assert_eq!(motion.freedom, 3);
    }
}
