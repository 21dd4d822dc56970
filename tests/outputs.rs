//! Declared outputs: what may stand in them, what they cost, where they have no value, and how an assembly holds them.
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::{ConstrainedSystem, Dual, Error, Level, Prepared, State};

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-13 * expected.abs().max(1.0)
}

/// A chain of three pendulums by their angles.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 3)]
#[coordinates(a[n])]
#[inertia(matrix([l[i]*l[j]*cos(a[i] - a[j])*sum(max(i, j)..n, |k| m[k]) for j in 0..n] for i in 0..n))]
#[forces(
    -sum(0..n, |j| sum(max(i, j)..n, |k| m[k])*l[i]*l[j]*sin(a[i] - a[j])*powi(dot(a[j]), 2))
        - sum(i..n, |k| m[k])*g*l[i]*sin(a[i]) for i in 0..n
)]
#[define(depth[i] = l[i]*cos(a[i]) for i in 0..n)]
#[output(height[i] = -sum(0..i + 1, |j| depth[j]) for i in 0..n)]
#[output(depth[i] for i in 0..n, lowest = height[n - 1], swing[i] = dot(a[i]) - dot(a[i - 1]) for i in 1..n)]
struct Chain {
    m: [f64; 3],
    l: [f64; 3],
    g: f64,
}

#[test]
fn outputs_stand_in_families() {
    let chain = Chain { m: [1.0, 2.0, 0.5], l: [0.7, 0.3, 0.5], g: 9.81 }.prepare().expect("good parameters");
    let s = State::<Chain> { a_0: 0.4, a_1: -0.3, a_2: 1.1, dot_a_0: 2.0, dot_a_1: -1.0, dot_a_2: 0.5 };
    let outputs = chain.outputs(0.0, &s, &[]);
    let depth = [0.7 * 0.4_f64.cos(), 0.3 * 0.3_f64.cos(), 0.5 * 1.1_f64.cos()];
    assert!(close(outputs.height_0, -depth[0]) && close(outputs.height_1, -depth[0] - depth[1]));
    assert!(close(outputs.lowest, -depth.iter().sum::<f64>()) && outputs.lowest == outputs.height_2);
    assert!(close(outputs.depth_1, depth[1]) && close(outputs.swing_1, -3.0) && close(outputs.swing_2, 1.5));
    let names: Vec<&str> = Chain::MODEL.outputs.iter().map(|output| output.name).collect();
    let expected =
        ["height_0", "height_1", "height_2", "depth_0", "depth_1", "depth_2", "lowest", "swing_1", "swing_2"];
    assert_eq!(names, expected);
    assert_eq!(Chain::MODEL.defines, ["depth_0", "depth_1", "depth_2"]);
    let text = |symbol| Chain::MODEL.equations.iter().find(|e| e.symbol == symbol).map(|e| e.text);
    assert_eq!(text("height_0"), Some("-l_0*cos(a_0)"));
}

/// A spherical pendulum in angles, with quasi-velocities.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[kinetic_energy(m/2*(powi(dot(x), 2) + powi(dot(y), 2) + powi(dot(z), 2)))]
#[potential_energy(m*g*z)]
#[configuration(
    of(a, b),
    x = l*sin(a)*cos(b),
    y = l*sin(a)*sin(b),
    z = -l*cos(a),
    speeds(p, h),
    p = l*dot(a),
    h = powi(l*sin(a), 2)*dot(b),
)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[define(spin = dot(b), faster = dot(p))]
#[output(faster, kept = dot(h), sinking = ddot(a), turning = ddot(b), up = ddot(z), z = z + l, spin, rise = spin*h)]
struct InAngles {
    m: f64,
    g: f64,
    l: f64,
}

/// Rates of what only the configuration has, against the state's rate and its derivative along the motion.
#[test]
fn rates_of_a_configuration_are_those_of_the_motion() {
    let (m, g, l) = (1.5, 9.81, 0.8);
    let pendulum = InAngles { m, g, l }.prepare().expect("good parameters");
    let s = State::<InAngles> { a: 0.7, b: 0.2, p: 1.3, h: 0.9 };
    let outputs = pendulum.outputs(0.0, &s, &[]);
    let (rate, _) = pendulum.derivative(0.0, &s, &[]);
    assert!(close(outputs.faster, rate.p) && outputs.kept == 0.0 && close(outputs.sinking, rate.p / l));
    // ḃ = h/(l sin a)², and ḣ = 0
    let bdot = s.h / (l * s.a.sin()).powi(2);
    assert!(close(outputs.turning, -2.0 * bdot * rate.a / s.a.tan()));
    // z = −l cos a, as a name of its own beside the coordinate
    let expected = l * (s.a.cos() * rate.a * rate.a + s.a.sin() * outputs.sinking);
    assert!(close(outputs.up, expected) && close(outputs.z, l - l * s.a.cos()));
    // The same from the carriers p and h with their rates.
    let lambda = pendulum.multipliers(0.0, &s, &[]);
    let carried = pendulum.carried_outputs(0.0, &s, (&[s.p, s.h], &[rate.p, rate.h]), &lambda, &[]);
    assert!(close(outputs.spin, bdot) && close(outputs.rise, bdot * s.h));
    for (one, other) in <[f64; 8]>::from(outputs).iter().zip(<[f64; 8]>::from(carried)) {
        assert!(close(*one, other), "{outputs:?} {carried:?}");
    }
}

/// A pendulum with outputs of every level.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(pull, -m*g)]
#[inputs(pull)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x))]
#[define(hidden = x + y, speed = sqrt(powi(dot(x), 2) + powi(dot(y), 2)))]
#[output(
    length = sqrt(powi(x, 2) + powi(y, 2)),
    slope = x/y,
    speed,
    ratio = dot(y)/x,
    tension = -l*reaction(rod),
    wind = pull/m,
    drag = if pull < 0 { 2*pull } else { pull } + t,
)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().expect("good parameters")
}

fn swinging() -> State<Pendulum> {
    State::<Pendulum> { x: 0.3, y: -0.4, dot_x: 0.8 }
}

#[test]
fn a_model_tells_what_its_outputs_depend_on() {
    let facts: Vec<_> = Pendulum::MODEL.outputs.iter().map(|output| (output.level, output.inputs)).collect();
    use Level::{Acceleration, Position, Velocity};
    let expected = [(Position, false), (Position, false), (Velocity, false), (Velocity, false), (Acceleration, true)];
    assert_eq!(facts[..5], expected);
    assert_eq!(facts[5..], [(Position, true), (Position, true)]);
    // y is a guard of the chart, x is nobody's
    let guarded = |name: &str| Pendulum::MODEL.guards.iter().any(|guard| guard.name == name);
    assert!(guarded("y") && !guarded("x"));
    let divisors: Vec<_> = Pendulum::MODEL.outputs.iter().map(|output| output.divisors).collect();
    assert!(divisors[1].is_empty() && divisors[4].is_empty() && divisors[5].is_empty(), "{divisors:?}");
}

#[test]
fn outputs_have_their_values() {
    let (pendulum, s) = (pendulum(), swinging());
    let outputs = pendulum.outputs(0.25, &s, &[-3.0].into());
    // ẏ = −x ẋ/y = 0.6; the pull of the rod: m v²/l + (m g y − F x)/l taken inwards
    assert!(close(outputs.length, 0.5) && close(outputs.slope, -0.75) && close(outputs.speed, 1.0));
    assert!(close(outputs.ratio, 2.0) && close(outputs.wind, -1.5) && close(outputs.drag, -5.75));
    let tension = 2.0 * 1.0 / 0.5 + (-3.0 * 0.3 - 2.0 * 9.81 * -0.4) / 0.5;
    assert!(close(outputs.tension, tension), "{} {tension}", outputs.tension);
    // single precision, and derivatives along ẋ
    let single = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare_as::<f32>().expect("good parameters");
    let found = single.outputs(0.25, &[0.3, -0.4, 0.8].into(), &[-3.0].into());
    assert!((f64::from(found.tension) - tension).abs() < 1e-5 * tension);
    let dual = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare_as::<Dual>().expect("good parameters");
    let moving = [Dual::constant(0.3), Dual::constant(-0.4), Dual::variable(0.8)].into();
    let found = dual.outputs(Dual::constant(0.25), &moving, &[Dual::constant(-3.0)].into());
    assert!(close(found.speed.derivative, 1.25) && close(found.tension.derivative, 2.0 * 2.0 * 1.25 / 0.5));
}

/// An output that needs no reaction costs none.
#[test]
fn outputs_cost_what_they_mention() {
    /// A pendulum by its angle that tells its height.
    #[derive(ConstrainedSystem, Clone, Debug)]
    #[coordinates(x, y)]
    #[inertia(diag(m, m))]
    #[forces(0, -m*g)]
    #[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
    #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    #[output(height = y)]
    struct Told {
        m: f64,
        l: f64,
        g: f64,
    }
    let cost = Told::MODEL.operations.iter().find(|cost| cost.function == "outputs").expect("a function");
    assert_eq!((cost.additions, cost.multiplications, cost.divisions, cost.sincos), (0, 1, 0, 1));
    let plain = |model: &holonomy::Description| model.operations.iter().any(|cost| cost.function == "outputs");
    assert!(!plain(Silent::MODEL) && Silent::MODEL.outputs.is_empty());
    let silent = Silent { m: 1.0 }.prepare().expect("good parameters");
    let none: [f64; 0] = silent.outputs(0.0, &State::<Silent>::default(), &[]);
    assert!(none.is_empty());
}

/// Nothing but a mass.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x)]
#[inertia(diag(m))]
#[forces(0)]
struct Silent {
    m: f64,
}

#[test]
fn a_run_passes_where_an_output_has_no_value_and_the_output_says_so() {
    let pendulum = pendulum();
    let none = |_: f64, _: &State<Pendulum>| [0.0].into();
    let start = State::<Pendulum> { x: 0.0, y: -0.5, dot_x: 1.0 };
    assert!(!pendulum.outputs(0.0, &start, &[0.0].into()).ratio.is_finite());
    let run = pendulum.simulate(start).inputs(none).every(0.1).until(2.0).expect("nothing stops it");
    let error = run.outputs(0, &[0.0].into()).expect_err("divided by zero");
    let Error::Undefined { output: "ratio", divisors, time } = error.clone() else { panic!("{error}") };
    assert!(divisors.contains(&"x") && time == 0.0, "{error}");
    assert!(error.to_string().contains("`ratio` has no finite value at t = 0; it divides by"), "{error}");
    // at the stored steps and between them
    for (index, (t, s)) in run.iter().enumerate().skip(1) {
        let (stored, dense) = (run.outputs(index, &[0.0].into()), run.outputs_at(t, &[0.0].into()));
        let (stored, dense) = (stored.expect("a value"), dense.expect("a value"));
        let expected = pendulum.outputs(t, s, &[0.0].into());
        assert!(close(stored.tension, dense.tension) && (stored.tension - expected.tension).abs() < 1e-9);
        assert!((stored.ratio - expected.ratio).abs() < 1e-9 * expected.ratio.abs().max(1.0));
    }
    let between = run.outputs_at(1.234, &[0.0].into()).expect("a value");
    assert!((between.length - 0.5).abs() < 1e-6);
    assert!(matches!(run.outputs_at(2.5, &[0.0].into()), Err(Error::OutOfRange { .. })));
}

#[test]
fn outputs_are_held_and_set() {
    let pendulum = pendulum();
    let guess = State::<Pendulum> { x: 0.2, y: -0.6, dot_x: 0.5 };
    // slope = x/y stays −1/3, the speed becomes 2
    let start = pendulum.assemble(guess).hold("slope").set("speed", 2.0).solve().expect("a solution");
    let outputs = pendulum.outputs(0.0, &start, &[0.0].into());
    assert!(close(outputs.slope, -1.0 / 3.0) && close(outputs.length, 0.5) && close(outputs.speed, 2.0));
    // what the constraint forbids is missed, by name
    let error = pendulum.assemble(guess).set("length", 0.7).solve().expect_err("the rod is shorter");
    let Error::Assembly { report, .. } = error else { panic!("{error}") };
    assert!(report.conflicts.contains(&"length") && report.unmet().any(|entry| entry.name == "rod"));
}

#[test]
fn what_cannot_be_held_says_why() {
    let pendulum = pendulum();
    let refused = |name: &str| pendulum.assemble(swinging()).hold(name).solve().expect_err("refused");
    assert_eq!(refused("tension"), Error::CannotHold { name: "tension", on: "accelerations or reactions" });
    assert_eq!(refused("wind"), Error::CannotHold { name: "wind", on: "inputs" });
    let hidden = refused("hidden");
    assert_eq!(hidden, Error::NotAnOutput { define: "hidden" });
    assert!(hidden.to_string().contains("`#[output(hidden)]`"), "{hidden}");
    let Error::UnknownName { known, .. } = refused("heigth") else { panic!("another error") };
    assert!(known.contains(&"length") && known.contains(&"dot_y"), "{known:?}");
    let error = pendulum.assemble(swinging()).set("speed", f64::NAN).solve().expect_err("refused");
    assert_eq!(error, Error::NonFinite { name: "speed" });
}

/// A skater whose independent speeds are combinations: the mean of two wheels, and in another chart their difference.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, 2*m))]
#[forces(0, -k*y)]
#[constraint(steer: dot(x)*cos(t) == dot(y)*sin(t))]
#[independent(mean = (dot(x) + dot(y))/2)]
#[independent(split = dot(x) - dot(y))]
#[define(twice = 2*mean)]
#[output(mean, twice, split, rate = ddot(x) - ddot(y), pull = reaction(steer))]
struct Combined {
    m: f64,
    k: f64,
}

#[test]
fn combinations_of_speeds_stand_in_outputs() {
    let model = Combined { m: 1.5, k: 2.0 }.prepare().expect("good parameters");
    let s = State::<Combined> { x: 0.3, y: -0.2, mean: 0.7 };
    let t = 0.4;
    let (v, rates) = (model.velocities(t, &s), model.velocity_rates(t, &s, &[]));
    let outputs = model.outputs(t, &s, &[]);
    assert!(close(outputs.mean, 0.7) && close(outputs.twice, 1.4) && close(outputs.split, v.dot_x - v.dot_y));
    assert!(close(outputs.rate, rates.dot_x - rates.dot_y));
    let lambda = model.multipliers(t, &s, &[]);
    let (w, dw) = ([v.dot_x, v.dot_y], [rates.dot_x, rates.dot_y]);
    let carried = model.carried_outputs(t, &s, (&w, &dw), &lambda, &[]);
    for (one, other) in <[f64; 5]>::from(outputs).iter().zip(<[f64; 5]>::from(carried)) {
        assert!(close(*one, other), "{outputs:?} {carried:?}");
    }
}
