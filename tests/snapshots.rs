//! The expansion of three models of the textbooks, as text to be read: the functions of the equations of motion and of the reactions, with
//! their documentation.
//!
//! The texts stand in `data/snapshots`. `HOLONOMY_BLESS=1` writes them anew: a change of a form or of a name is then read as text.

mod support;

use quote::ToTokens;
use std::fs;
use std::path::Path;
use support::declared::models;
use support::kept;

/// The models, by file.
const READ: [(&str, &str); 3] = [
    ("examples/rolling_disk/models.rs", "RollingDisk"),
    ("tests/models/particles.rs", "DoublePendulum"),
    ("tests/models/blades.rs", "Sleigh"),
];

/// What a reader of the paper looks for.
const FUNCTIONS: [&str; 6] =
    ["derivative", "mass_matrix_and_forcing", "velocities", "complement", "multipliers", "constraint_matrix"];

/// Lines of equations that a person reads at a sitting.
const LINES: usize = 150;

/// The functions of the implementation, formatted as `cargo expand` shows them.
fn expansion(model: &syn::ItemStruct) -> String {
    let tokens = holonomy_engine::expand(model.to_token_stream());
    let mut file = prettyplease_syn::parse_file(&tokens.to_string()).expect("the expansion is Rust");
    file.items.retain_mut(|item| match item {
        prettyplease_syn::Item::Const(item) => {
            if let prettyplease_syn::Expr::Block(block) = item.expr.as_mut() {
                item.attrs.clear();
                block.block.stmts.retain_mut(|statement| match statement {
                    prettyplease_syn::Stmt::Item(prettyplease_syn::Item::Impl(item)) => {
                        item.items.retain(|item| match item {
                            prettyplease_syn::ImplItem::Fn(f) => FUNCTIONS.contains(&f.sig.ident.to_string().as_str()),
                            _ => false,
                        });
                        !item.items.is_empty()
                    }
                    _ => false,
                });
            }
            true
        }
        _ => false,
    });
    prettyplease::unparse(&file)
}

/// Lines of code: neither documentation nor signatures, nor what only packs and closes.
fn equations(text: &str) -> usize {
    let code = text.lines().map(str::trim).filter(|line| !line.starts_with("///") && !line.starts_with("#["));
    code.filter(|line| line.contains([';', ':', '*', '+', '/']) && !line.starts_with("fn ")).count()
}

#[test]
fn expansions_are_as_they_were_read() {
    let top = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut changed = Vec::new();
    for (file, name) in READ {
        let source = fs::read_to_string(top.join(file)).expect("the file can be read");
        let model = models(&source).into_iter().find(|model| model.ident == name).expect("the model is there");
        let text = expansion(&model);
        for function in FUNCTIONS {
            assert!(text.contains(&format!("fn {function}<")), "{name} has no {function}");
        }
        let lines = equations(&text);
        println!("{name}: {lines} lines of equations");
        assert!(lines < LINES, "{name} has {lines} lines of equations");
        changed.extend(kept::changed(&top.join("tests/data/snapshots").join(format!("{name}.txt")), &text));
    }
    assert!(changed.is_empty(), "{}", changed.join("\n"));
}
