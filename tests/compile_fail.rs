//! Models that make no sense, and what the derive says about them: every message, at its place.
//!
//! Each `data/compile_fail/*.rs` is one struct with its statements; the `.stderr` beside it lists the errors in the order in
//! which they are emitted, `line:column..line:column message`. `HOLONOMY_BLESS=1` writes the `.stderr` files anew. Only our own
//! errors are compared, so the files do not depend on the version of rustc.

use proc_macro2::{LineColumn, TokenStream, TokenTree};
use quote::ToTokens;
use std::fs;
use std::path::{Path, PathBuf};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/compile_fail");

/// The cases that there must be at least.
const REQUIRED: [&str; 13] = [
    "unknown_name",
    "duplicate_name",
    "caret",
    "wrong_lengths",
    "inertia_not_symmetric",
    "kinematics_not_linear",
    "kinematics_not_invertible",
    "constraint_without_variable",
    "dependent_rows",
    "complement_not_orthogonal",
    "wrong_number_of_speeds",
    "unknown_statement",
    "two_errors_at_once",
];

fn cases() -> Vec<PathBuf> {
    let entries = fs::read_dir(FOLDER).expect("the folder is there").map(|entry| entry.expect("an entry").path());
    let mut cases: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|e| e == "rs")).collect();
    cases.sort();
    cases
}

/// What the derive emits for the only struct of a file, places counted in that file.
fn expanded(case: &Path) -> TokenStream {
    let source = fs::read_to_string(case).expect("the case can be read");
    let item: syn::ItemStruct = syn::parse_str(&source).unwrap_or_else(|e| panic!("{}: {e}", case.display()));
    holonomy_engine::expand(item.into_token_stream())
}

/// Every `compile_error!` in the tokens, as text.
fn errors(tokens: TokenStream) -> Vec<String> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = Vec::new();
    for (i, tree) in trees.iter().enumerate() {
        match (tree, trees.get(i + 1), trees.get(i + 2)) {
            (TokenTree::Ident(name), Some(TokenTree::Punct(_)), Some(TokenTree::Group(group)))
                if name == "compile_error" =>
            {
                let message: syn::LitStr = syn::parse2(group.stream()).expect("a message");
                let place = |at: LineColumn| format!("{}:{}", at.line, at.column + 1);
                let (start, end) = (place(name.span().start()), place(group.span_close().end()));
                found.push(format!("{start}..{end} {}", message.value()));
            }
            (TokenTree::Group(group), _, _) => found.extend(errors(group.stream())),
            _ => {}
        }
    }
    found
}

#[test]
fn every_message_is_at_its_place() {
    let mut failures = Vec::new();
    for case in cases() {
        let said: String = errors(expanded(&case)).iter().map(|error| format!("{error}\n")).collect();
        let expected = case.with_extension("stderr");
        if std::env::var_os("HOLONOMY_BLESS").is_some() {
            fs::write(&expected, &said).expect("the messages are written");
        }
        let name = case.file_stem().expect("a name").to_string_lossy();
        let committed = fs::read_to_string(&expected).unwrap_or_default();
        if said.is_empty() {
            failures.push(format!("{name}: accepted"));
        } else if said != committed {
            failures.push(format!("{name}:\n{said}instead of\n{committed}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_required_cases_are_there() {
    let names: Vec<String> =
        cases().iter().map(|case| case.file_stem().expect("a name").to_string_lossy().into_owned()).collect();
    for required in REQUIRED {
        assert!(names.iter().any(|name| name == required), "{required}");
    }
}

/// Beside the errors there is an implementation, so that code which uses the model brings no errors of its own.
#[test]
fn an_implementation_is_emitted_all_the_same() {
    for case in cases() {
        let tokens = expanded(&case);
        let file: Result<syn::File, _> = syn::parse2(tokens.clone());
        assert!(file.is_ok(), "{} does not parse", case.display());
        assert!(tokens.to_string().contains(":: ConstrainedSystem for"), "{}", case.display());
    }
}
