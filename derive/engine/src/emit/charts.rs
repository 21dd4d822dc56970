//! The trait's functions of charts: each chooses among the charts' own functions.
//!
//! A model with one chart has only `chart_speeds`; the trait provides the others by the model's own functions.

use super::functions::signature;
use super::shape::Types;
use super::target::Target;
use super::types::doc;
use crate::program::entry::chart_function;
use crate::program::{Arguments, Shape};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// `chart_speeds`, and beyond one chart `chart_derivative` and `chart_velocities`.
pub fn chosen(target: &Target, types: &Types) -> TokenStream {
    let known = &types.known;
    let k = known.state.len().saturating_sub(known.state_coordinates);
    let mut functions = Vec::new();
    let own = |at: usize, what: &str| Ident::new(&chart_function(at, what), Span::call_site());
    let first = own(0, "speeds");
    let speeds = match_chart(1..known.charts, &own, "speeds", &quote!(p, t, s, v), quote!(#first(p, t, s, v)));
    functions.push((
        "chart_speeds",
        Arguments::StateVelocities,
        vec![Shape::Array(k)],
        "u of a chart from v and the state's coordinates (5.2).",
        speeds,
    ));
    if known.charts > 1 {
        let guards = (0..known.chart_guards).map(|i| {
            let (at, scalar) = (Literal::usize_unsuffixed(i), &types.scalar);
            if i < known.guards { quote!(guards[#at]) } else { quote!(#scalar::from_f64(1.0)) }
        });
        let derivative = trait_function(target, "derivative");
        let first = quote!({
            let (rate, guards) = #derivative(p, t, s, i);
            (rate, [#(#guards),*])
        });
        functions.push((
            "chart_derivative",
            Arguments::StateInputs,
            vec![Shape::State, Shape::Array(known.chart_guards)],
            "The state's rate where its speeds are those of a chart, and the chart's guards.",
            match_chart(1..known.charts, &own, "derivative", &quote!(p, t, s, i), first),
        ));
        let velocities = trait_function(target, "velocities");
        functions.push((
            "chart_velocities",
            Arguments::State,
            vec![Shape::Velocities],
            "v of the state where its speeds are those of a chart.",
            match_chart(1..known.charts, &own, "velocities", &quote!(p, t, s), quote!(#velocities(p, t, s))),
        ));
    }
    let functions = functions.into_iter().map(|(name, reads, shapes, law, body)| {
        let signature = signature(target, types, name, Some("chart"), reads, &shapes);
        let law = doc(law);
        quote!(#law #signature { #body })
    });
    quote!(#(#functions)*)
}

fn trait_function(target: &Target, name: &str) -> TokenStream {
    let (krate, name) = (&target.krate, Ident::new(name, Span::call_site()));
    quote!(<Self as #krate::ConstrainedSystem>::#name)
}

fn match_chart(
    charts: std::ops::Range<usize>,
    own: &dyn Fn(usize, &str) -> Ident,
    what: &str,
    arguments: &TokenStream,
    first: TokenStream,
) -> TokenStream {
    if charts.is_empty() {
        return first;
    }
    let arms = charts.map(|at| {
        let (number, function) = (Literal::usize_unsuffixed(at), own(at, what));
        quote!(#number => #function(#arguments),)
    });
    quote! {
        match chart {
            #(#arms)*
            _ => #first,
        }
    }
}
