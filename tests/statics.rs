//! Statics of closed mechanisms: equilibria against the least potential energy, which a function here finds that closes the loops by
//! itself and knows neither C nor D nor h*; and small motions about them.

#[path = "models/geometry/loops.rs"]
mod loops;
mod support;

use holonomy::prelude::*;
use holonomy::{Error, State};
use loops::Squeezer;
use nalgebra::{DMatrix, DVector};
use support::andrews::andrews;
use support::golden::parse;

const G: f64 = 9.81;
const SOFT: f64 = 40.0;
const COIL: f64 = 6.0;

/// A four-bar of uniform rods that lies on a spring and has a coil spring in the rocker's bearing.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3)]
#[inputs(drive)]
#[frame(A = rotate(N, z, q1), B = rotate(N, z, q2), C = rotate(N, z, q3))]
#[point(P = O + 0.5*A.x, Q = P + 1.8*B.x, S = O + 2*N.x + 1.2*C.x, G1 = O + 1.1*N.x - 0.9*N.y, H = P + 0.9*B.x)]
#[body(
    crank = { frame: A, center: O + 0.25*A.x, mass: 0.5, inertia: rod(0.5, 0.5, x) },
    coupler = { frame: B, center: H, mass: 1.8, inertia: rod(1.8, 1.8, x) },
    rocker = { frame: C, center: O + 2*N.x + 0.6*C.x, mass: 1.2, inertia: rod(1.2, 1.2, x) },
)]
#[gravity(-g*N.y)]
#[spring(soft = { from: G1, to: H, stiffness: k, length: 0.7 })]
#[spring(coil = { of: q3, stiffness: c, length: 17/10 })]
#[torque(motor = { on: A, value: drive*N.z })]
#[constraint(closure: Q == S)]
#[independent(dot(q1))]
#[start(q1 = 0.1, q2 = 0.6, q3 = 1.9)]
struct SprungFourBar {
    #[nominal(9.81)]
    g: f64,
    #[nominal(40)]
    k: f64,
    #[nominal(6)]
    c: f64,
}

/// A mass and where it is, a moment of inertia and its angle.
type Rod = (f64, [f64; 2], f64, f64);

/// A mechanism of one degree of freedom by hand; the first angle is the crank's.
struct ByHand {
    loops: fn(&[f64]) -> Vec<f64>,
    potential: fn(&[f64]) -> f64,
    rods: fn(&[f64]) -> Vec<Rod>,
    /// A closed configuration in the middle of where it is looked.
    near: Vec<f64>,
}

/// Central differences over h, h/2 and h/4, extrapolated: errors of the order h⁶.
fn extrapolated(difference: impl Fn(f64) -> f64, h: f64) -> f64 {
    let [a, b, c] = [h, h / 2.0, h / 4.0].map(difference);
    let (ab, bc) = ((4.0 * b - a) / 3.0, (4.0 * c - b) / 3.0);
    (16.0 * bc - ab) / 15.0
}

impl ByHand {
    /// All angles for one of the crank.
    fn closed(&self, crank: f64) -> Vec<f64> {
        let mut q = self.near.clone();
        q[0] = crank;
        for _ in 0..60 {
            let f = DVector::from_vec((self.loops)(&q));
            if f.amax() < 1e-16 {
                break;
            }
            let column = |j: usize| {
                let shifted = |h: f64| {
                    let mut q = q.clone();
                    q[j] += h;
                    DVector::from_vec((self.loops)(&q))
                };
                (shifted(1e-5) - shifted(-1e-5)) / 2e-5
            };
            let columns: Vec<DVector<f64>> = (1..q.len()).map(column).collect();
            let change = DMatrix::from_columns(&columns).lu().solve(&f).expect("no dead point");
            change.iter().enumerate().for_each(|(j, change)| q[j + 1] -= change);
        }
        assert!((self.loops)(&q).iter().all(|f| f.abs() < 1e-15), "{q:?}");
        q
    }

    fn potential(&self, crank: f64) -> f64 {
        (self.potential)(&self.closed(crank))
    }

    /// V'
    fn slope(&self, crank: f64) -> f64 {
        extrapolated(|h| (self.potential(crank + h) - self.potential(crank - h)) / (2.0 * h), 2e-2)
    }

    /// The crank's angle of least potential energy: by golden sections, which see no more than half of the digits, and from there
    /// where the slope changes its sign.
    fn least(&self, mut low: f64, mut high: f64) -> f64 {
        let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
        while high - low > 1e-6 {
            let (a, b) = (high - golden * (high - low), low + golden * (high - low));
            if self.potential(a) < self.potential(b) { high = b } else { low = a }
        }
        (low, high) = (low - 1e-5, high + 1e-5);
        assert!(self.slope(low) < 0.0 && self.slope(high) > 0.0, "{low} {high}");
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if self.slope(middle) < 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// V'' and M_d = Σ m |∂r/∂q|² + I (∂φ/∂q)² for the crank.
    fn stiffness_and_mass(&self, crank: f64) -> (f64, f64) {
        let own = self.potential(crank);
        let second = |h: f64| (self.potential(crank + h) - 2.0 * own + self.potential(crank - h)) / (h * h);
        let count = (self.rods)(&self.near).len();
        let mass = (0..count).map(|at| {
            let rod = |crank: f64| (self.rods)(&self.closed(crank))[at];
            let along =
                |of: fn(&Rod) -> f64| extrapolated(|h| (of(&rod(crank + h)) - of(&rod(crank - h))) / (2.0 * h), 2e-2);
            let (x, y, turn) = (along(|rod| rod.1[0]), along(|rod| rod.1[1]), along(|rod| rod.3));
            let (m, _, inertia, _) = rod(crank);
            m * (x * x + y * y) + inertia * turn * turn
        });
        (extrapolated(second, 4e-2), mass.sum())
    }
}

fn four_bar_loops(q: &[f64]) -> Vec<f64> {
    vec![
        0.5 * q[0].cos() + 1.8 * q[1].cos() - 2.0 - 1.2 * q[2].cos(),
        0.5 * q[0].sin() + 1.8 * q[1].sin() - 1.2 * q[2].sin(),
    ]
}

fn four_bar_rods(q: &[f64]) -> Vec<Rod> {
    let at = |x: f64, y: f64, r: f64, angle: f64| [x + r * angle.cos(), y + r * angle.sin()];
    let p = at(0.0, 0.0, 0.5, q[0]);
    vec![
        (0.5, at(0.0, 0.0, 0.25, q[0]), 0.5 * 0.5 * 0.5 / 12.0, q[0]),
        (1.8, at(p[0], p[1], 0.9, q[1]), 1.8 * 1.8 * 1.8 / 12.0, q[1]),
        (1.2, at(2.0, 0.0, 0.6, q[2]), 1.2 * 1.2 * 1.2 / 12.0, q[2]),
    ]
}

fn four_bar_potential(q: &[f64]) -> f64 {
    let rods = four_bar_rods(q);
    let weights: f64 = rods.iter().map(|(m, [_, y], ..)| m * G * y).sum();
    let [x, y] = rods[1].1;
    let stretch = (x - 1.1).hypot(y + 0.9) - 0.7;
    weights + 0.5 * SOFT * stretch * stretch + 0.5 * COIL * (q[2] - 1.7).powi(2)
}

/// The four-bar, and by hand near its equilibrium.
fn four_bar() -> (Prepared<SprungFourBar>, State<SprungFourBar>, ByHand) {
    let bar = SprungFourBar { g: G, k: SOFT, c: COIL }.prepare().expect("good parameters");
    let guess = State::<SprungFourBar> { q1: -1.2, q2: 0.9, q3: 2.0, ..Default::default() };
    let guess = bar.assemble(guess).hold("q1").solve().expect("it closes");
    let near = vec![guess.q1, guess.q2, guess.q3];
    (bar, guess, ByHand { loops: four_bar_loops, potential: four_bar_potential, rods: four_bar_rods, near })
}

#[test]
fn a_four_bar_on_springs_rests_where_its_potential_energy_is_least() {
    let (bar, guess, by_hand) = four_bar();
    let rest = bar.trim(guess).rest().solve().expect("an equilibrium");
    let crank = by_hand.least(guess.q1 - 0.7, guess.q1 + 0.7);
    let expected = by_hand.closed(crank);
    let State::<SprungFourBar> { q1, q2, q3, dot_q1 } = rest.state;
    for (found, expected) in [q1, q2, q3].iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-10, "{rest:?} {expected}");
    }
    assert_eq!((dot_q1, rest.inputs.drive), (0.0, 0.0));
    assert!((bar.energy(0.0, &rest.state) - by_hand.potential(crank)).abs() < 1e-12);
    // What the pin carries, by moments of the rocker's weight and coil about its bearing and of the coupler about the crank's
    // pin: λ acts on the coupler's end, and the other way on the rocker.
    let lambda = bar.multipliers(0.0, &rest.state, &[0.0].into());
    let (fx, fy) = (lambda.closure_x, lambda.closure_y);
    let rocker = -1.2 * G * 0.6 * q3.cos() - COIL * (q3 - 1.7) - 1.2 * (q3.cos() * fy - q3.sin() * fx);
    let (x, y) = (0.5 * q1.cos() + 0.9 * q2.cos() - 1.1, 0.5 * q1.sin() + 0.9 * q2.sin() + 0.9);
    let pull = SOFT * (1.0 - 0.7 / x.hypot(y));
    let (sx, sy) = (-pull * x, -pull * y);
    let coupler = 0.9 * (q2.cos() * (sy - 1.8 * G) - q2.sin() * sx) + 1.8 * (q2.cos() * fy - q2.sin() * fx);
    assert!(rocker.abs() < 1e-11 && coupler.abs() < 1e-11, "{rocker:e} {coupler:e}");
}

#[test]
fn a_motor_holds_it_elsewhere_and_says_how_strongly() {
    let (bar, guess, by_hand) = four_bar();
    for crank in [-1.6, -0.9, -0.4] {
        let guess = State::<SprungFourBar> { q1: crank, ..guess };
        let held = bar.trim(guess).rest().hold("q1").free("drive").solve().expect("a motor holds it");
        // V' is what the motor gives.
        let slope = by_hand.slope(crank);
        assert!((held.inputs.drive - slope).abs() < 1e-10, "{held:?} {slope}");
        // The same with the state given: inputs of a motion that is none.
        let same = bar.inputs_for(0.0, &held.state, &[0.0], &[0.0].into()).expect("one motor");
        assert!((same.drive - slope).abs() < 1e-10, "{same:?}");
        // Without it the crank would not stay, and no equilibrium is claimed.
        let error = bar.trim(held.state).rest().hold("q1").solve().unwrap_err();
        assert!(matches!(error, Error::NotSteady { name: "dot_q1", .. }), "{error}");
    }
}

#[test]
fn small_motions_about_the_equilibrium() {
    let (bar, guess, by_hand) = four_bar();
    let rest = bar.trim(guess).rest().solve().expect("an equilibrium").state;
    let (stiffness, mass) = by_hand.stiffness_and_mass(rest.q1);
    let expected = (stiffness / mass).sqrt();
    assert!((bar.mass_matrix(0.0, &rest)[(0, 0)] - mass).abs() < 1e-9, "{mass}");
    let linear = bar.linearize(0.0, &rest, &[0.0].into()).expect("it is regular");
    assert_eq!((linear.states.len(), linear.dependents.len()), (2, 2), "{:?}", linear.states);
    let mut values = linear.eigenvalues().expect("they are found");
    values.sort_by(|a, b| a.im.total_cmp(&b.im));
    assert!(values.iter().all(|value| value.re.abs() < 1e-12), "{values:?}");
    let found = values[1].im;
    assert!((found - expected).abs() < 1e-8 * expected && (values[0].im + found).abs() < 1e-12, "{found} {expected}");
    // A unit of torque gives the crank 1/M_d.
    let speed = linear.states.iter().position(|name| *name == "dot_q1").expect("the crank's speed");
    assert!((linear.b[(speed, 0)] - 1.0 / mass).abs() < 1e-9, "{}", linear.b);

    // A run, let go from aside: its frequency differs by the square of the amplitude, which is taken off.
    let half = std::f64::consts::PI / expected;
    let frequency = |aside: f64| {
        let away = State::<SprungFourBar> { q1: rest.q1 + aside, ..rest };
        let start = bar.assemble(away).hold("q1").solve().expect("it closes");
        let run = bar.simulate(start).tolerance(1e-13, 1e-13).inputs(|_, _| [0.0].into());
        let run = run.until(10.5 * half).expect("it runs");
        // It is at rest for the tenth time.
        let speed = |t: f64| run.at(t).expect("within the run").dot_q1;
        let (mut low, mut high) = (9.8 * half, 10.2 * half);
        assert!(speed(low) * speed(high) < 0.0);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if speed(low) * speed(middle) <= 0.0 { high = middle } else { low = middle }
        }
        10.0 * std::f64::consts::PI / low
    };
    let (small, large) = (frequency(5e-3), frequency(1e-2));
    let limit = small + (small - large) / 3.0;
    assert!((limit - found).abs() < 1e-7 * found, "{small} {large}: {limit} {found}");
}

fn squeezer_loops(q: &[f64]) -> Vec<f64> {
    let [beta, theta, gamma, phi, delta, omega, epsilon] = q else { panic!("seven angles") };
    let x = 0.007 * beta.cos() - 0.028 * (beta + theta).cos();
    let y = 0.007 * beta.sin() - 0.028 * (beta + theta).sin();
    vec![
        x + 0.03635 - 0.035 * gamma.sin(),
        y - 0.03273 + 0.035 * gamma.cos(),
        x + 0.06934 - 0.04 * delta.cos() - 0.02 * (phi + delta).sin(),
        y + 0.00227 - 0.04 * delta.sin() + 0.02 * (phi + delta).cos(),
        x + 0.06934 - 0.04 * epsilon.sin() - 0.02 * (omega + epsilon).cos(),
        y + 0.00227 + 0.04 * epsilon.cos() - 0.02 * (omega + epsilon).sin(),
    ]
}

/// The spring's energy, and that of the motor's steady torque.
fn squeezer_potential(q: &[f64]) -> f64 {
    let (sin, cos) = q[2].sin_cos();
    let (x, y) = (-0.03635 + 0.02 * cos + 0.018 * sin, 0.03273 + 0.02 * sin - 0.018 * cos);
    let stretch = (x - 0.014).hypot(y - 0.072) - 0.07785;
    0.5 * 4530.0 * stretch * stretch - 0.033 * q[0]
}

#[test]
fn the_squeezing_mechanism_rests_where_its_spring_bears_the_motor() {
    let golden = parse(include_str!("data/andrews.json"));
    let mechanism = andrews!(Squeezer, golden["parameters"]).prepare().expect("good parameters");
    // From the published start the crank is turned by hand to where the spring is longest.
    let mut s = State::<Squeezer> {
        gamma: 0.4553,
        phi: 0.2227,
        delta: 0.4874,
        omega: -0.2227,
        epsilon: 1.2305,
        ..Default::default()
    };
    for step in 0..=20 {
        s = mechanism.assemble(s).set("beta", 0.15 * f64::from(step)).solve().expect("it closes");
    }
    let near = vec![s.beta, s.theta, s.gamma, s.phi, s.delta, s.omega, s.epsilon];
    let by_hand = ByHand { loops: squeezer_loops, potential: squeezer_potential, rods: |_| Vec::new(), near };
    let crank = by_hand.least(2.7, 3.9);
    let expected = by_hand.closed(crank);
    let rest = mechanism.trim(s).rest().solve().expect("an equilibrium").state;
    let found = [rest.beta, rest.theta, rest.gamma, rest.phi, rest.delta, rest.omega, rest.epsilon];
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-9, "{rest:?} {expected:?}");
    }
    // It is stable: nothing grows.
    let linear = mechanism.linearize(0.0, &rest, &[]).expect("it is regular");
    let values = linear.eigenvalues().expect("they are found");
    let fastest = values.iter().fold(0.0, |most: f64, value| most.max(value.im.abs()));
    assert!(values.len() == 2 && fastest > 1.0, "{values:?}");
    assert!(values.iter().all(|value| value.re.abs() < 1e-10 * fastest), "{values:?}");
}
