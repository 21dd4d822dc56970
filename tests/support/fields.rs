//! Fields of a model from a list of numbers.

/// A number, or an array of numbers.
pub trait Field {
    /// Takes what it needs.
    ///
    /// # Panics
    /// If the list ends before.
    fn take(numbers: &mut impl Iterator<Item = f64>) -> Self;
}

impl Field for f64 {
    fn take(numbers: &mut impl Iterator<Item = f64>) -> Self {
        numbers.next().expect("a parameter")
    }
}

impl<const N: usize> Field for [f64; N] {
    fn take(numbers: &mut impl Iterator<Item = f64>) -> Self {
        std::array::from_fn(|_| f64::take(numbers))
    }
}
