//! Reading whole inputs, and every error at its token.

mod errors;
mod reading;

use super::{Declarations, Diagnostics, read};

/// Every error as ``line:column `culprit`: message``, where the culprit is the source between the
/// error's first token and its last.
pub(crate) fn rendered(source: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let offset = |position: proc_macro2::LineColumn| {
        let line = source.split_inclusive('\n').take(position.line - 1);
        let before: usize = line.map(str::len).sum();
        let rest = source[before..].chars().take(position.column);
        before + rest.map(char::len_utf8).sum::<usize>()
    };
    diagnostics
        .iter()
        .map(|error| {
            let (start, end) = (error.place.start.start(), error.place.end.end());
            let culprit = &source[offset(start)..offset(end)];
            let column = start.column + 1;
            format!("{}:{column} `{culprit}`: {}", start.line, error.message)
        })
        .collect()
}

/// The declarations of an input without errors.
pub(crate) fn declarations(source: &str) -> Declarations {
    match super::parse(source.parse().unwrap()) {
        Ok(declarations) => declarations,
        Err(errors) => panic!("{:#?}", rendered(source, &errors)),
    }
}

/// The errors of an input.
fn errors(source: &str) -> Vec<String> {
    let (_, diagnostics) = read(source.parse().unwrap());
    rendered(source, &diagnostics)
}
