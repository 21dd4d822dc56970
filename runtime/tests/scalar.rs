//! Dual numbers against differences, nested and through a model; f32.

mod models;

use holonomy::prelude::*;
use holonomy::{Dual, Scalar};
use models::*;

/// Uses every function of the trait.
fn sample<T: Scalar>(x: T) -> T {
    let (sin, cos) = (x * x).sin_cos();
    let root = (x + T::from_f64(2.0)).sqrt();
    let arcs = (x / T::from_f64(3.0)).asin() * (x / T::from_f64(2.0)).acos() - (x * x).atan();
    let hyperbolic = x.sinh() * (x / T::from_f64(2.0)).cosh() + (x + x).tanh();
    let power = (x + T::from_f64(4.0)).powf(x - T::from_f64(0.7)) + (x + T::from_f64(2.0)).powf(T::from_f64(1.3));
    let kinks = (x - T::from_f64(0.1)).abs() * x.sign() + (x - T::from_f64(0.3)).select(x * x, x * x * x);
    sin.atan2(cos + T::from_f64(2.0)) * root.exp() / (x - T::from_f64(5.0)) - (-x + T::from_f64(3.0)).ln()
        + arcs * hyperbolic
        + power
        + kinks
}

#[test]
fn first_derivatives_agree_with_differences() {
    for x in [-1.3, -0.2, 0.05, 0.4, 1.7] {
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

/// x^1.5 at 0, where ln x has no value; and the powers of negative numbers.
#[test]
fn a_fixed_exponent_needs_no_logarithm() {
    let power = Dual::variable(0.0_f64).powf(Dual::constant(1.5));
    assert_eq!((power.value, power.derivative), (0.0, 0.0));
    let cube = Dual::variable(-2.0_f64).powf(Dual::constant(3.0));
    assert_eq!((cube.value, cube.derivative), (-8.0, 12.0));
    assert!(Dual::constant(-2.0_f64).powf(Dual::variable(3.0)).derivative.is_nan());
}

#[test]
fn signs_and_selections_at_their_edges() {
    assert_eq!([Scalar::sign(-0.3_f64), 0.0_f64.sign(), Scalar::sign(7.0_f32) as f64], [-1.0, 0.0, 1.0]);
    assert!(f64::NAN.sign().is_nan() && f64::NAN.select(1.0, 2.0).is_nan());
    assert_eq!([(-0.1_f64).select(1.0, 2.0), 0.0_f64.select(1.0, 2.0), 0.1_f64.select(1.0, 2.0)], [1.0, 2.0, 2.0]);
    // The branch that is not taken may have no value.
    let root = |x: f64| Dual::variable(x).select(Dual::constant(0.0), Dual::variable(x).sqrt());
    assert_eq!((root(-4.0).value, root(-4.0).derivative), (0.0, 0.0));
    assert_eq!((root(4.0).value, root(4.0).derivative), (2.0, 0.25));
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
