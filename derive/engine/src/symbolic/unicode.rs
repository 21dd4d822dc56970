//! Names as in print: Greek letters, subscripts, dots.

/// The names of Greek letters; `pi` is left out, for the letter is the number's.
const GREEK: [(&str, char); 34] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("PI", 'π'),
];

/// Over the letter before it.
const DOT: char = '\u{307}';
/// The same twice.
const DOTS: char = '\u{308}';

/// A name as in print: `theta1` and `theta_1` are θ₁, `dot_x` and `dot(x)` are ẋ, `dot(dot_x)` is ẍ, `m[3]` is m₃, `lambda(rod)`
/// is λ(rod). Words stay as they are.
pub fn name(name: &str) -> String {
    if let Some(dotted) = dotted(name) {
        return dotted;
    }
    match name.split_once('(') {
        Some((function, inner)) => format!("{}({inner}", plain(function)),
        None => plain(name),
    }
}

/// A rate with its dots over a letter; over a word they would not be seen.
fn dotted(rate: &str) -> Option<String> {
    let called = rate.strip_prefix("dot(").and_then(|rest| rest.strip_suffix(')'));
    let of = called.or_else(|| rate.strip_prefix("dot_"))?;
    let inner = name(of);
    let mut rest = inner.chars();
    let letter = rest.next().filter(|c| c.is_alphabetic())?;
    match rest.clone().next() {
        Some(DOT) => Some(format!("{letter}{DOTS}{}", &rest.as_str()[DOT.len_utf8()..])),
        Some(c) if c.is_alphabetic() => None,
        _ => Some(format!("{letter}{DOT}{}", rest.as_str())),
    }
}

/// Greek letters and subscripts.
fn plain(name: &str) -> String {
    let (stem, index) = match name.strip_suffix(']').and_then(|rest| rest.split_once('[')) {
        Some(parts) => parts,
        None => name.split_at(name.trim_end_matches(|c: char| c.is_ascii_digit()).len()),
    };
    let digits = !index.is_empty() && index.chars().all(|c| c.is_ascii_digit());
    let bare = if digits { stem.strip_suffix('_').unwrap_or(stem) } else { stem };
    let letter = GREEK.iter().find(|(word, _)| *word == bare).map(|(_, letter)| *letter);
    let stem = letter.map_or_else(|| bare.to_owned(), String::from);
    match digits {
        // `a_1` and `a1` are two names; of a word neither reads well.
        true if stem.chars().count() == 1 && (bare.len() == name.len() - index.len() || letter.is_some()) => {
            format!("{stem}{}", subscript(index))
        }
        true if name.ends_with(']') => format!("{stem}{}", subscript(index)),
        true => format!("{}{index}", name.trim_end_matches(|c: char| c.is_ascii_digit())),
        false => stem,
    }
}

fn subscript(digits: &str) -> String {
    digits.chars().map(|c| c.to_digit(10).and_then(|d| char::from_u32(0x2080 + d)).unwrap_or(c)).collect()
}

/// The digits of a power, raised.
pub fn superscript(k: u32) -> String {
    let raised = |c: char| match c {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => c.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(c),
    };
    k.to_string().chars().map(raised).collect()
}

/// sin(x) to a power: `sin²(x)`.
pub fn raised(function: &str, k: u32) -> String {
    let end = function.find('(').unwrap_or(function.len());
    format!("{}{}{}", &function[..end], superscript(k), &function[end..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_as_in_print() {
        for (of, print) in [
            ("theta", "θ"),
            ("theta1", "θ₁"),
            ("theta_1", "θ₁"),
            ("q12", "q₁₂"),
            ("q_12", "q_12"),
            ("m[3]", "m₃"),
            ("dot_x", "x\u{307}"),
            ("dot(v6)", "v\u{307}₆"),
            ("dot_theta", "θ\u{307}"),
            ("dot(dot_a1)", "a\u{308}₁"),
            ("dot_x_1", "x\u{307}_1"),
            ("dot(crank)", "dot(crank)"),
            ("dot(dot_crank)", "dot(dot_crank)"),
            ("dot_crank", "dot_crank"),
            ("dot_", "dot_"),
            ("pi", "pi"),
            ("lambda(no_slip_1)", "λ(no_slip_1)"),
            ("phi(rod)", "φ(rod)"),
            ("v_B_N_x", "v_B_N_x"),
            ("mass2", "mass2"),
            ("crank", "crank"),
            ("PI", "π"),
            ("h_u*", "h_u*"),
        ] {
            assert_eq!(name(of), print);
        }
    }

    #[test]
    fn powers_stand_at_the_function() {
        assert_eq!((raised("sin(θ)", 2), raised("cos(a − b)", 12)), ("sin²(θ)".to_owned(), "cos¹²(a − b)".to_owned()));
    }
}
