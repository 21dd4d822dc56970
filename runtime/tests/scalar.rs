//! Dual numbers against differences, nested and through a model; f32.

mod models;

use holonomy::prelude::*;
use holonomy::{Dual, Scalar};
use models::*;

/// Uses every function of the trait.
fn sample<T: Scalar>(x: T) -> T {
    let (sin, cos) = (x * x).sin_cos();
    let root = (x + T::from_f64(2.0)).sqrt();
    sin.atan2(cos + T::from_f64(2.0)) * root.exp() / (x - T::from_f64(5.0)) - (-x + T::from_f64(3.0)).ln()
}

#[test]
fn first_derivatives_agree_with_differences() {
    for x in [-1.3, -0.2, 0.0, 0.4, 1.7] {
        let h = 1e-5;
        // Richardson: order 4
        let difference = |h: f64| (sample(x + h) - sample(x - h)) / (2.0 * h);
        let expected = (4.0 * difference(h / 2.0) - difference(h)) / 3.0;
        let dual = sample(Dual::variable(x));
        assert_eq!(dual.value, sample(x));
        assert!((dual.derivative - expected).abs() < 1e-9 * (1.0 + expected.abs()), "at {x}");
    }
}

#[test]
fn nested_derivatives_agree_with_differences_of_the_first() {
    for x in [-1.3, -0.2, 0.4, 1.7] {
        let h = 1e-5;
        let first = |x: f64| sample(Dual::variable(x)).derivative;
        let expected = (first(x + h) - first(x - h)) / (2.0 * h);
        let dual = sample(Dual::variable(Dual::variable(x)));
        assert_eq!(dual.value.derivative, dual.derivative.value);
        assert!((dual.derivative.derivative - expected).abs() < 1e-7 * (1.0 + expected.abs()), "at {x}");
    }
}

#[test]
fn duals_go_through_a_model() {
    let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 };
    let plain = pendulum.clone().prepare().unwrap();
    let dual = pendulum.prepare_as::<Dual>().unwrap();
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.7 };
    let h = 1e-6;
    let at = |dx: f64| plain.accelerations(0.0, &PendulumState { x: s.x + dx, ..s }, &[])[0];
    let seeded = PendulumState { x: Dual::variable(s.x), y: Dual::constant(s.y), dot_x: Dual::constant(s.dot_x) };
    let slope = dual.accelerations(Dual::default(), &seeded, &[])[0].derivative;
    assert!((slope - (at(h) - at(-h)) / (2.0 * h)).abs() < 1e-6 * slope.abs());
}

#[test]
fn finiteness_includes_derivatives() {
    assert!(Scalar::is_finite(Dual::new(1.0, 2.0)));
    assert!(!Scalar::is_finite(Dual::new(1.0, f64::NAN)));
    assert!(!Scalar::is_finite(Dual::constant(0.0_f64).sqrt()));
    assert!(!Scalar::is_finite(f32::INFINITY));
}

#[test]
fn single_precision_agrees_to_its_rounding() {
    let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 };
    let double = pendulum.clone().prepare().unwrap();
    let single = pendulum.prepare_as::<f32>().unwrap();
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.7 };
    let t = PendulumState { x: 0.3f32, y: -0.4, dot_x: 0.7 };
    let (rate, guards) = single.derivative(0.0, &t, &[]);
    let (expected, _) = double.derivative(0.0, &s, &[]);
    assert!((f64::from(rate.dot_x) - expected.dot_x).abs() < 1e-5);
    assert!((f64::from(rate.y) - expected.y).abs() < 1e-6);
    assert_eq!(guards, [-0.4f32]);
    for x in [-1.3f32, 0.4, 1.7] {
        assert!((f64::from(sample(x)) - sample(f64::from(x))).abs() < 1e-5);
    }
}
