//! Linearisation and steady motions of derived models: against differences of the flow on the constraints, closed forms, and
//! themselves in other coordinates.
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

#[path = "models/kinds.rs"]
mod kinds;
#[path = "models/particles.rs"]
mod particles;
#[path = "models/rolling_disk.rs"]
mod rolling_disk;
#[path = "models/speeds.rs"]
mod speeds;
#[path = "support/splitmix.rs"]
#[allow(dead_code, reason = "not all distributions are needed here")]
mod splitmix;

use holonomy::prelude::*;
use holonomy::{Complex, Error, Linearization, State};
use kinds::*;
use particles::*;
use rolling_disk::*;
use speeds::*;
use splitmix::SplitMix;

const M: f64 = 2.0;
const R: f64 = 0.5;
const J: f64 = 0.125;
const G: f64 = 9.81;

fn entries<V: Vector<f64>>(v: &V) -> Vec<f64> {
    let array: V::Array = (*v).into();
    array.as_ref().to_vec()
}

/// ẏ and the outputs as functions of y and the inputs: the dependent entries are closed by assembly.
fn flow<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    linear: &Linearization,
    y: &[f64],
    inputs: &[f64],
) -> Vec<f64> {
    let independent = linear.states.iter().zip(y);
    let closed = independent.fold(model.assemble(*s).at_time(t), |assembly, (name, value)| assembly.set(name, *value));
    let (s, i) = (closed.solve().expect("a neighbour"), M::Inputs::<f64>::from_fn(|at| inputs[at]));
    let rate = model.derivative(t, &s, &i).0;
    let rates = linear.states.iter().map(|name| rate.get(name).expect("an entry"));
    rates.chain(entries(&model.outputs(t, &s, &i))).collect()
}

/// All four matrices against central differences over 2h, h and h/2, extrapolated: errors of the order h⁶ and of rounding over h.
fn agrees<M: ConstrainedSystem>(model: M, t: f64, s: M::State<f64>, i: M::Inputs<f64>) {
    const STEP: f64 = 4e-3;
    let model = model.prepare().expect("the parameters are good");
    let linear = model.linearize(t, &s, &i).unwrap_or_else(|error| panic!("{}: {error}", M::MODEL.name));
    let y: Vec<f64> = linear.states.iter().map(|name| s.get(name).expect("an entry")).collect();
    assert!(linear.undefined.is_empty(), "{:?}", linear.undefined);
    let inputs = entries(&i);
    let (k, e) = (y.len(), inputs.len());
    assert_eq!((linear.a.shape(), linear.b.shape()), ((k, k), (k, e)));
    assert_eq!((linear.c_y.ncols(), linear.d_y.shape()), (k, (linear.outputs.len(), e)));
    let own = flow(&model, t, &s, &linear, &y, &inputs);
    let scale = own.iter().fold(1.0, |scale: f64, entry| scale.max(entry.abs()));
    assert!(own.iter().zip(&linear.rate).all(|(own, rate)| (own - rate).abs() <= 1e-11 * scale), "{}", M::MODEL.name);
    for j in 0..k + e {
        let central = |h: f64| -> Vec<f64> {
            let shifted = |h: f64| {
                let (mut y, mut inputs) = (y.clone(), inputs.clone());
                if j < k {
                    y[j] += h
                } else {
                    inputs[j - k] += h
                }
                flow(&model, t, &s, &linear, &y, &inputs)
            };
            shifted(h).iter().zip(shifted(-h)).map(|(ahead, behind)| (ahead - behind) / (2.0 * h)).collect()
        };
        let better = |coarse: &[f64], fine: &[f64], power: f64| -> Vec<f64> {
            coarse.iter().zip(fine).map(|(c, f)| f + (f - c) / (power - 1.0)).collect()
        };
        let [a, b, c] = [STEP, STEP / 2.0, STEP / 4.0].map(central);
        let expected = better(&better(&a, &b, 4.0), &better(&b, &c, 4.0), 16.0);
        let (above, below) = if j < k {
            (linear.a.column(j), linear.c_y.column(j))
        } else {
            (linear.b.column(j - k), linear.d_y.column(j - k))
        };
        let scale = expected.iter().fold(scale, |scale, entry| scale.max(entry.abs()));
        for (row, (found, expected)) in above.iter().chain(below.iter()).zip(&expected).enumerate() {
            let place = format!("{} ({row}, {j}) of {:?}", M::MODEL.name, linear.states);
            assert!((found - expected).abs() <= 1e-9 * scale, "{place}: {found:e} instead of {expected:e}");
        }
    }
}

/// Two pendulums in a row in four coordinates; a push and a drag act on the upper one, on the lower one a wind that a function
/// tells.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, y1, x2, y2)]
#[inertia(diag(m1, m1, m2, m2))]
#[forces(push - c*dot(x1), -m1*g, b*wind(y2), -m2*g)]
#[inputs(push)]
#[function(wind(s), derivatives = [gradient])]
#[constraint(upper: (powi(x1, 2) + powi(y1, 2) - powi(l1, 2))/2 == 0)]
#[constraint(lower: (powi(x2 - x1, 2) + powi(y2 - y1, 2) - powi(l2, 2))/2 == 0)]
#[independent(dot(x1), dot(x2))]
#[output(height = y2, tension = -l2*reaction(lower), power = push*dot(x1))]
struct TwoRods {
    m1: f64,
    m2: f64,
    l1: f64,
    l2: f64,
    g: f64,
    c: f64,
    b: f64,
}

fn wind(s: f64) -> f64 {
    0.3 * s * s
}

fn gradient(s: f64) -> f64 {
    0.6 * s
}

/// A wind without its derivative, which the equations do not need, and gusts that depend on time alone.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x)]
#[inertia(diag(m))]
#[forces(wind(x) - k*x + wind(t))]
#[function(wind(s))]
struct Sail {
    m: f64,
    k: f64,
}

/// The wind of the place is measured only; that of the time pushes, and needs no derivative.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x)]
#[inertia(diag(m))]
#[forces(wind(t) - m*x)]
#[function(wind(s))]
#[output(shelter = 2*wind(x), place = x)]
struct Gauge {
    m: f64,
}

/// A particle in a valley whose speed is c: a row that binds coordinates, and one that binds speeds and depends on them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(valley: z == a*powi(x, 2)/2 + b*x*y)]
#[constraint(pace: (powi(dot(x), 2) + powi(dot(y), 2) + powi(dot(z), 2) - powi(c, 2))/2 == 0)]
#[output(load = reaction(valley))]
struct Valley {
    m: f64,
    g: f64,
    a: f64,
    b: f64,
    c: f64,
}

/// √|x| has no derivative at rest.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x)]
#[inertia(diag(m))]
#[forces(-k*sqrt(abs(x)))]
struct Rough {
    m: f64,
    k: f64,
}

#[test]
fn every_class_of_state_agrees_with_differences() {
    let pendulum = State::<Pendulum> { x: 0.48, y: -0.64, swing: 1.3 };
    agrees(Pendulum { m: 1.5, l: 0.8, g: G }, 0.0, pendulum, []);
    let hanging = State::<HangingPendulum> { x: 0.48, y: -0.64, dot_x: -0.7 };
    agrees(HangingPendulum { m: 1.5, l: 0.8, g: G }, 0.0, hanging, []);
    let angle = State::<PendulumByAngle> { alpha: 0.7, dot_alpha: -1.1 };
    agrees(PendulumByAngle { m: 1.5, l: 0.8, g: G }, 0.0, angle, []);
    // Rows that depend on time, rows that repeat others, rows of every level, a singular M.
    let (w, t): (f64, f64) = (1.25, 0.4);
    let bead = State::<BeadOnRod> { x: 0.9 * (w * t).cos(), y: 0.9 * (w * t).sin(), along: 0.6 };
    agrees(BeadOnRod { m: 0.7, w, g: G }, t, bead, []);
    let by_distance = State::<BeadByDistance> { rho: 0.9, dot_rho: 0.6 };
    agrees(BeadByDistance { m: 0.7, w, g: G }, t, by_distance, []);
    let triple = State::<TripleRod> { x: 0.48, y: -0.64, dot_x: 0.9 };
    agrees(TripleRod { m: 1.5, g: G, l: 0.8 }, 0.0, triple, []);
    let mut prescribed = State::<Prescribed>::default();
    (prescribed.x, prescribed.y, prescribed.z) = ((w * t).sin(), 0.3, -0.2);
    agrees(Prescribed { m: M, g: G, w }, t, prescribed, []);
    // Rows that are not linear in the velocities, and rows of accelerations.
    let fast = State::<ConstantSpeed> { x: 0.2, y: 0.3, dot_x: 1.8, dot_y: 2.4 };
    agrees(ConstantSpeed { m: 1.5, g: G, c: 3.0 }, 0.0, fast, []);
    let heading = State::<ConstantSpeedByDirection> { x: 0.2, y: 0.3, u: 0.9 };
    agrees(ConstantSpeedByDirection { m: 1.5, g: G, c: 3.0 }, 0.0, heading, []);
    let slope = State::<SteadySlope> { dot_x: 0.6, dot_y: -0.8, dot_z: 2.0, ..Default::default() };
    agrees(SteadySlope { m: 1.5, g: G, a: 0.5 }, 0.0, slope, []);
    let curve = State::<CurvedPath> { x: 0.1, y: 0.2, dot_x: 1.1, dot_y: -0.7 };
    agrees(CurvedPath { m: 1.5, g: G, kappa: 0.6 }, 0.0, curve, []);
    agrees(Pushed { m: 1.5, g: G, k: 0.4 }, 0.3, State::<Pushed> { dot_x: 0.5, ..Default::default() }, []);
}

/// Both kinds of rows together: the speeds that follow depend on coordinates, of which some follow themselves.
#[test]
fn rows_of_positions_and_of_speeds_together_agree_with_differences() {
    let valley = Valley { m: 1.5, g: G, a: 0.7, b: 0.4, c: 2.0 };
    let model = valley.clone().prepare().unwrap();
    let guess = State::<Valley>::from_fn(|i| [0.4, -0.3, 0.1, 1.1, 0.8][i]);
    let s = model.assemble(guess).hold("x").hold("y").solve().unwrap();
    let linear = model.linearize(0.0, &s, &[]).unwrap();
    assert_eq!((linear.states.len(), linear.dependents.len()), (3, 2), "{:?}", linear.states);
    agrees(valley, 0.0, s, []);
}

#[test]
fn rolling_and_closed_models_agree_with_differences() {
    let random = &mut SplitMix::new(77);
    for _ in 0..3 {
        let draw = random.vector(9, -0.8, 0.8);
        agrees(RollingDisk { m: M, r: R, j: J, g: G }, 0.0, State::<RollingDisk>::from_fn(|i| draw[i]), []);
        agrees(RollingDiskInStages { m: M, r: R, j: J, g: G }, 0.0, Vector::from_fn(|i| draw[i]), []);
    }
    let rods = TwoRods { m1: 1.5, m2: 0.8, l1: 0.5, l2: 0.65, g: G, c: 0.2, b: 1.1 };
    let mut s = State::<TwoRods> { x1: 0.3, y1: -0.4, x2: 0.55, y2: -1.0, dot_x1: 0.7, dot_x2: -0.4 };
    agrees(rods.clone(), 0.0, s, [1.7].into());
    // The lower rod points up: of the coordinates those stay whose rates are the speeds.
    (s.x2, s.y2) = (0.05, 0.2);
    let linear = rods.clone().prepare().unwrap().linearize(0.0, &s, &[1.7].into()).unwrap();
    assert_eq!((&linear.states[..2], &linear.dependents[..]), (&["x1", "x2"][..], &["y1", "y2"][..]));
    agrees(rods, 0.0, s, [1.7].into());
}

/// Those that are not zero.
fn moving(linear: &Linearization) -> Vec<Complex<f64>> {
    linear.eigenvalues().expect("they are found").into_iter().filter(|value| value.norm_sqr() > 1e-12).collect()
}

fn same(place: &str, found: &[Complex<f64>], expected: &[Complex<f64>], bound: f64) {
    assert_eq!(found.len(), expected.len(), "{place}: {found:?} instead of {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).norm_sqr().sqrt() <= bound, "{place}: {found} instead of {expected}");
    }
}

/// What belongs to a motion does not depend on the coordinates: pendulums in x and y and by their angles.
#[test]
fn eigenvalues_are_the_same_in_all_coordinates() {
    let (l, g) = (0.8, G);
    let about_angle = PendulumByAngle { m: 1.5, l, g }.prepare().unwrap();
    let by_angle = about_angle.linearize(0.0, &State::<PendulumByAngle>::default(), &[]).unwrap();
    let exact = [0.0, -g / l, 1.0, 0.0];
    assert!(by_angle.a.iter().zip(exact).all(|(found, exact)| (found - exact).abs() < 1e-14), "{}", by_angle.a);
    let hanging = State::<HangingPendulum> { y: -l, ..Default::default() };
    let in_plane = HangingPendulum { m: 1.5, l, g }.prepare().unwrap().linearize(0.0, &hanging, &[]).unwrap();
    assert_eq!(in_plane.states, ["x", "dot_x"]);
    // At rest √(ẋ² + ẏ²) has no derivative and ẏ/ẋ no value: that keeps from nothing else.
    let errors = [
        Error::NotDifferentiable { name: "speed", along: "x", time: 0.0 },
        Error::Undefined { output: "steepness", divisors: &["dot_x"], time: 0.0 },
    ];
    assert_eq!((&in_plane.undefined[..], in_plane.outputs[1]), (&errors[..], "tension"));
    let row = |at: usize| [in_plane.c_y[(at, 0)], in_plane.c_y[(at, 1)]];
    assert!(row(0).iter().chain(&row(2)).all(|entry| entry.is_nan()) && row(1) == [0.0, 0.0], "{}", in_plane.c_y);
    same("pendulum", &moving(&in_plane), &moving(&by_angle), 1e-14);

    let (m1, m2, l1, l2) = (1.5, 0.8, 0.5, 0.65);
    let still = TwoRods { m1, m2, l1, l2, g, c: 0.0, b: 0.0 }.prepare().unwrap();
    let by_angles = DoublePendulum { m1, m2, l1, l2, g }.prepare().unwrap();
    let by_angles = by_angles.linearize(0.0, &State::<DoublePendulum>::default(), &[]).unwrap();
    let s = State::<TwoRods> { y1: -l1, y2: -l1 - l2, ..Default::default() };
    let linear = still.linearize(0.0, &s, &[0.0].into()).unwrap();
    assert_eq!((linear.states.len(), linear.dependents.len()), (4, 2));
    // w⁴ − (m1 + m2)/m1 g (1/l1 + 1/l2) w² + (m1 + m2)/m1 g²/(l1 l2) = 0
    let (sum, product) = ((m1 + m2) / m1 * g * (1.0 / l1 + 1.0 / l2), (m1 + m2) / m1 * g * g / (l1 * l2));
    let root = (sum * sum / 4.0 - product).sqrt();
    let [fast, slow] = [(sum / 2.0 + root).sqrt(), (sum / 2.0 - root).sqrt()];
    let expected = [fast, slow, -slow, -fast].map(|w| Complex::new(0.0, w));
    for (place, linear) in [("by angles", &by_angles), ("in the plane", &linear)] {
        let mut found = moving(linear);
        found.sort_by(|a, b| b.im.total_cmp(&a.im));
        same(place, &found, &expected, 1e-13);
    }
}

#[test]
fn a_constant_speed_is_the_same_by_components_and_by_direction() {
    let (m, g, c) = (1.5, G, 3.0);
    let down = State::<ConstantSpeed> { dot_y: -c, ..Default::default() };
    let linear = ConstantSpeed { m, g, c }.prepare().unwrap().linearize(0.0, &down, &[]).unwrap();
    assert_eq!((&linear.states[..], &linear.dependents[..]), (&["x", "y", "dot_x"][..], &["dot_y"][..]));
    let u = State::<ConstantSpeedByDirection> { u: -std::f64::consts::FRAC_PI_2, ..Default::default() };
    let by_direction = ConstantSpeedByDirection { m, g, c }.prepare().unwrap();
    let by_direction = by_direction.linearize(0.0, &u, &[]).unwrap();
    assert_eq!(by_direction.states, ["x", "y", "u"]);
    // u̇ = −g/c cos u about u = −π/2
    let expected = [Complex::new(-g / c, 0.0)];
    same("by components", &moving(&linear), &expected, 1e-14);
    same("by direction", &moving(&by_direction), &expected, 1e-14);
}

/// Straight rolling is stable from |ψ'|² = m g r/(2 (m r² + 2 J)) on; below that L² = (m g r − 2 (m r² + 2 J) ψ'²)/(m r² + J).
#[test]
fn a_disk_rolls_steadily_above_its_threshold() {
    let disk = RollingDisk { m: M, r: R, j: J, g: G }.prepare().unwrap();
    let floor = RollingDiskOnFloor { m: M, r: R, j: J, g: G }.prepare().unwrap();
    let stages = RollingDiskInStages { m: M, r: R, j: J, g: G }.prepare().unwrap();
    let squared = |rate: f64| (M * G * R - 2.0 * (M * R * R + 2.0 * J) * rate * rate) / (M * R * R + J);
    for rate in [1.0, 2.5, 2.6, 6.0] {
        let rolling = State::<RollingDisk> { v6: rate, ..Default::default() };
        let linear = disk.linearize(0.0, &rolling, &[]).unwrap();
        let on_floor = State::<RollingDiskOnFloor> { v6: rate, ..Default::default() };
        let on_floor = floor.linearize(0.0, &on_floor, &[]).unwrap();
        assert_eq!((linear.states.len(), on_floor.states.len(), &on_floor.dependents[..]), (9, 8, &["z"][..]));
        let in_stages = State::<RollingDiskInStages> { dot_psi: rate, ..Default::default() };
        let in_stages = stages.linearize(0.0, &in_stages, &[]).unwrap();
        let root = Complex::new(squared(rate), 0.0);
        let expected = if root.re > 0.0 {
            [root.re.sqrt(), -root.re.sqrt()].map(|re| Complex::new(re, 0.0))
        } else {
            [(-root.re).sqrt(), -(-root.re).sqrt()].map(|im| Complex::new(0.0, im))
        };
        same("initial form", &moving(&linear), &expected, 1e-13);
        same("on the floor", &moving(&on_floor), &expected, 1e-13);
        same("in stages", &moving(&in_stages), &expected, 1e-13);
    }
    let grows = |rate: f64| {
        let s = State::<RollingDisk> { v6: rate, ..Default::default() };
        disk.linearize(0.0, &s, &[]).unwrap().eigenvalues().unwrap()[0].re > 1e-4
    };
    let (mut slow, mut fast) = (1.0, 6.0);
    for _ in 0..40 {
        let middle = 0.5 * (slow + fast);
        if grows(middle) { slow = middle } else { fast = middle }
    }
    let threshold = (M * G * R / (2.0 * (M * R * R + 2.0 * J))).sqrt();
    assert!((fast - threshold).abs() < 1e-8, "{fast} instead of {threshold}");
}

/// A disk in a circle: v5 (J tan θ v5 − (m r² + 2 J) v6) = m g r sin θ, from v̇4 = 0.
#[test]
fn a_disk_rolls_in_a_circle() {
    let disk = RollingDisk { m: M, r: R, j: J, g: G }.prepare().unwrap();
    let guess = State::<RollingDisk> { theta: 0.3, v5: 1.0, v6: -4.0, ..Default::default() };
    let found = disk.trim(guess).hold("theta").hold("v5").rate("theta", 0.0).solve().unwrap();
    let State::<RollingDisk> { theta, v4, v5, v6, x, y, .. } = found.state;
    assert_eq!((theta, v5, x, y), (0.3, 1.0, 0.0, 0.0));
    let exact = (J * theta.tan() * v5 - M * G * R * theta.sin() / v5) / (M * R * R + 2.0 * J);
    assert!((v6 - exact).abs() < 1e-14 * exact.abs() && v4 == 0.0, "{v6} instead of {exact}");
    // It does so: leaning and turning stay as they are.
    let run = disk.simulate(found.state).until(20.0).unwrap();
    let end = run.last().1;
    assert!((end.theta - 0.3).abs() < 1e-9 && (end.v6 - v6).abs() < 1e-9, "{end:?}");
    // At this speed it leans by itself, when the lean is free and the speeds are held.
    let guess = State::<RollingDisk> { theta: 0.25, v5, v6, ..Default::default() };
    let again = disk.trim(guess).hold("v5").hold("v6").rate("theta", 0.0).solve().unwrap();
    assert!((again.state.theta - 0.3).abs() < 1e-13, "{:?}", again.state);
    // No lean serves for a turn against the rolling, and none is claimed.
    let error = disk.trim(State::<RollingDisk> { theta: 0.3, v5: 1.0, v6: 4.0, ..Default::default() });
    let error = error.hold("theta").hold("v5").hold("v6").rate("theta", 0.0).solve().unwrap_err();
    assert!(matches!(&error, Error::NotSteady { what: "the rate of", name: "v4", .. }), "{error}");
}

#[test]
fn a_missing_derivative_and_one_that_does_not_exist_are_named() {
    let sail = Sail { m: 1.2, k: 2.0 }.prepare().unwrap();
    let s = State::<Sail> { x: 0.4, dot_x: 0.0 };
    let error = sail.linearize(0.0, &s, &[]).unwrap_err();
    assert_eq!(error, Error::MissingOrder { name: "dot_x" });
    assert!(error.to_string().contains("`dot_x` depends on a function"), "{error}");
    let error =
        Rough { m: 1.2, k: 2.0 }.prepare().unwrap().linearize(0.0, &State::<Rough>::default(), &[]).unwrap_err();
    assert_eq!(error, Error::NotDifferentiable { name: "dot_x", along: "x", time: 0.0 });
    // Newton's method cannot do without the derivative either.
    assert!(sail.trim(s).rest().solve().is_err());
}

#[test]
fn constraints_that_are_not_met_are_named() {
    let fast = ConstantSpeed { m: 1.5, g: G, c: 3.0 }.prepare().unwrap();
    let s = State::<ConstantSpeed> { dot_x: 1.0, dot_y: 2.0, ..Default::default() };
    assert!(matches!(fast.linearize(0.0, &s, &[]).unwrap_err(), Error::Unmet { constraint: "speed", residual: -2.0 }));
    let rods = TwoRods { m1: 1.5, m2: 0.8, l1: 0.5, l2: 0.65, g: G, c: 0.2, b: 1.1 }.prepare().unwrap();
    let s = State::<TwoRods> { x1: 0.3, y1: -0.4, x2: 0.55, y2: -0.9, ..Default::default() };
    assert!(matches!(rods.linearize(0.0, &s, &[0.0].into()).unwrap_err(), Error::Unmet { constraint: "lower", .. }));
}
