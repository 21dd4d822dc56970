//! The emitted structs: named vectors over any scalar.

use super::shape::{Record, Types};
use super::target::{Declared, Target};
use crate::program::Programs;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The lints that emitted code may trip over without being wrong.
pub fn allowed() -> TokenStream {
    quote! {
        #[allow(
            clippy::all,
            clippy::nursery,
            clippy::pedantic,
            clippy::restriction,
            dead_code,
            non_camel_case_types,
            non_snake_case,
            unreachable_pub,
            unused_parens,
            unused_qualifications,
            unused_variables
        )]
    }
}

/// The structs, and the implementations that belong to them.
pub struct Structs {
    /// The structs.
    pub definitions: TokenStream,
    /// Their conversions and `Vector`.
    pub implementations: TokenStream,
}

/// All structs of the model with their conversions.
pub fn structs(target: &Target, types: &Types, programs: Option<&Programs>) -> Structs {
    let name = target.ident.to_string();
    let known = &types.known;
    let (mut definitions, mut implementations) = (TokenStream::new(), TokenStream::new());
    let coordinates = known.state_coordinates;
    let docs = |record: &Record, fallback: &dyn Fn(usize, &str) -> String| -> Vec<TokenStream> {
        record.names.iter().enumerate().map(|(i, n)| doc_of(target, n, &fallback(i, n))).collect()
    };
    let mut add = |record: &Record, about: String, fallback: &dyn Fn(usize, &str) -> String| {
        if !record.fields.is_empty() {
            definitions.extend(structure(target, record, &about, &docs(record, fallback)));
            implementations.extend(vector(target, record));
        }
    };
    add(&types.state, format!("The state of [`{name}`]: coordinates, then independent speeds."), &|i, n| {
        if i < coordinates { format!("Coordinate `{n}`.") } else { format!("Independent speed `{n}`.") }
    });
    add(&types.velocities, format!("The velocities v of [`{name}`], dependent ones included (5.3)."), &|_, n| {
        format!("Velocity `{n}`.")
    });
    add(&types.parameters, format!("The parameters of [`{name}`]."), &|_, n| format!("Parameter `{n}`."));
    add(&types.inputs, format!("The inputs of [`{name}`]."), &|_, n| format!("Input `{n}`."));
    if !types.multipliers.fields.is_empty() {
        let about = format!(
            "The multipliers λ of [`{name}`]: M v̇ = h* + Cᵀ λ (2.8), each the force that its constraint exerts on the system."
        );
        let fields: Vec<TokenStream> = types
            .multipliers
            .names
            .iter()
            .map(|n| docs_or(None, &format!("λ of the constraint `{n}`."), target.units.of_multiplier(n)))
            .collect();
        definitions.extend(structure(target, &types.multipliers, &about, &fields));
        implementations.extend(vector(target, &types.multipliers));
    }
    if !types.outputs.fields.is_empty() {
        let about = format!("The outputs of [`{name}`].");
        let fields: Vec<TokenStream> = types
            .outputs
            .names
            .iter()
            .map(|n| docs_or(target.output(n), &format!("Output `{n}`."), target.units.of_output(n)))
            .collect();
        definitions.extend(structure(target, &types.outputs, &about, &fields));
        implementations.extend(vector(target, &types.outputs));
    }
    if !types.values.fields.is_empty() {
        let about = format!("The parameters of [`{name}`] and the work that depends on them alone.");
        let texts = programs.map(|p| p.graph.display_all(&p.values.quantities));
        let fields: Vec<TokenStream> = (0..types.values.fields.len())
            .map(|i| match texts.as_ref().and_then(|t| t.get(i)) {
                Some(text) => doc(&format!("`{text}`")),
                None => doc("Prepared value."),
            })
            .collect();
        definitions.extend(structure(target, &types.values, &about, &fields));
    }
    Structs { definitions, implementations }
}

/// Structs of which no field is known, so that at least their names resolve.
pub fn placeholders(target: &Target, types: &Types) -> TokenStream {
    let all = [&types.state, &types.velocities, &types.multipliers, &types.parameters, &types.inputs, &types.outputs];
    let vis = &target.vis;
    let allowed = allowed();
    let about = doc("Its fields are unknown while the model has errors.");
    let structs = all.into_iter().filter(|record| record.fields.is_empty()).map(|record| {
        let name = target.type_name(record.suffix);
        quote! {
            #about
            #allowed
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
            #vis struct #name<T = f64>(::core::marker::PhantomData<T>);
        }
    });
    quote!(#(#structs)*)
}

/// A doc comment.
pub fn doc(text: &str) -> TokenStream {
    let text = Literal::string(&format!(" {text}"));
    quote!(#[doc = #text])
}

fn doc_of(target: &Target, name: &str, fallback: &str) -> TokenStream {
    docs_or(target.declared(name), fallback, target.units.of(name))
}

/// The docs of a name, and its unit where it is more than a number.
fn docs_or(declared: Option<&Declared>, fallback: &str, unit: Option<&str>) -> TokenStream {
    let unit = unit.filter(|unit| *unit != "1");
    match (declared, unit) {
        (Some(declared), unit) if !declared.docs.is_empty() => {
            let docs = &declared.docs;
            let unit = unit.map(|unit| {
                let unit = doc(&format!("In {unit}."));
                quote!(#[doc = ""] #unit)
            });
            quote!(#(#docs)* #unit)
        }
        (_, Some(unit)) => doc(&format!("{}, in {unit}.", fallback.trim_end_matches('.'))),
        _ => doc(fallback),
    }
}

fn structure(target: &Target, record: &Record, about: &str, docs: &[TokenStream]) -> TokenStream {
    let vis = &target.vis;
    let name = target.type_name(record.suffix);
    let fields = record.idents(target);
    let about = doc(about);
    let allowed = allowed();
    quote! {
        #about
        #allowed
        #[derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::default::Default,
            ::core::cmp::PartialEq
        )]
        #vis struct #name<T = f64> {
            #(#docs #vis #fields: T,)*
        }
    }
}

fn vector(target: &Target, record: &Record) -> TokenStream {
    let krate = &target.krate;
    let name = target.type_name(record.suffix);
    let fields = record.idents(target);
    let names = &record.names;
    let n = Literal::usize_unsuffixed(fields.len());
    let indices: Vec<Literal> = (0..fields.len()).map(Literal::usize_unsuffixed).collect();
    // Not the fields' names: a pattern named like a constant of the user's, `J` say, would compare with it.
    let entries: Vec<Ident> = (0..fields.len()).map(|i| format_ident!("entry_{i}")).collect();
    quote! {
        #[automatically_derived]
        impl<T> ::core::convert::From<[T; #n]> for #name<T> {
            #[inline]
            fn from([#(#entries),*]: [T; #n]) -> Self {
                #name { #(#fields: #entries),* }
            }
        }
        #[automatically_derived]
        impl<T> ::core::convert::From<#name<T>> for [T; #n] {
            #[inline]
            fn from(vector: #name<T>) -> Self {
                [#(vector.#fields),*]
            }
        }
        #[automatically_derived]
        impl<T: #krate::Scalar> #krate::Vector<T> for #name<T> {
            type Array = [T; #n];
            const NAMES: &'static [&'static str] = &[#(#names),*];
            #[inline]
            fn from_fn(mut f: impl ::core::ops::FnMut(usize) -> T) -> Self {
                #name { #(#fields: f(#indices)),* }
            }
        }
    }
}
