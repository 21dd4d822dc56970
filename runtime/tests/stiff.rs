//! The implicit methods of `differential-equations` on stiff systems, against exact answers and the explicit methods.

#![cfg(feature = "differential-equations")]

mod models;

use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use holonomy::differential_equations::Equations;
use holonomy::prelude::*;
use models::*;
use std::cell::Cell;

#[test]
fn a_strong_damper_takes_radau_few_evaluations() {
    // ẍ = −1e6 (ẋ − cos t) − x: ẋ clings to cos t, and x to sin t + O(1e-6)
    let model = Oscillator { m: 1.0, a: 0.0, k: 1.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    let start = OscillatorState { x: 0.0, dot_x: 1.0 };
    let count = Cell::new(0usize);
    let drive = |t: f64, s: &OscillatorState| {
        count.set(count.get() + 1);
        OscillatorInputs { tau: -1e6 * (s.dot_x - t.cos()) }
    };
    let method = ImplicitRungeKutta::radau5().rtol(1e-9).atol(1e-9);
    let states = Equations::new(&model).unwrap().inputs(drive).every(0.25).solve(method, start, (0.0, 2.0)).unwrap();
    assert_eq!(states.len(), 9);
    for (t, s) in &states[1..] {
        // the first two terms of the expansion in 1e-6: x = sin t + 1e-6 (…), ẋ = cos t + 1e-6 (sin t − x)
        assert!((s.x - t.sin()).abs() < 3e-6 && (s.dot_x - t.cos()).abs() < 3e-6, "{t}: {s:?}");
    }
    let implicit = count.replace(0);
    // Forty times less time for the explicit method, and still more evaluations.
    let run = model.simulate(start).inputs(drive).until(0.05).unwrap();
    assert!((run.last().1.dot_x - 0.05f64.cos()).abs() < 3e-6);
    assert!(count.get() > 3 * implicit, "{} explicit for 0.05 s, {implicit} implicit for 2 s", count.get());
}

#[test]
fn radau_agrees_with_the_own_method_on_a_stiff_spring() {
    // A stiff cubic spring whose inertia grows, overdamped by its input.
    let model = Oscillator { m: 1.0, a: 0.2, k: 400.0, c: 2000.0, b: 3.0 }.prepare().unwrap();
    let start = OscillatorState { x: 0.3, dot_x: 0.0 };
    let damped = |_: f64, s: &OscillatorState| OscillatorInputs { tau: -200.0 * s.dot_x };
    let own = model.simulate(start).inputs(damped).tolerance(1e-12, 1e-12).every(0.1).until(1.0).unwrap();
    let method = ImplicitRungeKutta::radau5().rtol(1e-11).atol(1e-11);
    let theirs = Equations::new(&model).unwrap().inputs(damped).every(0.1).solve(method, start, (0.0, 1.0)).unwrap();
    assert_eq!(theirs.len(), own.times().len());
    for ((t, s), (at, exact)) in theirs.iter().zip(own.iter()) {
        assert!((t - at).abs() < 1e-15);
        // Its dense output is a cubic, which is worth less than its steps.
        let tolerance = if *t == 1.0 { 1e-8 } else { 1e-6 };
        let error = (s.x - exact.x).abs().max((s.dot_x - exact.dot_x).abs());
        assert!(error < tolerance, "{t}: {s:?} {exact:?}");
    }
}

#[test]
fn smaller_tolerances_give_smaller_errors_on_a_moving_constraint() {
    // The bead on a rotating rod, rheonomic, with its closed form.
    let (w, g, rho, speed) = (0.8f64, 9.81, 1.2, 0.3);
    let model = Bead { m: 1.5, w, g }.prepare().unwrap();
    let exact = |t: f64| {
        rho * (w * t).cosh() + (speed - g / (2.0 * w)) * (w * t).sinh() / w + g * (w * t).sin() / (2.0 * w * w)
    };
    let start = BeadState { x: rho, y: 0.0, dot_x: speed };
    let error = |tolerance: f64| {
        let method = ImplicitRungeKutta::radau5().rtol(tolerance).atol(tolerance);
        let states = Equations::new(&model).unwrap().solve(method, start, (0.0, 1.5)).unwrap();
        for (t, s) in &states {
            let f = model.position_residual_at(*t, s)[0];
            assert!(f.abs() < 1e-14, "at {t}: {f:e}");
        }
        let (t, s) = states.last().unwrap();
        assert_eq!(*t, 1.5);
        (s.x * (w * t).cos() + s.y * (w * t).sin() - exact(*t)).abs()
    };
    let errors = [1e-4, 1e-6, 1e-8, 1e-10].map(error);
    // Inside, Radau5 works with 0.1 rtol^(2/3): six digits of tolerance are four of the error, and a margin.
    assert!(errors.windows(2).all(|pair| pair[1] < 0.6 * pair[0]), "{errors:?}");
    assert!(errors[3] < 1e-6 && errors[3] < 0.01 * errors[0], "{errors:?}");
}

#[test]
fn their_explicit_methods_run_too_and_backwards() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let method = || ExplicitRungeKutta::dop853().rtol(1e-11).atol(1e-11);
    let equations = Equations::new(&model).unwrap();
    let there = equations.solve(method(), start, (0.0, 0.7)).unwrap();
    let own = model.simulate(start).tolerance(1e-12, 1e-12).until(0.7).unwrap();
    let end = there.last().unwrap().1;
    assert!((end.x - own.last().1.x).abs() < 1e-9);
    let back = equations.solve(method(), end, (0.7, 0.0)).unwrap();
    assert!((back.last().unwrap().1.x - 0.3).abs() < 1e-9);
}

#[test]
fn what_stops_an_own_run_stops_theirs() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let radau = || ImplicitRungeKutta::radau5().rtol(1e-8).atol(1e-8);
    let equations = Equations::new(&model).unwrap();
    let off = equations.solve(radau(), PendulumState { x: 0.3, y: -0.5, dot_x: 0.0 }, (0.0, 1.0)).unwrap_err();
    assert!(matches!(off, Error::Unmet { constraint: "rod", .. }), "{off}");
    // Over the level position, where ẋ says nothing.
    let over = equations.solve(radau(), PendulumState { x: 0.0, y: -0.5, dot_x: 4.0 }, (0.0, 10.0)).unwrap_err();
    assert!(matches!(over, Error::ChartSingularity { guard: "y", .. } | Error::Solver { .. }), "{over}");
    // Too few steps, in words.
    let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let few = equations.solve(radau().max_steps(3), start, (0.0, 10.0)).unwrap_err();
    assert!(matches!(&few, Error::Solver { .. }) && few.to_string().contains("as many steps as it may"), "{few}");
    let missing = Oscillator { m: 1.0, a: 0.0, k: 1.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    let error =
        Equations::new(&missing).unwrap().solve(ImplicitRungeKutta::radau5(), OscillatorState::default(), (0.0, 1.0));
    assert!(matches!(error, Err(Error::MissingInputs { .. })));
}
