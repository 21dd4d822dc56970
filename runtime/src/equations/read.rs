//! Reading the notation of models, by precedence.

mod tokens;

use alloc::boxed::Box;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use super::Formula;
use tokens::of_name;

/// Formulas are not higher than this, so that no text exhausts the stack. Those of the tests' models, the random ones included, reach 24.
const HIGHEST: usize = 64;

/// Why a text is no formula.
///
/// ```
/// use holonomy::equations::Formula;
///
/// let error = "m*(a + b".parse::<Formula>().unwrap_err();
/// assert_eq!((error.at, error.expected), (8, "`)`"));
/// assert_eq!(error.to_string(), "expected `)` at byte 8, found the end");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Unreadable {
    /// Where in the text, in bytes.
    pub at: usize,
    /// What should stand there.
    pub expected: &'static str,
    /// What stands there; empty at the end.
    pub found: String,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected {} at byte {}, found ", self.expected, self.at)?;
        if self.found.is_empty() { f.write_str("the end") } else { write!(f, "`{}`", self.found) }
    }
}

impl core::error::Error for Unreadable {}

impl FromStr for Formula {
    type Err = Unreadable;

    fn from_str(text: &str) -> Result<Self, Unreadable> {
        let mut reader = Reader { text, at: 0, depth: 0 };
        let formula = if reader.next() == Some('[') { reader.brackets()? } else { reader.sum()?.formula };
        match reader.next() {
            None => Ok(formula),
            Some(_) => Err(reader.refuse("an operator or the end")),
        }
    }
}

/// A formula and its height.
struct Tall {
    formula: Formula,
    height: usize,
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    /// How many parentheses, arguments and branches are open.
    depth: usize,
}

impl Reader<'_> {
    /// One floor above the highest of what it is made of.
    fn build(&mut self, below: usize, formula: Formula) -> Result<Tall, Unreadable> {
        let height = below + 1;
        if height > HIGHEST {
            Err(self.refuse("a formula that is nested less deeply"))
        } else {
            Ok(Tall { formula, height })
        }
    }

    fn negative(&mut self, of: Tall) -> Result<Tall, Unreadable> {
        self.build(of.height, Formula::Negative(Box::new(of.formula)))
    }

    /// Something that may hold sums again.
    fn nested(&mut self) -> Result<Tall, Unreadable> {
        if self.depth >= HIGHEST {
            return Err(self.refuse("a formula that is nested less deeply"));
        }
        self.depth += 1;
        let inner = self.sum();
        self.depth -= 1;
        inner
    }

    fn sum(&mut self) -> Result<Tall, Unreadable> {
        let first = self.eat('-');
        let mut term = self.product()?;
        if first {
            term = self.negative(term)?;
        }
        let (mut terms, mut height) = (Vec::new(), term.height);
        loop {
            let minus = match self.next() {
                Some('+') => false,
                Some('-') => true,
                _ => break,
            };
            self.at += 1;
            let mut next = self.product()?;
            if minus {
                next = self.negative(next)?;
            }
            height = height.max(next.height);
            terms.push(next.formula);
        }
        if terms.is_empty() {
            return Ok(term);
        }
        terms.insert(0, term.formula);
        self.build(height, Formula::Sum(terms))
    }

    fn product(&mut self) -> Result<Tall, Unreadable> {
        let mut all = self.factor()?;
        // Whether `all` is a product without parentheses, which takes further factors in.
        let mut open = false;
        loop {
            match self.next() {
                Some('*') => {
                    self.at += 1;
                    let factor = self.factor()?;
                    if let (true, Formula::Product(factors)) = (open, &mut all.formula) {
                        factors.push(factor.formula);
                        all.height = all.height.max(factor.height + 1);
                        if all.height > HIGHEST {
                            return Err(self.refuse("a formula that is nested less deeply"));
                        }
                    } else {
                        let height = all.height.max(factor.height);
                        all = self.build(height, Formula::Product(Vec::from([all.formula, factor.formula])))?;
                        open = true;
                    }
                }
                Some('/') => {
                    self.at += 1;
                    let below = self.factor()?;
                    let height = all.height.max(below.height);
                    let (numerator, denominator) = (Box::new(all.formula), Box::new(below.formula));
                    all = self.build(height, Formula::Quotient { numerator, denominator })?;
                    open = false;
                }
                _ => return Ok(all),
            }
        }
    }

    fn factor(&mut self) -> Result<Tall, Unreadable> {
        let mut signs = 0;
        while self.eat('-') {
            signs += 1;
        }
        let mut factor = self.atom()?;
        for _ in 0..signs {
            factor = self.negative(factor)?;
        }
        Ok(factor)
    }

    fn atom(&mut self) -> Result<Tall, Unreadable> {
        match self.next() {
            Some('(') => {
                self.at += 1;
                let inner = self.nested()?;
                self.require(')', "`)`")?;
                Ok(inner)
            }
            Some(c) if c.is_ascii_digit() => {
                let number = self.number();
                self.build(0, Formula::Number(number))
            }
            Some(c) if of_name(c) => {
                let name = self.name();
                if name == "if" { self.select() } else { self.named(name) }
            }
            _ => Err(self.refuse("a number, a name or `(`")),
        }
    }

    /// A symbol, an element of an array, a power or a function.
    fn named(&mut self, name: &str) -> Result<Tall, Unreadable> {
        if self.rest().starts_with('[') {
            let symbol = name.to_string() + &self.indices()?;
            return self.build(0, Formula::Symbol(symbol));
        }
        if !self.eat('(') {
            return self.build(0, Formula::Symbol(name.to_string()));
        }
        let first = self.nested()?;
        if name == "powi" {
            self.require(',', "`,`")?;
            let exponent = self.exponent()?;
            self.require(')', "`)`")?;
            return self.build(first.height, Formula::Power { base: Box::new(first.formula), exponent });
        }
        if let ("dot" | "ddot", Formula::Symbol(of)) = (name, &first.formula) {
            let symbol = alloc::format!("{name}({of})");
            self.require(')', "`)`")?;
            return self.build(0, Formula::Symbol(symbol));
        }
        let (mut arguments, mut height) = (Vec::from([first.formula]), first.height);
        while self.eat(',') {
            let next = self.nested()?;
            height = height.max(next.height);
            arguments.push(next.formula);
        }
        self.require(')', "`,` or `)`")?;
        self.build(height, Formula::Call { function: name.to_string(), arguments })
    }

    /// What follows on `if`.
    fn select(&mut self) -> Result<Tall, Unreadable> {
        let condition = self.nested()?;
        self.require('<', "`<`")?;
        self.require('0', "`0`")?;
        self.require('{', "`{`")?;
        let negative = self.nested()?;
        self.require('}', "`}`")?;
        self.require_else()?;
        self.require('{', "`{`")?;
        let otherwise = self.nested()?;
        self.require('}', "`}`")?;
        let height = condition.height.max(negative.height).max(otherwise.height);
        let [condition, negative, otherwise] = [condition, negative, otherwise].map(|tall| Box::new(tall.formula));
        self.build(height, Formula::Select { condition, negative, otherwise })
    }

    /// A vector or a matrix, from its first bracket on.
    fn brackets(&mut self) -> Result<Formula, Unreadable> {
        self.require('[', "`[`")?;
        if self.next() != Some('[') {
            return Ok(Formula::Vector(self.entries()?));
        }
        let mut rows: Vec<Vec<Formula>> = Vec::new();
        loop {
            self.require('[', "`[`")?;
            let row = self.entries()?;
            if rows.first().is_some_and(|first| first.len() != row.len()) {
                self.at -= 1;
                return Err(self.refuse("a row as long as the first"));
            }
            rows.push(row);
            if !self.eat(',') {
                self.require(']', "`,` or `]`")?;
                return Ok(Formula::Matrix(rows));
            }
        }
    }

    /// Formulas up to a closing bracket, which is taken.
    fn entries(&mut self) -> Result<Vec<Formula>, Unreadable> {
        let mut entries = Vec::new();
        if self.eat(']') {
            return Ok(entries);
        }
        loop {
            entries.push(self.sum()?.formula);
            if !self.eat(',') {
                self.require(']', "`,` or `]`")?;
                return Ok(entries);
            }
        }
    }
}
