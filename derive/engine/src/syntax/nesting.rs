//! Bounds on nesting, checked on the tokens before anything recursive sees them.
//!
//! syn parses by recursive descent, and a stack overflow in a macro takes the compiler with it.
//! What makes a descent deep is counted here without recursion.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

use super::diagnostics::{Diagnostic, messages};

/// How deep brackets and what nests like them may go. The parser's frames of one such step take up
/// to 30 KiB in an unoptimised build, and a thread may have no more than 2 MiB of stack.
pub(crate) const DEPTH: usize = 48;

/// Refuses brackets that are nested deeper than [`DEPTH`], at the first one that is.
pub(crate) fn check_brackets(input: &TokenStream) -> Result<(), Diagnostic> {
    let mut open = vec![input.clone().into_iter()];
    while let Some(level) = open.last_mut() {
        match level.next() {
            None => {
                open.pop();
            }
            Some(TokenTree::Group(group)) => {
                if open.len() > DEPTH {
                    return Err(too_deep(group.span_open()));
                }
                open.push(group.stream().into_iter());
            }
            Some(_) => {}
        }
    }
    Ok(())
}

/// Refuses an expression whose descent would be deeper than [`DEPTH`]. Brackets count, and every
/// prefix operator in a row, and every `if` between the same brackets (`else if` descends); so does, wherever it stands,
/// each token that has no place in an equation (`match`, `|`, `.`, ..), and after the first of these every `<` (in a type
/// it descends). Sums and products may be long: they are parsed by a loop.
pub(crate) fn check_expression(expression: &[TokenTree]) -> Result<(), Diagnostic> {
    let mut foreign = 0;
    let mut open = vec![Level::new(expression.to_vec(), 0)];
    while let Some(level) = open.last_mut() {
        let Some(token) = level.tokens.next() else {
            open.pop();
            continue;
        };
        let span = token.span();
        let depth = level.depth + level.run + level.choices;
        let mut inner = None;
        match token {
            TokenTree::Literal(_) => level.operand(),
            TokenTree::Ident(ident) => {
                let choice = ident == "if";
                let known = choice || ident == "else";
                let keyword = !known && syn::parse2::<syn::Ident>(TokenTree::Ident(ident).into()).is_err();
                foreign += usize::from(keyword);
                level.operand();
                level.choices += usize::from(choice);
                // What follows is no call.
                level.after_operator = known;
            }
            TokenTree::Group(group) => {
                // `f(..)(..)(..)` is a chain, `f(..)` is not, and `if a < f(x) {..}` neither.
                foreign += usize::from(level.after_group && group.delimiter() != Delimiter::Brace);
                level.operand();
                level.after_group = group.delimiter() != Delimiter::None;
                inner = Some(group.stream().into_iter().collect());
            }
            TokenTree::Punct(punct) => {
                let comparison = match punct.as_char() {
                    '<' | '>' => foreign == 0,
                    '=' => level.after_comparison,
                    _ => false,
                };
                foreign += usize::from(!comparison && !"+-*/,".contains(punct.as_char()));
                level.after_comparison = comparison && punct.as_char() != '=';
                level.run = if level.after_operator { level.run + 1 } else { 0 };
                level.after_operator = true;
                level.after_group = false;
            }
        }
        if depth + foreign > DEPTH {
            return Err(too_deep(span));
        }
        if let Some(inner) = inner {
            open.push(Level::new(inner, depth + 1));
        }
    }
    Ok(())
}

/// The tokens between two brackets, as far as they are not yet looked at.
struct Level {
    tokens: std::vec::IntoIter<TokenTree>,
    /// How deep the brackets stand.
    depth: usize,
    /// Prefix operators in a row up to here.
    run: usize,
    after_operator: bool,
    after_group: bool,
    /// Behind a `<` or a `>`.
    after_comparison: bool,
    /// The `if`s up to here.
    choices: usize,
}

impl Level {
    fn new(tokens: Vec<TokenTree>, depth: usize) -> Self {
        Level {
            tokens: tokens.into_iter(),
            depth,
            run: 0,
            after_operator: true,
            after_group: false,
            after_comparison: false,
            choices: 0,
        }
    }

    fn operand(&mut self) {
        self.run = 0;
        self.after_operator = false;
        self.after_group = false;
        self.after_comparison = false;
    }
}

fn too_deep(span: Span) -> Diagnostic {
    Diagnostic { place: span.into(), message: messages::too_deep(DEPTH) }
}
