//! From tokens to declarations.
//!
//! [`parse`] reads a derive input and every statement on it. It resolves no name and computes
//! nothing; every node keeps its span. All errors are collected in [`Diagnostics`].

mod conditional;
mod declarations;
mod diagnostics;
mod entries;
mod expression;
mod families;
mod fields;
mod forms;
mod geometry;
mod integer;
mod joints;
mod nesting;
mod number;
mod options;
mod quaternions;
mod read;
mod refusal;
mod statements;
#[cfg(test)]
pub(crate) mod tests;

use proc_macro2::TokenStream;

pub use declarations::*;
pub use diagnostics::{Diagnostic, Diagnostics, Place, nearest};
pub(crate) use diagnostics::{did_you_mean, messages};
pub(crate) use expression::AXES;
pub use expression::{Comparison, Expression, Operator, Term};
pub use geometry::{BodyInertia, Element, ElementKind, Geometry};
pub(crate) use joints::{JOINTS, ROTATIONS, is_quaternion, names_a_joint};
pub use quaternions::{Quaternion, Speed};
pub use statements::{FIELD_STATEMENTS, STATEMENTS, helper_attributes};

/// Reads a derive input without an error.
///
/// # Errors
///
/// Everything that is wrong with the form of the input and of its statements.
pub fn parse(input: TokenStream) -> Result<Declarations, Diagnostics> {
    let (declarations, diagnostics) = read(input);
    match declarations {
        Some(declarations) => diagnostics.result(declarations),
        None => Err(diagnostics),
    }
}

/// Reads a derive input as far as it can be read. Declarations that are `complete` in spite of
/// errors can be checked further, so that all errors are reported at once; incomplete ones still
/// tell what an `impl` needs.
pub fn read(input: TokenStream) -> (Option<Declarations>, Diagnostics) {
    if let Err(error) = nesting::check_brackets(&input) {
        return (None, error.into());
    }
    match syn::parse2(input) {
        Ok(input) => {
            let mut diagnostics = Diagnostics::new();
            let declarations = read::declarations(input, &mut diagnostics);
            (Some(declarations), diagnostics)
        }
        Err(error) => (None, error.into()),
    }
}
