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
    fn asin(self) -> Self {
        let one = T::from_f64(1.0);
        Dual::new(self.value.asin(), self.derivative / ((one - self.value) * (one + self.value)).sqrt())
    }

    #[inline(always)]
    fn acos(self) -> Self {
        let one = T::from_f64(1.0);
        Dual::new(self.value.acos(), -(self.derivative / ((one - self.value) * (one + self.value)).sqrt()))
    }

    #[inline(always)]
    fn atan(self) -> Self {
        Dual::new(self.value.atan(), self.derivative / (T::from_f64(1.0) + self.value * self.value))
    }

    #[inline(always)]
    fn sinh(self) -> Self {
        Dual::new(self.value.sinh(), self.value.cosh() * self.derivative)
    }

    #[inline(always)]
    fn cosh(self) -> Self {
        Dual::new(self.value.cosh(), self.value.sinh() * self.derivative)
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        let value = self.value.tanh();
        Dual::new(value, (T::from_f64(1.0) - value * value) * self.derivative)
    }

    /// An exponent that does not move needs no logarithm: the base may then be zero or negative.
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        let lower = self.value.powf(exponent.value - T::from_f64(1.0));
        let by_base = exponent.value * lower * self.derivative;
        if exponent.derivative == T::default() {
            return Dual::new(value, by_base);
        }
        Dual::new(value, by_base + value * self.value.ln() * exponent.derivative)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Dual::new(self.value.abs(), self.value.sign() * self.derivative)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Dual::constant(self.value.sign())
    }

    #[inline(always)]
    fn select(self, negative: Self, other: Self) -> Self {
        Dual::new(
            self.value.select(negative.value, other.value),
            self.value.select(negative.derivative, other.derivative),
        )
    }

    /// An argument that does not move, time or a parameter, needs no derivative of the function.
    #[inline(always)]
    fn apply(self, orders: &[fn(f64) -> f64]) -> Self {
        let value = self.value.apply(orders);
        if self.derivative == T::default() {
            return Dual::constant(value);
        }
        let slope = self.value.apply(orders.get(1..).unwrap_or_default());
        Dual::new(value, slope * self.derivative)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.derivative.is_finite()
    }
}
