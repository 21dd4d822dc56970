//! The functions of the trait.

use super::equations::Texts;
use super::shape::Types;
use super::target::Target;
use super::text::Writer;
use super::types::doc;
use crate::program::{Arguments, Count, Program, Programs, Shape};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

/// One function of the trait, and the private functions that a very large one is split into.
pub struct Emitted {
    /// The function.
    pub function: TokenStream,
    /// Private functions.
    pub parts: TokenStream,
}

/// The arguments of a function behind `p` and `t`.
fn arguments(target: &Target, types: &Types, arguments: Arguments) -> Vec<(Ident, TokenStream)> {
    let scalar = &types.scalar;
    let t = quote!(#scalar);
    let name = |name: &str| Ident::new(name, Span::call_site());
    let state = || (name("s"), types.of(target, &types.state, &t));
    let inputs = || (name("i"), types.of(target, &types.inputs, &t));
    let velocities = || (name("v"), types.of(target, &types.velocities, &t));
    let n = Literal::usize_unsuffixed(types.known.coordinates.len());
    let coordinates = || (name("at"), quote!([#t; #n]));
    let w = Literal::usize_unsuffixed(types.known.carriers.len());
    let carriers = || (name("w"), quote!([#t; #w]));
    match arguments {
        Arguments::State | Arguments::Chart(_) => vec![state()],
        Arguments::StateInputs | Arguments::ChartInputs(_) => vec![state(), inputs()],
        Arguments::StateVelocities => vec![state(), velocities()],
        Arguments::StateCarriers => vec![state(), carriers()],
        Arguments::StateCarriersRates => {
            let rates = (name("dw"), carriers().1);
            let multipliers = (name("lambda"), types.of(target, &types.multipliers, &t));
            vec![state(), carriers(), rates, multipliers, inputs()]
        }
        Arguments::Coordinates => vec![coordinates()],
        Arguments::CoordinatesVelocities => vec![coordinates(), velocities()],
        Arguments::CoordinatesVelocitiesRatesInputs => {
            vec![coordinates(), velocities(), (name("dv"), velocities().1), inputs()]
        }
        Arguments::CoordinatesVelocitiesInputs => vec![coordinates(), velocities(), inputs()],
        Arguments::Parameters => Vec::new(),
    }
}

/// The function's signature up to its body; `chart` names a first argument of that kind.
pub fn signature(
    target: &Target,
    types: &Types,
    name: &str,
    chart: Option<&str>,
    reads: Arguments,
    outputs: &[Shape],
) -> TokenStream {
    let (krate, scalar) = (&target.krate, &types.scalar);
    let name = Ident::new(name, Span::call_site());
    let values = types.of(target, &types.values, &quote!(#scalar));
    let arguments = arguments(target, types, reads).into_iter().map(|(name, ty)| quote!(#name: &#ty));
    let outputs: Vec<TokenStream> = outputs.iter().map(|shape| types.output(target, *shape)).collect();
    let output = match outputs.as_slice() {
        [one] => quote!(#one),
        many => quote!((#(#many),*)),
    };
    let chart = chart.map(|chart| {
        let chart = Ident::new(chart, Span::call_site());
        quote!(#chart: usize,)
    });
    quote!(fn #name<#scalar: #krate::Scalar>(#chart p: &#values, t: #scalar, #(#arguments),*) -> #output)
}

/// The function with its doc comment.
pub fn function(target: &Target, types: &Types, programs: &Programs, program: &Program, texts: &Texts<'_>) -> Emitted {
    let entry = &program.entry;
    let shapes: Vec<Shape> = entry.outputs.iter().map(|o| o.shape).collect();
    let signature = signature(target, types, &entry.name, None, entry.arguments, &shapes);
    let scalar = types.scalar.to_string();
    let writer = Writer { code: &program.code, layout: &program.layout, names: &programs.names, scalar: &scalar };
    let (last, earlier) = program.layout.parts.split_last().expect("a program has a part");
    let mut body = String::new();
    let mut parts = TokenStream::new();
    let called = arguments(target, types, entry.arguments);
    let called: Vec<String> =
        ["p", "t"].into_iter().map(str::to_owned).chain(called.iter().map(|(n, _)| n.to_string())).collect();
    for (k, part) in earlier.iter().enumerate() {
        let name = format_ident!("{}_{}", entry.name, k + 1);
        let leave = &program.layout.parts[k + 1].enter;
        let own = if part.enter.is_empty() { "" } else { ", part" };
        body.push_str(&format!("let part = {name}({}{own});\n", called.join(", ")));
        let list: Vec<String> = leave.iter().map(|r| writer.expression(*r)).collect();
        let text = format!("{}{}[{}]", writer.arrays(entry.arguments), writer.part(part), list.join(", "));
        parts.extend(part_function(target, types, entry.arguments, &name, part.enter.len(), leave.len(), &text));
    }
    body.push_str(&writer.arrays(entry.arguments));
    body.push_str(&writer.part(last));
    let krate = &target.krate;
    let mut at = 0;
    let packed: Vec<String> = entry
        .outputs
        .iter()
        .map(|output| {
            let from = at;
            at += output.roots.len();
            let record = match output.shape {
                Shape::State => Some(&types.state),
                Shape::Velocities => Some(&types.velocities),
                Shape::Multipliers => Some(&types.multipliers),
                Shape::Outputs => Some(&types.outputs),
                _ => None,
            };
            let outputs = &program.code.outputs[from..at];
            if writer.is_unit(output.shape, outputs) {
                return format!("{}::__private::unit()", quote!(#krate));
            }
            let name = record.map(|r| target.type_name(r.suffix).to_string()).unwrap_or_default();
            let record = record.map(|r| (name.as_str(), r.fields.as_slice()));
            writer.pack(output.shape, outputs, record)
        })
        .collect();
    match packed.as_slice() {
        [one] => body.push_str(one),
        many => body.push_str(&format!("({})", many.join(", "))),
    }
    let body = tokens(&body);
    let docs = docs(&entry.name, entry.law, &program.count, Some(texts));
    let inline = program.inline.then(|| quote!(#[inline]));
    Emitted { function: quote!(#docs #inline #signature { #body }), parts }
}

fn part_function(
    target: &Target,
    types: &Types,
    reads: Arguments,
    name: &Ident,
    enter: usize,
    leave: usize,
    text: &str,
) -> TokenStream {
    let (krate, scalar) = (&target.krate, &types.scalar);
    let values = types.of(target, &types.values, &quote!(#scalar));
    let arguments = arguments(target, types, reads).into_iter().map(|(name, ty)| quote!(#name: &#ty));
    let (enter, leave) = (Literal::usize_unsuffixed(enter), Literal::usize_unsuffixed(leave));
    let part = if enter.to_string() == "0" { quote!() } else { quote!(, part: [#scalar; #enter]) };
    let body = tokens(text);
    quote! {
        fn #name<#scalar: #krate::Scalar>(p: &#values, t: #scalar, #(#arguments),* #part) -> [#scalar; #leave] {
            #body
        }
    }
}

/// Emitted text as tokens.
pub fn tokens(text: &str) -> TokenStream {
    text.parse().unwrap_or_else(|_| {
        let message = format!("holonomy emitted text that is no Rust: {text}");
        quote!(::core::compile_error!(#message))
    })
}

/// The law, the cost, and the equations where they stay readable.
pub fn docs(function: &str, law: &str, count: &Count, texts: Option<&Texts<'_>>) -> TokenStream {
    let mut lines = vec![law.to_owned(), String::new(), cost(count)];
    match texts.map(|texts| texts.of(function)) {
        Some(Some(equations)) if !equations.is_empty() => {
            lines.push(String::new());
            lines.push("```text".to_owned());
            lines.extend(equations);
            lines.push("```".to_owned());
        }
        Some(None) => {
            lines.push(String::new());
            lines.push("The equations are too long for a page: they stand in `MODEL.equations`.".to_owned());
        }
        _ => {}
    }
    let lines = lines.iter().map(|line| if line.is_empty() { quote!(#[doc = ""]) } else { doc(line) });
    quote!(#(#lines)*)
}

/// A cost in words.
pub fn cost(count: &Count) -> String {
    let mut parts = Vec::new();
    let mut add = |n: usize, one: &str, many: &str| match n {
        0 => {}
        1 => parts.push(format!("1 {one}")),
        n => parts.push(format!("{n} {many}")),
    };
    add(count.additions, "addition", "additions");
    add(count.multiplications, "multiplication", "multiplications");
    add(count.divisions, "division", "divisions");
    add(count.roots, "root", "roots");
    add(count.sincos, "sine and cosine", "sines and cosines");
    add(count.selections, "selection", "selections");
    add(count.others, "other function", "other functions");
    if parts.is_empty() { "No operations.".to_owned() } else { format!("{}.", parts.join(", ")) }
}
