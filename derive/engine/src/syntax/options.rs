//! `#[holonomy(crate = path, simplify = off, elimination = recursive)]`

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::Path;
use syn::parse::Parser;

use super::declarations::{Elimination, Options};
use super::diagnostics::{Diagnostics, did_you_mean, messages, nearest};
use super::entries::Entry;

const OPTIONS: [&str; 3] = ["crate", "simplify", "elimination"];

/// `::holonomy`
pub(crate) fn default_crate(span: Span) -> Path {
    Path {
        leading_colon: Some(syn::token::PathSep { spans: [span, span] }),
        segments: std::iter::once(syn::PathSegment::from(Ident::new("holonomy", span))).collect(),
    }
}

pub(crate) fn read(entries: &[Entry], options: &mut Options, diagnostics: &mut Diagnostics) {
    let mut seen: Vec<String> = Vec::new();
    for entry in entries {
        let form = "crate = path`, `simplify = off` or `elimination = recursive";
        let Some((left, equals, right)) = entry.assignment(form, diagnostics) else {
            continue;
        };
        let [TokenTree::Ident(name)] = left else {
            diagnostics.report_local(entry.place(), messages::assignment_expected(form));
            continue;
        };
        let text = name.to_string();
        if seen.contains(&text) {
            diagnostics.report_local(name, messages::option_twice(name));
            continue;
        }
        match text.as_str() {
            "crate" => match path(right) {
                Some(path) => options.krate = path,
                None => diagnostics.report_local(place(right, equals), messages::option_crate()),
            },
            "simplify" => match right {
                [TokenTree::Ident(value)] if value == "off" => options.simplify = false,
                [TokenTree::Ident(value)] if value == "on" => options.simplify = true,
                _ => diagnostics.report_local(place(right, equals), messages::option_simplify()),
            },
            "elimination" => match right {
                [TokenTree::Ident(value)] if value == "matrix" => {
                    options.elimination = Some((Elimination::Matrix, value.span()));
                }
                [TokenTree::Ident(value)] if value == "recursive" => {
                    options.elimination = Some((Elimination::Recursive, value.span()));
                }
                _ => diagnostics.report_local(place(right, equals), messages::option_elimination()),
            },
            _ => {
                let meant = did_you_mean(nearest(&text, OPTIONS));
                diagnostics.report_local(name, messages::option_unknown(name, meant));
            }
        }
        seen.push(text);
    }
}

/// A path as in `use`: no generic arguments, so nothing that nests.
fn path(tokens: &[TokenTree]) -> Option<Path> {
    let tokens: TokenStream = tokens.iter().cloned().collect();
    Path::parse_mod_style.parse2(tokens).ok()
}

fn place(tokens: &[TokenTree], before: Span) -> Span {
    tokens.first().map_or(before, TokenTree::span)
}
