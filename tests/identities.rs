//! Identities between different statements of one mechanism: two stages and one, scaled constraints.
//!
//! A model in two stages has a configuration in front of its rows. Without that statement all rows are constraints of one stage:
//! v̇ and every λ must be the same, λ₁ of the first stage included, which (3.6) with h* alone would give wrong.

mod claims;
mod random;
mod support;

use claims::evaluated::{Evaluated, projected};
use claims::stages::difference;
use holonomy_engine::projection::Equations;
use oracle::{System, closed, onto_nonlinear_rows, read_models};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use random::{first, in_one_stage};
use std::path::Path;
use support::declared;
use support::splitmix::SplitMix;

/// A state on the constraints, by the equations of the model.
fn state(system: &System<'_>, equations: &Equations, random: &mut SplitMix) -> Option<(f64, Vec<f64>, Vec<f64>)> {
    let t = random.between(0.0, 2.0);
    let coordinate = |x: &String| match system.model.start.get(x) {
        Some(start) => start + random.between(-0.1, 0.1),
        None => random.between(0.2, 1.0),
    };
    let guess: Vec<f64> = system.model.state_coordinates().iter().map(coordinate).collect();
    let q = closed(system, t, &guess)?;
    let u = random.vector(equations.state_speeds.len(), -1.0, 1.0);
    let evaluated = Evaluated { equations, system };
    let x = system.coordinates(t, &q);
    let onto = |u: &[f64]| onto_nonlinear_rows(system, t, &x, u, |u| evaluated.velocities(t, &q, u));
    let u = if system.model.gives_velocities { u } else { onto(&u)? };
    Some((t, q, u))
}

#[test]
fn two_stages_are_one() {
    let mut random = SplitMix::new(12);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for (two, one) in first(1200, 31).iter().filter_map(|model| Some((model, in_one_stage(model)?))) {
        let declared = (read_models(&two.source).remove(0), read_models(&one.source).remove(0));
        let systems = (System::nominal(&declared.0), System::nominal(&declared.1));
        let equations = (projected(&two.source).expect(&two.source), projected(&one.source).expect(&one.source));
        let Some((t, q, u)) = (0..20).find_map(|_| state(&systems.0, &equations.0, &mut random)) else {
            panic!("{}: no state is reached\n{}", two.name, two.source)
        };
        let staged = Evaluated { equations: &equations.0, system: &systems.0 }.claim(t, &q, &u);
        // the same motion in the speeds that the one stage has chosen
        let names: Vec<&str> = equations.1.state_speeds.iter().map(|s| equations.1.graph.name(*s)).collect();
        let speed = |name: &&str| declared.1.speeds.iter().position(|v| v == name).map(|i| staged.velocities[i]);
        let speeds: Vec<f64> = names.iter().map(|name| speed(name).expect("a speed of the model")).collect();
        let whole = Evaluated { equations: &equations.1, system: &systems.1 }.claim(t, &staged.coordinates, &speeds);
        let place = || format!("{} at t = {t}, q = {q:?}, u = {u:?}\n{}", two.name, two.source);
        worst = worst.max(difference(&staged, &whole).unwrap_or_else(|text| panic!("{text} in {}", place())));
        compared += 1;
    }
    println!("{compared} systems in two stages and in one, largest difference {worst:.1e}");
    assert!(compared >= 100, "{compared} systems");
}

/// The struct with every constraint multiplied by its factor.
fn scaled(source: &str, factor: impl Fn(usize) -> f64) -> String {
    let mut item: syn::ItemStruct = syn::parse_str(source).expect("a struct");
    let constraints = item.attrs.iter_mut().filter(|a| a.path().is_ident("constraint"));
    for (i, attribute) in constraints.enumerate() {
        let factor = proc_macro2::Literal::f64_unsuffixed(factor(i));
        let multiplied = |input: syn::parse::ParseStream<'_>| -> syn::Result<TokenStream> {
            // a name, or an entry of a family of them
            let name: syn::Ident = input.parse()?;
            let index: Option<proc_macro2::Group> =
                if input.peek(syn::Token![:]) { None } else { Some(input.parse()?) };
            input.parse::<syn::Token![:]>()?;
            let equation: syn::ExprBinary = input.parse()?;
            let rest: TokenStream = input.parse()?;
            let (left, right) = (equation.left, equation.right);
            Ok(quote!(#name #index: #factor*(#left) == #factor*(#right) #rest))
        };
        let tokens = attribute.parse_args_with(multiplied).expect("a constraint");
        *attribute = syn::parse_quote!(#[constraint(#tokens)]);
    }
    item.to_token_stream().to_string()
}

/// Scaling constraints by s divides λ by s and leaves the motion: for one factor, and for one of each row where each carries its λ.
fn scales(source: &str, random: &mut SplitMix) {
    let declared = read_models(source).remove(0);
    if declared.constraints.is_empty() {
        return;
    }
    let mut system = System::nominal(&declared);
    system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
    let equations = projected(source).expect(source);
    let Some((t, q, u)) = (0..40).find_map(|_| state(&system, &equations, random)) else {
        panic!("{}: no state is reached", declared.name)
    };
    let claim = Evaluated { equations: &equations, system: &system }.claim(t, &q, &u);
    // rows of one statement have one factor
    let item: syn::ItemStruct = syn::parse_str(source).expect("a struct");
    let statements = item.attrs.iter().filter(|a| a.path().is_ident("constraint")).count();
    let single = statements == declared.constraints.len();
    let own = single
        && claim.multipliers.iter().all(|m| m.row.is_some())
        && !declared.constraints.iter().any(|c| c.redundant);
    let factor = |i: usize| if own { 0.4 + 0.7 * i as f64 } else { 2.5 };
    let other = scaled(source, factor);
    let equations = projected(&other).expect(&other);
    let other = Evaluated { equations: &equations, system: &system }.claim(t, &q, &u);
    // undone, nothing is left of the factors
    let mut undone = other;
    for multiplier in &mut undone.multipliers {
        let i = declared.constraints.iter().position(|c| c.name == multiplier.name).expect("a declared row");
        multiplier.value *= factor(i);
    }
    difference(&claim, &undone).unwrap_or_else(|text| panic!("{text} in {}", declared.name));
}

#[test]
fn scaled_constraints_divide_their_multipliers() {
    let mut random = SplitMix::new(13);
    for model in first(240, 41) {
        scales(&model.source, &mut random);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for file in declared::rust_files(&root.join("tests/models")) {
        let text = std::fs::read_to_string(file).expect("a text");
        for item in syn::parse_file(&text).expect("Rust").items {
            let syn::Item::Struct(mut item) = item else { continue };
            item.fields.iter_mut().for_each(with_a_value);
            scales(&item.to_token_stream().to_string(), &mut random);
        }
    }
}

/// A parameter without a nominal value gets one for the oracle, behind the derive's back.
fn with_a_value(field: &mut syn::Field) {
    if !field.attrs.iter().any(|a| a.path().is_ident("nominal")) {
        field.attrs.push(syn::parse_quote!(#[nominal(1)]));
    }
}
