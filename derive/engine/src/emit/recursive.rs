//! The functions of an open mechanism that was eliminated joint by joint, in terms of others: no program of theirs has M.

use super::functions::signature;
use super::shape::Types;
use super::target::{Target, ident};
use super::types::doc;
use crate::program::{Arguments, Shape};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// u̇ and v̇ out of the derivative, M column by column out of the momenta, h_u* out of h*.
pub fn functions(target: &Target, types: &Types) -> TokenStream {
    let krate = &target.krate;
    let known = &types.known;
    let (n, k) = (known.velocities.len(), known.reduced);
    let own = quote!(<Self as #krate::ConstrainedSystem>);
    let of = |name: &str, reads, shapes: &[Shape]| signature(target, types, name, None, reads, shapes);
    let field = |name: &String| ident(name, Span::call_site());
    let speeds: Vec<Ident> = types.state.fields[known.state_coordinates..].iter().map(field).collect();
    let velocities: Vec<Ident> = types.velocities.fields.iter().map(field).collect();
    let record = target.type_name("Velocities");
    let all: [(&str, Arguments, &[Shape], &str, TokenStream); 6] = [
        (
            "accelerations",
            Arguments::StateInputs,
            &[Shape::Array(speeds.len())],
            "u̇, found joint by joint with the derivative.",
            quote! {
                let (rate, _) = #own::derivative(p, t, s, i);
                [#(rate.#speeds),*]
            },
        ),
        (
            "velocity_rates",
            Arguments::StateInputs,
            &[Shape::Velocities],
            "v̇, found joint by joint with the derivative.",
            quote! {
                let (rate, _) = #own::derivative(p, t, s, i);
                #record { #(#velocities: rate.#speeds),* }
            },
        ),
        (
            "inertia",
            Arguments::Coordinates,
            &[Shape::Matrix(n, n)],
            "M of M v̇ = h* (2.3), column by column: the momenta of unit speeds.",
            quote!(#krate::__private::symmetric(|v| #own::momenta(p, t, at, v))),
        ),
        (
            "mass_matrix",
            Arguments::State,
            &[Shape::Matrix(k, k)],
            "M_d = M (4.10): nothing ties the speeds.",
            quote!(#own::inertia(p, t, &#own::coordinates(p, t, s))),
        ),
        (
            "forcing",
            Arguments::StateInputs,
            &[Shape::Array(k)],
            "h_u* = h* (4.10), (5.6): nothing ties the speeds.",
            quote! {
                let v = #own::forces(p, t, &#own::coordinates(p, t, s), &#own::velocities(p, t, s), i);
                [#(v.#velocities),*]
            },
        ),
        (
            "mass_matrix_and_forcing",
            Arguments::StateInputs,
            &[Shape::Matrix(k, k), Shape::Array(k)],
            "M_d and h_u* of M_d ν = h_u* (4.10), (5.6).",
            quote!((#own::mass_matrix(p, t, s), #own::forcing(p, t, s, i))),
        ),
    ];
    let functions = all.iter().map(|(name, reads, shapes, law, body)| {
        let (about, signature) = (doc(law), of(name, *reads, shapes));
        quote!(#about #signature { #body })
    });
    quote!(#(#functions)*)
}
