//! Numbers that know how large the terms were that they are made of.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Dual, Scalar};

/// A value, and a size of which its rounding error is a few units.
///
/// The sizes of the terms of a sum add up, also where the sum cancels; a function passes the size of its argument on by its
/// slope, and adds its own value. This is the running error analysis of Higham, Accuracy and Stability of Numerical
/// Algorithms, section 3.3.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub(crate) struct Measured {
    pub(crate) value: f64,
    pub(crate) size: f64,
}

impl Measured {
    /// A number that was not computed; it counts with a size of its own where that is larger than its magnitude.
    pub(crate) fn given(value: f64, least: f64) -> Self {
        Measured { value, size: value.abs().max(least) }
    }

    fn by(self, f: impl Fn(Dual) -> Dual) -> Self {
        let Dual { value, derivative } = f(Dual::variable(self.value));
        let passed = derivative.abs() * self.size;
        // Where the slope is infinite, as that of a root at zero, the value alone tells.
        Measured { value, size: value.abs() + if passed.is_finite() { passed } else { 0.0 } }
    }
}

impl Neg for Measured {
    type Output = Self;
    fn neg(self) -> Self {
        Measured { value: -self.value, ..self }
    }
}

impl Add for Measured {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Measured { value: self.value + other.value, size: self.size + other.size }
    }
}

impl Sub for Measured {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Measured { value: self.value - other.value, size: self.size + other.size }
    }
}

impl Mul for Measured {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let size = self.value.abs() * other.size + self.size * other.value.abs();
        Measured { value: self.value * other.value, size }
    }
}

impl Div for Measured {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Measured { value, size: (self.size + value.abs() * other.size) / other.value.abs() }
    }
}

impl Scalar for Measured {
    fn from_f64(x: f64) -> Self {
        Measured::given(x, 0.0)
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Self {
        self.by(Scalar::sqrt)
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.by(|x| x.sin_cos().0), self.by(|x| x.sin_cos().1))
    }
    fn atan2(self, x: Self) -> Self {
        let value = Scalar::atan2(self.value, x.value);
        let square = self.value * self.value + x.value * x.value;
        let passed = (x.value.abs() * self.size + self.value.abs() * x.size) / square;
        Measured { value, size: value.abs() + passed }
    }
    fn exp(self) -> Self {
        self.by(Scalar::exp)
    }
    fn ln(self) -> Self {
        self.by(Scalar::ln)
    }
    fn asin(self) -> Self {
        self.by(Scalar::asin)
    }
    fn acos(self) -> Self {
        self.by(Scalar::acos)
    }
    fn atan(self) -> Self {
        self.by(Scalar::atan)
    }
    fn sinh(self) -> Self {
        self.by(Scalar::sinh)
    }
    fn cosh(self) -> Self {
        self.by(Scalar::cosh)
    }
    fn tanh(self) -> Self {
        self.by(Scalar::tanh)
    }
    fn powf(self, exponent: Self) -> Self {
        self.by(|x| x.powf(Dual::constant(exponent.value)))
    }
    fn abs(self) -> Self {
        Measured { value: Scalar::abs(self.value), ..self }
    }
    fn sign(self) -> Self {
        Scalar::from_f64(Scalar::sign(self.value))
    }
    fn select(self, negative: Self, other: Self) -> Self {
        match self.value {
            value if value.is_nan() => self,
            value if value < 0.0 => negative,
            _ => other,
        }
    }
    fn apply(self, orders: &[fn(f64) -> f64]) -> Self {
        if orders.len() > 1 { self.by(|x| x.apply(orders)) } else { Scalar::from_f64(self.value.apply(orders)) }
    }
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.size.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_keeps_its_size() {
        // cos a − cos b at a = b = 0: the terms are ones, though no slope tells.
        let zero = Measured::given(0.0, 0.0);
        let f = zero.sin_cos().1 - zero.sin_cos().1;
        assert_eq!((f.value, f.size), (0.0, 2.0));
        let (x, l) = (Measured::given(3.0, 0.0), Measured::given(3.0, 0.0));
        assert_eq!(x * x - l * l, Measured { value: 0.0, size: 36.0 });
    }

    #[test]
    fn rounding_stays_within_a_few_units_of_the_size() {
        // (a + b)³ − a³ − 3 a² b − 3 a b² − b³ vanishes; so does ln(e^a e^b) − a − b.
        for i in 0..100 {
            let (a, b) = (0.1 + 0.037 * f64::from(i), 1.7 - 0.029 * f64::from(i));
            let (a, b) = (Measured::given(a, 0.0), Measured::given(b, 0.0));
            let (three, sum) = (Measured::from_f64(3.0), a + b);
            let cube = sum * sum * sum - a * a * a - three * a * a * b - three * a * b * b - b * b * b;
            let logarithm = (a.exp() * b.exp()).ln() - a - b;
            let root = (a * a).sqrt() - a;
            for zero in [cube, logarithm, root] {
                assert!(zero.value.abs() <= 4.0 * f64::EPSILON * zero.size, "{zero:?}");
                assert!(zero.size > 0.01 && zero.size < 1e3, "{zero:?}");
            }
        }
    }
}
