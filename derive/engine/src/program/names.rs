//! Identifiers: what the model says where it says something, descriptive where that stays short, numbered otherwise.

use super::operation::{Leaf, Operation, Reference};
use crate::projection::Equations;
use crate::symbolic::{Expr, Function, Given, Graph, Node, Rational};
use std::collections::BTreeSet;

/// Descriptive names stay below this many characters ...
const LONGEST: usize = 26;

/// ... and those of prepared quantities, which stand for all the work of parameters, below this.
const LONGEST_PREPARED: usize = 40;

/// Keywords of all editions that may be written as raw identifiers.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Words that can be no identifiers at all.
const FORBIDDEN: &[&str] = &["self", "Self", "super", "crate", "_", ""];

/// The arguments of emitted functions, which no local name may hide.
pub const ARGUMENTS: &[&str] = &["p", "t", "s", "i", "at", "v", "dv", "w", "dw", "lambda", "part"];

/// The name as a Rust identifier, raw where it is a keyword.
pub fn identifier(name: &str) -> String {
    let name = name.strip_prefix("r#").unwrap_or(name);
    let mut plain: String = name.chars().map(|c| if c == '_' || c.is_alphanumeric() { c } else { '_' }).collect();
    if plain.chars().next().is_some_and(char::is_numeric) {
        plain.insert(0, '_');
    }
    if FORBIDDEN.contains(&plain.as_str()) {
        plain.push('_');
        return plain;
    }
    if KEYWORDS.contains(&plain.as_str()) { format!("r#{plain}") } else { plain }
}

/// Names that were given out, so that each is given once.
#[derive(Clone, Default, Debug)]
pub struct Namer {
    used: BTreeSet<String>,
    counter: usize,
}

impl Namer {
    /// A namer that avoids the given names.
    pub fn avoiding<'a>(names: impl IntoIterator<Item = &'a str>) -> Self {
        Namer { used: names.into_iter().map(str::to_owned).collect(), counter: 0 }
    }

    /// The name, or the name with a number.
    pub fn unique(&mut self, wanted: &str) -> String {
        let wanted = identifier(wanted);
        let mut name = wanted.clone();
        let mut n = 2;
        while !self.used.insert(name.clone()) {
            name = format!("{}_{n}", wanted.trim_start_matches("r#"));
            n += 1;
        }
        name
    }

    /// A name for something that has none: a letter, and a number.
    pub fn numbered(&mut self, letter: char) -> String {
        loop {
            self.counter += 1;
            let name = format!("{letter}{}", self.counter);
            if self.used.insert(name.clone()) {
                return name;
            }
        }
    }
}

/// The field names of everything that emitted functions read.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Names {
    /// Parameters, then the other prepared values.
    pub values: Vec<String>,
    /// Coordinates of the state, then independent speeds.
    pub state: Vec<String>,
    /// How many of them are coordinates.
    pub state_coordinates: usize,
    /// Inputs.
    pub inputs: Vec<String>,
    /// Initial velocities.
    pub velocities: Vec<String>,
    /// Multipliers.
    pub multipliers: Vec<String>,
    /// Initial coordinates, as local variables.
    pub coordinates: Vec<String>,
    /// Carriers, as local variables.
    pub carriers: Vec<String>,
    /// Rates of the carriers, as local variables beside these.
    pub carrier_rates: Vec<String>,
    /// The user's functions and their derivatives.
    pub functions: Vec<Given>,
}

impl Names {
    /// The names in a model. Prepared values beyond the parameters are still to come.
    pub fn new(equations: &Equations) -> Self {
        let of = |symbols: &[crate::symbolic::Symbol]| -> Vec<String> {
            symbols.iter().map(|s| equations.graph.name(*s).to_owned()).collect()
        };
        let fields = |names: Vec<String>| -> Vec<String> {
            let mut namer = Namer::default();
            names.iter().map(|n| namer.unique(n)).collect()
        };
        let state = [of(&equations.state_coordinates), of(&equations.state_speeds)].concat();
        let locals = |symbols: &[crate::symbolic::Symbol]| -> Vec<String> {
            let mut namer = Namer::avoiding(ARGUMENTS.iter().copied());
            of(symbols).iter().map(|n| namer.unique(&n.to_lowercase())).collect()
        };
        let carriers = locals(&equations.carriers);
        let mut beside = Namer::avoiding(ARGUMENTS.iter().copied().chain(carriers.iter().map(String::as_str)));
        let rates: Vec<String> =
            carriers.iter().map(|w| beside.unique(&format!("dot_{}", w.trim_start_matches("r#")))).collect();
        Names {
            values: fields(of(&equations.parameters)),
            state: fields(state),
            state_coordinates: equations.state_coordinates.len(),
            inputs: fields(of(&equations.inputs)),
            velocities: fields(of(&equations.speeds)),
            multipliers: fields(equations.multiplier_names.clone()),
            functions: equations.graph.given().to_vec(),
            coordinates: locals(&equations.coordinates),
            carriers,
            carrier_rates: rates,
        }
    }

    /// The name of what is read, without its place.
    pub fn of(&self, leaf: Leaf) -> &str {
        match leaf {
            Leaf::Pi => "pi",
            Leaf::Time => "t",
            Leaf::Parameter(i) | Leaf::Value(i) => &self.values[i],
            Leaf::StateCoordinate(i) => &self.state[i],
            Leaf::StateSpeed(i) => &self.state[self.state_coordinates + i],
            Leaf::Coordinate(i) => &self.coordinates[i],
            Leaf::Speed(i) | Leaf::SpeedRate(i) => &self.velocities[i],
            Leaf::Carrier(i) => &self.carriers[i],
            Leaf::CarrierRate(i) => &self.carrier_rates[i],
            Leaf::Multiplier(i) => &self.multipliers[i],
            Leaf::Input(i) => &self.inputs[i],
        }
    }

    /// The argument that holds what is read; nothing for a local name.
    pub fn place(leaf: Leaf) -> &'static str {
        match leaf {
            Leaf::Pi | Leaf::Time | Leaf::Coordinate(_) | Leaf::Carrier(_) | Leaf::CarrierRate(_) => "",
            Leaf::Parameter(_) | Leaf::Value(_) => "p.",
            Leaf::StateCoordinate(_) | Leaf::StateSpeed(_) => "s.",
            Leaf::Speed(_) => "v.",
            Leaf::SpeedRate(_) => "dv.",
            Leaf::Multiplier(_) => "lambda.",
            Leaf::Input(_) => "i.",
        }
    }

    /// A lower-case description of a step by its operands' descriptions, where it stays short.
    pub fn describe(&self, operation: &Operation, of: &dyn Fn(Reference) -> Option<String>) -> Option<String> {
        let text = match operation {
            Operation::Read(Leaf::SpeedRate(i)) => {
                format!("d{}", self.velocities[*i].trim_start_matches("r#").to_lowercase())
            }
            Operation::Read(leaf) => self.of(*leaf).trim_start_matches("r#").to_lowercase(),
            Operation::Number(number) => word(number)?,
            Operation::Negate(a) => format!("minus_{}", of(*a)?),
            Operation::Add(a, b) => format!("{}_plus_{}", of(*a)?, of(*b)?),
            Operation::Subtract(a, b) => format!("{}_minus_{}", of(*a)?, of(*b)?),
            Operation::Multiply(a, b) => match (of(*a)?, of(*b)?) {
                (a, b) if b.starts_with("one_over_") => format!("{a}{}", &b["one".len()..]),
                (a, b) if a.starts_with("one_over_") => format!("{b}{}", &a["one".len()..]),
                (a, b) => format!("{a}_{b}"),
            },
            Operation::Divide(a, b) => format!("{}_over_{}", of(*a)?, of(*b)?),
            Operation::Sine(a) => format!("sin_{}", of(*a)?),
            Operation::Cosine(a) => format!("cos_{}", of(*a)?),
            Operation::Root(a) => format!("root_{}", of(*a)?),
            Operation::Call(function, arguments) => {
                let mut text = match function {
                    Function::Given(at) => self.functions[*at as usize].name.clone(),
                    other => other.name().to_owned(),
                };
                for argument in arguments {
                    text.push('_');
                    text.push_str(&of(*argument)?);
                }
                text
            }
        };
        (text.len() <= LONGEST).then_some(text)
    }
}

/// A number as a word.
pub fn word(number: &Rational) -> Option<String> {
    let words = ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];
    if let Some(n) = number.as_integer() {
        return words.get(usize::try_from(n).ok()?).map(|w| (*w).to_owned());
    }
    match number.parts() {
        (n, d) if n == "1" => match d.as_str() {
            "2" => Some("half".to_owned()),
            "3" => Some("third".to_owned()),
            "4" => Some("quarter".to_owned()),
            _ => None,
        },
        _ => None,
    }
}

/// A description of a quantity by its text, where it stays short: `m_r_r_plus_j`.
pub fn quantity(graph: &Graph, e: Expr) -> Option<String> {
    let mut texts: Vec<(Expr, Option<String>)> = Vec::new();
    for e in graph.reachable(&[e]) {
        let find = |child: Expr| {
            let at = texts.binary_search_by_key(&child, |(e, _)| *e).ok()?;
            texts[at].1.clone()
        };
        let text = describe_quantity(graph, e, &find).filter(|text| text.len() <= LONGEST_PREPARED);
        texts.push((e, text));
    }
    texts.pop()?.1.map(|text| text.to_lowercase())
}

fn describe_quantity(graph: &Graph, e: Expr, of: &dyn Fn(Expr) -> Option<String>) -> Option<String> {
    match graph.node(e) {
        Node::Number(number) => word(number),
        Node::Symbol(symbol) => Some(graph.name(*symbol).trim_start_matches("r#").to_owned()),
        Node::Sum { constant, terms } => {
            let mut text = String::new();
            let mut order: Vec<&(Rational, Expr)> = terms.iter().collect();
            order.sort_by_key(|(c, _)| c.is_negative());
            for (c, term) in order {
                text.push_str(joint(text.is_empty(), c.is_negative()));
                let magnitude = if c.is_negative() { c.neg() } else { c.clone() };
                if !magnitude.is_one() {
                    text.push_str(&word(&magnitude)?);
                    text.push('_');
                }
                text.push_str(&of(*term)?);
            }
            if !constant.is_zero() {
                text.push_str(joint(text.is_empty(), constant.is_negative()));
                text.push_str(&word(&if constant.is_negative() { constant.neg() } else { constant.clone() })?);
            }
            Some(text)
        }
        Node::Product(factors) => {
            let mut parts = Vec::new();
            for wanted in [false, true] {
                for (base, exponent) in factors.iter().filter(|(_, k)| (*k < 0) == wanted) {
                    if wanted {
                        if parts.is_empty() {
                            parts.push("one".to_owned());
                        }
                        parts.push("over".to_owned());
                    }
                    for _ in 0..exponent.unsigned_abs().min(LONGEST_PREPARED as u32) {
                        parts.push(of(*base)?);
                    }
                }
            }
            Some(parts.join("_"))
        }
        Node::Function(function, arguments) => {
            let name = graph.function_name(*function);
            let mut parts = vec![if name == "sqrt" { "root" } else { name }.to_owned()];
            for argument in arguments {
                parts.push(of(*argument)?);
            }
            Some(parts.join("_"))
        }
    }
}

fn joint(first: bool, negative: bool) -> &'static str {
    match (first, negative) {
        (true, false) => "",
        (true, true) => "minus_",
        (false, false) => "_plus_",
        (false, true) => "_minus_",
    }
}
