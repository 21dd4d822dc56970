//! Choosing the size of the steps.

use super::flow::Point;
use super::tableau::{Estimate, Tableau};
use crate::math::double::{pow, sqrt};

/// The part of the step for the aimed error that is taken.
const SAFETY: f64 = 0.9;

/// The part of the tolerated error that is aimed at; a step is repeated only beyond the whole.
///
/// The errors of an undriven motion add up over the steps with one sign, so that its energy is lost step by step. Aiming at
/// a fraction costs little: of steps that aim at the whole up to a quarter are taken twice.
const AIM: f64 = 0.03;

/// Relative and absolute tolerance.
#[derive(Copy, Clone, Debug)]
pub(super) struct Tolerance {
    pub(super) relative: f64,
    pub(super) absolute: f64,
}

impl Tolerance {
    #[inline(always)]
    fn scale(&self, a: f64, b: f64) -> f64 {
        self.absolute + self.relative * a.abs().max(b.abs())
    }

    /// The root of the mean square of `y` in units of what is tolerated at `at`.
    pub(super) fn norm<P: Point>(&self, y: &P, at: &P) -> f64 {
        let ratio = |i: usize| y.get(i) / self.scale(at.get(i), at.get(i));
        let sum: f64 = (0..y.len()).map(ratio).map(|ratio| ratio * ratio).sum();
        sqrt(sum / y.len().max(1) as f64)
    }

    /// The error of a step in units of what is tolerated; zero for methods without an estimate.
    pub(super) fn error<const S: usize, P: Point>(
        &self,
        tableau: &Tableau<S>,
        h: f64,
        k: &[P; S],
        y: &P,
        next: &P,
    ) -> f64 {
        let count = y.len().max(1) as f64;
        let sum = |weights: &[f64; S]| -> f64 {
            let mut sum = 0.0;
            for i in 0..y.len() {
                let mut error = 0.0;
                for (weight, k) in weights.iter().zip(k).take(tableau.stages) {
                    if *weight != 0.0 {
                        error += weight * k.get(i);
                    }
                }
                let ratio = error / self.scale(y.get(i), next.get(i));
                sum += ratio * ratio;
            }
            sum
        };
        match &tableau.error {
            Estimate::None => 0.0,
            Estimate::One(weights) => h.abs() * sqrt(sum(weights) / count),
            // Hairer's combination: the fifth-order estimate, lowered where the third-order one is much larger.
            Estimate::Two(fifth, third) => {
                let (fifth, third) = (sum(fifth), sum(third));
                let both = fifth + 0.01 * third;
                if both > 0.0 { h.abs() * fifth / sqrt(count * both) } else { both }
            }
        }
    }
}

/// The proportional-integral control of Hairer, Nørsett and Wanner, section II.4.
pub(super) struct Controller {
    exponent: f64,
    beta: f64,
    factors: (f64, f64),
    last_error: f64,
    rejected: bool,
}

impl Controller {
    pub(super) fn new<const S: usize>(tableau: &Tableau<S>) -> Self {
        Controller {
            exponent: 1.0 / f64::from(tableau.order) - 0.75 * tableau.beta,
            beta: tableau.beta,
            factors: tableau.factors,
            last_error: 1e-4,
            rejected: false,
        }
    }

    /// The factor for the step after one that is accepted with this error.
    pub(super) fn accept(&mut self, error: f64) -> f64 {
        let growth = SAFETY * pow(self.last_error, self.beta) * pow(AIM / error, self.exponent);
        let largest = if self.rejected { 1.0 } else { self.factors.1 };
        self.last_error = error.max(1e-4);
        self.rejected = false;
        growth.clamp(self.factors.0, largest)
    }

    /// The factor for repeating a step that is rejected with this error.
    pub(super) fn reject(&mut self, error: f64) -> f64 {
        self.rejected = true;
        if error.is_finite() { (SAFETY * pow(AIM / error, self.exponent)).clamp(self.factors.0, 1.0) } else { 0.1 }
    }
}
