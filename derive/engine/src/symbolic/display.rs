//! Text for messages and documentation.

use super::{Expr, Function, Graph, Node, Rational};
use std::collections::HashMap;

/// A subexpression whose text would be longer than this is printed as `…`.
const LONGEST: usize = 600;

/// How tightly the text binds: a sum, a product, an atom.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

impl Graph {
    /// The expression as text in the notation of models, for example `m*r*sin(theta)`.
    pub fn display(&self, e: Expr) -> String {
        self.display_all(&[e]).remove(0)
    }

    /// [`Graph::display`] of several expressions in one sweep.
    pub fn display_all(&self, roots: &[Expr]) -> Vec<String> {
        let mut texts: HashMap<Expr, (String, Binding)> = HashMap::new();
        for e in self.reachable(roots) {
            let (text, binding) = self.text(e, &texts);
            let text = if text.chars().count() > LONGEST { ("…".to_owned(), Binding::Atom) } else { (text, binding) };
            texts.insert(e, text);
        }
        roots.iter().map(|e| texts[e].0.clone()).collect()
    }

    fn text(&self, e: Expr, texts: &HashMap<Expr, (String, Binding)>) -> (String, Binding) {
        let at_least = |e: Expr, binding: Binding| {
            let (text, own) = &texts[&e];
            if *own >= binding { text.clone() } else { format!("({text})") }
        };
        match self.node(e) {
            Node::Number(n) if n.is_negative() => (n.to_string(), Binding::Sum),
            Node::Number(n) if n.as_integer().is_none() => (n.to_string(), Binding::Product),
            Node::Number(n) => (n.to_string(), Binding::Atom),
            Node::Symbol(symbol) => (self.name(*symbol).to_owned(), Binding::Atom),
            Node::Sum { constant, terms } => {
                let mut out = String::new();
                // A positive term first reads better than a leading minus.
                let mut order: Vec<usize> = (0..terms.len()).collect();
                order.sort_by_key(|i| terms[*i].0.is_negative());
                for i in order {
                    let (coefficient, term) = &terms[i];
                    join(&mut out, coefficient.is_negative());
                    let (n, d) = coefficient.parts();
                    let n = n.trim_start_matches('-');
                    if n != "1" {
                        out.push_str(&format!("{n}*"));
                    }
                    out.push_str(&at_least(*term, Binding::Product));
                    if d != "1" {
                        out.push_str(&format!("/{d}"));
                    }
                }
                if !constant.is_zero() {
                    join(&mut out, constant.is_negative());
                    let positive = if constant.is_negative() { constant.neg() } else { constant.clone() };
                    out.push_str(&positive.to_string());
                }
                let single = terms.len() == 1 && constant.is_zero() && !terms[0].0.is_negative();
                (out, if single { Binding::Product } else { Binding::Sum })
            }
            Node::Product(factors) => {
                let power = |base: &Expr, k: u32| {
                    if k == 1 { at_least(*base, Binding::Atom) } else { format!("powi({}, {k})", texts[base].0) }
                };
                let above: Vec<String> =
                    factors.iter().filter(|f| f.1 > 0).map(|(b, k)| power(b, k.unsigned_abs())).collect();
                let below: Vec<String> =
                    factors.iter().filter(|f| f.1 < 0).map(|(b, k)| power(b, k.unsigned_abs())).collect();
                let mut out = if above.is_empty() { "1".to_owned() } else { above.join("*") };
                for divisor in below {
                    out.push('/');
                    out.push_str(&divisor);
                }
                let atom = factors.len() == 1 && factors[0].1 > 1;
                (out, if atom { Binding::Atom } else { Binding::Product })
            }
            Node::Function(Function::Select, arguments) => {
                let [condition, negative, other] = [0, 1, 2].map(|k: usize| texts[&arguments[k]].0.as_str());
                (format!("if {condition} < 0 {{ {negative} }} else {{ {other} }}"), Binding::Sum)
            }
            Node::Function(function, arguments) => {
                let arguments: Vec<&str> = arguments.iter().map(|a| texts[a].0.as_str()).collect();
                (format!("{}({})", self.function_name(*function), arguments.join(", ")), Binding::Atom)
            }
        }
    }

    /// A number as text, for messages.
    pub fn display_number(&self, value: &Rational) -> String {
        value.to_string()
    }
}

fn join(out: &mut String, negative: bool) {
    match (out.is_empty(), negative) {
        (true, true) => out.push('-'),
        (true, false) => {}
        (false, true) => out.push_str(" - "),
        (false, false) => out.push_str(" + "),
    }
}
