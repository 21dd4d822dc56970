//! `MODEL`, and the derived equations as text.

use super::shape::Types;
use super::target::Target;
use crate::program::{Count, Programs};
use crate::projection::{Equations, Guard, GuardKind, Level, OutputFacts};
use crate::symbolic::{Expr, Matrix};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

/// The equations as text: function, symbol, number in the paper, right side.
#[derive(Clone, Debug, Default)]
pub struct Texts {
    lines: Vec<(&'static str, String, &'static str, String)>,
}

struct Collector<'a> {
    equations: &'a Equations,
    texts: BTreeMap<Expr, String>,
    lines: Vec<(&'static str, String, &'static str, String)>,
}

impl Collector<'_> {
    fn text(&self, e: Expr) -> String {
        self.texts.get(&e).cloned().unwrap_or_default()
    }

    fn each(&mut self, function: &'static str, source: &'static str, symbols: Vec<String>, roots: &[Expr]) {
        for (symbol, root) in symbols.into_iter().zip(roots) {
            self.lines.push((function, symbol, source, self.text(*root)));
        }
    }

    fn list(&mut self, function: &'static str, symbol: &str, source: &'static str, roots: &[Expr]) {
        let entries: Vec<String> = roots.iter().map(|e| self.text(*e)).collect();
        self.lines.push((function, symbol.to_owned(), source, format!("[{}]", entries.join(", "))));
    }

    fn matrix(&mut self, function: &'static str, symbol: &str, source: &'static str, matrix: &Matrix) {
        let row = |i: usize| matrix.row(i).iter().map(|e| self.text(*e)).collect::<Vec<_>>().join(", ");
        let rows: Vec<String> = (0..matrix.rows()).map(|i| format!("[{}]", row(i))).collect();
        self.lines.push((function, symbol.to_owned(), source, format!("[{}]", rows.join(", "))));
    }

    fn dots(&self, symbols: &[crate::symbolic::Symbol]) -> Vec<String> {
        symbols.iter().map(|s| format!("dot({})", self.equations.graph.name(*s))).collect()
    }
}

impl Texts {
    /// All equations of the model.
    pub fn new(e: &Equations) -> Self {
        let mut roots: Vec<Expr> = crate::program::entry::entries(e).iter().flat_map(|entry| entry.roots()).collect();
        roots.extend(e.chart_speeds.iter().flatten().filter(|_| e.combined));
        let texts = roots.iter().copied().zip(e.graph.display_all(&roots)).collect();
        let mut c = Collector { equations: e, texts, lines: Vec::new() };
        let configured = e.state_coordinates != e.coordinates;
        let names = |symbols: &[crate::symbolic::Symbol]| -> Vec<String> {
            symbols.iter().map(|s| e.graph.name(*s).to_owned()).collect()
        };
        // Section 4 of the paper where x = g(q, t) is given, section 5 otherwise.
        let number = |holonomic, otherwise| if configured { holonomic } else { otherwise };
        c.each("derivative", number("(4.3)", "(5.7)"), c.dots(&e.state_coordinates), &e.coordinate_rates);
        c.each("accelerations", number("(4.10)", "(5.6)"), c.dots(&e.state_speeds), &e.accelerations);
        c.matrix("mass_matrix", "M_d", "(4.10)", &e.mass_matrix);
        c.list("forcing", "h_u*", number("(4.10)", "(5.6)"), &e.forcing);
        if configured {
            c.each("coordinates", "(4.2)", names(&e.coordinates), &e.initial_coordinates);
        }
        if e.combined {
            // What the names of combinations stand for.
            c.each("chart_0_speeds", "(5.2)", names(&e.state_speeds), &e.chart_speeds[0]);
        }
        c.each("velocities", number("(4.4)", "(5.3)"), names(&e.speeds), &e.velocities);
        c.matrix("complement", "D", number("(4.9)", "(3.1)"), &e.complement);
        c.list("complement_bias", "a_u", number("(4.5)", "(5.5)"), &e.complement_bias);
        c.each("velocity_rates", number("(4.5)", "(5.5)"), c.dots(&e.speeds), &e.velocity_rates);
        let lambdas = e.multiplier_names.iter().map(|n| format!("lambda({n})")).collect();
        c.each("multipliers", "(3.6)", lambdas, &e.multipliers);
        c.matrix("kinematic_matrix", "A", "(2.1)", &e.kinematic_matrix);
        c.list("kinematic_bias", "a0", "(2.1)", &e.kinematic_bias);
        c.matrix("inertia", "M", "(2.3)", &e.inertia);
        c.list("forces", "h*", "(2.3)", &e.forces);
        c.matrix("constraint_matrix", "C", "(2.4)", &e.constraint_matrix);
        c.list("constraint_bias", "c0*", "(2.6)", &e.constraint_bias);
        let residuals = e.position_names.iter().map(|n| format!("f({n})")).collect();
        c.each("position_residual", "(2.5)", residuals, &e.position_residual);
        let residuals = e.velocity_row_names().iter().map(|n| format!("phi({n})")).collect();
        c.each("velocity_residual", "(2.5)", residuals, &e.velocity_residual);
        c.each("kinetic_energy", "", vec!["T".to_owned()], &[e.kinetic_energy]);
        let potential: Vec<Expr> = e.potential_energy.into_iter().collect();
        c.each("potential_energy", "", vec!["V".to_owned()], &potential);
        c.each("outputs", "", e.outputs.names.clone(), &e.outputs.values);
        Texts { lines: c.lines }
    }

    /// Symbol, number in the paper and right side of what a function computes.
    pub fn of(&self, function: &str) -> Vec<(&str, &str, &str)> {
        let shown: &[&str] = match function {
            "derivative" => &["derivative", "accelerations"],
            "mass_matrix_and_forcing" => &["mass_matrix", "forcing"],
            _ => &[function],
        };
        self.lines.iter().filter(|l| shown.contains(&l.0)).map(|l| (l.1.as_str(), l.2, l.3.as_str())).collect()
    }
}

/// The constant that describes the model.
pub fn model(target: &Target, types: &Types, equations: &Equations, programs: &Programs, texts: &Texts) -> TokenStream {
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
    let lines = texts
        .lines
        .iter()
        .map(|(_, symbol, source, text)| quote!(#krate::Equation { symbol: #symbol, source: #source, text: #text }));
    let costs = programs
        .functions
        .iter()
        .chain(&programs.charts)
        .map(|p| (p.entry.name.as_str(), &p.count))
        .chain([("values", &programs.values.count)]);
    let costs = costs.map(|(name, count)| cost(target, name, count));
    let outputs = e.outputs.names.iter().zip(e.output_facts()).map(|(name, facts)| output(target, name, &facts));
    let defines = &target.defines;
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
