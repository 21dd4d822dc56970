//! Special functions that exact answers need.

use std::f64::consts::PI;

/// The scale of the arithmetic-geometric mean for the modulus k: all a_n and c_n.
fn means(k: f64) -> Vec<(f64, f64)> {
    let (mut a, mut b, mut c) = (1.0_f64, (1.0 - k * k).sqrt(), k);
    let mut scale = vec![(a, c)];
    while c.abs() > f64::EPSILON * a && scale.len() < 12 {
        (a, b, c) = ((a + b) / 2.0, (a * b).sqrt(), (a - b) / 2.0);
        scale.push((a, c));
    }
    scale
}

/// The complete elliptic integral of the first kind, K(k).
pub fn quarter_period(k: f64) -> f64 {
    PI / (2.0 * means(k).last().expect("one mean").0)
}

/// Jacobi's sn, cn, dn of u for the modulus k, by descending Landen transformations (Abramowitz and Stegun 16.4).
pub fn jacobi(u: f64, k: f64) -> (f64, f64, f64) {
    let scale = means(k);
    let n = scale.len() - 1;
    let mut phi = 2.0_f64.powi(n as i32) * scale[n].0 * u;
    for &(a, c) in scale[1..].iter().rev() {
        phi = (phi + (c / a * phi.sin()).asin()) / 2.0;
    }
    let (sn, cn) = phi.sin_cos();
    (sn, cn, (1.0 - k * k * sn * sn).sqrt())
}

/// The Gudermannian, gd(0) = 0, gd' = sech.
pub fn gudermannian(x: f64) -> f64 {
    2.0 * (x / 2.0).tanh().atan()
}

#[test]
fn elliptic_functions_have_known_values() {
    // K(sin 75°) and sn, cn, dn(0.5; 0.8) from mpmath (ellipk, ellipfun), 17 digits
    let modulus = (75.0_f64 / 180.0 * PI).sin();
    assert!((quarter_period(modulus) - KNOWN[0]).abs() < 1e-14 * KNOWN[0]);
    let (sn, cn, dn) = jacobi(0.5, 0.8);
    for (value, known) in [sn, cn, dn].iter().zip(&KNOWN[1..]) {
        assert!((value - known).abs() < 1e-15, "{value} {known}");
    }
}

#[cfg(test)]
const KNOWN: [f64; 4] = [2.7680631453687674, 0.46832883538821457, 0.8835542439171002, 0.9271610352274884];
