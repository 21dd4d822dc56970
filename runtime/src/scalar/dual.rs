//! Dual numbers: a value and its derivative in one direction.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Scalar;

/// A number `value + derivative·ε` with `ε² = 0`: evaluating a function at `x + ẋ ε` gives its value and its derivative along ẋ.
///
/// Nested duals give second derivatives.
///
/// ```
/// use holonomy::{Dual, Scalar};
///
/// let x = Dual::variable(2.0);
/// let y = x * x * x;                                   // x³
/// assert_eq!((y.value, y.derivative), (8.0, 12.0));
///
/// let x = Dual::variable(Dual::variable(2.0));
/// assert_eq!((x * x * x).derivative.derivative, 12.0); // (x³)″ = 6 x
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Dual<T = f64> {
    /// The value.
    pub value: T,
    /// The derivative along the chosen direction.
    pub derivative: T,
}

impl<T: Scalar> Dual<T> {
    /// A number with the given derivative.
    #[inline(always)]
    pub fn new(value: T, derivative: T) -> Self {
        Dual { value, derivative }
    }

    /// A number that does not depend on the variable.
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        Dual::new(value, T::default())
    }

    /// The variable itself: its derivative is one.
    #[inline(always)]
    pub fn variable(value: T) -> Self {
        Dual::new(value, T::from_f64(1.0))
    }
}

impl<T: Scalar> Neg for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Dual::new(-self.value, -self.derivative)
    }
}

impl<T: Scalar> Add for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Dual::new(self.value + other.value, self.derivative + other.derivative)
    }
}

impl<T: Scalar> Sub for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Dual::new(self.value - other.value, self.derivative - other.derivative)
    }
}

impl<T: Scalar> Mul for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Dual::new(self.value * other.value, self.derivative * other.value + self.value * other.derivative)
    }
}

impl<T: Scalar> Div for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        Dual::new(quotient, (self.derivative - quotient * other.derivative) / other.value)
    }
}

impl<T: Scalar> Scalar for Dual<T> {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Dual::constant(T::from_f64(x))
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    /// At zero the derivative is infinite, or not a number where the argument does not move.
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Dual::new(root, self.derivative / (root + root))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (Dual::new(sin, cos * self.derivative), Dual::new(cos, -(sin * self.derivative)))
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        Dual::new(self.value.atan2(x.value), (x.value * self.derivative - self.value * x.derivative) / square)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        Dual::new(value, value * self.derivative)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        Dual::new(self.value.ln(), self.derivative / self.value)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.derivative.is_finite()
    }
}
