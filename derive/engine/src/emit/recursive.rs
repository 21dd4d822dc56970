//! The functions of a tree that was eliminated joint by joint, in terms of others: no program of theirs has M.

use super::functions::signature;
use super::shape::Types;
use super::target::{Target, ident};
use super::types::doc;
use crate::program::{Arguments, Shape};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// A function, what it reads and returns, its law and its body.
type Told = (&'static str, Arguments, Vec<Shape>, &'static str, TokenStream);

/// u̇ out of the derivative, M column by column out of the momenta; of what else has M in it, what follows from these.
pub fn functions(target: &Target, types: &Types) -> TokenStream {
    let krate = &target.krate;
    let known = &types.known;
    let (n, k) = (known.velocities.len(), known.reduced);
    let own = quote!(<Self as #krate::ConstrainedSystem>);
    let state = &types.state.fields[known.state_coordinates..];
    let speeds = fields(state);
    let mut all: Vec<Told> = vec![
        (
            "accelerations",
            Arguments::StateInputs,
            vec![Shape::Array(speeds.len())],
            "u̇, found joint by joint with the derivative.",
            quote! {
                let (rate, _) = #own::derivative(p, t, s, i);
                [#(rate.#speeds),*]
            },
        ),
        (
            "inertia",
            Arguments::Coordinates,
            vec![Shape::Matrix(n, n)],
            "M of M v̇ = h* (2.3), column by column: the momenta of unit speeds.",
            quote!(#krate::__private::symmetric(|v| #own::momenta(p, t, at, v))),
        ),
        (
            "mass_matrix_and_forcing",
            Arguments::StateInputs,
            vec![Shape::Matrix(k, k), Shape::Array(k)],
            "M_d and h_u* of M_d ν = h_u* (4.10), (5.6).",
            quote!((#own::mass_matrix(p, t, s), #own::forcing(p, t, s, i))),
        ),
    ];
    all.extend(match state == types.velocities.fields.as_slice() {
        true => untied(target, types, &own),
        false => tied(types, &quote!(#krate), &own),
    });
    let functions = all.iter().map(|(name, reads, shapes, law, body)| {
        let (about, signature) = (doc(law), signature(target, types, name, None, *reads, shapes));
        quote!(#about #signature { #body })
    });
    quote!(#(#functions)*)
}

/// Where nothing ties the speeds, and D is the unit matrix.
fn untied(target: &Target, types: &Types, own: &TokenStream) -> Vec<Told> {
    let k = types.known.reduced;
    let speeds = fields(&types.state.fields[types.known.state_coordinates..]);
    let velocities = fields(&types.velocities.fields);
    let record = target.type_name("Velocities");
    vec![
        (
            "velocity_rates",
            Arguments::StateInputs,
            vec![Shape::Velocities],
            "v̇, found joint by joint with the derivative.",
            quote! {
                let (rate, _) = #own::derivative(p, t, s, i);
                #record { #(#velocities: rate.#speeds),* }
            },
        ),
        (
            "mass_matrix",
            Arguments::State,
            vec![Shape::Matrix(k, k)],
            "M_d = M (4.10): nothing ties the speeds.",
            quote!(#own::inertia(p, t, &#own::coordinates(p, t, s))),
        ),
        (
            "forcing",
            Arguments::StateInputs,
            vec![Shape::Array(k)],
            "h_u* = h* (4.10), (5.6): nothing ties the speeds.",
            quote! {
                let v = #own::forces(p, t, &#own::coordinates(p, t, s), &#own::velocities(p, t, s), i);
                [#(v.#velocities),*]
            },
        ),
    ]
}

/// Where rows tie the speeds.
fn tied(types: &Types, krate: &TokenStream, own: &TokenStream) -> Vec<Told> {
    let k = types.known.reduced;
    vec![
        (
            "mass_matrix",
            Arguments::State,
            vec![Shape::Matrix(k, k)],
            "M_d = D M Dᵀ (4.10), column by column: the momenta of each row of D.",
            quote! {
                let at = #own::coordinates(p, t, s);
                #krate::__private::projected(&#own::complement(p, t, s), |v| #own::momenta(p, t, &at, v))
            },
        ),
        (
            "forcing",
            Arguments::StateInputs,
            vec![Shape::Array(k)],
            "h_u* = D (h* − M a_u) (4.10), (5.6): what the rates a_u leave of the forces.",
            quote! {
                let (at, v) = (#own::coordinates(p, t, s), #own::velocities(p, t, s));
                let needed = #own::inverse_dynamics(p, t, &at, &v, &#own::complement_bias(p, t, s), i);
                #krate::__private::left(&#own::complement(p, t, s), &needed)
            },
        ),
    ]
}

fn fields(names: &[String]) -> Vec<Ident> {
    names.iter().map(|name| ident(name, Span::call_site())).collect()
}
