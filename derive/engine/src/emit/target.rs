//! What the user's struct gives.

use crate::dimensions::Units;
use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;
use syn::ext::IdentExt;

/// A name of the model as the user wrote it.
#[derive(Clone, Debug)]
pub struct Declared {
    /// The name.
    pub name: String,
    /// Where it stands.
    pub span: Span,
    /// Its doc comment.
    pub docs: Vec<syn::Attribute>,
}

/// The struct that the equations are implemented for.
#[derive(Clone, Debug)]
pub struct Target {
    /// The struct's name.
    pub ident: Ident,
    /// Its visibility, which the emitted types share.
    pub vis: syn::Visibility,
    /// Its generics.
    pub generics: syn::Generics,
    /// The fields, or entries of fields, that are parameters, in the order of the model's parameters.
    pub parameters: Vec<TokenStream>,
    /// Coordinates, speeds, inputs and parameters as they were declared, for spans and docs.
    pub declared: Vec<Declared>,
    /// The units of names, as far as they are known.
    pub units: Units,
    /// Outputs as they were declared.
    pub outputs: Vec<Declared>,
    /// The names of defines.
    pub defines: Vec<String>,
    /// The paths of the user's functions, each with its derivatives.
    pub functions: Vec<Vec<syn::Path>>,
    /// The runtime crate, `::holonomy` unless renamed.
    pub krate: syn::Path,
}

impl Target {
    /// The declaration of a name.
    pub fn declared(&self, name: &str) -> Option<&Declared> {
        self.declared.iter().find(|d| d.name == name)
    }

    /// The declaration of an output.
    pub fn output(&self, name: &str) -> Option<&Declared> {
        self.outputs.iter().find(|d| d.name == name)
    }

    /// The name of an emitted type: `RollingDiskState`.
    pub fn type_name(&self, suffix: &str) -> Ident {
        format_ident!("{}{}", self.ident.unraw(), suffix, span = Span::call_site())
    }

    /// A name for the scalar type that none of the struct's generics has.
    pub fn scalar(&self) -> Ident {
        let taken = |name: &str| {
            self.generics.params.iter().any(|p| match p {
                syn::GenericParam::Type(p) => p.ident == name,
                syn::GenericParam::Const(p) => p.ident == name,
                syn::GenericParam::Lifetime(_) => false,
            })
        };
        let mut name = "T".to_owned();
        while taken(&name) {
            name.push('T');
        }
        Ident::new(&name, Span::call_site())
    }
}

/// An identifier from text that may be raw.
pub fn ident(text: &str, span: Span) -> Ident {
    match text.strip_prefix("r#") {
        Some(raw) => Ident::new_raw(raw, span),
        None => Ident::new(text, span),
    }
}
