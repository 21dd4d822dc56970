//! Reading declared models from Rust source text.

use super::declaration::{Constraint, Declaration, Level};
use super::families::{element, integer};
use super::quaternions;
use super::statements;
use super::system::{System, lift};
use crate::splitmix::SplitMix;
use std::collections::{BTreeMap, BTreeSet};
use syn::punctuated::Punctuated;
use syn::visit::Visit;
use syn::{Attribute, Expr, Fields, Item, ItemStruct, Token, Type};

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
    for attribute in item.attrs.iter().filter(|a| a.path().is_ident("size")) {
        statements::sizes(&mut model, attribute).unwrap_or_else(|e| panic!("{}: #[size]: {e}", item.ident));
    }
    for attribute in &item.attrs {
        let Some(name) = attribute.path().get_ident().map(ToString::to_string) else {
            continue;
        };
        statements::read(&mut model, &name, attribute).unwrap_or_else(|e| panic!("{}: #[{name}]: {e}", item.ident));
    }
    complete(&mut model);
    model
}

/// Fields of numbers, and of arrays of numbers, whose entries have one nominal value in common or one each.
fn read_fields(model: &mut Declaration, fields: &Fields) {
    for field in fields {
        let Some(name) = &field.ident else { continue };
        let number = |ty: &Type| matches!(ty, Type::Path(path) if path.path.is_ident("f64"));
        let names = match &field.ty {
            Type::Array(array) if number(&array.elem) => {
                let length = integer(&array.len, &BTreeMap::new());
                (0..length).map(|i| element(name, i)).collect()
            }
            ty if number(ty) => vec![name.to_string()],
            _ => continue,
        };
        let nominal = field.attrs.iter().find(|a| a.path().is_ident("nominal"));
        let values = |a: &Attribute| a.parse_args_with(Punctuated::<Expr, Token![,]>::parse_terminated);
        let values =
            nominal.map(|a| values(a).expect("nominal values").iter().map(statements::number).collect::<Vec<_>>());
        let of = |i: usize| values.as_ref().map(|values| if values.len() == 1 { values[0] } else { values[i] });
        model.parameters.extend(names.into_iter().enumerate().map(|(i, name)| (name, of(i))));
    }
}

/// What follows from all statements together: default speeds, the order of the kinematics, q, the level of each constraint.
fn complete(model: &mut Declaration) {
    quaternions::complete(model);
    if model.speeds.is_empty() {
        model.speeds = model.coordinates.iter().map(|x| format!("dot_{x}")).collect();
    }
    if let Some(configuration) = &mut model.configuration {
        let free = model.coordinates.iter().filter(|x| !configuration.map.contains_key(*x));
        let further = std::mem::take(&mut configuration.coordinates);
        configuration.coordinates = free.cloned().chain(further).collect();
    }
    let components = by_components(model);
    model.constraints = components.iter().map(|(constraint, _)| constraint.clone()).collect();
    let levels: Vec<Level> = model.constraints.iter().map(|c| level(model, &[&c.left, &c.right])).collect();
    for (constraint, level) in model.constraints.iter_mut().zip(levels) {
        constraint.level = level;
    }
    let kept: Vec<bool> =
        components.iter().enumerate().map(|(row, (_, component))| !component || !vanishes(model, row)).collect();
    let mut kept = kept.iter();
    model.constraints.retain(|_| *kept.next().expect("one for each row"));
}

/// Every constraint, a vector equation by its three components; each with whether it is one of these.
fn by_components(model: &Declaration) -> Vec<(Constraint, bool)> {
    let component = |row: &Constraint, axis: &str| {
        let frame = &row.expressed;
        let axis = syn::Ident::new(axis, proc_macro2::Span::call_site());
        let along = |side: &Expr| match side {
            Expr::Lit(_) => side.clone(),
            side => syn::parse_quote!(dot(#side, #frame.#axis)),
        };
        Constraint {
            name: format!("{}_{axis}", row.name),
            left: along(&row.left),
            right: along(&row.right),
            ..row.clone()
        }
    };
    let vector = |e: &Expr| model.geometry.is_vector(e, &model.definitions);
    let rows = |row: &Constraint| match vector(&row.left) || vector(&row.right) {
        true => ["x", "y", "z"].map(|axis| (component(row, axis), true)).to_vec(),
        false => vec![(row.clone(), row.in_short)],
    };
    model.constraints.iter().flat_map(rows).collect()
}

/// Whether a row is zero for all parameters and states: at a few random ones.
fn vanishes(model: &Declaration, row: usize) -> bool {
    let mut random = SplitMix::new(row as u64);
    (0..4).all(|_| {
        let parameters = random.vector(model.parameters.len(), 0.5, 1.5);
        let system = System { model, parameters, inputs: random.vector(model.inputs.len(), -1.0, 1.0) };
        let mut point = |n: usize| lift(&random.vector(n, -1.0, 1.0));
        let (t, x, v, vdot) = (point(1)[0], point(model.coordinates.len()), point(model.n()), point(model.n()));
        let residual = match model.constraints[row].level {
            Level::Position => system.position(row, t, &x),
            Level::Velocity => system.velocity(row, t, &x, &v),
            Level::Acceleration => {
                let scope = system.accelerated(t, &x, &v, &vdot);
                scope.value(&model.constraints[row].left) - scope.value(&model.constraints[row].right)
            }
        };
        residual.value.abs() <= 1e-12 * residual.size
    })
}

fn level(model: &Declaration, sides: &[&Expr]) -> Level {
    let mut open: Vec<&Expr> = sides.to_vec();
    let (mut names, mut level) = (BTreeSet::new(), Level::Position);
    while let Some(e) = open.pop() {
        let mut mentions = Mentions { model, names: BTreeSet::new(), velocities: false, accelerations: false };
        mentions.visit_expr(e);
        level = match level {
            _ if mentions.accelerations => Level::Acceleration,
            Level::Position if mentions.velocities => Level::Velocity,
            level => level,
        };
        let new = mentions.names.into_iter().filter(|name| names.insert(name.clone()));
        open.extend(new.collect::<Vec<_>>().iter().filter_map(|name| model.definitions.get(name)));
    }
    level
}

/// What an expression mentions.
struct Mentions<'a> {
    model: &'a Declaration,
    names: BTreeSet<String>,
    velocities: bool,
    accelerations: bool,
}

impl<'a> Visit<'a> for Mentions<'_> {
    fn visit_expr(&mut self, e: &'a Expr) {
        let speed = |name: &String| self.model.speeds.contains(name);
        let rate = statements::rate_of(e);
        let function = match e {
            Expr::Call(call) => statements::plain(&call.func).map(|name| (name, call.args.len())),
            _ => None,
        };
        match function.as_ref().map(|(name, count)| (name.as_str(), *count)) {
            Some(("velocity" | "angular_velocity" | "momentum" | "angular_momentum", _)) => self.velocities = true,
            Some(("acceleration" | "angular_acceleration", _)) => self.accelerations = true,
            // of a definition or an expression
            Some(("dot", 1)) if rate.is_none() => self.velocities = true,
            _ => {}
        }
        if statements::second_rate_of(e).is_some() || rate.as_ref().is_some_and(speed) {
            self.accelerations = true;
        } else if rate.is_some() || statements::plain(e).as_ref().is_some_and(speed) {
            self.velocities = true;
        }
        syn::visit::visit_expr(self, e);
    }

    fn visit_ident(&mut self, ident: &'a syn::Ident) {
        self.names.insert(ident.to_string());
    }
}
