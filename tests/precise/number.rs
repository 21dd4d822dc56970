//! The numbers that a program runs over: doubles as the emitted code has them, and long floats.

use dashu_float::round::mode::HalfEven;
use dashu_float::{DBig, FBig};
use holonomy::Scalar;
use holonomy_engine::symbolic::Rational;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the reference models' programs ask of a number.
pub trait Number:
    Clone + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Exactly this double.
    fn from_double(x: f64) -> Self;
    /// The nearest to n/d.
    fn from_rational(number: &Rational) -> Self;
    /// √self.
    fn root(&self) -> Self;
    /// (sin self, cos self).
    fn turn(&self) -> (Self, Self);
}

impl Number for f64 {
    fn from_double(x: f64) -> Self {
        x
    }
    fn from_rational(number: &Rational) -> Self {
        number.to_f64()
    }
    fn root(&self) -> Self {
        Scalar::sqrt(*self)
    }
    fn turn(&self) -> (Self, Self) {
        Scalar::sin_cos(*self)
    }
}

/// The bits of a [`Big`]: 77 digits, so that 50 are left where 27 cancel.
pub const BITS: usize = 256;

type Float = FBig<HalfEven, 2>;

/// A float of [`BITS`] bits. All operations of the library are rounded correctly, sines and cosines too.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Big(Float);

impl Big {
    fn rounded(float: Float) -> Self {
        Self(float.with_precision(BITS).value())
    }

    /// The nearest to what decimal digits spell.
    ///
    /// # Panics
    /// If the text is no number.
    pub fn from_digits(text: &str) -> Self {
        let decimal: DBig = text.parse().expect("digits");
        Self(decimal.with_base_and_precision::<2>(BITS).value().with_rounding())
    }

    /// The nearest double.
    pub fn to_double(&self) -> f64 {
        self.0.to_f64().value()
    }
}

impl Number for Big {
    fn from_double(x: f64) -> Self {
        Self::rounded(Float::try_from(x).expect("a finite number"))
    }
    fn from_rational(number: &Rational) -> Self {
        let (n, d) = number.parts();
        Self::from_digits(&n) / Self::from_digits(&d)
    }
    fn root(&self) -> Self {
        Self(self.0.sqrt())
    }
    fn turn(&self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }
}

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! binary {
    ($($operation:ident $method:ident),*) => {
        $(impl $operation for Big {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })*
    };
}
binary!(Add add, Sub sub, Mul mul, Div div);
