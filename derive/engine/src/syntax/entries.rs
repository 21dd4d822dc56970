//! A statement's tokens, cut at its commas.
//!
//! Entries are read one by one, so that an error in one does not hide the errors in the others.

use proc_macro2::{Delimiter, Group, Ident, Spacing, Span, TokenStream, TokenTree};

use super::declarations::{IndependentEntry, Name, Quantity, Unit};
use super::diagnostics::{Diagnostics, Place, messages};
use super::expression::{Expression, is_punct};
use super::families::element_name;
use super::read::Statement;
use super::{fields, integer};

/// An array has at most so many entries.
pub(crate) const LONGEST: i64 = 4096;

/// What stands between two commas.
pub(crate) struct Entry {
    pub tokens: Vec<TokenTree>,
    /// Where to point if there are no tokens: the comma that ends the entry.
    end: Span,
}

/// Cuts at the commas; a comma at the end is allowed.
pub(crate) fn split(tokens: TokenStream, end: Span) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut current = Vec::new();
    for token in tokens {
        if is_punct(&token, ',') {
            let end = token.span();
            let tokens = std::mem::take(&mut current);
            entries.push(Entry { tokens, end });
        } else {
            current.push(token);
        }
    }
    if !current.is_empty() {
        let tokens = current;
        entries.push(Entry { tokens, end });
    }
    entries
}

impl Entry {
    /// From the first token to the last.
    pub fn place(&self) -> Place {
        match (self.tokens.first(), self.tokens.last()) {
            (Some(first), Some(last)) => Place::between(first.span(), last.span()),
            _ => self.end.into(),
        }
    }

    /// The whole entry as an expression.
    pub fn expression(&self, diagnostics: &mut Diagnostics) -> Expression {
        Expression::read(&self.tokens, self.end, diagnostics)
    }

    /// The whole entry as a name that is introduced here, with the doc comment before it; `a[3]` is three names.
    pub fn names(&self, diagnostics: &mut Diagnostics) -> Vec<Name> {
        let (Before { docs, unit }, rest) = self.before(diagnostics);
        match rest {
            [token] => ident(token, diagnostics).map(|ident| Name { ident, docs, unit }).into_iter().collect(),
            [token @ TokenTree::Ident(name), TokenTree::Group(group)] if group.delimiter() == Delimiter::Bracket => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                let length = integer::value(&inner).filter(|length| (1..=LONGEST).contains(length));
                let Some(length) = length else {
                    diagnostics.report(group.span(), messages::length_expected(LONGEST));
                    return Vec::new();
                };
                if ident(token, diagnostics).is_none() {
                    return Vec::new();
                }
                let element = |index| Ident::new(&element_name(name, index), name.span());
                let name = |index| Name { ident: element(index), docs: docs.clone(), unit: unit.clone() };
                (0..length).map(name).collect()
            }
            [TokenTree::Ident(name), next, ..] => {
                diagnostics.report(next.span(), messages::comma_expected(name));
                Vec::new()
            }
            _ => {
                diagnostics.report(self.place(), messages::name_expected());
                Vec::new()
            }
        }
    }

    /// What stands before the entry, and the entry without it.
    pub fn documented(&self, diagnostics: &mut Diagnostics) -> (Before, Entry) {
        let (before, rest) = self.before(diagnostics);
        (before, Entry { tokens: rest.to_vec(), end: self.end })
    }

    /// Cuts off leading doc comments, which reach a derive as `#[doc = ".."]`, and a unit among them.
    fn before(&self, diagnostics: &mut Diagnostics) -> (Before, &[TokenTree]) {
        let mut before = Before::default();
        let mut measured = false;
        let mut rest = self.tokens.as_slice();
        while let [hash, TokenTree::Group(group), after @ ..] = rest {
            if !is_punct(hash, '#') {
                break;
            }
            match (doc_text(group), unit_statement(group)) {
                (Some(text), _) => before.docs.push(text),
                (None, Some(statement)) if measured => {
                    diagnostics.report_local(&statement.name, messages::statement_twice(&statement.name));
                }
                (None, Some(statement)) => {
                    before.unit = fields::unit_of(&statement, diagnostics);
                    measured = true;
                }
                (None, None) => diagnostics.report_local(group.span(), messages::attribute_on_name()),
            }
            rest = after;
        }
        (before, rest)
    }

    /// The entry cut at its first single `=`: what stands left, the `=`, what stands right.
    pub fn assignment(&self, what: &str, diagnostics: &mut Diagnostics) -> Option<(&[TokenTree], Span, &[TokenTree])> {
        let found = single_equals(&self.tokens);
        let Some(at) = found else {
            diagnostics.report(self.place(), messages::assignment_expected(what));
            return None;
        };
        let (left, right) = self.tokens.split_at(at);
        Some((left, right[0].span(), &right[1..]))
    }

    /// The entry as `name = expression`.
    pub fn named_expression(&self, what: &str, diagnostics: &mut Diagnostics) -> Option<(Ident, Expression)> {
        let (left, equals, right) = self.assignment(what, diagnostics)?;
        let name = single_ident(left, self.place(), diagnostics);
        let value = Expression::read(right, equals, diagnostics);
        Some((name?, value))
    }

    /// The entry as `v1`, as `dot(x)`, or as `s = expression` with the doc comment before it.
    pub fn independent(&self, diagnostics: &mut Diagnostics) -> Option<IndependentEntry> {
        if single_equals(&self.tokens).is_none() {
            return quantity(&self.tokens, self.place(), diagnostics).map(IndependentEntry::Speed);
        }
        let (Before { docs, unit }, rest) = self.before(diagnostics);
        let (left, right) = rest.split_at(single_equals(rest)?);
        let ident = single_ident(left, self.place(), diagnostics);
        let value = Expression::read(&right[1..], right[0].span(), diagnostics);
        Some(IndependentEntry::Combination { name: Name { ident: ident?, docs, unit }, value })
    }
}

/// `v1` or `dot(x)`
pub(crate) fn quantity(tokens: &[TokenTree], place: Place, diagnostics: &mut Diagnostics) -> Option<Quantity> {
    match tokens {
        [TokenTree::Ident(dot), TokenTree::Group(group)]
            if dot == "dot" && group.delimiter() == Delimiter::Parenthesis =>
        {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            match inner.as_slice() {
                [token] => {
                    let place = Place::between(dot.span(), group.span_close());
                    Some(Quantity::Rate(ident(token, diagnostics)?, place))
                }
                _ => {
                    diagnostics.report(group.span(), messages::quantity_expected());
                    None
                }
            }
        }
        [token @ TokenTree::Ident(_)] => ident(token, diagnostics).map(Quantity::Name),
        _ => {
            diagnostics.report(place, messages::quantity_expected());
            None
        }
    }
}

/// A single name.
pub(crate) fn single_ident(tokens: &[TokenTree], place: Place, diagnostics: &mut Diagnostics) -> Option<Ident> {
    match tokens {
        [token] => ident(token, diagnostics),
        [first, .., last] => {
            let place = Place::between(first.span(), last.span());
            diagnostics.report(place, messages::name_expected());
            None
        }
        [] => {
            diagnostics.report(place, messages::name_expected());
            None
        }
    }
}

/// A name that emitted code can use as it is: neither a keyword nor a raw identifier.
pub(crate) fn ident(token: &TokenTree, diagnostics: &mut Diagnostics) -> Option<Ident> {
    let TokenTree::Ident(ident) = token else {
        diagnostics.report(token.span(), messages::name_expected());
        return None;
    };
    let text = ident.to_string();
    if text.starts_with("r#") {
        diagnostics.report(ident, messages::raw_identifier(ident));
        None
    } else if syn::parse2::<Ident>(token.clone().into()).is_err() {
        diagnostics.report(ident, messages::keyword(ident));
        None
    } else {
        Some(ident.clone())
    }
}

/// The position of a `=` that is no part of `==`, `<=`, `>=` or `!=`.
pub(crate) fn single_equals(tokens: &[TokenTree]) -> Option<usize> {
    (0..tokens.len()).find(|&at| {
        let joint = |token: &TokenTree| {
            matches!(token, TokenTree::Punct(punct)
                if "=<>!".contains(punct.as_char()) && punct.spacing() == Spacing::Joint)
        };
        let begins_another = joint(&tokens[at]) && tokens.get(at + 1).is_some_and(|next| is_punct(next, '='));
        let ends_another = at > 0 && joint(&tokens[at - 1]);
        is_punct(&tokens[at], '=') && !begins_another && !ends_another
    })
}

/// The positions of `==`.
pub(crate) fn double_equals(tokens: &[TokenTree]) -> Vec<usize> {
    let mut found = Vec::new();
    let mut at = 0;
    while at + 1 < tokens.len() {
        let joint = matches!(&tokens[at], TokenTree::Punct(punct)
            if punct.as_char() == '=' && punct.spacing() == Spacing::Joint);
        if joint && is_punct(&tokens[at + 1], '=') {
            found.push(at);
            at += 1;
        }
        at += 1;
    }
    found
}

/// What may stand before a name.
#[derive(Default)]
pub(crate) struct Before {
    /// Doc comments, line by line.
    pub docs: Vec<String>,
    /// `#[unit(..)]`
    pub unit: Option<Unit>,
}

/// `[unit(kg)]`
fn unit_statement(group: &Group) -> Option<Statement> {
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Ident(name), TokenTree::Group(list)]
            if name == "unit" && list.delimiter() == Delimiter::Parenthesis =>
        {
            Some(Statement { name: name.clone(), tokens: list.stream(), end: list.span_close() })
        }
        _ => None,
    }
}

/// The text of `[doc = ".."]`.
fn doc_text(group: &Group) -> Option<String> {
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Ident(doc), equals, text] if doc == "doc" && is_punct(equals, '=') => {
            let literal: syn::LitStr = syn::parse2(text.clone().into()).ok()?;
            Some(literal.value())
        }
        _ => None,
    }
}

/// A `:` that is no part of `::`.
pub(crate) fn is_colon(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(punct)
        if punct.as_char() == ':' && punct.spacing() == Spacing::Alone)
}
