//! Short vectors of a fixed length, with or without named entries.

use core::fmt::Debug;

use crate::Scalar;

/// A vector whose length is known to the compiler: a plain array, or a struct that names its entries (a model's state, say).
///
/// ```
/// use holonomy::Vector;
///
/// let squares = <[f64; 3] as Vector<f64>>::from_fn(|i| (i * i) as f64);
/// assert_eq!(squares, [0.0, 1.0, 4.0]);
/// assert_eq!(squares.get("x"), None); // arrays have no names
/// ```
pub trait Vector<T: Scalar>: Copy + Debug + PartialEq + From<Self::Array> + Into<Self::Array> {
    /// `[T; N]`.
    type Array: AsRef<[T]> + AsMut<[T]> + Copy;
    /// The names of the entries in their order; empty for plain arrays.
    const NAMES: &'static [&'static str];

    /// The vector with the entries f(0), f(1), …
    fn from_fn(f: impl FnMut(usize) -> T) -> Self;

    /// The entry of that name, if there is one.
    fn get(&self, name: &str) -> Option<T> {
        let at = Self::NAMES.iter().position(|entry| *entry == name)?;
        let array: Self::Array = (*self).into();
        array.as_ref().get(at).copied()
    }
}

impl<T: Scalar, const N: usize> Vector<T> for [T; N] {
    type Array = [T; N];
    const NAMES: &'static [&'static str] = &[];

    #[inline(always)]
    fn from_fn(f: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(f)
    }
}

/// The same vector over another scalar.
#[inline]
pub(crate) fn convert<T: Scalar, U: Scalar, V: Vector<T>, W: Vector<U>>(v: &V, f: impl Fn(usize, T) -> U) -> W {
    let array: V::Array = (*v).into();
    let entries = array.as_ref();
    W::from_fn(|i| f(i, entries[i]))
}

/// The entries of a vector as a function of their places.
#[inline]
pub(crate) fn entry<T: Scalar, V: Vector<T>>(v: &V) -> impl Fn(usize) -> T + use<T, V> {
    let array: V::Array = (*v).into();
    move |i| array.as_ref()[i]
}
