//! Canonical sums, products and powers.

use super::rational::FOLDING_BITS;
use super::tables::Set;
use super::{Expr, Graph, Node, Rational, Stage};

/// A nested sum of more terms than this stays a term of its own, so that sums of sums grow linearly.
const FLATTENED_TERMS: usize = 32;

/// What is checked at run time not to vanish, and cancels therefore.
#[derive(Clone, Debug)]
pub struct Assumptions(Set);

impl Graph {
    /// An exact number.
    pub fn number(&mut self, value: Rational) -> Expr {
        self.intern(Node::Number(value))
    }

    /// An integer.
    pub fn integer(&mut self, n: i64) -> Expr {
        self.number(Rational::integer(n))
    }

    /// `constant + Σ coefficient·term`, like terms collected.
    pub fn linear(&mut self, constant: Rational, terms: &[(Rational, Expr)]) -> Expr {
        let mut total = constant;
        let mut collected: Vec<(Rational, Expr)> = Vec::with_capacity(terms.len());
        for (coefficient, term) in terms {
            match self.node(*term) {
                Node::Number(number) => {
                    let sum = total.add(&coefficient.mul(number));
                    if sum.bits() > FOLDING_BITS {
                        collected.push((coefficient.clone(), *term));
                    } else {
                        total = sum;
                    }
                }
                Node::Sum { constant, terms: inner } if inner.len() <= FLATTENED_TERMS => {
                    total = total.add(&coefficient.mul(constant));
                    collected.extend(inner.iter().map(|(c, e)| (coefficient.mul(c), *e)));
                }
                _ => collected.push((coefficient.clone(), *term)),
            }
        }
        collected.sort_by_key(|(_, e)| *e);
        let mut merged: Vec<(Rational, Expr)> = Vec::with_capacity(collected.len());
        for (coefficient, term) in collected {
            match merged.last_mut() {
                Some((last, same)) if *same == term && last.add(&coefficient).bits() <= FOLDING_BITS => {
                    *last = last.add(&coefficient);
                }
                _ => merged.push((coefficient, term)),
            }
        }
        merged.retain(|(c, _)| !c.is_zero());
        match merged.as_slice() {
            [] => self.number(total),
            [(c, e)] if c.is_one() && total.is_zero() => *e,
            _ => self.intern(Node::Sum { constant: total, terms: merged.into_boxed_slice() }),
        }
    }

    /// The sum of all.
    pub fn sum(&mut self, terms: &[Expr]) -> Expr {
        let terms: Vec<_> = terms.iter().map(|e| (Rational::ONE, *e)).collect();
        self.linear(Rational::ZERO, &terms)
    }

    /// `a + b`.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.sum(&[a, b])
    }

    /// `a - b`.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.linear(Rational::ZERO, &[(Rational::ONE, a), (Rational::MINUS_ONE, b)])
    }

    /// `-a`.
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.scale(Rational::MINUS_ONE, a)
    }

    /// `factor·a`.
    pub fn scale(&mut self, factor: Rational, a: Expr) -> Expr {
        self.linear(Rational::ZERO, &[(factor, a)])
    }

    /// `coefficient·Π base^exponent`.
    ///
    /// Numbers and the content of sums move into the coefficient. Equal bases are collected, except that a positive
    /// power never cancels a negative one unless the base is known to be non-zero or holds parameters only.
    pub fn power_product(&mut self, coefficient: Rational, factors: &[(Expr, i32)]) -> Expr {
        let mut total = coefficient;
        let mut collected: Vec<(Expr, i32)> = Vec::with_capacity(factors.len());
        let mut queue: Vec<(Expr, i32)> = factors.iter().rev().copied().collect();
        while let Some((base, exponent)) = queue.pop() {
            if exponent == 0 {
                continue;
            }
            match self.node(base) {
                Node::Number(number) => match number.powi(exponent).map(|p| p.mul(&total)) {
                    Some(folded) if folded.bits() <= FOLDING_BITS => total = folded,
                    _ => collected.push((base, exponent)),
                },
                Node::Product(inner) => {
                    let inner: Vec<_> = inner.iter().rev().map(|(b, k)| (*b, k.saturating_mul(exponent))).collect();
                    queue.extend(inner);
                }
                Node::Sum { .. } => match self.primitive(base) {
                    Some((content, part)) => match content.powi(exponent).map(|p| p.mul(&total)) {
                        Some(folded) if folded.bits() <= FOLDING_BITS => {
                            total = folded;
                            queue.push((part, exponent));
                        }
                        _ => collected.push((base, exponent)),
                    },
                    None => collected.push((base, exponent)),
                },
                Node::Function(super::Function::Sqrt, arguments) if exponent.abs() > 1 => {
                    let argument = arguments[0];
                    collected.push((base, exponent % 2));
                    queue.push((argument, exponent / 2));
                }
                _ => collected.push((base, exponent)),
            }
        }
        if total.is_zero() {
            return self.zero();
        }
        let merged = self.collect_powers(collected);
        let product = match merged.as_slice() {
            [] => return self.number(total),
            [(base, 1)] => *base,
            _ => self.intern(Node::Product(merged.into_boxed_slice())),
        };
        self.scale(total, product)
    }

    fn collect_powers(&mut self, mut factors: Vec<(Expr, i32)>) -> Vec<(Expr, i32)> {
        factors.retain(|(_, k)| *k != 0);
        factors.sort_by_key(|(base, k)| (*base, *k < 0));
        let mut merged: Vec<(Expr, i32)> = Vec::with_capacity(factors.len());
        for (base, exponent) in factors {
            match merged.last_mut() {
                Some((same, k)) if *same == base => {
                    if (*k < 0) == (exponent < 0) {
                        *k = k.saturating_add(exponent);
                    } else if self.is_nonzero(base) {
                        *k += exponent;
                    } else if self.stage(base) == Stage::Parameter {
                        self.cancelled.insert(base);
                        *k += exponent;
                    } else {
                        merged.push((base, exponent));
                    }
                }
                _ => merged.push((base, exponent)),
            }
        }
        merged.retain(|(_, k)| *k != 0);
        merged
    }

    /// Content and primitive part of a sum: coprime integer coefficients, the first one positive. `None` where the
    /// sum is primitive already.
    pub(super) fn primitive(&mut self, sum: Expr) -> Option<(Rational, Expr)> {
        let Node::Sum { constant, terms } = self.node(sum) else { return None };
        let mut content = terms[0].0.clone();
        if terms.len() > 1 || !constant.is_zero() {
            for (c, _) in &terms[1..] {
                content = content.common_divisor(c);
            }
            content = content.common_divisor(constant);
            if terms[0].0.is_negative() {
                content = content.neg();
            }
        }
        if content.is_one() || content.is_zero() {
            return None;
        }
        let inverse = content.recip()?;
        let terms: Vec<_> = terms.iter().map(|(c, e)| (c.mul(&inverse), *e)).collect();
        let constant = constant.mul(&inverse);
        // Interned as it is: a sum that is too long to be flattened would come back unchanged from `linear`.
        let part = match terms.as_slice() {
            [(c, e)] if c.is_one() && constant.is_zero() => *e,
            _ => self.intern(Node::Sum { constant, terms: terms.into_boxed_slice() }),
        };
        Some((content, part))
    }

    /// The rational content of an expression, with its sign, and the rest.
    pub(super) fn content(&mut self, e: Expr) -> (Rational, Expr) {
        self.primitive(e).unwrap_or((Rational::ONE, e))
    }

    /// The expression without its rational content.
    pub fn primitive_part(&mut self, e: Expr) -> Expr {
        self.content(e).1
    }

    /// The product of all.
    pub fn product(&mut self, factors: &[Expr]) -> Expr {
        let factors: Vec<_> = factors.iter().map(|e| (*e, 1)).collect();
        self.power_product(Rational::ONE, &factors)
    }

    /// `a·b`.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        self.product(&[a, b])
    }

    /// `a / b`.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.power_product(Rational::ONE, &[(a, 1), (b, -1)])
    }

    /// `a^n`.
    pub fn powi(&mut self, a: Expr, n: i32) -> Expr {
        self.power_product(Rational::ONE, &[(a, n)])
    }

    /// Records that the expression is checked at run time not to vanish: its powers cancel from now on.
    pub fn assume_nonzero(&mut self, e: Expr) {
        let one = self.power_product(Rational::ONE, &[(e, 1)]);
        let mut queue = vec![one];
        while let Some(e) = queue.pop() {
            match self.node(e) {
                Node::Number(_) => {}
                Node::Product(factors) => queue.extend(factors.iter().map(|(b, _)| *b).collect::<Vec<_>>()),
                Node::Sum { .. } => match self.primitive(e) {
                    Some((_, part)) => queue.push(part),
                    None => {
                        self.nonzero.insert(e);
                    }
                },
                _ => {
                    self.nonzero.insert(e);
                }
            }
        }
    }

    /// Runs a computation and forgets what it assumed to be non-zero.
    pub fn without_new_assumptions<R>(&mut self, compute: impl FnOnce(&mut Self) -> R) -> R {
        let before = (self.nonzero.clone(), self.cancelled.clone());
        let result = compute(self);
        (self.nonzero, self.cancelled) = before;
        result
    }

    /// What is assumed not to vanish.
    pub fn assumptions(&self) -> Assumptions {
        Assumptions(self.nonzero.clone())
    }

    /// Assumes this and nothing else, and gives what was assumed until now. What cancelled of the parameters is still to
    /// be checked.
    pub fn assume_only(&mut self, assumptions: Assumptions) -> Assumptions {
        Assumptions(std::mem::replace(&mut self.nonzero, assumptions.0))
    }

    /// Coefficient and factors of an expression seen as one term: `-2*x*y` is `(-2, [(x, 1), (y, 1)])`.
    pub fn as_term(&self, e: Expr) -> (Rational, Vec<(Expr, i32)>) {
        let (coefficient, core) = match self.node(e) {
            Node::Number(number) => return (number.clone(), Vec::new()),
            Node::Sum { constant, terms } if constant.is_zero() && terms.len() == 1 => terms[0].clone(),
            _ => (Rational::ONE, e),
        };
        match self.node(core) {
            Node::Product(factors) => (coefficient, factors.to_vec()),
            _ => (coefficient, vec![(core, 1)]),
        }
    }

    /// Constant and terms of an expression seen as a sum.
    pub fn as_sum(&self, e: Expr) -> (Rational, Vec<(Rational, Expr)>) {
        match self.node(e) {
            Node::Number(number) => (number.clone(), Vec::new()),
            Node::Sum { constant, terms } => (constant.clone(), terms.to_vec()),
            _ => (Rational::ZERO, vec![(Rational::ONE, e)]),
        }
    }
}
