//! Integers in indices, ranges and sizes: `+ - * / %`, `min`, `max` and parentheses over literals.

use proc_macro2::{Delimiter, TokenTree};

use super::expression::is_punct;

/// The value; `None` where the tokens are no such expression, or where it has no value.
pub(crate) fn value(tokens: &[TokenTree]) -> Option<i64> {
    let (value, rest) = sum(tokens)?;
    rest.is_empty().then_some(value)
}

type Parsed<'a> = Option<(i64, &'a [TokenTree])>;

fn sum(tokens: &[TokenTree]) -> Parsed<'_> {
    let (mut value, mut rest) = product(tokens)?;
    loop {
        let minus = match rest.first() {
            Some(token) if is_punct(token, '+') => false,
            Some(token) if is_punct(token, '-') => true,
            _ => return Some((value, rest)),
        };
        let (other, behind) = product(&rest[1..])?;
        value = if minus { value.checked_sub(other)? } else { value.checked_add(other)? };
        rest = behind;
    }
}

fn product(tokens: &[TokenTree]) -> Parsed<'_> {
    let (mut value, mut rest) = atom(tokens)?;
    loop {
        let operator = match rest.first() {
            Some(TokenTree::Punct(punct)) if "*/%".contains(punct.as_char()) => punct.as_char(),
            _ => return Some((value, rest)),
        };
        let (other, behind) = atom(&rest[1..])?;
        value = match operator {
            '*' => value.checked_mul(other)?,
            '/' => value.checked_div(other)?,
            _ => value.checked_rem(other)?,
        };
        rest = behind;
    }
}

fn atom(tokens: &[TokenTree]) -> Parsed<'_> {
    // Signs in a loop: brackets are the only descent, and they are bounded.
    let signs = tokens.iter().take_while(|token| is_punct(token, '-')).count();
    let (first, mut rest) = tokens[signs..].split_first()?;
    let magnitude = match first {
        TokenTree::Literal(literal) => literal.to_string().replace('_', "").parse::<i64>().ok()?,
        TokenTree::Group(group) if matches!(group.delimiter(), Delimiter::Parenthesis | Delimiter::None) => {
            value(&group.stream().into_iter().collect::<Vec<_>>())?
        }
        TokenTree::Ident(name) if name == "min" || name == "max" => {
            let (TokenTree::Group(group), behind) = rest.split_first()? else { return None };
            rest = behind;
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            let comma = inner.iter().position(|token| is_punct(token, ','))?;
            let (a, b) = (value(&inner[..comma])?, value(&inner[comma + 1..])?);
            if name == "min" { a.min(b) } else { a.max(b) }
        }
        _ => return None,
    };
    Some((if signs % 2 == 1 { magnitude.checked_neg()? } else { magnitude }, rest))
}

#[cfg(test)]
mod tests {
    fn of(text: &str) -> Option<i64> {
        let tokens: proc_macro2::TokenStream = text.parse().unwrap();
        super::value(&tokens.into_iter().collect::<Vec<_>>())
    }

    #[test]
    fn integers_follow_the_rules_of_rust() {
        let table = [
            ("2 + 3*4 - 1", 13),
            ("-(7/2)*2", -6),
            ("7 % 4 - 10/3/2", 2),
            ("--3", 3),
            ("1_000", 1000),
            ("max(1, 2*2) - min(3, 1)", 3),
        ];
        for (text, expected) in table {
            assert_eq!(of(text), Some(expected), "{text}");
        }
        for text in ["", "1/0", "n", "1.5", "2 3", "1 +", "f(2)", "max(1)", "9223372036854775807 + 1"] {
            assert_eq!(of(text), None, "{text}");
        }
    }
}
