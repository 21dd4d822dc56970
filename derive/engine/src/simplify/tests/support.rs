//! What the tests share.

use crate::symbolic::{Expr, Graph, Kind, Rational, Symbol};

/// Expressions from names, by a small parser of our own: `+ - * / ( )`, powers by `^`, sin, cos, sqrt.
pub struct Names {
    pub graph: Graph,
    names: Vec<(String, Symbol)>,
}

impl Names {
    pub fn new(names: &[(&str, Kind)]) -> Self {
        let mut graph = Graph::new();
        let names = names.iter().flat_map(|(list, kind)| list.split_whitespace().map(move |n| (n.to_owned(), *kind)));
        let names = names.map(|(name, kind)| (name.clone(), graph.symbol(&name, kind))).collect();
        Names { graph, names }
    }

    pub fn parse(&mut self, text: &str) -> Expr {
        let tokens: Vec<char> = text.chars().filter(|c| !c.is_whitespace()).collect();
        let mut at = 0;
        let e = self.sum(&tokens, &mut at);
        assert_eq!(at, tokens.len(), "{text}");
        e
    }

    fn sum(&mut self, t: &[char], at: &mut usize) -> Expr {
        let mut total = self.graph.zero();
        let mut minus = t[*at] == '-';
        *at += usize::from(minus);
        loop {
            let term = self.term(t, at);
            total = if minus { self.graph.sub(total, term) } else { self.graph.add(total, term) };
            match t.get(*at) {
                Some(c @ ('+' | '-')) => minus = *c == '-',
                _ => return total,
            }
            *at += 1;
        }
    }

    fn term(&mut self, t: &[char], at: &mut usize) -> Expr {
        let mut total = self.factor(t, at);
        while let Some(c @ ('*' | '/')) = t.get(*at) {
            *at += 1;
            let factor = self.factor(t, at);
            total = if *c == '*' { self.graph.mul(total, factor) } else { self.graph.div(total, factor) };
        }
        total
    }

    fn factor(&mut self, t: &[char], at: &mut usize) -> Expr {
        let mut word = String::new();
        while t.get(*at).is_some_and(|c| c.is_alphanumeric()) {
            word.push(t[*at]);
            *at += 1;
        }
        let mut base = if t.get(*at) == Some(&'(') {
            *at += 1;
            let inner = self.sum(t, at);
            *at += 1;
            match word.as_str() {
                "" => inner,
                "sin" => self.graph.sin(inner),
                "cos" => self.graph.cos(inner),
                "tan" => self.graph.tan(inner),
                "sqrt" => self.graph.sqrt(inner),
                other => panic!("function {other}"),
            }
        } else if let Some(number) = Rational::parse(&word) {
            self.graph.number(number)
        } else {
            let symbol = self.names.iter().find(|(n, _)| *n == word).unwrap_or_else(|| panic!("name {word}")).1;
            self.graph.var(symbol)
        };
        if t.get(*at) == Some(&'^') {
            *at += 1;
            let exponent = self.factor(t, at);
            let n = self.graph.as_number(exponent).and_then(Rational::as_integer).unwrap();
            base = self.graph.powi(base, n as i32);
        }
        base
    }
}
