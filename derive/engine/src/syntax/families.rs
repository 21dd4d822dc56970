//! Arrays, families and sums, written out token by token before anything else reads them.
//!
//! `a[i + 1]` becomes the name `a_3`, an entry `.. for i in 0..n` becomes one entry for each i, and `sum(0..n, |j| ..)`
//! becomes a sum. Every token keeps its span, so that errors in what was written out stand where it was written.

use std::collections::BTreeMap;

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

use super::diagnostics::{Diagnostics, Place, messages};
use super::entries;
use super::expression::is_punct;
use super::integer;

/// A model's families may come to so many tokens when they are written out.
const MOST_TOKENS: usize = 400_000;

/// Sizes, and the lengths of arrays; `None` where the length is no number that the derive can see.
#[derive(Debug, Default)]
pub(crate) struct Families {
    sizes: BTreeMap<String, i64>,
    arrays: BTreeMap<String, Option<i64>>,
    spent: usize,
}

impl Families {
    /// The families of a struct with these arrays among its fields.
    pub fn new(arrays: BTreeMap<String, Option<i64>>) -> Self {
        Families { arrays, ..Families::default() }
    }

    /// The lengths of all arrays that are known.
    pub fn lengths(&self) -> BTreeMap<String, i64> {
        self.arrays.iter().filter_map(|(name, length)| Some((name.clone(), (*length)?))).collect()
    }

    /// Reads `#[size(n = 20, m = n - 1)]`.
    pub fn size(&mut self, tokens: TokenStream, end: Span, diagnostics: &mut Diagnostics) {
        for entry in entries::split(tokens, end) {
            let Some((left, _, right)) = entry.assignment("n = 20", diagnostics) else { continue };
            let name = entries::single_ident(left, entry.place(), diagnostics);
            let value = integer::value(&self.with_sizes(right));
            match (name, value) {
                (Some(name), Some(value)) => {
                    if self.sizes.insert(name.to_string(), value).is_some() {
                        diagnostics.report(&name, messages::size_twice(&name));
                    }
                }
                (_, None) => diagnostics.report(entry.place(), messages::integer_expected()),
                (None, Some(_)) => {}
            }
        }
    }

    /// Takes note of the arrays that a statement declares: `a[n]`.
    pub fn declare(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        for pair in tokens.windows(2) {
            let [TokenTree::Ident(name), TokenTree::Group(group)] = pair else { continue };
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            if group.delimiter() == Delimiter::Bracket {
                let length = integer::value(&self.with_sizes(&inner));
                self.arrays.insert(name.to_string(), length);
            }
        }
    }

    /// Takes note of the arrays that a statement introduces besides what it says of others: `of(a[n])`, `speeds(u[n])`.
    pub fn declare_introduced(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        for pair in tokens.windows(2) {
            match pair {
                [TokenTree::Ident(word), TokenTree::Group(group)] if introduces(word) => self.declare(group.stream()),
                _ => {}
            }
        }
    }

    /// A statement that declares names: sizes are put in, indices stay.
    pub fn declaration(&self, tokens: TokenStream) -> TokenStream {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        self.with_sizes(&tokens).into_iter().collect()
    }

    /// A statement written out.
    pub fn statement(&mut self, tokens: TokenStream, diagnostics: &mut Diagnostics) -> TokenStream {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let tokens = self.with_sizes(&tokens);
        if !has_families(&tokens) {
            // Brackets keep the places of their two ends.
            return tokens.into_iter().collect();
        }
        self.list(tokens, diagnostics).into_iter().collect()
    }

    fn with_sizes(&self, tokens: &[TokenTree]) -> Vec<TokenTree> {
        if !mentions(tokens, &self.sizes) {
            return tokens.to_vec();
        }
        replaced(tokens, &|name| self.sizes.get(name).copied())
    }

    /// The entries between commas, each written out.
    fn list(&mut self, tokens: Vec<TokenTree>, diagnostics: &mut Diagnostics) -> Vec<TokenTree> {
        let mut out = Vec::new();
        let mut entries = cut(tokens).into_iter().peekable();
        while let Some((entry, comma)) = entries.next() {
            let at = entry.iter().position(|token| matches!(token, TokenTree::Ident(ident) if ident == "for"));
            let Some(at) = at else {
                match entry.as_slice() {
                    // What a list declares has lengths, not indices.
                    [TokenTree::Ident(word), TokenTree::Group(_)] if introduces(word) => out.extend(entry),
                    _ => out.extend(self.sequence(entry, diagnostics)),
                }
                out.extend(comma);
                continue;
            };
            // Words about the family are about each of its entries.
            let mut columns = vec![self.copies(&entry[..at], &entry[at..], diagnostics)];
            while let Some((word, _)) = entries.next_if(|(next, _)| is_word(next)) {
                columns.push(self.copies(&word, &entry[at..], diagnostics));
            }
            for row in 0..columns[0].len() {
                for part in columns.iter_mut().filter_map(|column| column.get_mut(row)).map(std::mem::take) {
                    let end = part.last().map_or(entry[at].span(), TokenTree::span);
                    out.extend(part);
                    out.push(punct(',', end));
                }
            }
        }
        out
    }

    /// The entry for each index of its first clause, the further clauses inside.
    fn copies(
        &mut self,
        body: &[TokenTree],
        clauses: &[TokenTree],
        diagnostics: &mut Diagnostics,
    ) -> Vec<Vec<TokenTree>> {
        let [keyword, rest @ ..] = clauses else {
            return vec![self.sequence(body.to_vec(), diagnostics)];
        };
        let next = rest.iter().position(|token| matches!(token, TokenTree::Ident(ident) if ident == "for"));
        let (clause, further) = rest.split_at(next.unwrap_or(rest.len()));
        let (index, range) = match clause {
            [TokenTree::Ident(index), TokenTree::Ident(keyword), range @ ..] if keyword == "in" => (index, range),
            _ => {
                diagnostics.report(keyword.span(), messages::family_form());
                return vec![self.sequence(body.to_vec(), diagnostics)];
            }
        };
        let name = index.to_string();
        let Some(range) = range_of(range) else {
            // One entry stands for those that are not known; what it says is checked all the same.
            diagnostics.report(place_of(range, index.span()), messages::range_expected());
            let first = replaced(body, &|other| (other == name).then_some(0));
            return vec![self.sequence(first, diagnostics)];
        };
        let mut copies = Vec::new();
        for value in range {
            let put = |tokens: &[TokenTree]| replaced(tokens, &|other| (other == name).then_some(value));
            if !self.spend(body.len() + further.len(), keyword.span(), diagnostics) {
                break;
            }
            copies.extend(self.copies(&put(body), &put(further), diagnostics));
        }
        copies
    }

    /// Tokens in which indices are put into names, and sums are written out; lists in brackets are entries of their own.
    fn sequence(&mut self, tokens: Vec<TokenTree>, diagnostics: &mut Diagnostics) -> Vec<TokenTree> {
        let mut out = Vec::with_capacity(tokens.len());
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            let TokenTree::Ident(name) = &token else {
                out.push(self.inside(token, diagnostics));
                continue;
            };
            match tokens.next_if(|next| matches!(next, TokenTree::Group(_))) {
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => {
                    match self.element(name, &group, diagnostics) {
                        Some(element) => out.push(element),
                        None => out.extend([token, TokenTree::Group(group)]),
                    }
                }
                Some(TokenTree::Group(group))
                    if group.delimiter() == Delimiter::Parenthesis && (name == "sum" || name == "product") =>
                {
                    out.push(self.repeated(name, &group, diagnostics));
                }
                Some(next) => {
                    out.push(token);
                    out.push(self.inside(next, diagnostics));
                }
                None => out.push(token),
            }
        }
        out
    }

    fn inside(&mut self, token: TokenTree, diagnostics: &mut Diagnostics) -> TokenTree {
        let TokenTree::Group(group) = token else { return token };
        let inner: Vec<TokenTree> = group.stream().into_iter().collect();
        let inner = match group.delimiter() {
            Delimiter::Parenthesis | Delimiter::Bracket => self.list(inner, diagnostics),
            _ => self.sequence(inner, diagnostics),
        };
        grouped(group.delimiter(), inner, group.span())
    }

    /// `a[2]` as the name `a_2`; `None` where the index is no integer.
    fn element(&mut self, name: &Ident, group: &Group, diagnostics: &mut Diagnostics) -> Option<TokenTree> {
        let inner: Vec<TokenTree> = group.stream().into_iter().collect();
        let index = integer::value(&inner)?;
        let place = place_of(&inner, group.span());
        match self.arrays.get(&name.to_string()) {
            Some(None) => diagnostics.report_local(name.span(), messages::length_unknown(name)),
            Some(Some(length)) if !(0..*length).contains(&index) => {
                let entries = messages::counted(usize::try_from(*length).unwrap_or(0), "entry", "entries");
                diagnostics.report_local(place, messages::index_out_of_range(index, name, entries));
            }
            _ if index < 0 => diagnostics.report_local(place, messages::index_negative(index)),
            _ => return Some(TokenTree::Ident(Ident::new(&element_name(name, index), name.span()))),
        }
        // Reported; a number stands in, so that the rest is checked.
        Some(number(1, name.span()))
    }

    /// `sum(0..n, |j| body)` as a sum in parentheses.
    fn repeated(&mut self, name: &Ident, group: &Group, diagnostics: &mut Diagnostics) -> TokenTree {
        let (sign, nothing) = if name == "sum" { ('+', 0) } else { ('*', 1) };
        let inner: Vec<TokenTree> = group.stream().into_iter().collect();
        let comma = inner.iter().position(|token| is_punct(token, ','));
        let (range, rest) = inner.split_at(comma.unwrap_or(inner.len()));
        let body = match rest {
            [_, open, TokenTree::Ident(index), close, body @ ..]
                if is_punct(open, '|') && is_punct(close, '|') && !body.is_empty() =>
            {
                Some((index, body))
            }
            _ => None,
        };
        let Some((index, body)) = body else {
            diagnostics.report_local(name.span(), messages::sum_form(name));
            return number(1, name.span());
        };
        let Some(range) = range_of(range) else {
            diagnostics.report_local(place_of(range, index.span()), messages::range_expected());
            return number(1, name.span());
        };
        let index = index.to_string();
        let mut out: Vec<TokenTree> = Vec::new();
        for value in range {
            if !self.spend(body.len(), name.span(), diagnostics) {
                break;
            }
            let term = replaced(body, &|other| (other == index).then_some(value));
            let term = self.sequence(term, diagnostics);
            if !out.is_empty() {
                out.push(punct(sign, name.span()));
            }
            out.push(grouped(Delimiter::Parenthesis, term, group.span()));
        }
        if out.is_empty() {
            out.push(number(nothing, name.span()));
        }
        grouped(Delimiter::Parenthesis, out, group.span())
    }

    /// Whether so many more tokens may be written; told once where they may not.
    fn spend(&mut self, tokens: usize, place: Span, diagnostics: &mut Diagnostics) -> bool {
        let within = self.spent <= MOST_TOKENS;
        self.spent = self.spent.saturating_add(tokens + 1);
        if within && self.spent > MOST_TOKENS {
            diagnostics.report(place, messages::families_too_large(MOST_TOKENS));
        }
        self.spent <= MOST_TOKENS
    }
}

/// Whether an entry is a word about the constraint before it.
fn is_word(entry: &[TokenTree]) -> bool {
    match entry {
        [TokenTree::Ident(word)] => word == "redundant",
        [TokenTree::Ident(word), equals, _, ..] => word == "expressed" && is_punct(equals, '='),
        _ => false,
    }
}

/// Whether names are introduced in the parentheses behind this word.
fn introduces(word: &Ident) -> bool {
    word == "of" || word == "speeds"
}

/// `0..n` or `1..=n`
fn range_of(tokens: &[TokenTree]) -> Option<std::ops::Range<i64>> {
    let at = tokens.windows(2).position(|pair| is_punct(&pair[0], '.') && is_punct(&pair[1], '.'))?;
    let (from, to) = (&tokens[..at], &tokens[at + 2..]);
    let (to, last) = match to {
        [equals, to @ ..] if is_punct(equals, '=') => (to, 1),
        to => (to, 0),
    };
    Some(integer::value(from)?..integer::value(to)?.checked_add(last)?)
}

fn place_of(tokens: &[TokenTree], otherwise: Span) -> Place {
    match (tokens.first(), tokens.last()) {
        (Some(first), Some(last)) => Place::between(first.span(), last.span()),
        _ => otherwise.into(),
    }
}

/// Whether there is anything to be written out.
fn has_families(tokens: &[TokenTree]) -> bool {
    tokens.iter().enumerate().any(|(at, token)| match token {
        TokenTree::Ident(ident) => {
            let next = tokens.get(at + 1);
            let indexed = matches!(next, Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket);
            indexed || ident == "for" || ident == "sum" || ident == "product"
        }
        TokenTree::Group(group) => has_families(&group.stream().into_iter().collect::<Vec<_>>()),
        _ => false,
    })
}

/// The name of an entry of an array, as in the emitted structs.
pub(crate) fn element_name(array: &Ident, index: i64) -> String {
    format!("{array}_{index}")
}

/// The tokens with some names replaced by numbers; a name before a `:` is no such name.
fn replaced(tokens: &[TokenTree], value: &dyn Fn(&str) -> Option<i64>) -> Vec<TokenTree> {
    let of = |at: usize, token: &TokenTree| match token {
        TokenTree::Ident(ident) if !tokens.get(at + 1).is_some_and(entries::is_colon) => {
            value(&ident.to_string()).map_or_else(|| token.clone(), |value| number(value, ident.span()))
        }
        // The names in `#[unit(m)]` are none of the model's.
        TokenTree::Group(_) if at > 0 && is_punct(&tokens[at - 1], '#') => token.clone(),
        TokenTree::Group(group) => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            grouped(group.delimiter(), replaced(&inner, value), group.span())
        }
        _ => token.clone(),
    };
    tokens.iter().enumerate().map(|(at, token)| of(at, token)).collect()
}

fn mentions(tokens: &[TokenTree], sizes: &BTreeMap<String, i64>) -> bool {
    !sizes.is_empty()
        && tokens.iter().any(|token| match token {
            TokenTree::Ident(ident) => sizes.contains_key(&ident.to_string()),
            TokenTree::Group(group) => mentions(&group.stream().into_iter().collect::<Vec<_>>(), sizes),
            _ => false,
        })
}

/// Cut at the commas, each entry with the comma behind it.
fn cut(tokens: Vec<TokenTree>) -> Vec<(Vec<TokenTree>, Option<TokenTree>)> {
    let mut entries = Vec::new();
    let mut current = Vec::new();
    for token in tokens {
        if is_punct(&token, ',') {
            entries.push((std::mem::take(&mut current), Some(token)));
        } else {
            current.push(token);
        }
    }
    if !current.is_empty() {
        entries.push((current, None));
    }
    entries
}

fn number(value: i64, span: Span) -> TokenTree {
    let mut literal = Literal::u64_unsuffixed(value.unsigned_abs());
    literal.set_span(span);
    let literal = TokenTree::Literal(literal);
    if value >= 0 { literal } else { grouped(Delimiter::Parenthesis, vec![punct('-', span), literal], span) }
}

fn punct(character: char, span: Span) -> TokenTree {
    let mut punct = Punct::new(character, Spacing::Alone);
    punct.set_span(span);
    TokenTree::Punct(punct)
}

/// A group keeps its place as a whole; its brackets take it over.
fn grouped(delimiter: Delimiter, tokens: Vec<TokenTree>, span: Span) -> TokenTree {
    let mut group = Group::new(delimiter, tokens.into_iter().collect());
    group.set_span(span);
    TokenTree::Group(group)
}
