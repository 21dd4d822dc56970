//! Expressions: parsed by syn, then laid out flat.
//!
//! The result is a list in which operands stand before what uses them, so that everything that
//! reads an expression is a loop.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{ParseStream, Parser};
use syn::{BinOp, Expr, ExprField, ExprUnary, Member, UnOp, parenthesized};

use super::diagnostics::{Diagnostics, Place, messages};
use super::refusal::refusal;
use super::{conditional, nesting, number};
use crate::symbolic::Rational;

/// An expression in postfix order; the last term is the whole.
#[derive(Clone, Debug)]
pub struct Expression {
    terms: Vec<(Term, Span)>,
    place: Place,
}

/// One step of an expression. Operands are indices of earlier terms.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// A literal.
    Number(Rational),
    /// A name.
    Name(String),
    /// `A.x`: an axis of a frame, counted from zero.
    Axis(String, usize),
    /// `-a`
    Negative(usize),
    /// `a + b` and the like.
    Binary(Operator, usize, usize),
    /// `f(a, b)`
    Call(String, Vec<usize>),
    /// `if left < right { then } else { other }`: the four operands in this order. `>` and `>=` stand with their sides
    /// exchanged.
    If(Comparison, [usize; 4]),
    /// What could not be read; its error is reported already.
    Hole,
}

impl Term {
    pub(crate) fn operands(&self) -> Vec<usize> {
        match self {
            Term::Number(_) | Term::Name(_) | Term::Axis(..) | Term::Hole => Vec::new(),
            Term::Negative(of) => vec![*of],
            Term::Binary(_, left, right) => vec![*left, *right],
            Term::Call(_, arguments) => arguments.clone(),
            Term::If(_, parts) => parts.to_vec(),
        }
    }

    /// The term in a list that begins with the term `first`.
    fn shifted(&self, first: usize) -> Term {
        match self {
            Term::Negative(of) => Term::Negative(of - first),
            Term::Binary(operator, left, right) => Term::Binary(*operator, left - first, right - first),
            Term::Call(function, arguments) => {
                Term::Call(function.clone(), arguments.iter().map(|at| at - first).collect())
            }
            Term::If(comparison, parts) => Term::If(*comparison, parts.map(|at| at - first)),
            other => other.clone(),
        }
    }
}

/// The four operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
}

/// What an `if` asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `left < right`
    Less,
    /// `left <= right`
    AtMost,
}

impl Expression {
    /// Reads an expression from its tokens. `before` is the token that it follows: where there are
    /// no tokens at all, the error stands there. What cannot be read is reported and leaves a
    /// [`Term::Hole`], so that the rest of the model can still be checked.
    pub(crate) fn read(tokens: &[TokenTree], before: Span, diagnostics: &mut Diagnostics) -> Self {
        let (Some(first), Some(last)) = (tokens.first(), tokens.last()) else {
            diagnostics.report_local(before, messages::expression_expected());
            return Expression::hole(before.into());
        };
        let place = Place::between(first.span(), last.span());
        if let Some(hash) = tokens.iter().find(|token| is_punct(token, '#')) {
            diagnostics.report_local(hash.span(), messages::attribute_in_expression());
            return Expression::hole(place);
        }
        if let Err(error) = nesting::check_expression(tokens) {
            diagnostics.report_local(error.place, error.message);
            return Expression::hole(place);
        }
        match parse(tokens, last.span()) {
            Ok(expression) => flatten(expression, place, diagnostics),
            Err(error) => {
                diagnostics.report_local(error.span(), messages::not_an_expression(&error));
                Expression::hole(place)
            }
        }
    }

    /// An operand as an expression of its own.
    pub(crate) fn part(&self, at: usize) -> Expression {
        // Operands lie before what uses them without a gap.
        let mut first = at;
        let mut open = vec![at];
        while let Some(term) = open.pop() {
            first = first.min(term);
            open.extend(self.terms[term].0.operands());
        }
        let terms: Vec<(Term, Span)> =
            self.terms[first..=at].iter().map(|(term, span)| (term.shifted(first), *span)).collect();
        // The token of a call stands before its arguments.
        let place = match &self.terms[at] {
            (Term::Call(..), function) => (*function).into(),
            (_, last) => Place::between(self.terms[first].1, *last),
        };
        Expression { terms, place }
    }

    fn hole(place: Place) -> Self {
        Expression { terms: vec![(Term::Hole, place.start)], place }
    }

    /// The terms in postfix order with their spans; that of an operation is its operator's, that of
    /// a call is its function's.
    pub fn terms(&self) -> &[(Term, Span)] {
        &self.terms
    }

    /// From the first token to the last.
    pub fn place(&self) -> Place {
        self.place
    }
}

pub(crate) fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

/// Parses inside a group that ends at the last token, so that "unexpected end" has a place.
fn parse(tokens: &[TokenTree], end: Span) -> syn::Result<Expr> {
    let mut group = Group::new(Delimiter::Parenthesis, tokens.iter().cloned().collect());
    group.set_span(end);
    let parser = |input: ParseStream<'_>| {
        let content;
        parenthesized!(content in input);
        let expression: Expr = content.parse()?;
        if content.is_empty() { Ok(expression) } else { Err(content.error(messages::operator_expected())) }
    };
    parser.parse2(TokenStream::from(TokenTree::Group(group)))
}

/// What remains to be done: look at an expression, or put together what lies on the stack.
enum Step {
    Visit(Expr),
    Negative(Span),
    Binary(Operator, Span),
    Call(Ident, usize),
    If(Comparison, Span),
    /// In place of an operation on so many operands that was refused.
    Hole(usize, Span),
}

/// Takes the tree apart from the top. It is consumed piece by piece, because dropping a long sum
/// whole would recurse as deep as the sum is long.
fn flatten(root: Expr, place: Place, diagnostics: &mut Diagnostics) -> Expression {
    let mut terms: Vec<(Term, Span)> = Vec::new();
    let mut operands: Vec<usize> = Vec::new();
    let mut steps = vec![Step::Visit(root)];
    while let Some(step) = steps.pop() {
        let (term, span) = match step {
            Step::Visit(expression) => match expression {
                Expr::Paren(inner) => {
                    steps.push(Step::Visit(*inner.expr));
                    continue;
                }
                Expr::Group(inner) => {
                    steps.push(Step::Visit(*inner.expr));
                    continue;
                }
                Expr::Unary(ExprUnary { op: UnOp::Neg(minus), expr, .. }) => {
                    steps.push(Step::Negative(minus.span));
                    steps.push(Step::Visit(*expr));
                    continue;
                }
                Expr::Binary(binary) => {
                    match operator(&binary.op) {
                        Ok((operator, span)) => steps.push(Step::Binary(operator, span)),
                        Err((span, message)) => {
                            // Both sides are looked at all the same: they may hold more errors.
                            diagnostics.report_local(span, message);
                            steps.push(Step::Hole(2, span));
                        }
                    }
                    steps.push(Step::Visit(*binary.right));
                    steps.push(Step::Visit(*binary.left));
                    continue;
                }
                Expr::Call(call) => match function(&call.func) {
                    Some(function) => {
                        steps.push(Step::Call(function, call.args.len()));
                        steps.extend(call.args.into_iter().rev().map(Step::Visit));
                        continue;
                    }
                    None => Err((call.paren_token.span.open(), messages::call_of_no_name())),
                },
                Expr::If(choice) => {
                    let span = choice.if_token.span;
                    match conditional::read(choice) {
                        Ok((comparison, operands)) => {
                            steps.push(Step::If(comparison, span));
                            steps.extend(operands.into_iter().rev().map(Step::Visit));
                        }
                        Err(refused) => {
                            // What could be read is looked at all the same: it may hold more errors.
                            diagnostics.report_local(refused.place, refused.message);
                            steps.push(Step::Hole(refused.parts.len(), span));
                            steps.extend(refused.parts.into_iter().rev().map(Step::Visit));
                        }
                    }
                    continue;
                }
                Expr::Lit(literal) => match number::read(&literal.lit) {
                    Ok(number) => Ok((Term::Number(number), literal.lit.span())),
                    Err(message) => Err((literal.lit.span(), message)),
                },
                Expr::Field(field) => match axis_of(&field) {
                    Some((frame, axis)) => Ok((Term::Axis(frame.to_string(), axis), frame.span())),
                    None => Err(refusal(&Expr::Field(field), place.start)),
                },
                Expr::Path(path) => match path.path.get_ident() {
                    Some(ident) if path.qself.is_none() && ident != "self" => {
                        Ok((Term::Name(ident.to_string()), ident.span()))
                    }
                    _ => Err(refusal(&Expr::Path(path), place.start)),
                },
                other => Err(refusal(&other, place.start)),
            }
            .unwrap_or_else(|(span, message)| {
                diagnostics.report_local(span, message);
                (Term::Hole, span)
            }),
            Step::Negative(span) => (Term::Negative(take(&mut operands)), span),
            Step::Binary(operator, span) => {
                let right = take(&mut operands);
                let left = take(&mut operands);
                (Term::Binary(operator, left, right), span)
            }
            Step::Hole(count, span) => {
                operands.truncate(operands.len().saturating_sub(count));
                (Term::Hole, span)
            }
            Step::If(comparison, span) => {
                let mut parts = [0; 4];
                parts.iter_mut().rev().for_each(|part| *part = take(&mut operands));
                (Term::If(comparison, parts), span)
            }
            Step::Call(function, count) => {
                let arguments = operands.split_off(operands.len().saturating_sub(count));
                (Term::Call(function.to_string(), arguments), function.span())
            }
        };
        operands.push(terms.len());
        terms.push((term, span));
    }
    Expression { terms, place }
}

/// Every step that takes an operand is pushed below the visit that makes it.
fn take(operands: &mut Vec<usize>) -> usize {
    operands.pop().unwrap_or_default()
}

fn operator(op: &BinOp) -> Result<(Operator, Span), (Span, String)> {
    match op {
        BinOp::Add(token) => Ok((Operator::Add, token.span)),
        BinOp::Sub(token) => Ok((Operator::Subtract, token.span)),
        BinOp::Mul(token) => Ok((Operator::Multiply, token.span)),
        BinOp::Div(token) => Ok((Operator::Divide, token.span)),
        BinOp::BitXor(token) => Err((token.span, messages::caret())),
        BinOp::Eq(token) => Err((token.spans[0], messages::equation_in_expression())),
        other => {
            let tokens: Vec<TokenTree> = other.to_token_stream().into_iter().collect();
            let text: String = tokens.iter().map(ToString::to_string).collect();
            let span = tokens.first().map_or_else(Span::call_site, TokenTree::span);
            Err((span, messages::operator(text)))
        }
    }
}

/// The axes of a frame, by their names.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// `A.x`
fn axis_of(field: &ExprField) -> Option<(Ident, usize)> {
    let (Expr::Path(path), Member::Named(name)) = (&*field.base, &field.member) else { return None };
    let frame = path.path.get_ident().filter(|frame| path.qself.is_none() && *frame != "self")?;
    let axis = AXES.iter().position(|axis| name == axis)?;
    Some((frame.clone(), axis))
}

/// The plain name of a called function.
fn function(callee: &Expr) -> Option<Ident> {
    match callee {
        Expr::Path(path) if path.qself.is_none() => path.path.get_ident().cloned(),
        _ => None,
    }
}
