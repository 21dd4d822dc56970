//! Numbers that know whether a function behind them lacks its derivative.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Scalar;

/// A value, whether it moves, and whether its derivative needs an order that one of the user's functions does not give.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub(crate) struct Orders {
    value: f64,
    moving: bool,
    pub(crate) lacking: bool,
}

impl Orders {
    pub(crate) fn still(value: f64) -> Self {
        Orders { value, moving: false, lacking: false }
    }

    pub(crate) fn moving(value: f64) -> Self {
        Orders { value, moving: true, lacking: false }
    }

    fn with(self, value: f64) -> Self {
        Orders { value, ..self }
    }

    fn and(self, other: Self, value: f64) -> Self {
        Orders { value, moving: self.moving || other.moving, lacking: self.lacking || other.lacking }
    }
}

impl Neg for Orders {
    type Output = Self;
    fn neg(self) -> Self {
        self.with(-self.value)
    }
}

macro_rules! binary {
    ($($operation:ident $method:ident),*) => {
        $(impl $operation for Orders {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.and(other, self.value.$method(other.value))
            }
        })*
    };
}
binary!(Add add, Sub sub, Mul mul, Div div);

macro_rules! unary {
    ($($method:ident),*) => {
        $(fn $method(self) -> Self {
            self.with(Scalar::$method(self.value))
        })*
    };
}

impl Scalar for Orders {
    unary!(sqrt, exp, ln, asin, acos, atan, sinh, cosh, tanh, abs, sign);

    fn from_f64(x: f64) -> Self {
        Orders::still(x)
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Scalar::sin_cos(self.value);
        (self.with(sin), self.with(cos))
    }
    fn atan2(self, x: Self) -> Self {
        self.and(x, Scalar::atan2(self.value, x.value))
    }
    fn powf(self, exponent: Self) -> Self {
        self.and(exponent, Scalar::powf(self.value, exponent.value))
    }
    fn select(self, negative: Self, other: Self) -> Self {
        match self.value {
            value if value.is_nan() => self,
            value if value < 0.0 => negative,
            _ => other,
        }
    }
    fn apply(self, orders: &[fn(f64) -> f64]) -> Self {
        Orders { lacking: self.lacking || self.moving && orders.len() < 2, ..self.with(self.value.apply(orders)) }
    }
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }
}
