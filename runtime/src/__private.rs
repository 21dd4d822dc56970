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

/// D M Dᵀ by what M makes of vectors.
pub fn projected<T: Scalar, V: Vector<T>, const K: usize, const N: usize>(
    d: &SMatrix<T, K, N>,
    of: impl Fn(&V) -> V,
) -> SMatrix<T, K, K> {
    let mut matrix = SMatrix::from_fn(|_, _| T::from_f64(0.0));
    for j in 0..K {
        let column: V::Array = of(&V::from_fn(|i| d[(j, i)])).into();
        for i in j..K {
            let value = along(d, i, column.as_ref());
            matrix[(i, j)] = value;
            matrix[(j, i)] = value;
        }
    }
    matrix
}

/// −D r: what forces along the independent speeds are left where the rates at hand need r.
pub fn left<T: Scalar, V: Vector<T>, const K: usize, const N: usize>(d: &SMatrix<T, K, N>, needed: &V) -> [T; K] {
    let needed: V::Array = (*needed).into();
    array::from_fn(|i| -along(d, i, needed.as_ref()))
}

/// The i-th entry of D r.
fn along<T: Scalar, const K: usize, const N: usize>(d: &SMatrix<T, K, N>, i: usize, r: &[T]) -> T {
    r.iter().enumerate().fold(T::from_f64(0.0), |sum, (j, r)| sum + d[(i, j)] * *r)
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
