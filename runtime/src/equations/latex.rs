//! Formulas in LaTeX.

#[cfg(test)]
mod tests;

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{Formula, names};

/// Functions that LaTeX has a command for, by their names in models.
const COMMANDS: [(&str, &str); 12] = [
    ("sin", r"\sin"),
    ("cos", r"\cos"),
    ("tan", r"\tan"),
    ("asin", r"\arcsin"),
    ("acos", r"\arccos"),
    ("atan", r"\arctan"),
    ("sinh", r"\sinh"),
    ("cosh", r"\cosh"),
    ("tanh", r"\tanh"),
    ("ln", r"\ln"),
    ("exp", r"\exp"),
    ("sign", r"\operatorname{sgn}"),
];

/// The same functions, whose powers are written at the function: sin²θ.
const POWERS_AT_THE_FUNCTION: [&str; 6] = ["sin", "cos", "tan", "sinh", "cosh", "tanh"];

/// A line of a page takes about so many characters of a formula.
const WIDEST: usize = 80;

/// `bmatrix` has room for so many columns.
const COLUMNS: usize = 10;

fn parenthesised(latex: &str) -> String {
    format!("\\left({latex}\\right)")
}

fn command(function: &str) -> Option<&'static str> {
    COMMANDS.iter().find(|(name, _)| *name == function).map(|(_, command)| *command)
}

impl Formula {
    /// The formula in LaTeX, for math mode with amsmath: quotients as fractions, vectors and matrices as `bmatrix`, `if` as
    /// `cases`, functions of LaTeX's own by their commands and behind the other factors of a product, others upright.
    ///
    /// ```
    /// use holonomy::equations::Formula;
    ///
    /// let latex = |text: &str| text.parse().map(|formula: Formula| formula.latex());
    /// assert_eq!(latex("powi(sin(theta_1), 2)*dot(x)/2")?, r"\frac{\dot{x} \sin^{2}\theta_{1}}{2}");
    /// assert_eq!(latex("[m[3]*(a + b), -2*mass]")?, r"\begin{bmatrix} m_{3} \left(a + b\right) \\ -2 \, \mathrm{mass} \end{bmatrix}");
    /// # Ok::<(), holonomy::equations::Unreadable>(())
    /// ```
    pub fn latex(&self) -> String {
        match self {
            Formula::Number(digits) => number(digits),
            Formula::Symbol(name) => names::symbol(name),
            Formula::Negative(of) => format!("-{}", of.as_term()),
            Formula::Sum(terms) => sum(terms),
            Formula::Product(_) | Formula::Quotient { .. } => fraction(self),
            Formula::Power { base, exponent } => power(base, *exponent),
            Formula::Call { function, arguments } => call(function, arguments),
            Formula::Select { condition, negative, otherwise } => format!(
                "\\begin{{cases}} {} & \\text{{if }} {} < 0 \\\\ {} & \\text{{otherwise}} \\end{{cases}}",
                negative.latex(),
                condition.latex(),
                otherwise.latex()
            ),
            Formula::Vector(entries) => matrix(&entries.iter().map(core::slice::from_ref).collect::<Vec<_>>()),
            Formula::Matrix(rows) => matrix(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>()),
        }
    }

    /// The same in lines that a page is wide enough for, as far as breaks between the terms of a sum go.
    pub(super) fn latex_in_lines(&self) -> Vec<String> {
        let Formula::Sum(terms) = self else { return Vec::from([self.latex()]) };
        let mut lines: Vec<String> = Vec::new();
        for (at, term) in terms.iter().enumerate() {
            let signed = signed(at, term);
            match lines.last_mut() {
                Some(line) if width(line) + width(&signed) <= WIDEST => line.push_str(&signed),
                _ => lines.push(signed),
            }
        }
        lines
    }

    /// As a term of a sum.
    fn as_term(&self) -> String {
        let latex = self.latex();
        if matches!(self, Formula::Sum(_) | Formula::Negative(_) | Formula::Select { .. }) {
            parenthesised(&latex)
        } else {
            latex
        }
    }

    /// As the base of a power.
    fn as_base(&self) -> String {
        let latex = self.latex();
        match self {
            Formula::Number(digits) if !digits.contains(['e', 'E']) => latex,
            // Two superscripts on one letter are an error in TeX.
            Formula::Symbol(_) if !latex.contains('^') => latex,
            Formula::Call { function, .. } if function == "abs" => latex,
            _ => parenthesised(&latex),
        }
    }

    /// Where the formula stands in a product: numbers first, functions that may do without parentheses last.
    fn rank(&self) -> u8 {
        match self {
            Formula::Number(_) => 0,
            Formula::Call { function, .. } if command(function).is_some() => 2,
            Formula::Power { base, .. } => match &**base {
                Formula::Call { function, .. } if POWERS_AT_THE_FUNCTION.contains(&function.as_str()) => 2,
                _ => 1,
            },
            _ => 1,
        }
    }
}

/// Digits; an exponent as a power of ten.
fn number(text: &str) -> String {
    match text.split_once(['e', 'E']) {
        Some((digits, exponent)) => format!("{digits} \\cdot 10^{{{}}}", exponent.trim_start_matches('+')),
        None => text.to_string(),
    }
}

fn sum(terms: &[Formula]) -> String {
    terms.iter().enumerate().map(|(at, term)| signed(at, term)).collect()
}

/// A term with the sign before it.
fn signed(at: usize, term: &Formula) -> String {
    let (sign, term) = match term {
        Formula::Negative(of) => (if at == 0 { "-" } else { " - " }, &**of),
        term => (if at == 0 { "" } else { " + " }, term),
    };
    format!("{sign}{}", term.as_term())
}

/// About how many characters wide the formula is set: commands count as one, what only groups as nothing, and fractions as if
/// their parts stood side by side.
fn width(latex: &str) -> usize {
    let (mut width, mut in_command) = (0, false);
    for c in latex.chars() {
        in_command = c == '\\' || (in_command && c.is_ascii_alphabetic());
        width += usize::from(c == '\\' || !(in_command || "{}_^ &".contains(c)));
    }
    width
}

/// A product or a quotient, all that is divided by below one line.
fn fraction(formula: &Formula) -> String {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    gather(formula, &mut above, &mut below);
    if below.is_empty() {
        product(&mut above)
    } else {
        format!("\\frac{{{}}}{{{}}}", product(&mut above), product(&mut below))
    }
}

fn gather<'a>(formula: &'a Formula, above: &mut Vec<&'a Formula>, below: &mut Vec<&'a Formula>) {
    match formula {
        Formula::Product(factors) => factors.iter().for_each(|factor| gather(factor, above, below)),
        Formula::Quotient { numerator, denominator } => {
            gather(numerator, above, below);
            match &**denominator {
                Formula::Product(factors) => below.extend(factors),
                single => below.push(single),
            }
        }
        single => above.push(single),
    }
}

fn product(factors: &mut [&Formula]) -> String {
    if let [single] = factors {
        return single.latex();
    }
    factors.sort_by_key(|factor| factor.rank());
    let mut out = String::new();
    let mut before = String::new();
    for factor in factors.iter() {
        let latex = factor.as_term();
        if !out.is_empty() {
            out.push_str(between(&before, &latex));
        }
        out.push_str(&latex);
        before = latex;
    }
    out
}

/// What keeps two factors apart: nothing, a thin space at upright names, and a dot where they would be read as one number or
/// as a function of what follows.
fn between(before: &str, after: &str) -> &'static str {
    let word = |latex: &str| latex.contains(r"\mathrm{") || latex.contains(r"\text{");
    if after.starts_with(|c: char| c.is_ascii_digit()) || (word(before) && after.starts_with(r"\left(")) {
        r" \cdot "
    } else if word(before) || word(after) {
        r" \, "
    } else {
        " "
    }
}

fn power(base: &Formula, exponent: i32) -> String {
    if let Formula::Call { function, arguments } = base
        && POWERS_AT_THE_FUNCTION.contains(&function.as_str())
        && let (Some(command), true) = (command(function), exponent > 1)
    {
        return applied(&format!("{command}^{{{exponent}}}"), arguments);
    }
    format!("{}^{{{exponent}}}", base.as_base())
}

fn call(function: &str, arguments: &[Formula]) -> String {
    match (function, arguments) {
        ("sqrt", [of]) => format!("\\sqrt{{{}}}", of.latex()),
        ("abs", [of]) => format!("\\left|{}\\right|", of.latex()),
        ("powf", [base, exponent]) => format!("{}^{{{}}}", base.as_base(), exponent.latex()),
        _ => match command(function) {
            Some(command) => applied(command, arguments),
            None => format!("{}{}", names::upright(function), parenthesised(&list(arguments))),
        },
    }
}

/// A function of one letter needs no parentheses: sin θ.
fn applied(command: &str, arguments: &[Formula]) -> String {
    match arguments {
        [Formula::Symbol(name)] => {
            let name = names::symbol(name);
            // A command ends where something other than a letter stands.
            let gap = if name.starts_with('\\') || command.ends_with('}') { "" } else { " " };
            format!("{command}{gap}{name}")
        }
        _ => format!("{command}{}", parenthesised(&list(arguments))),
    }
}

fn list(formulas: &[Formula]) -> String {
    formulas.iter().map(Formula::latex).collect::<Vec<_>>().join(", ")
}

fn matrix(rows: &[&[Formula]]) -> String {
    let row = |row: &&[Formula]| row.iter().map(Formula::latex).collect::<Vec<_>>().join(" & ");
    let body = rows.iter().map(row).collect::<Vec<_>>().join(r" \\ ");
    match rows.first().map_or(0, |first| first.len()) {
        columns if columns <= COLUMNS => format!("\\begin{{bmatrix}} {body} \\end{{bmatrix}}"),
        columns => format!("\\left[\\begin{{array}}{{{}}} {body} \\end{{array}}\\right]", "c".repeat(columns)),
    }
}
