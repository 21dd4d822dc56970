//! The bounds of simplification, all in one place. They are counts: the same input stops at the same step everywhere.

/// Terms that a polynomial may grow to before expansion gives up.
pub const POLYNOMIAL_TERMS: usize = 600;
/// Products of terms that one expansion may form.
pub const POLYNOMIAL_WORK: usize = 4_000;
/// The highest power of a sum that is expanded.
pub const EXPANDED_POWER: i32 = 8;
/// How deep sums in denominators of sums are taken apart.
pub const NESTED_DENOMINATORS: usize = 12;
/// Terms, with parameter-only coefficients collected, beyond which a polynomial is written as a plain sum.
pub const FACTORED_TERMS: usize = 120;
/// Terms of a sum that is made a factor. The arena opens sums of at most as many when it scales them.
pub const FACTOR_TERMS: usize = 32;
/// Depth of nesting that factoring goes to.
pub const FACTORED_DEPTH: usize = 24;
/// Trigonometric forms of one numerator that are compared.
pub const NUMERATOR_FORMS: usize = 4;
