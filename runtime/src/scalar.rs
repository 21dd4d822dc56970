//! The numbers that the equations are evaluated over.

mod dual;
mod measured;
mod orders;

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::{self, double, single};

pub use dual::Dual;
pub(crate) use measured::Measured;
pub(crate) use orders::Orders;

/// A number type for the emitted equations: `f64`, `f32`, dual numbers, or a type of your own.
///
/// The emitted functions never compare and never branch, they [select](Scalar::select); so a scalar may as well be a
/// bundle of lanes.
///
/// ```
/// use holonomy::{Dual, Scalar};
///
/// fn pythagoras<T: Scalar>(angle: T) -> T {
///     let (sin, cos) = angle.sin_cos();
///     sin * sin + cos * cos
/// }
/// assert!((pythagoras(0.3_f64) - 1.0).abs() < 1e-15);
/// assert!(pythagoras(Dual::variable(0.3_f64)).derivative.abs() < 1e-15);
/// ```
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + Send
    + Sync
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + 'static
{
    /// The number nearest to `x`; derivatives are zero.
    fn from_f64(x: f64) -> Self;
    /// The value, without derivatives.
    fn to_f64(self) -> f64;
    /// √self.
    fn sqrt(self) -> Self;
    /// (sin self, cos self). That of f64 is in line, within 2 units in the last place, and the same on every machine that
    /// a build runs on, up to 2^20 in magnitude (a build for machines that fuse products with sums is faster, and differs in last
    /// bits); bundles of lanes may take it from [`sin_cos_lanes`](crate::sin_cos_lanes).
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the point (x, self), in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// e to the power of self.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// The inverse sine, in [−π/2, π/2].
    fn asin(self) -> Self;
    /// The inverse cosine, in [0, π].
    fn acos(self) -> Self;
    /// The inverse tangent, in (−π/2, π/2).
    fn atan(self) -> Self;
    /// The hyperbolic sine.
    fn sinh(self) -> Self;
    /// The hyperbolic cosine.
    fn cosh(self) -> Self;
    /// The hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Self to a real power.
    fn powf(self, exponent: Self) -> Self;
    /// The absolute value; its derivative is the sign.
    fn abs(self) -> Self;
    /// −1, 0 or 1; its derivative is zero.
    fn sign(self) -> Self;
    /// `negative` where self is below zero, else `other`; not a number where self is none, so that a condition without a
    /// value does not pass unseen. Each lane of a bundle selects for itself. Derivatives are those of the branch.
    ///
    /// ```
    /// use holonomy::{Dual, Scalar};
    ///
    /// assert_eq!((-2.0_f64).select(1.0, 5.0), 1.0);
    /// assert_eq!(0.0_f64.select(1.0, 5.0), 5.0);
    /// assert!(f64::NAN.select(1.0, 5.0).is_nan());
    /// let x = Dual::variable(3.0_f64);
    /// assert_eq!((x - Dual::constant(4.0)).select(x * x, x).derivative, 6.0);
    /// ```
    fn select(self, negative: Self, other: Self) -> Self;
    /// A function of the user's: `orders` holds it, its derivative, the second derivative and so on. What needs an order that
    /// is not there is not a number. Each lane of a bundle is computed for itself.
    ///
    /// ```
    /// use holonomy::{Dual, Scalar};
    ///
    /// let orders: [fn(f64) -> f64; 2] = [|x| x * x, |x| 2.0 * x];
    /// assert_eq!(3.0_f64.apply(&orders), 9.0);
    /// let x = Dual::variable(3.0_f64);
    /// assert_eq!((x.apply(&orders).value, x.apply(&orders).derivative), (9.0, 6.0));
    /// assert!(x.apply(&orders[1..]).derivative.is_nan());
    /// ```
    fn apply(self, orders: &[fn(f64) -> f64]) -> Self;
    /// Whether the value and all derivatives are finite.
    fn is_finite(self) -> bool;
}

/// Implements [`Scalar`] for a float type by the elementary functions of `$math`.
macro_rules! float_scalar {
    ($float:ty, $math:ident, $sin_cos:path, $from:expr, $to:expr) => {
        float_scalar!($float, $math, $sin_cos, $from, $to, [sqrt, exp, ln, asin, acos, atan, sinh, cosh, tanh]);
    };
    ($float:ty, $math:ident, $sin_cos:path, $from:expr, $to:expr, [$($unary:ident),*]) => {
        impl Scalar for $float {
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                $from(x)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                $to(self)
            }
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    $math::$unary(self)
                }
            )*
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                $math::atan2(self, x)
            }
            #[inline(always)]
            fn powf(self, exponent: Self) -> Self {
                $math::pow(self, exponent)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$float>::abs(self)
            }
            #[inline(always)]
            fn sign(self) -> Self {
                if self == 0.0 || self.is_nan() { self } else { self.signum() }
            }
            #[inline(always)]
            fn apply(self, orders: &[fn(f64) -> f64]) -> Self {
                match orders {
                    [function, ..] => $from(function($to(self))),
                    [] => <$float>::NAN,
                }
            }
            #[inline(always)]
            fn select(self, negative: Self, other: Self) -> Self {
                let chosen = if self < 0.0 { negative } else { other };
                if self.is_nan() { self } else { chosen }
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
        }
    };
}

float_scalar!(f64, double, math::sin_cos, |x: f64| x, |x: f64| x);
float_scalar!(f32, single, single::sin_cos, |x: f64| x as f32, f64::from);
