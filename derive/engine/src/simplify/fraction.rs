//! Quotients of polynomials: one denominator for all terms, and exact division by what it holds.
//!
//! Only bases that are known not to vanish, or that hold parameters only, become denominators and cancel; the
//! reciprocal of any other base is an atom of the numerator.

use super::expand::{Angle, Atoms, Depth, Square, expand, reduce};
use super::limits::NESTED_DENOMINATORS;
use super::polynomial::{Atom, Monomial, Polynomial, Work};
use crate::symbolic::{Expr, Graph, Node};
use std::collections::BTreeMap;

/// A polynomial without negative exponents over a product of atoms.
#[derive(Clone, Debug)]
pub struct Fraction {
    /// Above.
    pub numerator: Polynomial,
    /// Below: atoms with positive exponents.
    pub denominator: BTreeMap<Atom, i32>,
}

/// What the atoms that stand for sums are: the sums, over a common denominator themselves.
#[derive(Debug, Default)]
pub struct Sums {
    known: BTreeMap<Atom, Option<Fraction>>,
    nesting: usize,
}

impl Fraction {
    /// All terms over one denominator.
    pub fn of(
        graph: &Graph,
        mut numerator: Polynomial,
        depth: Depth,
        atoms: &mut Atoms,
        sums: &mut Sums,
        work: &mut Work,
    ) -> Option<Fraction> {
        let mut denominator = BTreeMap::new();
        // Sums of later expressions may hold reciprocals of earlier ones, so the latest go first, plain atoms last.
        while let Some((_, atom)) = negative(graph, &numerator, atoms) {
            let least = numerator.0.keys().map(|m| m.exponent(atom)).min().unwrap_or(0);
            *denominator.entry(atom).or_insert(0) -= least;
            match sums.get(graph, atom, depth, atoms, work) {
                None => numerator = numerator.shift(&Monomial::power(atom, -least)),
                Some(sum) => {
                    let mut value = sum.numerator.clone();
                    let below = Monomial(sum.denominator.iter().map(|(a, k)| (*a, -k)).collect());
                    value = value.shift(&below);
                    numerator = raise(&numerator, atom, -least, &value, work)?;
                }
            }
        }
        let mut fraction = Fraction { numerator, denominator };
        fraction.denominator.retain(|_, k| *k > 0);
        Some(fraction)
    }

    /// Divides out what divides exactly, trying the numerator in each of its trigonometric forms, and of those of quaternions.
    pub fn cancel(
        &mut self,
        graph: &Graph,
        depth: Depth,
        atoms: &mut Atoms,
        sums: &mut Sums,
        (angles, spheres): (&[Angle], &[Vec<Square>]),
        work: &mut Work,
    ) -> Option<()> {
        let of_spheres = |at: usize| spheres.iter().filter_map(move |squares| squares.get(at).cloned());
        let forms: [Vec<Square>; 3] = [
            Vec::new(),
            angles.iter().map(Angle::sin_square).chain(of_spheres(0)).collect(),
            angles.iter().map(Angle::cos_square).chain(of_spheres(3)).collect(),
        ];
        let reduced = |p: &Polynomial, form: &[Square], work: &mut Work| {
            form.iter()
                .try_fold(p.clone(), |p, square| if square.applies(&p) { reduce(&p, square, work) } else { Some(p) })
        };
        let applies = |p: &Polynomial, form: &[Square]| form.iter().any(|square| square.applies(p));
        let candidates: Vec<Atom> = self.denominator.keys().rev().copied().collect();
        for atom in candidates {
            let sum = sums.get(graph, atom, depth, atoms, work).cloned();
            while self.denominator.get(&atom).is_some_and(|k| *k > 0) {
                let above = &self.numerator;
                let quotient = forms.iter().enumerate().find_map(|(i, form)| {
                    let below = sum.as_ref().map(|sum| &sum.numerator);
                    // A form that changes neither is the first one again.
                    if i > 0 && !applies(above, form) && !below.is_some_and(|below| applies(below, form)) {
                        return None;
                    }
                    match below {
                        Some(below) => reduced(above, form, work)?.divide(&reduced(below, form, work)?, work),
                        None if i == 0 => divide_by_atom(above, atom),
                        None => divide_by_atom(&reduced(above, form, work)?, atom),
                    }
                });
                let Some(quotient) = quotient else { break };
                self.numerator = quotient;
                *self.denominator.entry(atom).or_insert(0) -= 1;
                for (below, k) in sum.iter().flat_map(|s| &s.denominator) {
                    let left = self.denominator.entry(*below).or_insert(0);
                    *left -= k;
                    if *left < 0 {
                        self.numerator = self.numerator.shift(&Monomial::power(*below, -*left));
                        *left = 0;
                    }
                }
            }
        }
        self.denominator.retain(|_, k| *k > 0);
        Some(())
    }
}

impl Sums {
    /// The exact quotient of a polynomial by what an atom stands for, where it is known and divides.
    pub fn divide(&self, polynomial: &Polynomial, atom: Atom, work: &mut Work) -> Option<Polynomial> {
        match self.known.get(&atom).and_then(Option::as_ref) {
            Some(sum) => {
                let below = Monomial(sum.denominator.iter().map(|(a, k)| (*a, *k)).collect());
                Some(polynomial.divide(&sum.numerator, work)?.shift(&below))
            }
            None => divide_by_atom(polynomial, atom),
        }
    }

    /// The fraction that an atom stands for, if it stands for a sum that is within the limits.
    fn get(
        &mut self,
        graph: &Graph,
        atom: Atom,
        depth: Depth,
        atoms: &mut Atoms,
        work: &mut Work,
    ) -> Option<&Fraction> {
        if !self.known.contains_key(&atom) {
            let sum = atoms.base(atom).filter(|base| matches!(graph.node(*base), Node::Sum { .. }));
            self.nesting += 1;
            let fraction = sum.filter(|_| self.nesting <= NESTED_DENOMINATORS).and_then(|sum| {
                let polynomial = expand(graph, sum, depth, atoms, work)?;
                (polynomial.len() > 1).then_some(())?;
                Fraction::of(graph, polynomial, depth, atoms, self, work)
            });
            self.nesting -= 1;
            self.known.insert(atom, fraction);
        }
        self.known.get(&atom)?.as_ref()
    }
}

/// The atom with a negative exponent whose base comes last, sums before others.
fn negative(graph: &Graph, polynomial: &Polynomial, atoms: &Atoms) -> Option<((bool, Expr), Atom)> {
    polynomial
        .0
        .keys()
        .flat_map(|m| &m.0)
        .filter(|(_, k)| *k < 0)
        .filter_map(|(atom, _)| {
            let base = atoms.base(*atom)?;
            Some(((matches!(graph.node(base), Node::Sum { .. }), base), *atom))
        })
        .max()
}

/// Multiplies by `value^shift`, where the atom stands for the value: its powers are replaced as they rise.
fn raise(numerator: &Polynomial, atom: Atom, shift: i32, value: &Polynomial, work: &mut Work) -> Option<Polynomial> {
    let mut powers: BTreeMap<i32, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in &numerator.0 {
        let exponent = monomial.exponent(atom);
        let rest = monomial.mul(&Monomial::power(atom, -exponent));
        powers.entry(exponent + shift).or_default().push(rest, coefficient.clone());
    }
    let mut out = Polynomial::default();
    for (power, part) in powers {
        let factor = value.powi(power, work)?;
        out.add_scaled(&part.mul(&factor, work)?, &crate::symbolic::Rational::ONE, work)?;
    }
    Some(out)
}

fn divide_by_atom(polynomial: &Polynomial, atom: Atom) -> Option<Polynomial> {
    let divides = !polynomial.is_empty() && polynomial.0.keys().all(|m| m.exponent(atom) > 0);
    divides.then(|| polynomial.shift(&Monomial::power(atom, -1)))
}
