//! Without a search for cheaper forms the derive gives the same types and the same names: a model may be switched over, and an editor
//! sees what the compiler sees.

mod random;
mod support;

use quote::ToTokens;
use random::first;
use std::fs;
use std::path::Path;
use support::{declared, parallel};

/// The structs that an expansion declares, and the associated types of its implementation.
fn types(tokens: proc_macro2::TokenStream, model: &str) -> Vec<String> {
    let file: syn::File = syn::parse2(tokens).unwrap_or_else(|e| panic!("{model}: {e}"));
    let mut found = Vec::new();
    let mut open = file.items;
    while let Some(item) = open.pop() {
        match item {
            syn::Item::Struct(item) => found.push(item.to_token_stream().to_string()),
            syn::Item::Impl(item) => {
                let types = item.items.iter().filter(|item| matches!(item, syn::ImplItem::Type(_)));
                found.extend(types.map(|item| item.to_token_stream().to_string()));
            }
            syn::Item::Const(item) => {
                // Everything may stand in one anonymous constant.
                if let syn::Expr::Block(block) = *item.expr {
                    open.extend(block.block.stmts.into_iter().filter_map(|statement| match statement {
                        syn::Stmt::Item(item) => Some(item),
                        _ => None,
                    }));
                }
            }
            _ => {}
        }
    }
    found
}

fn models() -> Vec<syn::ItemStruct> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models");
    let files = declared::rust_files(&folder).into_iter();
    let sources = files.map(|file| fs::read_to_string(file).expect("a text"));
    let generated = first(60, 61).into_iter().map(|model| model.source);
    sources.chain(generated).flat_map(|source| declared::models(&source)).collect()
}

#[test]
fn the_types_do_not_depend_on_the_search_for_cheaper_forms() {
    // As text: tokens stay in their thread.
    let models: Vec<String> = models().iter().map(|model| model.to_token_stream().to_string()).collect();
    parallel::each(models.len(), |number| {
        let model: syn::ItemStruct = syn::parse_str(&models[number]).expect("a struct");
        let name = model.ident.to_string();
        let [full, plain] = [holonomy_engine::expand, holonomy_engine::expand_plainly]
            .map(|expand| types(expand(model.to_token_stream()), &name));
        assert!(full.len() > 5, "{name}: {full:?}");
        // Prepared values are another matter: what parameters are combined to depends on the forms.
        let values = format!("{name}Values");
        let differ = full.iter().zip(&plain).find(|(a, b)| a != b && !a.contains(&values) && !a.contains("Guards"));
        assert!(full.len() == plain.len() && differ.is_none(), "{name}: {differ:?}");
    });
    assert!(models.len() > 100, "{}", models.len());
}
