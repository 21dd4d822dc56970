//! What emitted code needs besides the public traits. Not for users: it changes without notice.

pub use core::clone::Clone;
pub use core::convert::{From, Into};
pub use core::default::Default;
pub use core::fmt::Debug;
pub use core::marker::Copy;
pub use core::ops::FnMut;
pub use core::option::Option::{self, None, Some};
pub use core::result::Result::{self, Err, Ok};
pub use core::{array, unreachable};
pub use nalgebra::SMatrix;

use crate::{Error, GuardInfo, GuardKind, Scalar, Vector};

/// The unit matrix.
pub fn unit<T: Scalar, const N: usize>() -> SMatrix<T, N, N> {
    SMatrix::from_fn(|i, j| T::from_f64(if i == j { 1.0 } else { 0.0 }))
}

/// A symmetric matrix by what it makes of unit vectors.
pub fn symmetric<T: Scalar, V: Vector<T>, const N: usize>(of: impl Fn(&V) -> V) -> SMatrix<T, N, N> {
    let mut matrix = SMatrix::from_fn(|_, _| T::from_f64(0.0));
    for j in 0..N {
        let column: V::Array = of(&V::from_fn(|i| T::from_f64(if i == j { 1.0 } else { 0.0 }))).into();
        for (i, value) in column.as_ref().iter().enumerate().skip(j) {
            matrix[(i, j)] = *value;
            matrix[(j, i)] = *value;
        }
    }
    matrix
}

/// Every parameter must be finite.
pub fn check_parameters<T: Scalar>(names: &[&'static str], values: &[T]) -> Result<(), Error> {
    for (name, value) in names.iter().zip(values) {
        if !value.is_finite() {
            return Err(Error::NonFinite { name });
        }
    }
    Ok(())
}

/// A pivot of the parameters must not vanish, a positive guard must be positive.
pub fn check_parameter_guards<T: Scalar>(guards: &[GuardInfo], values: &[T]) -> Result<(), Error> {
    for (guard, figure) in guards.iter().zip(values) {
        let value = figure.to_f64();
        if !figure.is_finite() {
            return Err(Error::NonFinite { name: guard.name });
        }
        match guard.kind {
            GuardKind::Positive if value <= 0.0 => {
                return Err(Error::Indefinite { pivot: guard.name, value, time: None });
            }
            GuardKind::Pivot if value == 0.0 => {
                return Err(Error::SingularParameter { guard: guard.name, origin: guard.origin });
            }
            _ => {}
        }
    }
    Ok(())
}
