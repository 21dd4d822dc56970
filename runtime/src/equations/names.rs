//! Names in LaTeX.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Greek letters that LaTeX has under their names; `pi` is left out, for the letter is the number's.
const GREEK: [&str; 33] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Sigma",
    "Upsilon", "Phi", "Psi", "Omega", "Pi",
];

/// The same letters by their characters, in that order.
const LETTERS: &str = "αβγδεζηθικλμνξρστυφχψωΓΔΘΛΞΣΥΦΨΩΠ";

/// A symbol as it stands on either side of an equation: `theta_1`, `dot(x)`, `m[3]`, `lambda(rod)`, `h_u*`.
pub(super) fn symbol(text: &str) -> String {
    let (text, star) = match text.strip_suffix('*') {
        Some(text) => (text, "^{*}"),
        None => (text, ""),
    };
    let mut latex = match text.strip_suffix(')').and_then(|text| text.split_once('(')) {
        Some(("dot", of)) => name(of, 1),
        Some(("ddot", of)) => name(of, 2),
        Some((letter @ ("lambda" | "f" | "phi"), of)) => with_subscripts(&base(letter), &[upright(of)]),
        Some((function, of)) => alloc::format!("{}\\left({}\\right)", upright(function), name(of, 0)),
        None => name(text, 0),
    };
    latex.push_str(star);
    latex
}

/// A name with so many dots, those included that it begins with.
fn name(text: &str, dots: usize) -> String {
    if text == "PI" {
        return r"\pi".to_string();
    }
    let text = text.strip_prefix("r#").unwrap_or(text);
    let (identifier, indices) = text.split_once('[').unwrap_or((text, ""));
    let indices = indices.split(['[', ']']).filter(|index| !index.is_empty()).map(upright_or_digits);
    // Where underscores do more than separate, the name is told from others only as it stands.
    if identifier.split('_').any(str::is_empty) {
        let subscripts: Vec<String> = indices.collect();
        return with_subscripts(&dotted(upright(identifier), dots), &subscripts);
    }
    let (mut identifier, mut dots) = (identifier, dots);
    while let Some((rate @ ("dot" | "ddot"), of)) = identifier.split_once('_')
        && !of.starts_with(|c: char| c.is_ascii_digit())
    {
        dots += if rate == "dot" { 1 } else { 2 };
        identifier = of;
    }
    let mut words = identifier.split('_');
    let first = words.next().unwrap_or_default();
    let (letters, digits) = first.split_at(first.trim_end_matches(|c: char| c.is_ascii_digit()).len());
    let trailing = (!digits.is_empty()).then(|| digits.to_string());
    let subscripts: Vec<String> = trailing.into_iter().chain(words.map(upright_or_digits)).chain(indices).collect();
    with_subscripts(&dotted(base(letters), dots), &subscripts)
}

/// A letter as such, a Greek letter by its command, longer words upright.
fn base(word: &str) -> String {
    let mut characters = word.chars();
    match (characters.next(), characters.next()) {
        _ if GREEK.contains(&word) => alloc::format!("\\{word}"),
        (Some(letter), None) if letter.is_ascii_alphabetic() => word.to_string(),
        (Some(letter), None) => match LETTERS.chars().position(|known| known == letter) {
            Some(at) => alloc::format!("\\{}", GREEK[at]),
            None => upright(word),
        },
        _ => upright(word),
    }
}

fn upright_or_digits(word: &str) -> String {
    if word.bytes().all(|b| b.is_ascii_digit()) { word.to_string() } else { base(word) }
}

/// Upright and escaped. Letters beyond ASCII stand as text, which is where LaTeX takes them.
pub(super) fn upright(word: &str) -> String {
    let style = if word.is_ascii() { "mathrm" } else { "text" };
    alloc::format!("\\{style}{{{}}}", escaped(word))
}

/// Without characters that mean something to TeX.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '_' | '{' | '}' | '%' | '$' | '#' | '&' => {
                out.push('\\');
                out.push(c);
            }
            '\\' => out.push_str(r"\textbackslash{}"),
            '^' => out.push_str(r"\textasciicircum{}"),
            '~' => out.push_str(r"\textasciitilde{}"),
            '…' => out.push_str(r"\ldots{}"),
            c => out.push(c),
        }
    }
    out
}

fn dotted(base: String, dots: usize) -> String {
    match dots {
        0 => base,
        1 => alloc::format!("\\dot{{{base}}}"),
        2 => alloc::format!("\\ddot{{{base}}}"),
        3 => alloc::format!("\\dddot{{{base}}}"),
        _ => alloc::format!("{base}^{{({dots})}}"),
    }
}

fn with_subscripts(base: &str, subscripts: &[String]) -> String {
    if subscripts.is_empty() { base.to_string() } else { alloc::format!("{base}_{{{}}}", subscripts.join(",")) }
}
