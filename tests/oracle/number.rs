//! Numbers of the oracle: f64, dual numbers, and numbers that carry the size of what went into them.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What an expression can be evaluated over.
pub trait Number:
    'static
    + Copy
    + Debug
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// A number that depends on nothing.
    fn constant(x: f64) -> Self;
    /// The number without derivatives, for comparisons.
    fn value(self) -> f64;
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// The exponential.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// The positive root.
    fn sqrt(self) -> Self;
    /// The angle of the point (x, self).
    fn atan2(self, x: Self) -> Self;

    /// Zero.
    fn zero() -> Self {
        Self::constant(0.0)
    }
    /// One.
    fn one() -> Self {
        Self::constant(1.0)
    }
    /// The absolute value.
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
    /// The angle between -π/2 and π/2 with this sine.
    fn asin(self) -> Self {
        self.atan2((Self::one() - self * self).sqrt())
    }
    /// The angle between 0 and π with this cosine.
    fn acos(self) -> Self {
        (Self::one() - self * self).sqrt().atan2(self)
    }
    /// Hyperbolic sine and cosine, by exponentials.
    fn sinh_cosh(self) -> (Self, Self) {
        let (up, down, half) = (self.exp(), (-self).exp(), Self::constant(0.5));
        (half * (up - down), half * (up + down))
    }
    /// The n-th power by repeated multiplication; a negative power is a division.
    fn powi(self, n: i32) -> Self {
        let power = (0..n.unsigned_abs()).fold(Self::one(), |product, _| product * self);
        if n < 0 { Self::one() / power } else { power }
    }
}

impl Number for f64 {
    fn constant(x: f64) -> Self {
        x
    }
    fn value(self) -> f64 {
        self
    }
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
    fn exp(self) -> Self {
        f64::exp(self)
    }
    fn ln(self) -> Self {
        f64::ln(self)
    }
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
}

/// A number and its derivative in one direction; nested, it gives derivatives of derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Dual<N> {
    /// The number itself.
    pub value: N,
    /// Its derivative.
    pub rate: N,
}

impl<N: Number> Dual<N> {
    /// A number that does not change in the direction of the derivative.
    pub fn fixed(value: N) -> Self {
        Self { value, rate: N::zero() }
    }
    /// A number with its derivative.
    pub fn moving(value: N, rate: N) -> Self {
        Self { value, rate }
    }
    /// f(self), where f and f' were evaluated at the value.
    fn chain(self, f: N, slope: N) -> Self {
        Self { value: f, rate: slope * self.rate }
    }
}

impl<N: Number> Neg for Dual<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, rate: -self.rate }
    }
}
impl<N: Number> Add for Dual<N> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, rate: self.rate + o.rate }
    }
}
impl<N: Number> Sub for Dual<N> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, rate: self.rate - o.rate }
    }
}
impl<N: Number> Mul for Dual<N> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self { value: self.value * o.value, rate: self.rate * o.value + self.value * o.rate }
    }
}
impl<N: Number> Div for Dual<N> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self { value, rate: (self.rate - value * o.rate) / o.value }
    }
}

impl<N: Number> Number for Dual<N> {
    fn constant(x: f64) -> Self {
        Self::fixed(N::constant(x))
    }
    fn value(self) -> f64 {
        self.value.value()
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }
    fn ln(self) -> Self {
        self.chain(self.value.ln(), N::one() / self.value)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, N::constant(0.5) / root)
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        Self { value: self.value.atan2(x.value), rate: (self.rate * x.value - self.value * x.rate) / square }
    }
}

/// A number with the size of the terms it was made of: first-order running error analysis.
///
/// Whoever evaluates the same expression in f64, operation by operation, is off by at most `size` times the unit roundoff
/// times a modest count of operations; cancellation leaves the size and shrinks the value. So the size is the scale against
/// which two evaluations of one expression may be compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled {
    /// The number itself.
    pub value: f64,
    /// Sum of the absolute values of what it was made of, carried through with the derivatives of each operation.
    pub size: f64,
}

impl Neg for Scaled {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, size: self.size }
    }
}
impl Add for Scaled {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, size: self.size + o.size }
    }
}
impl Sub for Scaled {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, size: self.size + o.size }
    }
}
impl Mul for Scaled {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self { value: self.value * o.value, size: self.size * o.value.abs() + self.value.abs() * o.size }
    }
}
impl Div for Scaled {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self { value, size: (self.size + value.abs() * o.size) / o.value.abs() }
    }
}

impl Scaled {
    fn through(self, f: f64, slope: f64) -> Self {
        Self { value: f, size: f.abs() + slope.abs() * self.size }
    }
}

impl Number for Scaled {
    fn constant(x: f64) -> Self {
        Self { value: x, size: x.abs() }
    }
    fn value(self) -> f64 {
        self.value
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.through(sin, cos), self.through(cos, sin))
    }
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.through(exp, exp)
    }
    fn ln(self) -> Self {
        self.through(self.value.ln(), 1.0 / self.value)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.through(root, 0.5 / root)
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let value = self.value.atan2(x.value);
        let moved = (self.size * x.value.abs() + self.value.abs() * x.size) / square;
        Self { value, size: value.abs() + moved }
    }
}
