//! The emitted code as a file, formatted: what `cargo expand` shows of the models.

use std::path::Path;

/// Writes the expansion of every model in the source text.
pub fn write(models: &str, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let mut text = String::from("// The code that the derive emits for the models of this example.\n\n");
    for item in syn::parse_file(models)?.items {
        if let syn::Item::Struct(item) = item {
            let tokens = holonomy_engine::expand(quote::quote!(#item));
            let file = prettyplease_syn::parse_file(&tokens.to_string())?;
            text.push_str(&format!("// ---- {} ----\n\n{}\n", item.ident, prettyplease::unparse(&file)));
        }
    }
    std::fs::write(path, text)?;
    Ok(())
}
