//! The own adaptive methods beside those of two other crates, `differential-equations` and `ode_solvers`.
//!
//! Only ends are compared with `ode_solvers`, whose states between its steps are not right, and only its Dormand-Prince 5(4):
//! version 0.6.2 reports stiffness where there is none, or other ends, with its method of order 8.

mod models;

use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::prelude::IVP;
use holonomy::prelude::*;
use models::*;
use ode_solvers::{Dopri5, OutputType, SVector, System};

/// A rate over N entries.
struct Rate<F>(F);

impl<const N: usize, F: Fn(f64, [f64; N]) -> [f64; N]> System<f64, SVector<f64, N>> for Rate<F> {
    fn system(&self, t: f64, y: &SVector<f64, N>, rate: &mut SVector<f64, N>) {
        *rate = SVector::from((self.0)(t, (*y).into()));
    }
}

/// The ends that the two methods of the two crates give: `differential-equations`, then `ode_solvers`.
fn peers<const N: usize>(
    rate: impl Fn(f64, [f64; N]) -> [f64; N] + Copy,
    start: [f64; N],
    end: f64,
    tolerance: f64,
) -> [(Method, &'static str, [f64; N]); 3] {
    let first = |eighth: bool| {
        let problem = IVP::ode_from_fn(|t, y: &[f64; N], dy: &mut [f64; N]| *dy = rate(t, *y), 0.0, end, start);
        let solution = match eighth {
            true => problem.method(ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance)).solve(),
            false => problem.method(ExplicitRungeKutta::dopri5().rtol(tolerance).atol(tolerance)).solve(),
        };
        *solution.unwrap().last().unwrap().1
    };
    let y = SVector::from(start);
    let mut fifth = Dopri5::new(Rate(rate), 0.0, end, end, y, tolerance, tolerance);
    fifth.set_output(OutputType::Sparse);
    fifth.integrate().unwrap();
    [
        (Method::Dop853, "differential-equations", first(true)),
        (Method::DormandPrince, "differential-equations", first(false)),
        (Method::DormandPrince, "ode_solvers", (*fifth.y_out().last().unwrap()).into()),
    ]
}

fn agree<const N: usize>(problem: &str, own: [f64; N], (method, name, theirs): (Method, &str, [f64; N]), bound: f64) {
    for (own, theirs) in own.iter().zip(theirs) {
        assert!((own - theirs).abs() < bound, "{problem}, {method:?} of {name}: {own} and {theirs}");
    }
}

#[test]
fn a_driven_nonlinear_oscillator() {
    let model = Oscillator { m: 1.3, a: 0.1, k: 2.0, c: 0.7, b: 0.6 }.prepare().unwrap();
    let input = |t: f64, _: &OscillatorState| OscillatorInputs { tau: 0.3 * (3.0 * t).cos() };
    // m (1 + a x) ẍ = −k x − c x³ + b sin t + tau, by hand
    let rate = |t: f64, [x, dx]: [f64; 2]| {
        let force = -2.0 * x - 0.7 * x * x * x + 0.6 * t.sin() + 0.3 * (3.0 * t).cos();
        [dx, force / (1.3 * (1.0 + 0.1 * x))]
    };
    for peer in peers(rate, [0.8, -0.3], 10.0, 1e-11) {
        let start = OscillatorState { x: 0.8, dot_x: -0.3 };
        let run = model.simulate(start).inputs(input).method(peer.0).tolerance(1e-11, 1e-11).until(10.0).unwrap();
        agree("oscillator", (*run.last().1).into(), peer, 1e-8);
    }
}

#[test]
fn a_bead_on_a_rod_that_turns() {
    // Minimal coordinates for the others: ρ along the rod, at the angle w t
    let (w, g) = (0.8f64, 9.81);
    let model = Bead { m: 1.5, w, g }.prepare().unwrap();
    let rate = |t: f64, [rho, speed]: [f64; 2]| [speed, w * w * rho - g * (w * t).sin()];
    for peer in peers(rate, [1.2, 0.3], 1.5, 1e-11) {
        let start = BeadState { x: 1.2, y: 0.0, dot_x: 0.3 };
        let run = model.simulate(start).method(peer.0).tolerance(1e-11, 1e-11).until(1.5).unwrap();
        let (t, s) = run.last();
        let rho = s.x * (w * t).cos() + s.y * (w * t).sin();
        let v = model.velocities(t, s);
        let v: [f64; 2] = v.into();
        agree("bead", [rho, v[0] * (w * t).cos() + v[1] * (w * t).sin()], peer, 1e-8);
    }
}

#[test]
fn a_pendulum_in_its_angle_and_in_its_coordinates() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let rate = |_: f64, [angle, speed]: [f64; 2]| [speed, -9.81 / 0.5 * angle.sin()];
    for peer in peers(rate, [0.3f64.atan2(0.4), 0.0], 3.0, 1e-11) {
        let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
        let run = model.simulate(start).method(peer.0).tolerance(1e-11, 1e-11).until(3.0).unwrap();
        let s = run.last().1;
        let angle = s.x.atan2(-s.y);
        agree("pendulum", [angle, s.dot_x / (0.5 * angle.cos())], peer, 1e-8);
    }
}

/// The energy on the dense output, far between the steps, beside the energy at the steps, which lose it step by step. From the
/// beginning the dense output errs by no more than two of what a step may.
#[test]
fn the_energy_of_the_dense_output_is_as_good_as_that_of_the_steps() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let energy = model.energy(0.0, &start);
    let error = |t: f64, s: &PendulumState| (model.energy(t, s) - energy).abs();
    let methods = [Method::Rk4 { step: 2e-3 }, Method::DormandPrince, Method::Dop853];
    for method in methods {
        let run = model.simulate(start).method(method).tolerance(1e-9, 1e-9).until(100.0).unwrap();
        let steps = run.iter().map(|(t, s)| error(t, s)).fold(0.0, f64::max);
        let between = |from: i32, to: i32| {
            let points = (from..=to).map(|i| 1e-3 * f64::from(i));
            points.map(|t| error(t, &run.at(t).unwrap())).fold(0.0, f64::max)
        };
        let (first, all) = (between(0, 5_000), between(0, 100_000));
        println!("{method:?}: {steps:.1e} at the steps, {first:.1e} between the first, {all:.1e} between all");
        assert!(all < 2.0 * steps, "{method:?}: {steps:e} at the steps, {all:e} between them");
        assert!(first < 2e-9, "{method:?}: {first:e} between the first steps");
    }
}
