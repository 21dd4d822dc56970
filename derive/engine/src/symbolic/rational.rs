//! Exact rational numbers: machine words while they fit, big integers beyond.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use std::cmp::Ordering;
use std::fmt;

/// Constants fold exactly up to this many bits in numerator and denominator.
pub const FOLDING_BITS: u64 = 256;

/// An exact rational number in lowest terms with a positive denominator.
///
/// Almost every coefficient of a model is a small integer, so those stay in machine words: macros run
/// unoptimised, and big-integer arithmetic would dominate the derive.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Rational {
    /// Numerator and positive denominator, coprime. Every number that fits is stored so.
    Small(i64, i64),
    /// A number that does not fit in two machine words.
    Big(Box<BigRational>),
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        if a <= u64::MAX as u128 && b <= u64::MAX as u128 {
            let (mut x, mut y) = (a as u64, b as u64);
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return x as u128;
        }
        (a, b) = (b, a % b);
    }
    a
}

impl Rational {
    /// Zero.
    pub const ZERO: Rational = Rational::Small(0, 1);
    /// One.
    pub const ONE: Rational = Rational::Small(1, 1);
    /// Minus one.
    pub const MINUS_ONE: Rational = Rational::Small(-1, 1);

    /// The integer `n`.
    pub fn integer(n: i64) -> Self {
        if n == i64::MIN { Self::from_big(BigRational::from_integer(n.into())) } else { Rational::Small(n, 1) }
    }

    /// The fraction `n / d`; `None` where `d` is zero.
    pub fn fraction(n: i64, d: i64) -> Option<Self> {
        if d == 0 { None } else { Some(Self::reduced(n as i128, d as i128)) }
    }

    fn reduced(n: i128, d: i128) -> Self {
        let (n, d) = if d < 0 { (-n, -d) } else { (n, d) };
        let g = gcd(n.unsigned_abs(), d.unsigned_abs()).max(1) as i128;
        let (n, d) = (n / g, d / g);
        if n.unsigned_abs() <= i64::MAX as u128 && d <= i64::MAX as i128 {
            Rational::Small(n as i64, d as i64)
        } else {
            Rational::Big(Box::new(BigRational::new_raw(n.into(), d.into())))
        }
    }

    /// From a big rational in lowest terms.
    pub fn from_big(value: BigRational) -> Self {
        match (value.numer().to_i64(), value.denom().to_i64()) {
            (Some(n), Some(d)) if n != i64::MIN => Rational::Small(n, d),
            _ => Rational::Big(Box::new(value)),
        }
    }

    /// As a big rational.
    pub fn to_big(&self) -> BigRational {
        match self {
            Rational::Small(n, d) => BigRational::new_raw((*n).into(), (*d).into()),
            Rational::Big(value) => (**value).clone(),
        }
    }

    /// The rational that a Rust literal spells: digits, optionally a point, an exponent, underscores.
    ///
    /// `0.1` is one tenth. `None` where the text is no such number or its exponent exceeds 400 in magnitude.
    pub fn parse(text: &str) -> Option<Self> {
        let text: String = text.chars().filter(|c| *c != '_').collect();
        let (mantissa, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
            None => (text.as_str(), 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{fraction}");
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) || exponent.abs() > 400 {
            return None;
        }
        let number: BigInt = digits.parse().ok()?;
        let shift = exponent as i64 - fraction.len() as i64;
        let power = BigInt::from(10).pow(shift.unsigned_abs() as u32);
        Some(Self::from_big(if shift >= 0 {
            BigRational::from_integer(number * power)
        } else {
            BigRational::new(number, power)
        }))
    }

    /// Whether this is zero.
    pub fn is_zero(&self) -> bool {
        matches!(self, Rational::Small(0, _))
    }

    /// Whether this is one.
    pub fn is_one(&self) -> bool {
        matches!(self, Rational::Small(1, 1))
    }

    /// Whether this is below zero.
    pub fn is_negative(&self) -> bool {
        match self {
            Rational::Small(n, _) => *n < 0,
            Rational::Big(value) => value.is_negative(),
        }
    }

    /// The integer that this is, if it is one of 64 bits.
    pub fn as_integer(&self) -> Option<i64> {
        match self {
            Rational::Small(n, 1) => Some(*n),
            _ => None,
        }
    }

    /// Bits of the longer of numerator and denominator.
    pub fn bits(&self) -> u64 {
        match self {
            Rational::Small(..) => 64,
            Rational::Big(value) => value.numer().bits().max(value.denom().bits()),
        }
    }

    /// The sum.
    pub fn add(&self, other: &Self) -> Self {
        match (self, other) {
            (Rational::Small(a, 1), Rational::Small(b, 1)) => match a.checked_add(*b) {
                Some(n) if n != i64::MIN => Rational::Small(n, 1),
                _ => Self::reduced(*a as i128 + *b as i128, 1),
            },
            (Rational::Small(a, b), Rational::Small(c, d)) => {
                let (a, b, c, d) = (*a as i128, *b as i128, *c as i128, *d as i128);
                match (a * d).checked_add(c * b) {
                    Some(n) => Self::reduced(n, b * d),
                    None => Self::from_big(self.to_big() + other.to_big()),
                }
            }
            _ => Self::from_big(self.to_big() + other.to_big()),
        }
    }

    /// The product.
    pub fn mul(&self, other: &Self) -> Self {
        match (self, other) {
            (Rational::Small(1, 1), _) => other.clone(),
            (_, Rational::Small(1, 1)) => self.clone(),
            (Rational::Small(a, 1), Rational::Small(b, 1)) => match a.checked_mul(*b) {
                Some(n) if n != i64::MIN => Rational::Small(n, 1),
                _ => Self::reduced(*a as i128 * *b as i128, 1),
            },
            (Rational::Small(a, b), Rational::Small(c, d)) => {
                Self::reduced(*a as i128 * *c as i128, *b as i128 * *d as i128)
            }
            _ => Self::from_big(self.to_big() * other.to_big()),
        }
    }

    /// The opposite.
    pub fn neg(&self) -> Self {
        match self {
            Rational::Small(n, d) => Rational::Small(-n, *d),
            Rational::Big(value) => Self::from_big(-(**value).clone()),
        }
    }

    /// The magnitude.
    pub fn abs(&self) -> Self {
        if self.is_negative() { self.neg() } else { self.clone() }
    }

    /// The reciprocal; `None` for zero.
    pub fn recip(&self) -> Option<Self> {
        match self {
            Rational::Small(0, _) => None,
            Rational::Small(n, d) => Some(Self::reduced(*d as i128, *n as i128)),
            Rational::Big(value) => Some(Self::from_big(value.recip())),
        }
    }

    /// The integer power; `None` for a negative power of zero and where the result would pass [`FOLDING_BITS`].
    pub fn powi(&self, exponent: i32) -> Option<Self> {
        if exponent < 0 {
            return self.recip()?.powi(exponent.checked_neg()?);
        }
        if self.is_one() || exponent == 0 {
            return Some(Self::ONE);
        }
        let mut result = Self::ONE;
        for _ in 0..exponent {
            result = result.mul(self);
            if result.bits() > FOLDING_BITS {
                return None;
            }
            if result.is_zero() {
                break;
            }
        }
        Some(result)
    }

    /// The nearest double (to within a unit in the last place for numbers of many digits).
    pub fn to_f64(&self) -> f64 {
        match self {
            Rational::Small(n, d) if n.unsigned_abs() < 1 << 53 && *d < 1 << 53 => *n as f64 / *d as f64,
            _ => {
                // Decimal digits, then the correctly rounded parser of the standard library.
                let value = self.to_big();
                let scale = BigInt::from(10).pow(40);
                let (n, d) = (value.numer(), value.denom());
                let shift = d.bits() as i64 - n.bits() as i64;
                let ten = (shift.max(0) as f64 * std::f64::consts::LOG10_2) as u32;
                let scaled = n * &scale * BigInt::from(10).pow(ten) / d;
                format!("{scaled}e-{}", 40 + ten).parse().unwrap_or(f64::NAN)
            }
        }
    }

    /// Numerator and denominator as text, for printing.
    pub fn parts(&self) -> (String, String) {
        match self {
            Rational::Small(n, d) => (n.to_string(), d.to_string()),
            Rational::Big(value) => (value.numer().to_string(), value.denom().to_string()),
        }
    }

    /// The greatest rational that divides both into integers; positive, zero only for two zeros.
    pub fn common_divisor(&self, other: &Self) -> Self {
        let (a, b) = (self.to_parts(), other.to_parts());
        if let (Some((n1, d1)), Some((n2, d2))) = (a, b) {
            let n = gcd(n1.unsigned_abs() as u128, n2.unsigned_abs() as u128) as i128;
            let d = d1 as i128 / gcd(d1 as u128, d2 as u128) as i128 * d2 as i128;
            return Self::reduced(n, d);
        }
        use num_integer::Integer;
        let (a, b) = (self.to_big(), other.to_big());
        Self::from_big(BigRational::new(a.numer().gcd(b.numer()), a.denom().lcm(b.denom())))
    }

    fn to_parts(&self) -> Option<(i64, i64)> {
        match self {
            Rational::Small(n, d) => Some((*n, *d)),
            Rational::Big(_) => None,
        }
    }

    /// The exact square root, if it is rational.
    pub fn sqrt(&self) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        let value = self.to_big();
        let (n, d) = (value.numer().sqrt(), value.denom().sqrt());
        (&n * &n == *value.numer() && &d * &d == *value.denom()).then(|| Self::from_big(BigRational::new(n, d)))
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Rational::Small(a, 1), Rational::Small(b, 1)) => a.cmp(b),
            (Rational::Small(a, b), Rational::Small(c, d)) => (*a as i128 * *d as i128).cmp(&(*c as i128 * *b as i128)),
            _ => self.to_big().cmp(&other.to_big()),
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (n, d) = self.parts();
        if d == "1" { write!(f, "{n}") } else { write!(f, "{n}/{d}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_the_rationals_they_spell() {
        assert_eq!(Rational::parse("9.81"), Rational::fraction(981, 100));
        assert_eq!(Rational::parse("1e-3"), Rational::fraction(1, 1000));
        assert_eq!(Rational::parse("1_000.5E2"), Some(Rational::integer(100_050)));
        assert_eq!(Rational::parse("x"), None);
    }

    #[test]
    fn arithmetic_leaves_and_reenters_machine_words() {
        let big = Rational::integer(i64::MAX).mul(&Rational::integer(i64::MAX));
        assert!(matches!(big, Rational::Big(_)));
        let back = big.mul(&Rational::integer(i64::MAX).recip().unwrap());
        assert_eq!(back, Rational::integer(i64::MAX));
        assert_eq!(back.add(&back.neg()), Rational::ZERO);
        let third = Rational::fraction(1, -3).unwrap();
        assert_eq!(third, Rational::Small(-1, 3));
    }

    #[test]
    fn doubles_are_nearest() {
        for text in ["0.1", "9.81", "123456789012345678901234567890", "1e-30", "2.5e200", "0.30000000000000004"] {
            assert_eq!(Rational::parse(text).unwrap().to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
    }

    #[test]
    fn roots_and_divisors_are_exact() {
        assert_eq!(Rational::fraction(9, 4).unwrap().sqrt(), Rational::fraction(3, 2));
        assert_eq!(Rational::integer(2).sqrt(), None);
        let (a, b) = (Rational::fraction(3, 4).unwrap(), Rational::fraction(9, 10).unwrap());
        assert_eq!(a.common_divisor(&b), Rational::fraction(3, 20).unwrap());
    }
}
