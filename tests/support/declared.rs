//! The models that source files declare.

use std::path::{Path, PathBuf};

/// The Rust files of a folder, in order.
pub fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder is there").map(|entry| entry.expect("an entry").path());
    let mut files: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|e| e == "rs")).collect();
    files.sort();
    files
}

/// The structs of a source that have statements, as the derive gets them: without the `derive` itself.
pub fn models(source: &str) -> Vec<syn::ItemStruct> {
    let items = syn::parse_file(source).expect("the models are Rust").items;
    let structs = items.into_iter().filter_map(|item| match item {
        syn::Item::Struct(mut item) => {
            item.attrs.retain(|a| !a.path().is_ident("derive"));
            Some(item)
        }
        _ => None,
    });
    structs.filter(|item| item.attrs.iter().any(|a| a.path().is_ident("coordinates"))).collect()
}
