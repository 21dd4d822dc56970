//! From polynomials to cheap nested expressions.
//!
//! Terms are collected by what runs; a coefficient of parameters is one factor, computed in `prepare`, so it is worth
//! more to collect `(m r² + J) ω²` than to share `m` with a neighbour. Nesting is greedy: the factor that saves most
//! goes first, with all that its terms share beyond it.

use super::expand::Atoms;
use super::fraction::{Fraction, Sums};
use super::limits::{FACTOR_TERMS, FACTORED_DEPTH, FACTORED_TERMS};
use super::polynomial::{Atom, Monomial, Polynomial, Work};
use crate::symbolic::{Expr, Graph, Node, Rational};
use std::collections::{BTreeMap, BTreeSet};

/// A term with its coefficient collected: `number · coefficient · monomial`, the coefficient of parameters only.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// The rational factor.
    pub number: Rational,
    /// The parameter-only factor; one where there is none.
    pub coefficient: Expr,
    /// What runs.
    pub monomial: Monomial,
}

/// How a fraction is written.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Style {
    /// Every term over what of the denominator it keeps.
    Split,
    /// One denominator below all.
    Joint,
}

/// The fraction as an expression.
pub fn write(
    graph: &mut Graph,
    fraction: &Fraction,
    style: Style,
    atoms: &Atoms,
    sums: &Sums,
    work: &mut Work,
) -> Option<Expr> {
    let (live, fixed): (Vec<_>, Vec<_>) =
        fraction.denominator.iter().map(|(a, k)| (*a, *k)).partition(|(a, _)| atoms.runs(*a));
    let below = Monomial(live.into_iter().map(|(a, k)| (a, -k)).collect());
    let mut collected: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
    for (monomial, number) in &fraction.numerator.0 {
        let (running, parameters): (Vec<_>, Vec<_>) = monomial.0.iter().partition(|(a, _)| atoms.runs(*a));
        let mut running = Monomial(running);
        if style == Style::Split {
            running = running.mul(&below);
        }
        collected.entry(running).or_default().push(Monomial(parameters), number.clone());
    }
    let mut terms = Vec::with_capacity(collected.len());
    for (monomial, polynomial) in collected {
        let (number, coefficient) = coefficient(graph, polynomial, &fixed, atoms, sums, work)?;
        terms.push(Term { number, coefficient, monomial });
    }
    let above = nest(graph, terms, atoms, FACTORED_DEPTH)?;
    if style == Style::Split {
        return Some(above);
    }
    times(graph, Rational::ONE, powers(atoms, &below), above)
}

/// `number · factors · last`; `None` where one of them is too long a sum for a factor.
fn times(graph: &mut Graph, number: Rational, mut factors: Vec<(Expr, i32)>, last: Expr) -> Option<Expr> {
    factors.push((last, 1));
    let long = |e: Expr| matches!(graph.node(e), Node::Sum { terms, .. } if terms.len() > FACTOR_TERMS);
    if factors.iter().any(|(base, exponent)| *exponent > 0 && long(*base)) {
        return None;
    }
    Some(graph.power_product(number, &factors))
}

fn powers(atoms: &Atoms, monomial: &Monomial) -> Vec<(Expr, i32)> {
    monomial.0.iter().map(|(atom, exponent)| atoms.factor(*atom, *exponent)).collect()
}

/// A parameter-only polynomial over parameter-only atoms, as a number times one expression.
fn coefficient(
    graph: &mut Graph,
    mut polynomial: Polynomial,
    below: &[(Atom, i32)],
    atoms: &Atoms,
    sums: &Sums,
    work: &mut Work,
) -> Option<(Rational, Expr)> {
    let mut factors: Vec<(Expr, i32)> = Vec::new();
    // The denominator was made common to all terms; here each coefficient gets rid of what it does not need.
    for (atom, power) in below {
        let mut left = *power;
        while left > 0
            && let Some(quotient) = sums.divide(&polynomial, *atom, work)
        {
            polynomial = quotient;
            left -= 1;
        }
        factors.push(atoms.factor(*atom, -left));
    }
    let content = content(&polynomial);
    let inverse = content.recip()?;
    let common = Monomial::common(polynomial.0.keys());
    let mut terms = Vec::with_capacity(polynomial.len());
    for (monomial, number) in &polynomial.0 {
        let product = graph.power_product(Rational::ONE, &powers(atoms, &monomial.div(&common)));
        terms.push((number.mul(&inverse), product));
    }
    let sum = graph.linear(Rational::ZERO, &terms);
    factors.extend(powers(atoms, &common));
    let whole = times(graph, content, factors, sum)?;
    let (number, factors) = graph.as_term(whole);
    Some((number, graph.power_product(Rational::ONE, &factors)))
}

/// The number that makes the coefficients coprime integers, the first one positive, when divided by.
fn content(polynomial: &Polynomial) -> Rational {
    let mut all = polynomial.0.values();
    let Some(first) = all.next() else { return Rational::ONE };
    let content = all.fold(first.common_divisor(&Rational::ZERO), |content, c| content.common_divisor(c));
    if first.is_negative() { content.neg() } else { content }
}

/// A factor that several terms may share: an atom above or below the line, or a coefficient.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Shared {
    Atom(Atom, bool),
    Coefficient(Expr),
}

impl Shared {
    fn is_in(self, term: &Term) -> bool {
        match self {
            Shared::Atom(atom, below) => {
                let exponent = term.monomial.exponent(atom);
                exponent != 0 && (exponent < 0) == below
            }
            Shared::Coefficient(coefficient) => term.coefficient == coefficient,
        }
    }
}

/// The sum of the terms, nested.
pub fn nest(graph: &mut Graph, terms: Vec<Term>, atoms: &Atoms, depth: usize) -> Option<Expr> {
    if depth == 0 || terms.len() > FACTORED_TERMS || terms.len() < 2 {
        return Some(flat(graph, &terms, atoms));
    }
    let mut rest = terms;
    let mut parts: Vec<(Vec<(Expr, i32)>, Expr)> = Vec::new();
    while let Some(best) = most_shared(graph, &rest) {
        let (mut with, without): (Vec<Term>, Vec<Term>) = rest.into_iter().partition(|t| best.is_in(t));
        rest = without;
        let outer = take_common(graph, &mut with, atoms);
        let inner = nest(graph, with, atoms, depth - 1)?;
        // a·(c + d) + b·(c + d) is (a + b)·(c + d).
        match parts.iter_mut().find(|(_, same)| *same == inner) {
            Some((factors, _)) => {
                let (a, b) = (graph.power_product(Rational::ONE, factors), graph.power_product(Rational::ONE, &outer));
                *factors = vec![(graph.add(a, b), 1)];
            }
            None => parts.push((outer, inner)),
        }
    }
    let mut sum: Vec<Expr> = vec![flat(graph, &rest, atoms)];
    for (factors, inner) in parts {
        sum.push(times(graph, Rational::ONE, factors, inner)?);
    }
    Some(graph.sum(&sum))
}

/// The sum of the terms as they are.
pub fn flat(graph: &mut Graph, terms: &[Term], atoms: &Atoms) -> Expr {
    let products: Vec<Expr> = terms
        .iter()
        .map(|term| {
            let mut factors = powers(atoms, &term.monomial);
            factors.push((term.coefficient, 1));
            graph.power_product(term.number.clone(), &factors)
        })
        .collect();
    graph.sum(&products)
}

/// The factor that saves most multiplications; the first of equals.
fn most_shared(graph: &Graph, terms: &[Term]) -> Option<Shared> {
    let mut candidates: BTreeSet<Shared> = BTreeSet::new();
    for term in terms {
        candidates.extend(term.monomial.0.iter().map(|(atom, k)| Shared::Atom(*atom, *k < 0)));
        if !graph.is_one(term.coefficient) {
            candidates.insert(Shared::Coefficient(term.coefficient));
        }
    }
    let mut best: Option<(usize, Shared)> = None;
    for candidate in candidates {
        let with = || terms.iter().filter(|t| candidate.is_in(t));
        let count = with().count();
        if count < 2 {
            continue;
        }
        let common = Monomial::common(with().map(|t| &t.monomial));
        let coefficient = with().next().map(|t| t.coefficient);
        let same = with().all(|t| Some(t.coefficient) == coefficient && !graph.is_one(t.coefficient));
        let saved = (count - 1) * (common.degree() + usize::from(same));
        if best.is_none_or(|(most, _)| saved > most) {
            best = Some((saved, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Takes what all terms share out of them.
fn take_common(graph: &Graph, terms: &mut [Term], atoms: &Atoms) -> Vec<(Expr, i32)> {
    let common = Monomial::common(terms.iter().map(|t| &t.monomial));
    let mut factors = powers(atoms, &common);
    let coefficient = terms[0].coefficient;
    let same = terms.iter().all(|t| t.coefficient == coefficient);
    for term in terms.iter_mut() {
        term.monomial = term.monomial.div(&common);
        if same {
            term.coefficient = graph.one();
        }
    }
    if same {
        factors.push((coefficient, 1));
    }
    factors
}
