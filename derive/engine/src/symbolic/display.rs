//! Text for messages and documentation.

use super::tables::Set;
use super::{Expr, Function, Graph, Node, Rational, unicode};
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

/// How expressions are written.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum Notation {
    /// As in models: `m*powi(r, 2)*sin(theta)`.
    Model,
    /// As in print: `m·r²·sin(θ)`.
    Unicode,
}

/// Expressions that are written by name: what is long, or used in several places and not short. Those that others are made of come
/// first.
#[derive(Clone, Debug, Default)]
pub struct Parts {
    names: HashMap<Expr, String>,
    order: Vec<Expr>,
}

/// A text longer than this gets a name.
const LONG: usize = 240;
/// One longer than this that stands in several places does so too.
const REPEATED: usize = 100;

impl Parts {
    /// The name of an expression that is a part.
    pub fn name(&self, e: Expr) -> Option<&str> {
        self.names.get(&e).map(String::as_str)
    }

    /// The parts of which expressions are made, directly or through others.
    pub fn of(&self, graph: &Graph, roots: &[Expr]) -> Vec<(Expr, &str)> {
        let inside = Set::of(&graph.reachable(roots));
        self.order.iter().filter(|e| inside.contains(**e)).map(|e| (*e, self.names[e].as_str())).collect()
    }
}

/// Texts of expressions: where others are made of them, and on their own where these differ.
#[derive(Default)]
struct Texts {
    inside: HashMap<Expr, (String, Binding)>,
    whole: HashMap<Expr, String>,
}

impl Texts {
    fn on_its_own(&self, e: Expr) -> String {
        self.whole.get(&e).unwrap_or(&self.inside[&e].0).clone()
    }
}

impl Graph {
    /// The expression as text in the notation of models, for example `m*r*sin(theta)`.
    pub fn display(&self, e: Expr) -> String {
        self.display_all(&[e]).remove(0)
    }

    /// [`Graph::display`] of several expressions in one sweep.
    pub fn display_all(&self, roots: &[Expr]) -> Vec<String> {
        let long = |_, text: &str| (text.chars().count() > LONGEST).then(|| "…".to_owned());
        let texts = self.texts(roots, Notation::Model, long);
        roots.iter().map(|e| texts.inside[e].0.clone()).collect()
    }

    /// The expressions in the notation of models and in full, long ones over named parts: the texts of the expressions and of the
    /// parts, and the parts. `name` gives the name of the n-th part.
    pub fn display_by_parts(&self, roots: &[Expr], name: impl Fn(usize) -> String) -> (HashMap<Expr, String>, Parts) {
        let mut used: HashMap<Expr, usize> = HashMap::new();
        for e in self.reachable(roots) {
            self.node(e).children().into_iter().for_each(|child| *used.entry(child).or_default() += 1);
        }
        let mut parts = Parts::default();
        let texts = self.texts(roots, Notation::Model, |e, text| {
            let (length, uses) = (text.chars().count(), used.get(&e).copied().unwrap_or(0));
            let named = (length > LONG && uses > 0) || (length > REPEATED && uses > 1);
            named.then(|| {
                parts.order.push(e);
                let name = name(parts.order.len());
                parts.names.insert(e, name.clone());
                name
            })
        });
        let told = roots.iter().chain(&parts.order).map(|e| (*e, texts.on_its_own(*e))).collect();
        (told, parts)
    }

    /// The expressions in a notation, over parts that were named before.
    pub fn display_over(&self, roots: &[Expr], parts: &Parts, notation: Notation) -> Vec<String> {
        let texts = self.texts(roots, notation, |e, _| parts.name(e).map(|name| notation.name(name)));
        roots.iter().map(|e| texts.on_its_own(*e)).collect()
    }

    /// The texts of all expressions of which the roots are made; `instead` gives a name for a text.
    fn texts(
        &self,
        roots: &[Expr],
        notation: Notation,
        mut instead: impl FnMut(Expr, &str) -> Option<String>,
    ) -> Texts {
        let mut texts = Texts::default();
        for e in self.reachable(roots) {
            let (text, binding) = self.text(e, &texts.inside, notation);
            match instead(e, &text) {
                Some(name) => {
                    texts.whole.insert(e, text);
                    texts.inside.insert(e, (name, Binding::Atom));
                }
                None => {
                    texts.inside.insert(e, (text, binding));
                }
            }
        }
        texts
    }

    fn text(&self, e: Expr, texts: &HashMap<Expr, (String, Binding)>, notation: Notation) -> (String, Binding) {
        let at_least = |e: Expr, binding: Binding| {
            let (text, own) = &texts[&e];
            if *own >= binding { text.clone() } else { format!("({text})") }
        };
        let times = notation.times();
        match self.node(e) {
            Node::Number(n) if n.is_negative() => (notation.signed(&n.to_string()), Binding::Sum),
            Node::Number(n) if n.as_integer().is_none() => (n.to_string(), Binding::Product),
            Node::Number(n) => (n.to_string(), Binding::Atom),
            Node::Symbol(symbol) => (notation.name(self.name(*symbol)), Binding::Atom),
            Node::Sum { constant, terms } => {
                let mut out = String::new();
                // A positive term first reads better than a leading minus.
                let mut order: Vec<usize> = (0..terms.len()).collect();
                order.sort_by_key(|i| terms[*i].0.is_negative());
                for i in order {
                    let (coefficient, term) = &terms[i];
                    notation.join(&mut out, coefficient.is_negative());
                    let (n, d) = coefficient.parts();
                    let n = n.trim_start_matches('-');
                    if n != "1" {
                        out.push_str(&format!("{n}{times}"));
                    }
                    out.push_str(&at_least(*term, Binding::Product));
                    if d != "1" {
                        out.push_str(&format!("/{d}"));
                    }
                }
                if !constant.is_zero() {
                    notation.join(&mut out, constant.is_negative());
                    let positive = if constant.is_negative() { constant.neg() } else { constant.clone() };
                    out.push_str(&positive.to_string());
                }
                let single = terms.len() == 1 && constant.is_zero() && !terms[0].0.is_negative();
                (out, if single { Binding::Product } else { Binding::Sum })
            }
            Node::Product(factors) => {
                let power = |base: &Expr, k: u32| match (k, notation) {
                    (1, _) => at_least(*base, Binding::Atom),
                    (_, Notation::Model) => format!("powi({}, {k})", texts[base].0),
                    (_, Notation::Unicode) => match self.node(*base) {
                        Node::Function(Function::Sin | Function::Cos, _) => unicode::raised(&texts[base].0, k),
                        Node::Symbol(_) => format!("{}{}", texts[base].0, unicode::superscript(k)),
                        _ => format!("({}){}", texts[base].0, unicode::superscript(k)),
                    },
                };
                let above: Vec<String> =
                    factors.iter().filter(|f| f.1 > 0).map(|(b, k)| power(b, k.unsigned_abs())).collect();
                let below: Vec<String> =
                    factors.iter().filter(|f| f.1 < 0).map(|(b, k)| power(b, k.unsigned_abs())).collect();
                let mut out = if above.is_empty() { "1".to_owned() } else { above.join(times) };
                for divisor in below {
                    out.push('/');
                    out.push_str(&divisor);
                }
                let atom = factors.len() == 1 && factors[0].1 > 1;
                (out, if atom { Binding::Atom } else { Binding::Product })
            }
            Node::Function(Function::Whole, arguments) => texts[&arguments[0]].clone(),
            Node::Function(Function::Select, arguments) => {
                let [condition, negative, other] = [0, 1, 2].map(|k: usize| texts[&arguments[k]].0.as_str());
                (format!("if {condition} < 0 {{ {negative} }} else {{ {other} }}"), Binding::Sum)
            }
            Node::Function(function, arguments) => {
                let inner: Vec<&str> = arguments.iter().map(|a| texts[a].0.as_str()).collect();
                let text = match (notation, function, self.node(arguments[0])) {
                    (Notation::Unicode, Function::Sqrt, Node::Symbol(_)) => format!("√{}", inner[0]),
                    (Notation::Unicode, Function::Sqrt, _) => format!("√({})", inner[0]),
                    _ => format!("{}({})", self.function_name(*function), inner.join(", ")),
                };
                (text, Binding::Atom)
            }
        }
    }

    /// A number as text, for messages.
    pub fn display_number(&self, value: &Rational) -> String {
        value.to_string()
    }
}

impl Notation {
    /// A name of the model, or of one of its parts.
    pub fn name(self, name: &str) -> String {
        match self {
            Notation::Model => name.to_owned(),
            Notation::Unicode => unicode::name(name),
        }
    }

    fn times(self) -> &'static str {
        match self {
            Notation::Model => "*",
            Notation::Unicode => "·",
        }
    }

    fn minus(self) -> &'static str {
        match self {
            Notation::Model => "-",
            Notation::Unicode => "−",
        }
    }

    fn signed(self, number: &str) -> String {
        number.replacen('-', self.minus(), 1)
    }

    fn join(self, out: &mut String, negative: bool) {
        match (out.is_empty(), negative) {
            (true, true) => out.push_str(self.minus()),
            (true, false) => {}
            (false, true) => {
                out.push(' ');
                out.push_str(self.minus());
                out.push(' ');
            }
            (false, false) => out.push_str(" + "),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    fn disk(g: &mut Graph) -> Expr {
        let [m, r] = ["m", "r"].map(|name| g.symbol(name, Kind::Parameter)).map(|s| g.var(s));
        let [theta, q1] = ["theta", "q1"].map(|name| g.symbol(name, Kind::Coordinate)).map(|s| g.var(s));
        let (sin, cos) = (g.sin(theta), g.cos(q1));
        let r2 = g.powi(r, 2);
        let sin2 = g.powi(sin, 2);
        let a = [m, r2, sin2].into_iter().reduce(|a, b| g.mul(a, b)).expect("factors");
        let quotient = g.div(a, cos);
        let difference = g.sub(theta, q1);
        let other = g.cos(difference);
        let root = g.sqrt(m);
        let other = g.mul(other, root);
        g.sub(other, quotient)
    }

    #[test]
    fn an_expression_reads_as_in_print() {
        let mut g = Graph::new();
        let e = disk(&mut g);
        let [model, print] = [Notation::Model, Notation::Unicode]
            .map(|notation| g.display_over(&[e], &Parts::default(), notation).remove(0));
        assert_eq!(model, g.display(e));
        assert_eq!(model, "cos(theta - q1)*sqrt(m) - m*powi(r, 2)*powi(sin(theta), 2)/cos(q1)");
        assert_eq!(print, "cos(θ − q₁)·√m − m·r²·sin²(θ)/cos(q₁)");
    }

    #[test]
    fn what_is_long_stands_by_name_and_nothing_is_lost() {
        let mut g = Graph::new();
        let e = disk(&mut g);
        // A chain of squares: written out it would have thousands of characters.
        let mut tower = e;
        for _ in 0..8 {
            let square = g.powi(tower, 2);
            let scaled = g.mul(square, e);
            tower = g.add(scaled, e);
        }
        let (texts, parts) = g.display_by_parts(&[tower, e], |n| format!("e{n}"));
        let named = parts.of(&g, &[tower]);
        assert!(named.len() > 2 && texts.len() >= named.len());
        assert_eq!(texts[&e], g.display(e));
        for (part, name) in named {
            assert!(texts[&part].chars().count() < 3 * LONG && texts[&part] != name, "{name} = {}", texts[&part]);
            assert_eq!(vec![texts[&part].clone()], g.display_over(&[part], &parts, Notation::Model));
        }
        assert!(texts.values().all(|text| !text.contains('…')), "{texts:?}");
    }
}
