//! Errors of a model, collected while it is read and reported together.
//!
//! A derive that stops at its first error makes its user compile once per mistake. Every step
//! therefore writes into one [`Diagnostics`] and goes on as long as what it reads makes sense.

pub(crate) mod messages;
mod suggest;

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

pub use suggest::nearest;
pub(crate) use suggest::{did_you_mean, distance};

/// A stretch of source: from the first token to the last.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The first token.
    pub start: Span,
    /// The last token; the same as `start` for a single token.
    pub end: Span,
}

impl Place {
    /// From one token to another.
    pub fn between(start: Span, end: Span) -> Self {
        Place { start, end }
    }
}

impl From<Span> for Place {
    fn from(span: Span) -> Self {
        Place { start: span, end: span }
    }
}

impl From<&Ident> for Place {
    fn from(ident: &Ident) -> Self {
        ident.span().into()
    }
}

/// One error.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// Where the error is.
    pub place: Place,
    /// What is wrong and what to do about it.
    pub message: String,
}

/// All errors of a model, in the order in which they were found.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    /// How many of them leave the rest of the model as it was meant.
    local: usize,
}

impl Diagnostics {
    /// No errors yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an error at a token or a stretch of tokens; once, where a family says it for every index.
    pub fn report(&mut self, place: impl Into<Place>, message: impl Into<String>) {
        self.add(place.into(), message.into());
    }

    /// Whether the error is a new one.
    fn add(&mut self, place: Place, message: String) -> bool {
        // Spans can be compared as text only.
        let same =
            |other: &Diagnostic| other.message == message && format!("{:?}", other.place) == format!("{place:?}");
        let new = !self.list.iter().any(same);
        if new {
            self.list.push(Diagnostic { place, message });
        }
        new
    }

    /// Adds an error that leaves the rest of the model as it was meant: one inside an expression, say.
    pub(crate) fn report_local(&mut self, place: impl Into<Place>, message: String) {
        self.local += usize::from(self.add(place.into(), message));
    }

    /// Whether all errors, if any, leave the rest of the model as it was meant.
    pub(crate) fn only_local(&self) -> bool {
        self.local == self.list.len()
    }

    /// Adds the errors of another step.
    pub fn extend(&mut self, other: Diagnostics) {
        self.list.extend(other.list);
        self.local += other.local;
    }

    /// Whether nothing was reported.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The errors in the order in which they were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.list.iter()
    }

    /// The value, if nothing was reported.
    pub fn result<T>(self, value: T) -> Result<T, Diagnostics> {
        if self.is_empty() { Ok(value) } else { Err(self) }
    }

    /// One `::core::compile_error! { ".." }` per error, spanned so that rustc underlines the place.
    pub fn into_tokens(self) -> TokenStream {
        self.list.iter().flat_map(Diagnostic::tokens).collect()
    }
}

impl Diagnostic {
    /// rustc underlines a macro invocation from the span of its first token to that of its last.
    fn tokens(&self) -> Vec<TokenTree> {
        let Place { start, end } = self.place;
        let punct = |character, spacing| {
            let mut punct = Punct::new(character, spacing);
            punct.set_span(start);
            TokenTree::Punct(punct)
        };
        let mut text = Literal::string(&self.message);
        text.set_span(end);
        let mut braces = Group::new(Delimiter::Brace, TokenTree::Literal(text).into());
        braces.set_span(end);
        vec![
            punct(':', Spacing::Joint),
            punct(':', Spacing::Alone),
            TokenTree::Ident(Ident::new("core", start)),
            punct(':', Spacing::Joint),
            punct(':', Spacing::Alone),
            TokenTree::Ident(Ident::new("compile_error", start)),
            punct('!', Spacing::Alone),
            TokenTree::Group(braces),
        ]
    }
}

impl From<Diagnostic> for Diagnostics {
    fn from(diagnostic: Diagnostic) -> Self {
        Diagnostics { list: vec![diagnostic], local: 0 }
    }
}

impl From<syn::Error> for Diagnostics {
    fn from(errors: syn::Error) -> Self {
        let mut diagnostics = Diagnostics::new();
        for error in errors {
            diagnostics.report(error.span(), error.to_string());
        }
        diagnostics
    }
}
