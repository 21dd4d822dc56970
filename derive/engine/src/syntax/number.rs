//! Literals as the exact rationals that they spell.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::pow;
use syn::Lit;

use super::diagnostics::messages;

/// Numerators and denominators are bounded by this many bits, as everywhere in the engine.
const BITS: u64 = 256;

/// The number that a literal spells: 9.81 is 981/100.
pub(crate) fn read(literal: &Lit) -> Result<BigRational, String> {
    match literal {
        Lit::Int(literal) => {
            check_suffix(literal.suffix(), literal.base10_digits())?;
            let digits = literal.base10_digits();
            digits
                .parse::<BigInt>()
                .ok()
                .filter(|number| number.bits() <= BITS)
                .map(BigRational::from)
                .ok_or_else(|| messages::literal_out_of_range(shortened(digits)))
        }
        Lit::Float(literal) => {
            check_suffix(literal.suffix(), literal.base10_digits())?;
            decimal(literal.base10_digits())
                .ok_or_else(|| messages::literal_out_of_range(shortened(literal.base10_digits())))
        }
        _ => Err(messages::not_a_number()),
    }
}

/// Reads `12.5e-3`; `None` where the number does not fit [`BITS`].
fn decimal(digits: &str) -> Option<BigRational> {
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i64 = exponent.parse().ok()?;
    let fraction = fraction.trim_end_matches('0');
    // More digits than this cannot fit; powers of ten are not computed before that is known.
    let most = 1 + BITS as usize / 3;
    let numerator = format!("{whole}{fraction}");
    if numerator.trim_start_matches('0').len() > most {
        return None;
    }
    let numerator: BigInt = numerator.parse().ok()?;
    let exponent = exponent.checked_sub(i64::try_from(fraction.len()).ok()?)?;
    let magnitude = usize::try_from(exponent.unsigned_abs()).ok()?;
    if numerator == BigInt::ZERO {
        return Some(BigRational::from(numerator));
    }
    if magnitude > most {
        return None;
    }
    let power = pow(BigInt::from(10), magnitude);
    let number = if exponent < 0 { BigRational::new(numerator, power) } else { BigRational::from(numerator * power) };
    let fits = number.numer().bits() <= BITS && number.denom().bits() <= BITS;
    fits.then_some(number)
}

fn check_suffix(suffix: &str, digits: &str) -> Result<(), String> {
    if suffix.is_empty() { Ok(()) } else { Err(messages::literal_suffix(shortened(digits), suffix)) }
}

fn shortened(digits: &str) -> String {
    if digits.len() > 24 { format!("{}..", &digits[..20]) } else { digits.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<BigRational, String> {
        read(&syn::parse_str(text).unwrap())
    }

    fn ratio(a: i64, b: i64) -> BigRational {
        BigRational::new(a.into(), b.into())
    }

    #[test]
    fn literals_are_the_rationals_they_spell() {
        assert_eq!(of("9.81"), Ok(ratio(981, 100)));
        assert_eq!(of("0.1"), Ok(ratio(1, 10)));
        assert_eq!(of("1_000"), Ok(ratio(1000, 1)));
        assert_eq!(of("0x10"), Ok(ratio(16, 1)));
        assert_eq!(of("2."), Ok(ratio(2, 1)));
        assert_eq!(of("12.50e-3"), Ok(ratio(1, 80)));
        assert_eq!(of("1.5E2"), Ok(ratio(150, 1)));
        assert_eq!(of("0.0e999999999999"), Ok(ratio(0, 1)));
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
