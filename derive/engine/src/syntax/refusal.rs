//! Rust syntax that is no part of an equation, and what to write instead.

use proc_macro2::Span;
use syn::{Expr, Lit, Member, UnOp};

use super::diagnostics::messages;

/// Where to point and what to say about an expression of a kind that equations do not have.
/// `start` is where the whole expression begins, for kinds without a telling token of their own.
pub(crate) fn refusal(expression: &Expr, start: Span) -> (Span, String) {
    match expression {
        Expr::MethodCall(call) => (call.method.span(), messages::method_call(&call.method)),
        Expr::Field(field) => {
            let of_self = matches!(&*field.base, Expr::Path(path) if path.path.is_ident("self"));
            match &field.member {
                Member::Named(name) if of_self => (name.span(), messages::field_of_self(name)),
                Member::Named(name) => (name.span(), messages::component(name)),
                Member::Unnamed(index) => (index.span, messages::component(index.index)),
            }
        }
        Expr::Path(path) => {
            let last = path.path.segments.last();
            let span = last.map_or(start, |segment| segment.ident.span());
            match last {
                Some(segment) if segment.ident == "PI" => (span, messages::path_to_pi()),
                _ => (span, messages::path()),
            }
        }
        Expr::Lit(literal) => (literal.lit.span(), literal_refusal(&literal.lit)),
        Expr::Index(index) => (index.bracket_token.span.open(), messages::index()),
        Expr::Array(array) => (array.bracket_token.span.open(), messages::array()),
        Expr::Repeat(array) => (array.bracket_token.span.open(), messages::array()),
        Expr::Tuple(tuple) => (tuple.paren_token.span.open(), messages::tuple()),
        Expr::Match(choice) => (choice.match_token.span, messages::choice_by_match()),
        Expr::Cast(cast) => (cast.as_token.span, messages::cast()),
        Expr::Infer(infer) => (infer.underscore_token.span, messages::underscore()),
        Expr::Reference(reference) => (reference.and_token.span, messages::operator("&")),
        Expr::Assign(assign) => (assign.eq_token.span, messages::equation_in_expression()),
        Expr::Unary(unary) => match unary.op {
            UnOp::Deref(token) => (token.span, messages::operator("*")),
            UnOp::Not(token) => (token.span, messages::operator("!")),
            _ => (start, messages::foreign_syntax()),
        },
        Expr::Try(unwrap) => (unwrap.question_token.span, messages::operator("?")),
        Expr::Block(block) => (block.block.brace_token.span.open(), messages::foreign_syntax()),
        Expr::Macro(call) => (call.mac.bang_token.span, messages::foreign_syntax()),
        Expr::Closure(closure) => (closure.inputs_begin.span, messages::foreign_syntax()),
        _ => (start, messages::foreign_syntax()),
    }
}

fn literal_refusal(literal: &Lit) -> String {
    match literal {
        Lit::Int(_) | Lit::Float(_) => messages::foreign_syntax(),
        _ => messages::not_a_number(),
    }
}
