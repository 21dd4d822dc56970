//! Gauss' points against the table, and the step against motions that are known.

use super::super::stages::interpolate;
use super::*;

#[test]
fn points_are_those_of_the_table() {
    // Abramowitz and Stegun, table 25.4, n = 4 and n = 10.
    let four = Gauss::new(4);
    for (found, exact) in four.points.iter().zip([-0.861136311594053, -0.339981043584856]) {
        assert!((2.0 * found - 1.0 - exact).abs() < 1e-15, "{found}");
    }
    for (found, exact) in four.transform[0].iter().zip([0.347854845137454, 0.652145154862546]) {
        assert!((2.0 * found - exact).abs() < 1e-15, "{found}");
    }
    let ten = Gauss::new(10);
    assert!((2.0 * ten.points[5] - 1.0 - 0.148874338981631).abs() < 1e-15);
    assert!((2.0 * ten.transform[0][5] - 0.295524224714753).abs() < 1e-15);
}

/// ÿ = −y from y = 1 at rest: y = cos t, by the fixed points of the step.
#[test]
fn a_step_of_the_oscillator_is_exact_to_rounding() {
    let (gauss, y, h) = (Gauss::new(10), [1.0, 0.0], 0.5);
    let mut rates = vec![[0.0, -1.0]; 10];
    for _ in 0..40 {
        let kappa = gauss.expand(&rates);
        for (rate, theta) in rates.iter_mut().zip(&gauss.points) {
            let at = integral(&y, h, &kappa, *theta);
            *rate = [at[1], -at[0]];
        }
    }
    let kappa = gauss.expand(&rates);
    let ahead = integral(&y, h, &kappa, 1.0);
    assert!((ahead[0] - h.cos()).abs() < 1e-15 && (ahead[1] + h.sin()).abs() < 1e-15, "{ahead:?}");
    let polynomial = dense(&gauss, &y, h, &kappa, &ahead);
    for part in 0..=40 {
        let theta = f64::from(part) / 40.0;
        let value = interpolate(polynomial.len(), theta, |j| polynomial[j][0]);
        assert!((value - (theta * h).cos()).abs() < 1e-14, "{theta}: {value}");
        assert!((slope(&kappa, theta)[0] + (theta * h).sin()).abs() < 1e-13);
    }
}
