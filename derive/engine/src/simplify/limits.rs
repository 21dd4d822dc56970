//! The bounds of simplification, all in one place. They are counts: the same input stops at the same step everywhere.

/// Terms that a polynomial may grow to before expansion gives up.
pub const POLYNOMIAL_TERMS: usize = 600;
/// Products of terms that one expansion may form.
pub const POLYNOMIAL_WORK: usize = 4_000;
/// So many times the products of an expansion may exceed its bound before like terms are collected: what would exceed it
/// further is not begun.
pub const ALIKE: f64 = 4.0;
/// Products of terms that the expansions of a whole model may form.
pub const MODEL_WORK: usize = 60_000;
/// Products of terms that the projection of a whole model may form on its way.
pub const PROJECTION_WORK: usize = 300_000;
/// Expressions that run in one that the projection opens on its way: a larger one only grows, and is dearer as a sum of
/// many terms than as the products that it was made of.
pub const OPENED: usize = 60;
/// The same for the roots of a group, whose forms are compared with what went in.
pub const OPENED_TOGETHER: usize = 150;
/// Expressions that run in a sum with a form of its own, beyond which it is not opened again.
pub const SETTLED_ALONE: usize = 60;
/// The same for a sum whose form was found together with others, which it may share more with.
pub const SETTLED_TOGETHER: usize = 100;
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
/// Pairs of terms that are drawn together to the sine or cosine of a sum or difference.
pub const FOLDS: usize = 60;
/// E-nodes of one group of roots.
pub const GROUP_NODES: usize = 800;
/// Expressions that run in one group, below which the canonical forms leave nothing to find.
pub const GROUP_LEAST: usize = 10;
/// E-nodes of a whole model.
pub const MODEL_NODES: usize = 15_000;
/// Expressions that run in one group, before its e-graph is grown.
pub const GROUP_SEEDS: usize = 200;
/// Rounds of rules.
pub const ROUNDS: usize = 3;
/// Ways in which a term of a sum is read as a product.
pub const READINGS: usize = 3;
/// Passes of the extraction over all classes.
pub const EXTRACTION_PASSES: usize = 12;
/// Reciprocals and angles that the extraction tries to do without, in a group.
pub const EXTRACTION_BANS: usize = 8;
/// Choices that the extraction tries against all roots of a group.
pub const EXTRACTION_TRIALS: usize = 200;
/// Denominators and arguments of functions that are normalised on their own, in a model.
pub const INNER_FORMS: usize = 100;
/// Products of terms that are formed to find the factors of what the plain equations divide by.
pub const DIVISOR_WORK: usize = 10_000;
