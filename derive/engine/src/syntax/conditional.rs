//! `if a < b { .. } else { .. }`, taken apart.

use proc_macro2::TokenTree;
use quote::ToTokens;
use syn::{BinOp, Block, Expr, ExprIf, Stmt};

use super::diagnostics::{Place, messages};
use super::expression::Comparison;

/// Why an `if` is none of an equation, and what of it can be read all the same.
pub(crate) struct Refused {
    pub place: Place,
    pub message: String,
    pub parts: Vec<Expr>,
}

/// The comparison and its sides, then the two branches.
pub(crate) fn read(choice: ExprIf) -> Result<(Comparison, [Expr; 4]), Refused> {
    let if_token = choice.if_token.span;
    let refuse = |place: Place, message: String, parts: Vec<Expr>| Err(Refused { place, message, parts });
    let mut parts = Vec::new();
    let then = branch(choice.then_branch);
    let other = match choice.else_branch {
        None => return refuse(if_token.into(), messages::else_missing(), then.into_iter().collect()),
        Some((_, other)) => match *other {
            Expr::Block(block) => branch(block.block),
            other => Ok(other),
        },
    };
    let branches: Vec<Expr> = [&then, &other].into_iter().filter_map(|b| b.as_ref().ok().cloned()).collect();
    let compared = match *choice.cond {
        Expr::Binary(compared) => compared,
        other => {
            let place = place_of(&other).unwrap_or(if_token.into());
            return refuse(place, messages::condition_form(), branches);
        }
    };
    let operator = place_of(&compared.op).unwrap_or(if_token.into());
    let (comparison, exchanged) = match compared.op {
        BinOp::Lt(_) => (Comparison::Less, false),
        BinOp::Le(_) => (Comparison::AtMost, false),
        BinOp::Gt(_) => (Comparison::Less, true),
        BinOp::Ge(_) => (Comparison::AtMost, true),
        BinOp::And(_) | BinOp::Or(_) => return refuse(operator, messages::condition_joined(), branches),
        BinOp::Eq(_) | BinOp::Ne(_) => return refuse(operator, messages::condition_of_equality(), branches),
        _ => return refuse(operator, messages::condition_form(), branches),
    };
    let (left, right) = (*compared.left, *compared.right);
    parts.extend(if exchanged { [right, left] } else { [left, right] });
    match (then, other) {
        (Ok(then), Ok(other)) => {
            let [left, right]: [Expr; 2] = parts.try_into().unwrap_or_else(|_| unreachable!("two sides"));
            Ok((comparison, [left, right, then, other]))
        }
        (Err(place), _) | (_, Err(place)) => {
            parts.extend(branches);
            refuse(place, messages::branch_form(), parts)
        }
    }
}

/// The one expression of a block, or where it is something else.
fn branch(mut block: Block) -> Result<Expr, Place> {
    let place = Place::between(block.brace_token.span.open(), block.brace_token.span.close());
    match (block.stmts.pop(), block.stmts.is_empty()) {
        (Some(Stmt::Expr(expression, None)), true) => Ok(expression),
        _ => Err(place),
    }
}

fn place_of(tokens: &impl ToTokens) -> Option<Place> {
    let tokens: Vec<TokenTree> = tokens.to_token_stream().into_iter().collect();
    Some(Place::between(tokens.first()?.span(), tokens.last()?.span()))
}
