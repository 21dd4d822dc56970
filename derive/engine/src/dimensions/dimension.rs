//! Dimensions: products of powers of base units, of ten, and of what is not known yet.

use crate::symbolic::Rational;

/// The base units, each with its name; the power of ten comes after them.
pub const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// The place of the power of ten among the factors: numbers are not converted, so that mm and m are as far apart as m and s.
pub const TEN: usize = BASE.len();

/// The unknowns come behind.
const UNKNOWN: usize = TEN + 1;

/// A product of powers: exponents that do not vanish, sorted by factor.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Dimension {
    factors: Vec<(usize, Rational)>,
}

impl Dimension {
    /// The dimension of a pure number.
    pub fn pure() -> Self {
        Dimension::default()
    }

    /// A base unit, or ten.
    pub fn base(factor: usize) -> Self {
        Dimension { factors: vec![(factor, Rational::ONE)] }
    }

    /// Powers of kg, m and s.
    pub fn mechanical(mass: i64, length: i64, time: i64) -> Self {
        let powers = [mass, length, time].into_iter().enumerate().filter(|(_, power)| *power != 0);
        Dimension { factors: powers.map(|(factor, power)| (factor, Rational::integer(power))).collect() }
    }

    /// An unknown by its number.
    pub fn unknown(number: usize) -> Self {
        Dimension::base(UNKNOWN + number)
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Dimension) -> Self {
        let mut factors = Vec::with_capacity(self.factors.len() + other.factors.len());
        let (mut left, mut right) = (self.factors.iter().peekable(), other.factors.iter().peekable());
        loop {
            let next = match (left.peek(), right.peek()) {
                (Some((a, p)), Some((b, q))) if a == b => {
                    let sum = (*a, p.add(q));
                    left.next();
                    right.next();
                    sum
                }
                (Some((a, _)), Some((b, _))) if b < a => right.next().cloned().unwrap_or((*a, Rational::ZERO)),
                (Some(_), _) => left.next().cloned().unwrap_or((0, Rational::ZERO)),
                (None, Some(_)) => right.next().cloned().unwrap_or((0, Rational::ZERO)),
                (None, None) => break,
            };
            if !next.1.is_zero() {
                factors.push(next);
            }
        }
        Dimension { factors }
    }

    /// A power.
    #[must_use]
    pub fn power(&self, exponent: &Rational) -> Self {
        if exponent.is_zero() {
            return Dimension::pure();
        }
        Dimension { factors: self.factors.iter().map(|(factor, power)| (*factor, power.mul(exponent))).collect() }
    }

    /// A whole power.
    #[must_use]
    pub fn powi(&self, exponent: i64) -> Self {
        self.power(&Rational::integer(exponent))
    }

    /// The quotient.
    #[must_use]
    pub fn over(&self, other: &Dimension) -> Self {
        self.times(&other.powi(-1))
    }

    /// Whether it is that of a pure number.
    pub fn is_pure(&self) -> bool {
        self.factors.is_empty()
    }

    /// The exponents of base units and of ten.
    pub fn known(&self) -> impl Iterator<Item = (usize, &Rational)> {
        self.factors.iter().filter(|(factor, _)| *factor < UNKNOWN).map(|(factor, power)| (*factor, power))
    }

    /// The exponent of a base unit, or of ten.
    pub fn of(&self, factor: usize) -> Rational {
        self.known().find(|(known, _)| *known == factor).map_or(Rational::ZERO, |(_, power)| power.clone())
    }

    /// The exponents of the unknowns, by their numbers.
    pub fn unknowns(&self) -> impl DoubleEndedIterator<Item = (usize, &Rational)> {
        self.factors.iter().filter(|(factor, _)| *factor >= UNKNOWN).map(|(factor, power)| (factor - UNKNOWN, power))
    }

    /// What of it is known.
    #[must_use]
    pub fn without_unknowns(&self) -> Self {
        Dimension { factors: self.factors.iter().filter(|(factor, _)| *factor < UNKNOWN).cloned().collect() }
    }

    /// Whether it is a power of ten and of unknowns.
    pub fn is_scale(&self) -> bool {
        self.known().all(|(factor, _)| factor == TEN)
    }
}
