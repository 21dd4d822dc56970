//! Literals as the exact rationals that they spell.

use syn::Lit;

use super::diagnostics::messages;
use crate::symbolic::Rational;
use crate::symbolic::rational::FOLDING_BITS;

/// More digits than this cannot fit into [`FOLDING_BITS`], whatever the exponent.
const DIGITS: usize = 400;

/// The number that a literal spells: 9.81 is 981/100.
pub(crate) fn read(literal: &Lit) -> Result<Rational, String> {
    let (digits, suffix) = match literal {
        Lit::Int(literal) => (literal.base10_digits(), literal.suffix()),
        Lit::Float(literal) => (literal.base10_digits(), literal.suffix()),
        _ => return Err(messages::not_a_number()),
    };
    if !suffix.is_empty() {
        return Err(messages::literal_suffix(shortened(digits), suffix));
    }
    Some(digits)
        .filter(|digits| digits.len() <= DIGITS)
        .and_then(Rational::parse)
        .filter(|number| number.bits() <= FOLDING_BITS)
        .ok_or_else(|| messages::literal_out_of_range(shortened(digits)))
}

fn shortened(digits: &str) -> String {
    if digits.len() > 24 { format!("{}..", &digits[..20]) } else { digits.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Rational, String> {
        read(&syn::parse_str(text).unwrap())
    }

    fn ratio(a: i64, b: i64) -> Result<Rational, String> {
        Ok(Rational::fraction(a, b).unwrap())
    }

    #[test]
    fn literals_are_the_rationals_they_spell() {
        assert_eq!(of("9.81"), ratio(981, 100));
        assert_eq!(of("0.1"), ratio(1, 10));
        assert_eq!(of("1_000"), ratio(1000, 1));
        assert_eq!(of("0x10"), ratio(16, 1));
        assert_eq!(of("2."), ratio(2, 1));
        assert_eq!(of("12.50e-3"), ratio(1, 80));
        assert_eq!(of("1.5E2"), ratio(150, 1));
        assert_eq!(of("0.0"), ratio(0, 1));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert!(of(&"9".repeat(77)).is_ok());
        assert!(of(&"9".repeat(78)).is_err());
        assert!(of("1e400").is_err());
        assert!(of("1e-400").is_err());
        assert!(of("1e99999999999999999999").is_err());
        assert!(of("1.0f32").is_err());
        assert!(of("2u8").is_err());
        assert!(of("\"2\"").is_err());
    }
}
