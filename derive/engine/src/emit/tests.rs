//! The emitted tokens: well-formed, hygienic, readable.

use super::{Declared, Known, Target, diverging, implementation};
use crate::program::programs;
use crate::program::tests::disks::{disk, disk_stage};
use crate::program::tests::models::{chain, pendulum};
use crate::projection::Equations;
use proc_macro2::{Span, TokenStream, TokenTree};
use quote::format_ident;

fn target(text: &str, equations: &Equations) -> Target {
    let item: syn::DeriveInput = syn::parse_str(text).expect("a struct");
    let name = |symbol| equations.graph.name(symbol);
    Target {
        units: Default::default(),
        ident: item.ident,
        vis: item.vis,
        generics: item.generics,
        parameters: equations
            .parameters
            .iter()
            .map(|s| {
                let field = format_ident!("{}", name(*s));
                quote::quote!(#field)
            })
            .collect(),
        declared: Vec::new(),
        outputs: Vec::new(),
        defines: Vec::new(),
        functions: Vec::new(),
        krate: syn::parse_quote!(::holonomy),
    }
}

fn emitted(text: &str, equations: &Equations) -> TokenStream {
    let programs = programs(equations).expect("the functions read what they may");
    implementation(&target(text, equations), equations, &programs)
}

fn parsed(tokens: &TokenStream) -> syn::File {
    syn::parse2(tokens.clone()).unwrap_or_else(|error| panic!("{error} in {tokens}"))
}

/// The text between two marks, white space evened out.
fn between(tokens: &TokenStream, from: &str, to: &str) -> String {
    let text = tokens.to_string();
    let start = text.find(from).unwrap_or_else(|| panic!("no `{from}` in {text}"));
    let end = text[start..].find(to).map_or(text.len(), |at| start + at);
    text[start..end].split_whitespace().collect::<String>()
}

#[test]
fn all_models_give_items() {
    for equations in [pendulum(), disk(), disk_stage(), chain(60), chain(2_500)] {
        let tokens = emitted("pub struct Model { a: f64 }", &equations);
        let file = parsed(&tokens);
        let structs = file.items.iter().filter(|item| matches!(item, syn::Item::Struct(_))).count();
        let scopes = file.items.iter().filter(|item| matches!(item, syn::Item::Const(_))).count();
        assert!((4..=6).contains(&structs) && scopes == 1 && file.items.len() == structs + 1);
    }
}

#[test]
fn the_pendulum_reads_well() {
    let tokens = emitted("pub struct Pendulum { a: f64 }", &pendulum());
    let body = between(&tokens, "fn velocities", "fn complement");
    assert!(body.contains("PendulumVelocities{dot_x:s.dot_x,dot_y:-(s.x*s.dot_x/s.y)}"), "{body}");
    let residual = between(&tokens, "fn position_residual", "fn velocity_residual");
    assert!(residual.contains("let[x,y]=*at;"), "{residual}");
    let matrix = between(&tokens, "fn constraint_matrix", "fn constraint_bias");
    assert!(matrix.contains("[[x],[y]]"), "columns, as nalgebra stores them: {matrix}");
}

#[test]
fn the_equations_stand_in_the_docs() {
    let text = emitted("pub struct Disk { a: f64 }", &disk()).to_string();
    // In the notation of models for `MODEL`, as in print for the documentation.
    assert!(text.contains("[[2*j + m*powi(r, 2), 0, 0], [0, j, 0], [0, 0, j + m*powi(r, 2)]]"));
    let rows = ["M_d = ⎡2·j + m·r²  0  0       ⎤", "⎢0           j  0       ⎥", "⎣0           0  j + m·r²⎦"];
    assert!(rows.iter().all(|row| text.contains(row)), "{text}");
    assert!(text.contains("(4.10)") && text.contains("2 sines and cosines"));
}

#[test]
fn the_same_model_gives_the_same_text() {
    let [a, b] = [0, 1].map(|_| emitted("pub struct Disk { a: f64 }", &disk()).to_string());
    assert_eq!(a, b);
}

/// No path starts at a name that the user could have redefined: `core` and the runtime come with leading colons, and
/// the only bare method calls are those of the scalar's trait.
#[test]
fn paths_are_absolute() {
    let tokens = emitted("pub struct Disk { a: f64 }", &disk());
    let mut flat = Vec::new();
    let mut stack = vec![tokens];
    while let Some(tokens) = stack.pop() {
        for tree in tokens {
            match tree {
                TokenTree::Group(group) => {
                    flat.push(" ".to_owned());
                    stack.push(group.stream());
                }
                other => flat.push(other.to_string()),
            }
        }
        flat.push(" ".to_owned());
    }
    for (at, word) in flat.iter().enumerate() {
        if word == "core" || word == "holonomy" {
            assert_eq!((flat[at - 1].as_str(), flat[at - 2].as_str()), (":", ":"), "{:?}", &flat[at - 2..at + 3]);
        }
        assert!(!["Some", "Vec", "String", "println", "unsafe", "std"].contains(&word.as_str()) || flat[at - 1] == ":");
    }
}

#[test]
fn generics_pass_through() {
    let text = "pub(crate) struct Disk<'a, T: Copy, const N: usize = 3> where f64: From<T> { a: &'a [T; N] }";
    let tokens = emitted(text, &disk());
    parsed(&tokens);
    let header = between(&tokens, "impl < 'a", "{");
    assert_eq!(header, "impl<'a,T:Copy,constN:usize>::holonomy::ConstrainedSystemforDisk<'a,T,N>wheref64:From<T>");
    let derivative = between(&tokens, "fn derivative", "{");
    assert!(derivative.starts_with("fnderivative<TT:::holonomy::Scalar>(p:&DiskValues<TT>,t:TT"), "{derivative}");
}

#[test]
fn docs_and_names_are_the_users() {
    let equations = disk();
    let mut target = target("pub struct Disk { a: f64 }", &equations);
    target.declared = vec![Declared {
        name: "theta".to_owned(),
        span: Span::call_site(),
        docs: vec![syn::parse_quote!(#[doc = " Lean."])],
    }];
    target.krate = syn::parse_quote!(crate::renamed);
    let tokens = implementation(&target, &equations, &programs(&equations).expect("programs"));
    let state = between(&tokens, "pub struct DiskState", "}");
    assert!(state.contains("#[doc=\"Lean.\"]pubtheta:T"), "{state}");
    assert!(!tokens.to_string().contains(":: holonomy") && tokens.to_string().contains("crate :: renamed"));
}

#[test]
fn a_model_with_errors_has_all_types() {
    let equations = disk();
    let target = target("pub struct Disk { a: f64 }", &equations);
    for known in [Known::of(&equations), Known::default()] {
        let tokens = diverging(&target, &known);
        parsed(&tokens);
        assert_eq!(tokens.to_string().matches("type ").count() - known.types(), 21);
    }
}

impl Known {
    /// How many structs have a `type Array`.
    fn types(&self) -> usize {
        [&self.state, &self.velocities, &self.multipliers, &self.parameters, &self.inputs, &self.outputs]
            .iter()
            .filter(|names| !names.is_empty())
            .count()
    }
}
