//! Inputs that give a motion: loops, chains, rows of every kind, more and fewer inputs than degrees of freedom.
#![allow(missing_docs, reason = "models of this test alone")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

#[path = "models/geometry/arms.rs"]
mod arms;
#[path = "support/splitmix.rs"]
#[allow(dead_code, reason = "not all distributions are needed here")]
mod splitmix;

use arms::SevenJoints;
use holonomy::prelude::*;
use holonomy::{Error, State};
use splitmix::SplitMix;

const G: f64 = 9.81;

/// A four-bar of uniform rods with motors on the crank and on the rocker.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3)]
#[inputs(drive, aid)]
#[frame(A = rotate(N, z, q1), B = rotate(N, z, q2), C = rotate(N, z, q3))]
#[point(P = O + 0.5*A.x, Q = P + 1.8*B.x, S = O + 2*N.x + 1.2*C.x)]
#[body(
    crank = { frame: A, center: O + 0.25*A.x, mass: 0.5, inertia: rod(0.5, 0.5, x) },
    coupler = { frame: B, center: P + 0.9*B.x, mass: 1.8, inertia: rod(1.8, 1.8, x) },
    rocker = { frame: C, center: O + 2*N.x + 0.6*C.x, mass: 1.2, inertia: rod(1.2, 1.2, x) },
)]
#[gravity(-g*N.y)]
#[torque(motor = { on: A, value: drive*N.z }, other = { on: C, value: aid*N.z })]
#[constraint(closure: Q == S)]
#[independent(dot(q1))]
#[start(q1 = 0.1, q2 = 0.6, q3 = 1.9)]
struct DrivenFourBar {
    #[nominal(9.81)]
    g: f64,
}

/// The same with its crank's motor alone.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3)]
#[inputs(drive)]
#[frame(A = rotate(N, z, q1), B = rotate(N, z, q2), C = rotate(N, z, q3))]
#[point(P = O + 0.5*A.x, Q = P + 1.8*B.x, S = O + 2*N.x + 1.2*C.x)]
#[body(
    crank = { frame: A, center: O + 0.25*A.x, mass: 0.5, inertia: rod(0.5, 0.5, x) },
    coupler = { frame: B, center: P + 0.9*B.x, mass: 1.8, inertia: rod(1.8, 1.8, x) },
    rocker = { frame: C, center: O + 2*N.x + 0.6*C.x, mass: 1.2, inertia: rod(1.2, 1.2, x) },
)]
#[gravity(-g*N.y)]
#[torque(motor = { on: A, value: drive*N.z })]
#[constraint(closure: Q == S)]
#[independent(dot(q1))]
#[start(q1 = 0.1, q2 = 0.6, q3 = 1.9)]
struct CrankDriven {
    #[nominal(9.81)]
    g: f64,
}

/// A pole on a cart that is pushed.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, angle)]
#[inertia(matrix([m1 + m2, m2*l*cos(angle)], [_, m2*l*l]))]
#[forces(push + m2*l*sin(angle)*powi(dot(angle), 2), -m2*g*l*sin(angle))]
#[inputs(push)]
struct CartPole {
    m1: f64,
    m2: f64,
    l: f64,
    g: f64,
}

/// A crank without mass of its own, a rod, and a slide that is pushed.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, rod, slide)]
#[inertia(diag(1, 1, 1))]
#[forces(0, 0, push)]
#[inputs(push)]
#[constraint(across: cos(crank) + 3*cos(rod) == slide)]
#[constraint(upwards: sin(crank) + 3*sin(rod) == 0)]
#[independent(dot(crank))]
struct PushedSlide;

/// A bob on a rod, the rod twice; one force acts across, another along the rod.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(across + along*x, -m*g + along*y)]
#[inputs(across, along)]
#[constraint(rod: (x*x + y*y - l*l)/2 == 0)]
#[constraint(again: x*x + y*y == l*l, redundant)]
#[independent(dot(x))]
struct Bob {
    m: f64,
    l: f64,
    g: f64,
}

/// The same, pushed across and upwards alike.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(push, push - m*g)]
#[inputs(push)]
#[constraint(rod: (x*x + y*y - l*l)/2 == 0)]
#[constraint(again: x*x + y*y == l*l, redundant)]
#[independent(dot(x))]
struct PushedBob {
    m: f64,
    l: f64,
    g: f64,
}

/// A vehicle of constant speed in a plane; its rudder turns it. The drag is taken up by what holds the speed.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(-rudder*dot(y), rudder*dot(x), lift - m*g)]
#[inputs(rudder, lift)]
#[constraint(pace: (powi(dot(x), 2) + powi(dot(y), 2) - powi(c, 2))/2 == 0)]
struct Vehicle {
    m: f64,
    g: f64,
    c: f64,
}

/// Two masses whose accelerations are bound, and a third.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(1, 2, 3))]
#[forces(first - 0.3*dot(x), second*dot(y) + first, second - z)]
#[inputs(first, second)]
#[constraint(bound: ddot(x) + cos(y)*ddot(y) == sin(t))]
struct Bound;

/// Two masses on two rails; the motors differ much in size.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(2, 3))]
#[forces(weak*a, b)]
#[inputs(a, b)]
struct Rails {
    weak: f64,
}

/// Two motors on the same cart, a second mass on a spring.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(2, 3))]
#[forces(a + 2*b - 5*(x - y), 5*(x - y))]
#[inputs(a, b)]
struct SameCart;

/// A rotor lifts by the square of its speed.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(height)]
#[inertia(diag(m))]
#[forces(c*rotor*rotor - m*g)]
#[inputs(rotor)]
struct Rotor {
    m: f64,
    c: f64,
    g: f64,
}

/// A pump whose characteristic has no derivative.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(height)]
#[inertia(diag(m))]
#[forces(pump(speed) - m)]
#[inputs(speed)]
#[function(pump(s))]
struct Pump {
    m: f64,
}

/// A nozzle's thrust by its valve.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(height)]
#[inertia(diag(m))]
#[forces(sqrt(valve) - m)]
#[inputs(valve)]
struct Nozzle {
    m: f64,
}

fn pump(s: f64) -> f64 {
    s * s
}

fn entries<V: Vector<f64>>(v: &V) -> Vec<f64> {
    let array: V::Array = (*v).into();
    array.as_ref().to_vec()
}

/// The inputs for drawn rates; under them the independent speeds have these rates, and nothing more is needed.
fn undoes<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    random: &mut SplitMix,
) -> M::Inputs<f64> {
    let drawn = random.vector(M::MODEL.reduced_speeds.len(), -5.0, 5.0);
    let rates = M::Reduced::<f64>::from_fn(|i| drawn[i]);
    let found = model.inputs_for(t, s, &rates, &Vector::from_fn(|_| 0.0)).expect("inputs serve");
    let rate = model.derivative(t, s, &found).0;
    for (name, wanted) in M::MODEL.reduced_speeds.iter().zip(&drawn) {
        let got = rate.get(name).expect("a speed of the state");
        assert!((got - wanted).abs() < 1e-11, "{}: {name} {got} {wanted}", M::MODEL.name);
    }
    let size = entries(&model.inverse_dynamics(t, s, &rates, &Vector::from_fn(|_| 0.0)));
    for (rest, size) in entries(&model.inverse_dynamics(t, s, &rates, &found)).iter().zip(size) {
        assert!(rest.abs() < 1e-12 * (1.0 + size.abs()), "{}: {rest:e} of {size}", M::MODEL.name);
    }
    found
}

/// The crank's wanted motion, its rate, and the rate of that: more than two turns, faster and slower.
fn wanted(t: f64) -> [f64; 3] {
    [0.1 + 3.0 * t + 0.2 * (2.0 * t).sin(), 3.0 + 0.4 * (2.0 * t).cos(), -0.8 * (2.0 * t).sin()]
}

fn on_its_way(bar: &Prepared<CrankDriven>, t: f64, near: State<CrankDriven>) -> State<CrankDriven> {
    let [q1, dot_q1, _] = wanted(t);
    bar.assemble(near).set("q1", q1).set("dot_q1", dot_q1).solve().expect("it closes")
}

#[test]
fn a_four_bar_follows_a_prescribed_crank() {
    let bar = CrankDriven { g: G }.prepare().expect("a good parameter");
    let none = CrankDrivenInputs { drive: 0.0 };
    let torque = |t: f64, s: &State<CrankDriven>| {
        bar.inputs_for(t, s, &[wanted(t)[2]], &none).expect("one motor, one degree of freedom")
    };
    let start = on_its_way(&bar, 0.0, State::<CrankDriven> { q2: 0.6, q3: 1.9, ..Default::default() });
    let run = bar.simulate(start).tolerance(1e-12, 1e-12).inputs(torque).until(5.0).expect("it runs");
    let mut largest: f64 = 0.0;
    for (t, s) in run.iter() {
        let [q1, dot_q1, _] = wanted(t);
        assert!((s.q1 - q1).abs() < 1e-9 && (s.dot_q1 - dot_q1).abs() < 1e-9, "{t}: {s:?}");
        // The torque's power is the rate of the energy on the way, which knows nothing of forces.
        let energy = |h: f64| bar.energy(t, &on_its_way(&bar, t + h, *s));
        let central = |h: f64| (energy(h) - energy(-h)) / (2.0 * h);
        let rate = (4.0 * central(1e-3) - central(2e-3)) / 3.0;
        let power = torque(t, s).drive * dot_q1;
        assert!((power - rate).abs() < 1e-7, "{t}: {power} {rate}");
        largest = largest.max(power.abs());
    }
    assert!(run.times().len() > 20 && largest > 10.0, "{} {largest}", run.times().len());
}

#[test]
fn of_more_motors_the_least_torques_are_taken() {
    let both = DrivenFourBar { g: G }.prepare().expect("a good parameter");
    let guess = State::<DrivenFourBar> { q1: 0.7, q2: 0.6, q3: 1.9, dot_q1: 1.5 };
    let s = both.assemble(guess).hold("q1").solve().expect("it closes");
    let none = DrivenFourBarInputs { drive: 0.0, aid: 0.0 };
    let [alone] = both.inverse_dynamics(0.0, &s, &[2.0], &none);
    // The rocker turns by so much for the crank; the two share the work in these proportions.
    let ratio = both.velocities(0.0, &s).dot_q3 / 1.5;
    let share = alone / (1.0 + ratio * ratio);
    let found = both.inputs_for(0.0, &s, &[2.0], &none).expect("two motors");
    assert!(
        (found.drive - share).abs() < 1e-12 && (found.aid - share * ratio).abs() < 1e-12,
        "{found:?} {share} {ratio}"
    );
    // Nearest to a guess: what changes has these proportions.
    let guess = DrivenFourBarInputs { drive: -3.0, aid: 4.0 };
    let near = both.inputs_for(0.0, &s, &[2.0], &guess).expect("two motors");
    assert!((near.drive + near.aid * ratio - alone).abs() < 1e-11, "{near:?}");
    assert!(((near.aid - 4.0) - (near.drive + 3.0) * ratio).abs() < 1e-11, "{near:?}");
    assert!((near.aid - found.aid).abs() > 0.1 && ratio.abs() > 0.05);
}

#[test]
fn a_pole_on_a_cart_cannot_have_any_motion() {
    let (m1, m2, l) = (3.0, 1.5, 0.8);
    let model = CartPole { m1, m2, l, g: G }.prepare().expect("good parameters");
    let s = State::<CartPole> { x: 0.3, angle: 0.5, dot_x: -0.4, dot_angle: 1.1 };
    // What a push of 2 does, a push of 2 does.
    let free = model.accelerations(0.0, &s, &[2.0].into());
    let found = model.inputs_for(0.0, &s, &free, &[0.0].into()).expect("a motion of the cart");
    assert!((found.push - 2.0).abs() < 1e-12, "{found:?}");
    // Else the pole is not held: m2 l² φ̈ + m2 l cos φ ẍ + m2 g l sin φ is missing.
    let error = model.inputs_for(0.5, &s, &[1.0, 2.0], &[0.0].into()).unwrap_err();
    let missing = m2 * l * (l * 2.0 + 0.5_f64.cos() + G * 0.5_f64.sin());
    let Error::NotHeld { speed: "dot_angle", residual, time: 0.5 } = error else { panic!("{error}") };
    assert!((residual - missing).abs() < 1e-12, "{residual} {missing}");
    assert!(error.to_string().contains("at t = 0.5: along `dot_angle` a generalised force of"), "{error}");
}

#[test]
fn inputs_without_effect_are_named() {
    let bob = Bob { m: 2.0, l: 0.5, g: G }.prepare().expect("good parameters");
    let random = &mut SplitMix::new(3);
    for _ in 0..20 {
        let angle = random.between(-1.4, 1.4);
        let s = State::<Bob> { x: 0.5 * angle.sin(), y: -0.5 * angle.cos(), dot_x: random.between(-1.0, 1.0) };
        let error = bob.inputs_for(0.0, &s, &[1.0], &[0.0, 0.0].into()).unwrap_err();
        assert_eq!(error, Error::NoEffect { inputs: vec!["along"], time: 0.0 });
        assert!(error.to_string().contains("the inputs `along` at t = 0"), "{error}");
    }
    // At its dead points a push moves no crank, beside them it does; sin π is not zero in these numbers.
    let slide = PushedSlide.prepare().expect("no parameters");
    for crank in [0.0, std::f64::consts::PI] {
        let s = State::<PushedSlide> { crank, slide: 3.0 + f64::cos(crank), dot_crank: 1.0, ..Default::default() };
        let error = slide.inputs_for(0.0, &s, &[1.0], &[0.0].into()).unwrap_err();
        assert_eq!(error, Error::NoEffect { inputs: vec!["push"], time: 0.0 });
        let near = slide.assemble(State::<PushedSlide> { crank: crank + 1e-3, ..s }).hold("crank").solve();
        undoes(&slide, 0.0, &near.expect("it closes"), random);
    }
}

#[test]
fn rows_of_every_kind() {
    let random = &mut SplitMix::new(11);
    let vehicle = Vehicle { m: 1.5, g: G, c: 2.5 }.prepare().expect("good parameters");
    let bound = Bound.prepare().expect("no parameters");
    assert_eq!((Vehicle::MODEL.state_speeds.len(), Vehicle::MODEL.reduced_speeds.len()), (3, 2));
    assert_eq!((Bound::MODEL.state_speeds.len(), Bound::MODEL.reduced_speeds.len()), (3, 2));
    for _ in 0..10 {
        let heading = random.between(0.3, 1.2);
        let (dot_x, dot_y) = (2.5 * heading.cos(), 2.5 * heading.sin());
        undoes(&vehicle, 0.0, &State::<Vehicle> { dot_x, dot_y, dot_z: 0.4, ..Default::default() }, random);
        let drawn = random.vector(6, 0.2, 1.0);
        undoes(&bound, drawn[0], &State::<Bound>::from_fn(|i| drawn[i]), random);
    }
    // Rows that repeat others: x ẍ + y ÿ is bound twice, and the push is unique all the same.
    let bob = PushedBob { m: 2.0, l: 0.5, g: G }.prepare().expect("good parameters");
    assert!(PushedBob::MODEL.rows.len() == 2 && PushedBob::MODEL.rows[1].redundant);
    undoes(&bob, 0.0, &State::<PushedBob> { x: 0.3, y: -0.4, dot_x: 0.7 }, random);
    let both = DrivenFourBar { g: G }.prepare().expect("a good parameter");
    let guess = State::<DrivenFourBar> { q1: 0.7, q2: 0.6, q3: 1.9, dot_q1: 1.5 };
    undoes(&both, 0.0, &both.assemble(guess).hold("q1").solve().expect("it closes"), random);
}

#[test]
fn the_motors_of_an_arm_are_its_joint_torques() {
    let arm = SevenJoints { g: G }.prepare().expect("a good parameter");
    let random = &mut SplitMix::new(5);
    for _ in 0..10 {
        let (drawn, rates) = (random.vector(14, -1.5, 1.5), random.vector(7, -3.0, 3.0));
        let s = State::<SevenJoints>::from_fn(|i| drawn[i]);
        let (rates, none) = (Vector::from_fn(|i| rates[i]), Vector::from_fn(|_| 0.0));
        let torques = entries(&arm.inverse_dynamics(0.0, &s, &rates, &none));
        let found = entries(&arm.inputs_for(0.0, &s, &rates, &none).expect("seven motors"));
        for (found, torque) in found.iter().zip(&torques) {
            assert!((found - torque).abs() < 1e-12 * (1.0 + torque.abs()), "{found} {torque}");
        }
    }
}

#[test]
fn weak_motors_and_motors_that_do_the_same() {
    // 2 ẍ = 1e-13 a, 3 ÿ = b
    let rails = Rails { weak: 1e-13 }.prepare().expect("good parameters");
    let s = State::<Rails>::default();
    let found = rails.inputs_for(0.0, &s, &[0.5, 2.0], &[0.0, 0.0].into()).expect("two motors");
    assert!((found.a - 1e13).abs() < 0.1 && (found.b - 6.0).abs() < 1e-14, "{found:?}");
    // a + 2 b = 2 ẍ + 5 (x − y) where 3 ÿ = 5 (x − y): of these the least, (1, 2) times something.
    let cart = SameCart.prepare().expect("no parameters");
    let s = State::<SameCart> { x: 0.9, y: 0.3, ..Default::default() };
    let found = cart.inputs_for(0.0, &s, &[1.0, 1.0], &[0.0, 0.0].into()).expect("the spring does the rest");
    assert!((found.a - 1.0).abs() < 1e-14 && (found.b - 2.0).abs() < 1e-14, "{found:?}");
    let error = cart.inputs_for(0.0, &s, &[1.0, 0.0], &[0.0, 0.0].into()).unwrap_err();
    assert!(
        matches!(error, Error::NotHeld { speed: "dot_y", residual, .. } if (residual + 3.0).abs() < 1e-13),
        "{error}"
    );
}

#[test]
fn forces_that_are_not_linear_in_the_inputs() {
    let rotor = Rotor { m: 2.0, c: 0.01, g: 10.0 }.prepare().expect("good parameters");
    let s = State::<Rotor>::default();
    let speed = |rate: f64, guess: f64| rotor.inputs_for(0.0, &s, &[rate], &[guess].into()).map(|found| found.rotor);
    // 0.01 w² = 2 (10 + 2.5). At rest nothing tells which way it turns.
    assert!((speed(2.5, 30.0).expect("it lifts") - 50.0).abs() < 1e-12);
    assert!((speed(2.5, -1.0).expect("it lifts") + 50.0).abs() < 1e-12);
    assert!((speed(2.5, 0.0).expect("it lifts").abs() - 50.0).abs() < 1e-12);
    // Far away the terms are large, and so is their rounding; that counts no longer where it ends.
    assert!((speed(2.5, 1e9).expect("it lifts") - 50.0).abs() < 1e-12);
    // It cannot pull: 2 (12 − 10) are missing at best.
    let error = speed(-12.0, 5.0).unwrap_err();
    let Error::NotHeld { speed: "dot_height", residual, .. } = error else { panic!("{error}") };
    assert!((residual + 4.0).abs() < 1e-6, "{residual}");
    let pump = Pump { m: 2.0 }.prepare().expect("a good parameter");
    let error = pump.inputs_for(0.0, &State::<Pump>::default(), &[1.0], &[1.0].into()).unwrap_err();
    assert_eq!(error, Error::MissingOrder { name: "dot_height" });
    // √i has no derivative at zero, and no value below it.
    let nozzle = Nozzle { m: 2.0 }.prepare().expect("a good parameter");
    let valve = |guess: f64| nozzle.inputs_for(1.5, &State::<Nozzle>::default(), &[1.0], &[guess].into());
    assert!((valve(9.0).expect("it lifts").valve - 16.0).abs() < 1e-12);
    assert_eq!(valve(0.0), Err(Error::NotDifferentiable { name: "dot_height", along: "valve", time: 1.5 }));
    assert_eq!(valve(-1.0), Err(Error::NonFinite { name: "dot_height" }));
}

#[test]
fn what_is_not_finite_and_charts_that_end_are_told() {
    let bob = Bob { m: 2.0, l: 0.5, g: G }.prepare().expect("good parameters");
    let aside = State::<Bob> { x: 0.3, y: -0.4, dot_x: 0.0 };
    let asked = |s, rate: f64, guess: f64| bob.inputs_for(0.0, &s, &[rate], &[guess, 0.0].into()).unwrap_err();
    assert_eq!(asked(aside, f64::NAN, 0.0), Error::NonFinite { name: "dot_x" });
    assert_eq!(asked(aside, 0.0, f64::INFINITY), Error::NonFinite { name: "across" });
    assert_eq!(asked(State::<Bob> { x: f64::NAN, ..aside }, 0.0, 0.0), Error::NonFinite { name: "x" });
    let level = asked(State::<Bob> { x: 0.5, y: 0.0, dot_x: 0.0 }, 0.0, 0.0);
    assert!(matches!(level, Error::ChartSingularity { .. }), "{level}");
}
