//! Names as in print: Greek letters, subscripts, dots.

/// The names of Greek letters.
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
    ("pi", 'π'),
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
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("PI", 'π'),
];

/// Over the letter before it.
const DOT: char = '\u{307}';

/// A name as in print: `theta_1` is θ₁, `dot_x` and `dot(x)` are ẋ, `m[3]` is m₃, `lambda(rod)` is λ(rod). Two names that differ stay
/// different.
pub fn name(name: &str) -> String {
    if let Some(inner) = name.strip_prefix("dot(").and_then(|rest| rest.strip_suffix(')')) {
        return dotted(inner);
    }
    if let Some((function, inner)) = name.split_once('(') {
        return format!("{}({inner}", plain(function));
    }
    match name.strip_prefix("dot_") {
        Some(rest) if !rest.is_empty() => dotted(rest),
        _ => plain(name),
    }
}

/// A name with a dot over its letter; over a word it would not be seen.
fn dotted(inner: &str) -> String {
    let inner = name(inner);
    let letters = inner.chars().take_while(|c| c.is_alphabetic()).count();
    match letters {
        1 => {
            let mut out: String = inner.chars().take(1).collect();
            out.push(DOT);
            out.extend(inner.chars().skip(1));
            out
        }
        _ => format!("d{inner}/dt"),
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

/// sin x to a power: `sin² x`.
pub fn raised(function: &str, k: u32) -> String {
    let end = function.find([' ', '(']).unwrap_or(function.len());
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
            ("dot(crank)", "dcrank/dt"),
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
        assert_eq!((raised("sin θ", 2), raised("cos(a − b)", 12)), ("sin² θ".to_owned(), "cos¹²(a − b)".to_owned()));
    }
}
