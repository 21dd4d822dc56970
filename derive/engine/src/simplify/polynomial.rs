//! Sparse polynomials over atoms, with exact coefficients and bounded growth.
//!
//! A polynomial knows nothing of what its atoms stand for; exponents may be negative where the atom may cancel.

use super::limits::{ALIKE, EXPANDED_POWER, POLYNOMIAL_TERMS, POLYNOMIAL_WORK};
use crate::symbolic::Rational;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// An index into the table of atoms.
pub type Atom = u32;

/// A product of powers of atoms, ascending, exponents non-zero.
#[derive(Clone, Debug, Default)]
pub struct Monomial(pub Vec<(Atom, i32)>);

// Written out: comparisons of monomials are most of the work of expansion, and derived ones, which pass through half a
// dozen functions for every factor, are slow where nothing is inlined.
impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b) = (self.0.as_slice(), other.0.as_slice());
        let mut i = 0;
        while i < a.len() && i < b.len() {
            let ((x, k), (y, l)) = (a[i], b[i]);
            if x != y {
                return if x < y { Ordering::Less } else { Ordering::Greater };
            }
            if k != l {
                return if k < l { Ordering::Less } else { Ordering::Greater };
            }
            i += 1;
        }
        if a.len() == b.len() {
            Ordering::Equal
        } else if a.len() < b.len() {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Monomial {
    fn eq(&self, other: &Self) -> bool {
        matches!(self.cmp(other), Ordering::Equal)
    }
}

impl Eq for Monomial {}

impl Monomial {
    /// One atom to a power.
    pub fn power(atom: Atom, exponent: i32) -> Self {
        if exponent == 0 { Monomial::default() } else { Monomial(vec![(atom, exponent)]) }
    }

    /// The exponent of the atom, zero where it does not occur.
    pub fn exponent(&self, atom: Atom) -> i32 {
        let factors = self.0.as_slice();
        let mut i = 0;
        while i < factors.len() && factors[i].0 < atom {
            i += 1;
        }
        if i < factors.len() && factors[i].0 == atom { factors[i].1 } else { 0 }
    }

    /// The product.
    pub fn mul(&self, other: &Monomial) -> Monomial {
        self.times(other, 1)
    }

    /// The product with a power of another.
    fn times(&self, other: &Monomial, exponent: i32) -> Monomial {
        let (a, b) = (self.0.as_slice(), other.0.as_slice());
        let (mut i, mut j, mut n) = (0, 0, 0);
        let mut factors = vec![(0, 0); a.len() + b.len()];
        let out = factors.as_mut_slice();
        while i < a.len() || j < b.len() {
            if j == b.len() || (i < a.len() && a[i].0 < b[j].0) {
                out[n] = a[i];
                i += 1;
                n += 1;
                continue;
            }
            let (atom, k) = (b[j].0, b[j].1 * exponent);
            j += 1;
            out[n] = (atom, k);
            if i < a.len() && a[i].0 == atom {
                out[n].1 = a[i].1 + k;
                i += 1;
            }
            if out[n].1 != 0 {
                n += 1;
            }
        }
        factors.truncate(n);
        Monomial(factors)
    }

    /// The quotient, with whatever exponents result.
    pub fn div(&self, other: &Monomial) -> Monomial {
        self.times(other, -1)
    }

    /// Whether `other` divides this without negative exponents in the quotient.
    fn divisible(&self, other: &Monomial) -> bool {
        other.0.iter().all(|(atom, k)| self.exponent(*atom) >= *k)
    }

    /// The largest monomial that all share: least exponents where all are positive, those nearest zero where all are
    /// negative.
    pub fn common<'a>(mut all: impl Iterator<Item = &'a Monomial>) -> Monomial {
        let Some(first) = all.next() else { return Monomial::default() };
        let mut common = first.0.clone();
        for monomial in all {
            common.retain_mut(|(atom, k)| {
                let l = monomial.exponent(*atom);
                let same_sign = (l > 0) == (*k > 0) && l != 0;
                *k = if *k > 0 { (*k).min(l) } else { (*k).max(l) };
                same_sign
            });
        }
        Monomial(common)
    }

    /// Factors with multiplicity.
    pub fn degree(&self) -> usize {
        self.0.iter().map(|(_, k)| k.unsigned_abs() as usize).sum()
    }
}

/// A sum of monomials with non-zero coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polynomial(pub BTreeMap<Monomial, Rational>);

/// How much more one computation may do.
#[derive(Debug)]
pub struct Work(usize);

impl Work {
    /// As much as one expression may take, out of what a model has left.
    pub fn out_of(left: usize) -> Self {
        Work(left.min(POLYNOMIAL_WORK))
    }

    /// What is left.
    pub fn left(&self) -> usize {
        self.0
    }

    /// `None` where a computation that would form so many products cannot stay within what is left, even if most of its
    /// terms are alike.
    pub fn hopeful(&self, products: f64) -> Option<()> {
        (products <= ALIKE * self.0 as f64).then_some(())
    }

    fn spend(&mut self, amount: usize) -> Option<()> {
        let left = self.0.checked_sub(amount);
        self.0 = left.unwrap_or(0);
        left.map(|_| ())
    }
}

impl Polynomial {
    /// A number.
    pub fn number(value: Rational) -> Self {
        Polynomial::term(Monomial::default(), value)
    }

    /// A single term.
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let mut terms = BTreeMap::new();
        if !coefficient.is_zero() {
            terms.insert(monomial, coefficient);
        }
        Polynomial(terms)
    }

    /// How many terms.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no term: zero.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds one term.
    pub fn push(&mut self, monomial: Monomial, coefficient: Rational) {
        use std::collections::btree_map::Entry;
        match self.0.entry(monomial) {
            Entry::Vacant(slot) => {
                if !coefficient.is_zero() {
                    slot.insert(coefficient);
                }
            }
            Entry::Occupied(mut slot) => {
                let sum = slot.get().add(&coefficient);
                if sum.is_zero() {
                    slot.remove();
                } else {
                    *slot.get_mut() = sum;
                }
            }
        }
    }

    /// Adds a multiple of another polynomial.
    pub fn add_scaled(&mut self, other: &Polynomial, scale: &Rational, work: &mut Work) -> Option<()> {
        work.spend(other.len())?;
        for (monomial, coefficient) in &other.0 {
            self.push(monomial.clone(), coefficient.mul(scale));
        }
        (self.len() <= POLYNOMIAL_TERMS).then_some(())
    }

    /// The product; `None` beyond the limits.
    pub fn mul(&self, other: &Polynomial, work: &mut Work) -> Option<Polynomial> {
        work.spend(self.len() * other.len())?;
        let mut out = Polynomial::default();
        for (a, x) in &self.0 {
            for (b, y) in &other.0 {
                out.push(a.mul(b), x.mul(y));
            }
            if out.len() > POLYNOMIAL_TERMS {
                return None;
            }
        }
        Some(out)
    }

    /// The product with a monomial.
    pub fn shift(&self, monomial: &Monomial) -> Polynomial {
        Polynomial(self.0.iter().map(|(m, c)| (m.mul(monomial), c.clone())).collect())
    }

    /// A power; `None` beyond the limits.
    pub fn powi(&self, exponent: i32, work: &mut Work) -> Option<Polynomial> {
        if self.len() > 1 && exponent > EXPANDED_POWER {
            return None;
        }
        if self.len() == 1 && exponent > 0 {
            let (monomial, coefficient) = self.0.first_key_value()?;
            let monomial = Monomial(
                monomial.0.iter().map(|(a, k)| Some((*a, k.checked_mul(exponent)?))).collect::<Option<Vec<_>>>()?,
            );
            return Some(Polynomial::term(monomial, coefficient.powi(exponent)?));
        }
        let mut out = Polynomial::number(Rational::ONE);
        for _ in 0..exponent {
            out = out.mul(self, work)?;
        }
        Some(out)
    }

    /// The exact quotient, where the divisor divides this. Exponents of both must not be negative.
    pub fn divide(&self, divisor: &Polynomial, work: &mut Work) -> Option<Polynomial> {
        let (lead, coefficient) = divisor.leading()?;
        let inverse = coefficient.recip()?;
        let mut rest = self.clone();
        let mut quotient = Polynomial::default();
        while let Some((top, c)) = rest.leading() {
            if !top.divisible(lead) {
                return None;
            }
            let (monomial, factor) = (top.div(lead), c.mul(&inverse));
            work.spend(divisor.len())?;
            for (m, d) in &divisor.0 {
                rest.push(m.mul(&monomial), d.mul(&factor).neg());
            }
            quotient.push(monomial, factor);
            if rest.len() > POLYNOMIAL_TERMS || quotient.len() > POLYNOMIAL_TERMS {
                return None;
            }
        }
        Some(quotient)
    }

    /// The term that leads in the lexicographic order of exponents: an order that products respect, which the order
    /// of storage is not.
    fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.0.iter().max_by(|(a, _), (b, _)| lexicographic(a, b))
    }
}

/// Compares exponent vectors, the first atom first.
fn lexicographic(a: &Monomial, b: &Monomial) -> Ordering {
    let (a, b) = (a.0.as_slice(), b.0.as_slice());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let (mut k, mut l) = (0, 0);
        let (own, other) =
            (j == b.len() || (i < a.len() && a[i].0 <= b[j].0), i == a.len() || (j < b.len() && b[j].0 <= a[i].0));
        if own {
            k = a[i].1;
            i += 1;
        }
        if other {
            l = b[j].1;
            j += 1;
        }
        if k != l {
            return if k < l { Ordering::Less } else { Ordering::Greater };
        }
    }
    Ordering::Equal
}
