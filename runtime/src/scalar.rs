//! The numbers that the equations are evaluated over.

mod dual;

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::{double, single};

pub use dual::Dual;

/// A number type for the emitted equations: `f64`, `f32`, dual numbers, or a type of your own.
///
/// The emitted functions never compare and never branch, so a scalar may as well be a bundle of lanes.
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
    /// (sin self, cos self).
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the point (x, self), in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// e to the power of self.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// Whether the value and all derivatives are finite.
    fn is_finite(self) -> bool;
}

/// Implements [`Scalar`] for a float type by the elementary functions of `$math`.
macro_rules! float_scalar {
    ($float:ty, $math:ident, $from:expr, $to:expr) => {
        impl Scalar for $float {
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                $from(x)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                $to(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $math::sqrt(self)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $math::sin_cos(self)
            }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                $math::atan2(self, x)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                $math::exp(self)
            }
            #[inline(always)]
            fn ln(self) -> Self {
                $math::ln(self)
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
        }
    };
}

float_scalar!(f64, double, |x: f64| x, |x: f64| x);
float_scalar!(f32, single, |x: f64| x as f32, f64::from);
