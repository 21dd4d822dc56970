//! Runs against exact solutions; dense output, long runs, inputs, and the options.

mod models;

use holonomy::prelude::*;
use models::*;
use std::cell::Cell;

const METHODS: [(Method, f64); 3] =
    [(Method::Rk4 { step: 1e-3 }, 1e-9), (Method::DormandPrince, 1e-8), (Method::Dop853, 1e-8)];

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

fn swing() -> PendulumState {
    PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }
}

/// The complete elliptic integral K(k), by the arithmetic-geometric mean.
fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..8 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    std::f64::consts::PI / (2.0 * a)
}

#[test]
fn the_pendulum_returns_after_its_period() {
    // P1: 4 K(sin(α₀/2)) / ω
    let half = (0.3f64).atan2(0.4) / 2.0;
    let period = 4.0 * elliptic_k(half.sin()) / (9.81f64 / 0.5).sqrt();
    for (method, tolerance) in METHODS {
        let model = pendulum();
        let run = model.simulate(swing()).method(method).tolerance(1e-10, 1e-10).until(3.0 * period).unwrap();
        let (t, end) = run.last();
        assert_eq!(t, 3.0 * period);
        assert!((end.x - 0.3).abs() < tolerance && end.dot_x.abs() < 20.0 * tolerance, "{method:?}: {end:?}");
        let half_way = run.at(1.5 * period).unwrap();
        assert!((half_way.x + 0.3).abs() < tolerance, "{method:?}: {half_way:?}");
    }
}

#[test]
fn the_bead_follows_its_exact_solution() {
    // P2, with a constraint that moves; ρ(t) along the rod
    let (w, g, rho, speed) = (0.8f64, 9.81, 1.2, 0.3);
    let model = Bead { m: 1.5, w, g }.prepare().unwrap();
    let exact = |t: f64| {
        rho * (w * t).cosh() + (speed - g / (2.0 * w)) * (w * t).sinh() / w + g * (w * t).sin() / (2.0 * w * w)
    };
    let start = BeadState { x: rho, y: 0.0, dot_x: speed };
    for (method, tolerance) in METHODS {
        let run = model.simulate(start).method(method).tolerance(1e-11, 1e-11).until(1.5).unwrap();
        for (t, s) in run.iter() {
            let along = s.x * (w * t).cos() + s.y * (w * t).sin();
            assert!((along - exact(t)).abs() < tolerance, "{method:?} at {t}");
            // Back on the constraint after every step, to rounding.
            let f = model.position_residual_at(t, s)[0];
            assert!(f.abs() < 1e-14, "{method:?} at {t}: {f:e}");
        }
    }
}

#[test]
fn time_dependent_forces_and_inputs_are_taken_at_their_times() {
    // ẍ = b sin t + tau with tau = cos 2t
    let model = Oscillator { m: 1.0, a: 0.0, k: 0.0, c: 0.0, b: 0.7 }.prepare().unwrap();
    let start = OscillatorState { x: 0.2, dot_x: -0.1 };
    let (from, end) = (0.4f64, 3.0f64);
    let force = |t: f64| -0.7 * t.sin() - 0.25 * (2.0 * t).cos();
    let slope = |t: f64| -0.7 * t.cos() + 0.5 * (2.0 * t).sin();
    let exact = |t: f64| 0.2 + (-0.1 - slope(from)) * (t - from) + force(t) - force(from);
    for (method, tolerance) in METHODS {
        let run = model
            .simulate(start)
            .starting_at(from)
            .method(method)
            .inputs(|t, _| OscillatorInputs { tau: (2.0 * t).cos() })
            .until(end)
            .unwrap();
        assert!((run.last().1.x - exact(end)).abs() < tolerance, "{method:?}");
        for i in 0..100 {
            let t = from + (end - from) * f64::from(i) / 100.0;
            assert!((run.at(t).unwrap().x - exact(t)).abs() < tolerance, "{method:?} at {t}");
        }
    }
}

#[test]
fn inputs_may_depend_on_the_state() {
    // A controller that cancels the spring and damps: ẍ = −ẋ
    let model = Oscillator { m: 1.0, a: 0.0, k: 2.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    let run = model
        .simulate(OscillatorState { x: 1.0, dot_x: 1.0 })
        .inputs(|_, s| OscillatorInputs { tau: 2.0 * s.x - s.dot_x })
        .until(2.0)
        .unwrap();
    assert!((run.last().1.dot_x - (-2.0f64).exp()).abs() < 1e-8);
}

#[test]
fn energy_and_constraint_hold_over_long_runs() {
    let model = pendulum();
    let energy = model.energy(0.0, &swing());
    for (method, tolerance) in [(Method::DormandPrince, 1e-7), (Method::Dop853, 1e-8)] {
        let run = model
            .simulate(swing())
            .method(method)
            .tolerance(1e-12, 1e-12)
            .every(1.0)
            .dense(false)
            .until(500.0)
            .unwrap();
        assert_eq!(run.times().len(), 501);
        for (t, s) in run.iter() {
            assert!((model.energy(t, s) - energy).abs() < tolerance, "{method:?} at {t}");
            let f = model.position_residual_at(t, s)[0];
            assert!(f.abs() < 1e-15, "{method:?} at {t}: {f:e}");
        }
    }
}

#[test]
fn outputs_stand_at_their_spacing_and_at_the_end() {
    let model = pendulum();
    for method in [Method::Rk4 { step: 0.01 }, Method::Rk4 { step: 0.013 }, Method::DormandPrince, Method::Dop853] {
        let run = model.simulate(swing()).method(method).every(0.1).until(0.95).unwrap();
        let expected: Vec<f64> = (0..10).map(|i| 0.1 * f64::from(i)).chain([0.95]).collect();
        assert_eq!(run.times().len(), expected.len(), "{method:?}");
        for (found, expected) in run.times().iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15);
        }
        let fine = model.simulate(swing()).tolerance(1e-13, 1e-13).until(0.95).unwrap();
        for (t, s) in run.iter() {
            assert!((s.x - fine.at(t).unwrap().x).abs() < 1e-6, "{method:?} at {t}");
            assert!(model.position_residual_at(t, s)[0].abs() < 1e-15);
            assert_eq!(run.at(t).unwrap(), *s);
        }
    }
    // A spacing beyond the end leaves the start and the end.
    let run = model.simulate(swing()).every(10.0).until(0.5).unwrap();
    assert_eq!(run.times(), [0.0, 0.5]);
}

#[test]
fn fixed_steps_take_their_time_from_a_count() {
    let model = pendulum();
    let run = model.simulate(swing()).method(Method::Rk4 { step: 0.1 }).until(1.0).unwrap();
    assert_eq!(run.times().len(), 11);
    assert_eq!(run.times()[3], 0.1 * 3.0);
    assert_eq!(run.last().0, 1.0);
    // Four evaluations a step; the first rate of a step is the last of the one before, unless the state was moved back.
    let free = Oscillator { m: 1.0, a: 0.0, k: 2.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    let run = free
        .simulate(OscillatorState { x: 1.0, dot_x: 0.0 })
        .inputs(|_, _| OscillatorInputs { tau: 0.0 })
        .method(Method::Rk4 { step: 0.1 })
        .until(0.95)
        .unwrap();
    assert_eq!((run.statistics().accepted, run.statistics().evaluations), (10, 41));
    assert!((run.times()[9] - 0.9).abs() < 1e-15 && run.last().0 == 0.95);
}

#[test]
fn time_runs_backwards_too() {
    let model = pendulum();
    let there = model.simulate(swing()).tolerance(1e-12, 1e-12).until(0.7).unwrap();
    for (method, tolerance) in METHODS {
        let back = model
            .simulate(*there.last().1)
            .starting_at(0.7)
            .method(method)
            .tolerance(1e-11, 1e-11)
            .every(0.2)
            .until(0.0)
            .unwrap();
        assert!((back.last().1.x - 0.3).abs() < tolerance, "{method:?}");
        assert_eq!(back.times().len(), 5);
        assert!((back.at(0.35).unwrap().x - there.at(0.35).unwrap().x).abs() < tolerance);
        assert!(back.at(0.71).is_err());
    }
}

#[test]
fn nothing_to_do_gives_the_start() {
    let model = pendulum();
    for (method, _) in METHODS {
        let run = model.simulate(swing()).method(method).every(0.1).until(0.0).unwrap();
        assert_eq!((run.times().len(), *run.last().1), (1, swing()));
        assert_eq!(run.at(0.0).unwrap(), swing());
    }
}

#[test]
fn progress_is_told_in_order_up_to_the_end() {
    let model = pendulum();
    let (calls, last) = (Cell::new(0), Cell::new(0.0));
    let told = |fraction: f64| {
        assert!(fraction > last.get());
        calls.set(calls.get() + 1);
        last.set(fraction);
    };
    model.simulate(swing()).method(Method::Rk4 { step: 1e-4 }).progress(told).until(1.0).unwrap();
    assert!((150..=201).contains(&calls.get()));
    assert_eq!(last.get(), 1.0);
}

#[test]
fn a_short_force_is_not_stepped_over_with_a_longest_step() {
    let model = Oscillator { m: 1.0, a: 0.0, k: 0.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    let run = model
        .simulate(OscillatorState::default())
        .inputs(|t, _| OscillatorInputs { tau: (-1000.0 * (t - 5.0) * (t - 5.0)).exp() })
        .max_step(0.02)
        .until(10.0)
        .unwrap();
    let impulse = (std::f64::consts::PI / 1000.0).sqrt();
    assert!((run.last().1.dot_x - impulse).abs() < 1e-7);
}
