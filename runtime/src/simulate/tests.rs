//! The order of every method and of its dense output, measured with fixed steps.

use alloc::vec::Vec;

use super::charts::Charts;
use super::course::Course;
use super::crossing::{Approach, Crossing};
use super::kernel::{Pace, Plan};
use super::tableau::{DORMAND_PRINCE, Estimate, RK4, Tableau};
use super::trajectory::Trajectory;
use super::{control::Tolerance, dop853::DOP853};
use crate::models::{Oscillator, OscillatorInputs, OscillatorState};
use crate::{ConstrainedSystem, Prepared};

const END: f64 = 4.0;

/// A nonlinear oscillator that time drives in two ways.
fn model() -> Prepared<Oscillator> {
    let oscillator = Oscillator { m: 1.3, a: 0.1, k: 2.0, c: 0.7, b: 0.6 };
    oscillator.prepare().unwrap()
}

fn run<const S: usize>(tableau: &'static Tableau<S>, pace: Pace) -> Trajectory<Oscillator> {
    let model = model();
    let start = OscillatorState { x: 0.8, dot_x: -0.3 };
    let mut trajectory = Trajectory::new(&model, 0.0, start, model.velocities(0.0, &start));
    let course = Course {
        model: &model,
        source: |t: f64, s: &OscillatorState| OscillatorInputs { tau: 0.3 * (3.0 * t).cos() - 0.1 * s.dot_x },
        manifold: None,
        redundancy: None,
        charts: Charts::Change,
        baumgarte: None,
        events: Vec::new(),
        progress: None,
        strength: None,
        crossing: Crossing::Refuse,
        tolerance: Tolerance { relative: 1e-9, absolute: 1e-9 },
        approach: Approach::default(),
        inside: None,
    };
    let plan = Plan { start: 0.0, end: END, pace, every: None, dense: true, max_steps: 1_000_000 };
    course.run(tableau, &plan, &mut trajectory).unwrap();
    trajectory
}

fn reference() -> Trajectory<Oscillator> {
    run(&DOP853, Pace::Fixed { step: 1.0 / 256.0 })
}

fn distance(a: &OscillatorState, b: &OscillatorState) -> f64 {
    (a.x - b.x).abs().max((a.dot_x - b.dot_x).abs())
}

/// Errors at the end, and the largest one between the steps, for halved steps.
fn errors<const S: usize>(tableau: &'static Tableau<S>, steps: &[f64]) -> Vec<(f64, f64)> {
    let exact = reference();
    let error = |step: &f64| {
        let found = run(tableau, Pace::Fixed { step: *step });
        let between = (0..4001).map(|i| {
            let t = END * f64::from(i) / 4000.0;
            distance(&found.at(t).unwrap(), &exact.at(t).unwrap())
        });
        (distance(found.last().1, exact.last().1), between.fold(0.0, f64::max))
    };
    steps.iter().map(error).collect()
}

fn check<const S: usize>(tableau: &'static Tableau<S>, steps: &[f64], order: f64, dense_order: f64) {
    let errors = errors(tableau, steps);
    for (pair, steps) in errors.windows(2).zip(steps.windows(2)) {
        let halvings = (steps[0] / steps[1]).log2();
        let measured = (pair[0].0 / pair[1].0).log2() / halvings;
        let dense = (pair[0].1 / pair[1].1).log2() / halvings;
        assert!((order - 0.5..order + 1.2).contains(&measured), "order {measured}, {errors:?}");
        assert!((dense_order - 0.5..dense_order + 1.7).contains(&dense), "dense order {dense}, {errors:?}");
    }
}

#[test]
fn rk4_has_order_4_and_its_dense_output_too() {
    check(&RK4, &[0.1, 0.05, 0.025, 0.0125], 4.0, 4.0);
}

#[test]
fn dormand_prince_has_order_5_and_its_dense_output_error_of_order_5() {
    check(&DORMAND_PRINCE, &[0.1, 0.05, 0.025], 5.0, 5.0);
}

#[test]
fn dop853_has_order_8_and_its_dense_output_error_of_order_8() {
    check(&DOP853, &[0.5, 0.25, 0.125], 8.0, 8.0);
}

/// The rows of a table sum to the times of their stages, and the estimates vanish for constant rates.
fn consistent<const S: usize>(tableau: &Tableau<S>) {
    for (row, c) in tableau.a.iter().zip(tableau.c) {
        let size: f64 = row.iter().map(|a| a.abs()).sum();
        assert!((row.iter().sum::<f64>() - c).abs() < 4e-16 * (1.0 + size));
    }
    let estimates = match &tableau.error {
        Estimate::None => Vec::new(),
        Estimate::One(weights) => alloc::vec![weights],
        Estimate::Two(fifth, third) => alloc::vec![fifth, third],
    };
    for weights in estimates.into_iter().chain(tableau.dense) {
        let size: f64 = weights.iter().map(|w| w.abs()).sum();
        assert!(weights.iter().sum::<f64>().abs() < 1e-15 * (1.0 + size));
    }
}

#[test]
fn tables_are_consistent() {
    consistent(&RK4);
    consistent(&DORMAND_PRINCE);
    consistent(&DOP853);
}

/// The error follows the tolerance over ten powers of ten, and the steps grow as the order says.
fn follows<const S: usize>(tableau: &'static Tableau<S>) {
    let exact = reference();
    let mut last = 0;
    for exponent in [4, 6, 8, 10, 12] {
        let tolerance = 10f64.powi(-exponent);
        let pace = Pace::Adaptive {
            tolerance: Tolerance { relative: tolerance, absolute: tolerance },
            longest: f64::INFINITY,
        };
        let found = run(tableau, pace);
        let error = distance(found.last().1, exact.last().1);
        assert!(error < 30.0 * tolerance, "{error:e} for {tolerance:e}");
        let steps = found.statistics().accepted;
        assert!(found.statistics().rejected <= 2 + steps / 4, "{:?}", found.statistics());
        let growth = 100f64.powf(1.0 / f64::from(tableau.order));
        assert!(last == 0 || (steps as f64) < 1.6 * growth * last as f64, "{steps} after {last}");
        last = steps;
    }
}

#[test]
fn adaptive_methods_follow_their_tolerance() {
    follows(&DORMAND_PRINCE);
    follows(&DOP853);
}
