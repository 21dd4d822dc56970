//! `MODEL`.

use super::equations::Texts;
use super::shape::Types;
use super::target::Target;
use crate::program::{Count, Programs};
use crate::projection::{Equations, Guard, GuardKind, Level, OutputFacts};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// The constant that describes the model.
pub fn model(
    target: &Target,
    types: &Types,
    equations: &Equations,
    programs: &Programs,
    texts: &Texts<'_>,
) -> TokenStream {
    let krate = &target.krate;
    let e = equations;
    let known = &types.known;
    let (q, u) = known.state.split_at(known.state_coordinates);
    let (x, v, parameters, inputs) = (&known.coordinates, &known.velocities, &known.parameters, &known.inputs);
    let rows = e.rows.iter().map(|row| {
        let level = level(row.level);
        let (name, linear, redundant) = (&row.name, row.linear, row.redundant);
        quote! {
            #krate::RowInfo { name: #name, level: #krate::Level::#level, linear: #linear, redundant: #redundant }
        }
    });
    let reduced = e.reduced_speeds.iter().map(|s| e.graph.name(*s));
    let multipliers = e.multiplier_names.iter().zip(&e.multiplier_rows).map(|(name, row)| {
        let row = match row {
            Some(row) => {
                let row = Literal::usize_unsuffixed(*row);
                quote!(::core::option::Option::Some(#row))
            }
            None => quote!(::core::option::Option::None),
        };
        quote!(#krate::MultiplierInfo { name: #name, row: #row })
    });
    let guards: Vec<TokenStream> = e.guards.iter().map(|g| guard(target, g)).collect();
    let pivot = |at: usize| e.relative_pivots.get(at).copied().flatten();
    let first = chart(target, u, &guards, pivot(0));
    let charts = e.charts.iter().enumerate().map(|(at, further)| {
        let speeds: Vec<&str> = further.speeds.iter().map(|s| e.graph.name(*s)).collect();
        let guards: Vec<TokenStream> = further.guards.iter().map(|g| guard(target, g)).collect();
        chart(target, &speeds, &guards, pivot(at + 1))
    });
    let carriers = &known.carriers;
    let parameter_guards = programs.values.guards.iter().map(|g| guard(target, g));
    let lines = texts.model();
    let lines = lines.iter().map(|line| {
        let (symbol, function, source, text) = (&line.symbol, line.function, line.source, &line.text);
        quote!(#krate::Equation { symbol: #symbol, function: #function, source: #source, text: #text })
    });
    let costs = programs
        .functions
        .iter()
        .chain(&programs.charts)
        .map(|p| (p.entry.name.as_str(), &p.count))
        .chain([("values", &programs.values.count)]);
    let costs = costs.map(|(name, count)| cost(target, name, count));
    let outputs = e.outputs.names.iter().zip(e.output_facts()).map(|(name, facts)| output(target, name, &facts));
    let defines = &target.defines;
    let units = units(target, types);
    let positions = &e.position_names;
    let notes = &e.notes;
    let name = target.ident.to_string();
    quote! {
        &#krate::Description {
            name: #name,
            coordinates: &[#(#x),*],
            state_coordinates: &[#(#q),*],
            state_speeds: &[#(#u),*],
            reduced_speeds: &[#(#reduced),*],
            velocities: &[#(#v),*],
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            units: &[#(#units),*],
            outputs: &[#(#outputs),*],
            defines: &[#(#defines),*],
            rows: &[#(#rows),*],
            position_rows: &[#(#positions),*],
            multipliers: &[#(#multipliers),*],
            guards: &[#(#guards),*],
            parameter_guards: &[#(#parameter_guards),*],
            charts: &[#first, #(#charts),*],
            carriers: &[#(#carriers),*],
            notes: &[#(#notes),*],
            equations: &[#(#lines),*],
            operations: &[#(#costs),*],
        }
    }
}

/// The units that are known, kind by kind.
fn units(target: &Target, types: &Types) -> Vec<TokenStream> {
    let krate = &target.krate;
    let known = &types.known;
    let mut entries = Vec::new();
    let mut add = |kind: &str, names: &[String], unit: &dyn Fn(&str) -> Option<String>| {
        let kind = Ident::new(kind, Span::call_site());
        for name in names {
            if let Some(unit) = unit(name) {
                entries.push(quote!(#krate::UnitInfo { kind: #krate::UnitKind::#kind, name: #name, unit: #unit }));
            }
        }
    };
    let named = |name: &str| target.units.of(name).map(str::to_owned);
    let (q, u) = known.state.split_at(known.state_coordinates);
    let others = |all: &[String], more: &[String]| -> Vec<String> {
        let further = more.iter().filter(|name| !all.contains(name));
        all.iter().chain(further).cloned().collect()
    };
    add("Parameter", &known.parameters, &named);
    add("Coordinate", &others(&known.coordinates, q), &named);
    add("Speed", &others(&known.velocities, u), &named);
    add("Input", &known.inputs, &named);
    add("Output", &known.outputs, &|name| target.units.of_output(name).map(str::to_owned));
    add("Multiplier", &known.multipliers, &|name| target.units.of_multiplier(name).map(str::to_owned));
    entries
}

fn level(level: Level) -> TokenStream {
    match level {
        Level::Position => quote!(Position),
        Level::Velocity => quote!(Velocity),
        Level::Acceleration => quote!(Acceleration),
    }
}

fn output(target: &Target, name: &str, facts: &OutputFacts) -> TokenStream {
    let krate = &target.krate;
    let (level, inputs, divisors) = (level(facts.level), facts.inputs, &facts.divisors);
    quote! {
        #krate::OutputInfo { name: #name, level: #krate::Level::#level, inputs: #inputs, divisors: &[#(#divisors),*] }
    }
}

/// The constant of a model with errors: names, and nothing else.
pub fn bare(target: &Target, types: &Types) -> TokenStream {
    let krate = &target.krate;
    let known = &types.known;
    let (q, u) = known.state.split_at(known.state_coordinates.min(known.state.len()));
    let (x, v, parameters, inputs) = (&known.coordinates, &known.velocities, &known.parameters, &known.inputs);
    let name = target.ident.to_string();
    quote! {
        &#krate::Description {
            name: #name,
            coordinates: &[#(#x),*],
            state_coordinates: &[#(#q),*],
            state_speeds: &[#(#u),*],
            reduced_speeds: &[],
            velocities: &[#(#v),*],
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            units: &[],
            outputs: &[],
            defines: &[],
            rows: &[],
            position_rows: &[],
            multipliers: &[],
            guards: &[],
            parameter_guards: &[],
            charts: &[],
            carriers: &[],
            notes: &[],
            equations: &[],
            operations: &[],
        }
    }
}

fn chart<S: AsRef<str>>(target: &Target, speeds: &[S], guards: &[TokenStream], pivot: Option<f64>) -> TokenStream {
    let krate = &target.krate;
    let speeds = speeds.iter().map(AsRef::as_ref);
    let pivot = figure(pivot);
    quote!(#krate::ChartInfo { speeds: &[#(#speeds),*], guards: &[#(#guards),*], relative_pivot: #pivot })
}

/// A number that may not be known.
fn figure(value: Option<f64>) -> TokenStream {
    match value {
        Some(value) => {
            let (sign, size) = ((value < 0.0).then(|| quote!(-)), Literal::f64_unsuffixed(value.abs()));
            quote!(::core::option::Option::Some(#sign #size))
        }
        None => quote!(::core::option::Option::None),
    }
}

fn guard(target: &Target, guard: &Guard) -> TokenStream {
    let krate = &target.krate;
    let (name, origin, rows) = (&guard.name, &guard.origin, &guard.rows);
    let kind = match guard.kind {
        GuardKind::Pivot => quote!(Pivot),
        GuardKind::Positive => quote!(Positive),
    };
    let start = figure(guard.start);
    quote! {
        #krate::GuardInfo {
            name: #name,
            kind: #krate::GuardKind::#kind,
            origin: #origin,
            rows: &[#(#rows),*],
            start: #start,
        }
    }
}

fn cost(target: &Target, function: &str, count: &Count) -> TokenStream {
    let krate = &target.krate;
    let n = Literal::usize_unsuffixed;
    let (additions, multiplications) = (n(count.additions), n(count.multiplications));
    let (divisions, roots) = (n(count.divisions), n(count.roots));
    let (sincos, selections, others) = (n(count.sincos), n(count.selections), n(count.others));
    quote! {
        #krate::FunctionCost {
            function: #function,
            additions: #additions,
            multiplications: #multiplications,
            divisions: #divisions,
            roots: #roots,
            sincos: #sincos,
            selections: #selections,
            others: #others,
        }
    }
}
