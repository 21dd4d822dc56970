//! Models with tokens lost, doubled and exchanged: nothing panics, and what is refused says why.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

use super::super::build;
use super::{DISK, FIELDS};
use crate::syntax::read;

/// The tokens as text, brackets included; puncts that belong together stay together.
fn pieces(tokens: TokenStream, out: &mut Vec<String>) {
    let mut joint = false;
    for token in tokens {
        let (text, next) = match &token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                out.push(open.to_owned());
                pieces(group.stream(), out);
                (close.to_owned(), false)
            }
            TokenTree::Punct(punct) => (punct.to_string(), punct.spacing() == Spacing::Joint),
            other => (other.to_string(), false),
        };
        match out.last_mut() {
            Some(last) if joint => last.push_str(&text),
            _ => out.push(text),
        }
        joint = next;
    }
}

/// A reproducible sequence of numbers (xorshift).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n as u64) as usize
    }
}

#[test]
fn nothing_panics() {
    let rest = "
        #[constraint(along: v1 + r*v6 == 0)] #[constraint(height: z == 0)] #[configuration(of(s), z = s*t)]
        #[independent(v6, dot(phi))] #[inputs(tau)] #[define(k = m*r, q = k/2)]
        #[start(theta = PI/6)] #[holonomy(crate = ::a, simplify = off)]";
    let source = format!("{DISK}{rest}{FIELDS}");
    let mut original = Vec::new();
    pieces(source.parse().unwrap(), &mut original);
    let mut numbers = Numbers(0x2545_f491_4f6c_dd1d);
    let (mut refused, mut built) = (0, 0);
    for _ in 0..400 {
        let mut mutated = original.clone();
        for _ in 0..1 + numbers.below(3) {
            let (i, j) = (numbers.below(mutated.len()), numbers.below(mutated.len()));
            match numbers.below(4) {
                0 => {
                    mutated.remove(i);
                }
                1 => mutated.insert(i, mutated[j].clone()),
                2 => mutated.swap(i, j),
                _ => mutated[i] = mutated[j].clone(),
            }
        }
        let Ok(tokens) = mutated.join(" ").parse() else { continue };
        let (declarations, diagnostics) = read(tokens);
        let complete = declarations.as_ref().is_some_and(|declarations| declarations.complete);
        assert!(complete || !diagnostics.is_empty());
        // Incomplete declarations too: what they give is no use, but it is no panic either.
        match declarations.map(|declarations| build(&declarations)) {
            Some(Ok(_)) if diagnostics.is_empty() => built += 1,
            Some(Err(errors)) => {
                assert!(!errors.is_empty() || !diagnostics.is_empty());
                refused += 1;
            }
            _ => refused += 1,
        }
    }
    assert!(refused > 50 && built > 5, "{refused} refused, {built} built");
}
