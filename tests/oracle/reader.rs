//! Reading declared models from Rust source text.

use super::declaration::{Declaration, Level};
use super::statements;
use std::collections::BTreeSet;
use syn::visit::Visit;
use syn::{Attribute, Expr, Fields, Item, ItemStruct, Type};

/// Every struct of the text that derives `ConstrainedSystem`.
///
/// # Panics
/// On text that is no Rust or a statement that cannot be read: a test that declares such a model is wrong.
pub fn read_models(source: &str) -> Vec<Declaration> {
    let file = syn::parse_file(source).expect("the models must be Rust");
    file.items
        .iter()
        .filter_map(|item| match item {
            Item::Struct(item) if derives(&item.attrs) => Some(read(item)),
            _ => None,
        })
        .collect()
}

fn derives(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|a| {
        a.path().is_ident("derive")
            && matches!(&a.meta, syn::Meta::List(list) if list.tokens.to_string().contains("ConstrainedSystem"))
    })
}

fn read(item: &ItemStruct) -> Declaration {
    let mut model = Declaration { name: item.ident.to_string(), ..Declaration::default() };
    read_fields(&mut model, &item.fields);
    for attribute in &item.attrs {
        let Some(name) = attribute.path().get_ident().map(ToString::to_string) else {
            continue;
        };
        statements::read(&mut model, &name, attribute).unwrap_or_else(|e| panic!("{}: #[{name}]: {e}", item.ident));
    }
    complete(&mut model);
    model
}

fn read_fields(model: &mut Declaration, fields: &Fields) {
    for field in fields {
        let (Some(name), Type::Path(path)) = (&field.ident, &field.ty) else {
            continue;
        };
        if !path.path.is_ident("f64") {
            continue;
        }
        let nominal = field.attrs.iter().find(|a| a.path().is_ident("nominal"));
        let nominal = nominal.map(|a| statements::number(&a.parse_args::<Expr>().expect("a nominal value")));
        model.parameters.push((name.to_string(), nominal));
    }
}

/// What follows from all statements together: default speeds, the order of the kinematics, q, the level of each constraint.
fn complete(model: &mut Declaration) {
    if model.speeds.is_empty() {
        model.speeds = model.coordinates.iter().map(|x| format!("dot_{x}")).collect();
    }
    if let Some(configuration) = &mut model.configuration {
        let free = model.coordinates.iter().filter(|x| !configuration.map.contains_key(*x));
        let further = std::mem::take(&mut configuration.coordinates);
        configuration.coordinates = free.cloned().chain(further).collect();
    }
    let levels: Vec<Level> = model.constraints.iter().map(|c| level(model, &[&c.left, &c.right])).collect();
    for (constraint, level) in model.constraints.iter_mut().zip(levels) {
        constraint.level = level;
    }
}

fn level(model: &Declaration, sides: &[&Expr]) -> Level {
    let mut names = Names::default();
    sides.iter().for_each(|side| names.visit_expr(side));
    let mut open: Vec<String> = names.0.iter().cloned().collect();
    let mut all = names.0;
    while let Some(name) = open.pop() {
        let Some(definition) = model.definitions.get(&name) else {
            continue;
        };
        let mut more = Names::default();
        more.visit_expr(definition);
        open.extend(more.0.iter().filter(|n| all.insert((*n).clone())).cloned().collect::<Vec<_>>());
    }
    let moving = all.contains("dot") || model.speeds.iter().any(|v| all.contains(v));
    if moving { Level::Velocity } else { Level::Position }
}

/// The names in an expression, called functions included.
#[derive(Default)]
struct Names(BTreeSet<String>);

impl<'a> Visit<'a> for Names {
    fn visit_ident(&mut self, ident: &'a syn::Ident) {
        self.0.insert(ident.to_string());
    }
}
