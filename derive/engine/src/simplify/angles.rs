//! cos a·cos b + sin a·sin b = cos(a - b), and its kin, on polynomials.

use super::expand::{Angle, Atoms};
use super::limits::FOLDS;
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::symbolic::{Expr, Function, Graph, Node, Rational};
use std::collections::{BTreeMap, BTreeSet};

/// The polynomial with sums and differences of its angles drawn together wherever two terms allow it, or `None` where
/// none do. Each step lowers the degree.
pub fn fold(graph: &mut Graph, polynomial: &Polynomial, angles: &[Angle], atoms: &mut Atoms) -> Option<Polynomial> {
    let mut folding = Folding::new(polynomial, angles);
    // What cannot be drawn together at one pair of terms cannot at another.
    let mut refused: BTreeSet<((usize, usize), bool, bool)> = BTreeSet::new();
    let mut steps = 0;
    while steps < FOLDS {
        let next = folding.first(|angles, place, equal| {
            let key = (place.angles, place.sine, equal);
            if refused.contains(&key) {
                return None;
            }
            let (a, b) = (angles[place.angles.0], angles[place.angles.1]);
            let found = combined(graph, atoms, a, b, place.sine, equal);
            if found.is_none() {
                refused.insert(key);
            }
            found
        });
        let Some((Place { angles, sine, left, right }, (atom, minus, angle))) = next else { break };
        let (a, b) = (folding.angles[angles.0], folding.angles[angles.1]);
        let rest = without(&left, if sine { a.sin } else { a.cos }, b.cos);
        angle.into_iter().for_each(|angle| folding.know(angle));
        // Both terms carry `whole`; what one has beyond it stays.
        let (whole, equal) = folding.shared(&left, &right)?;
        folding.push(left, whole.neg());
        folding.push(right, if equal { whole.neg() } else { whole.clone() });
        folding.push(rest.mul(&Monomial::power(atom, 1)), if minus { whole.neg() } else { whole });
        steps += 1;
    }
    (steps > 0).then_some(folding.polynomial)
}

/// Two terms that differ by sin a·sin b in the place of cos a·cos b, or by cos a·sin b in that of sin a·cos b.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    /// The positions of a and b, a behind b.
    angles: (usize, usize),
    /// Whether it is the second kind.
    sine: bool,
    /// The term with cos b.
    left: Monomial,
    /// The term with sin b.
    right: Monomial,
}

/// A polynomial and where its terms may be drawn together. That is found term by term, once for each term that appears:
/// a term has few angles, a polynomial may have hundreds.
struct Folding {
    polynomial: Polynomial,
    angles: Vec<Angle>,
    /// The angle of an atom, and whether the atom is its sine.
    angle_of: BTreeMap<Atom, (usize, bool)>,
    /// In the order of the angles; some may have lost a term since they were found.
    places: BTreeSet<Place>,
}

impl Folding {
    fn new(polynomial: &Polynomial, angles: &[Angle]) -> Self {
        let mut folding = Folding {
            polynomial: polynomial.clone(),
            angles: Vec::new(),
            angle_of: BTreeMap::new(),
            places: BTreeSet::new(),
        };
        angles.iter().for_each(|angle| folding.know(*angle));
        for left in polynomial.0.keys() {
            folding.enter(left, true);
        }
        folding
    }

    fn know(&mut self, angle: Angle) {
        if self.angles.iter().all(|old| old.sin != angle.sin) {
            self.angle_of.insert(angle.sin, (self.angles.len(), true));
            self.angle_of.insert(angle.cos, (self.angles.len(), false));
            self.angles.push(angle);
        }
    }

    /// The first place that `combine` accepts, with what it made of it; it is told whether the signs there are equal.
    fn first<R>(&mut self, mut combine: impl FnMut(&[Angle], &Place, bool) -> Option<R>) -> Option<(Place, R)> {
        let mut stale = Vec::new();
        let mut found = None;
        for place in &self.places {
            let Some((_, equal)) = self.shared(&place.left, &place.right) else {
                stale.push(place.clone());
                continue;
            };
            if let Some(result) = combine(&self.angles, place, equal) {
                found = Some((place.clone(), result));
                break;
            }
        }
        for place in stale {
            self.places.remove(&place);
        }
        found
    }

    /// The part of the coefficients of two terms that agrees up to sign, with the sign of the first, and whether the
    /// signs are equal; `None` where one of the terms is gone.
    fn shared(&self, left: &Monomial, right: &Monomial) -> Option<(Rational, bool)> {
        let (x, y) = (self.polynomial.0.get(left)?, self.polynomial.0.get(right)?);
        let least = x.abs().min(y.abs());
        Some((if x.is_negative() { least.neg() } else { least }, x.is_negative() == y.is_negative()))
    }

    fn push(&mut self, monomial: Monomial, coefficient: Rational) {
        let appears = !self.polynomial.0.contains_key(&monomial);
        self.polynomial.push(monomial.clone(), coefficient);
        if appears {
            self.enter(&monomial, true);
            self.enter(&monomial, false);
        }
    }

    /// Finds the places of a term, as the left one or as the right one.
    fn enter(&mut self, term: &Monomial, left: bool) {
        let there: Vec<(usize, bool)> =
            term.0.iter().filter(|(_, k)| *k >= 1).filter_map(|(atom, _)| self.angle_of.get(atom).copied()).collect();
        for (i, first) in &there {
            for (j, _) in there.iter().filter(|(j, second)| j < i && *second != left) {
                let (a, b) = (self.angles[*i], self.angles[*j]);
                let (own, partner) = if *first { (a.sin, a.cos) } else { (a.cos, a.sin) };
                let (beside, opposite) = if left { (b.cos, b.sin) } else { (b.sin, b.cos) };
                let other =
                    without(term, own, beside).mul(&Monomial::power(partner, 1)).mul(&Monomial::power(opposite, 1));
                if self.polynomial.0.contains_key(&other) {
                    let (angles, term) = ((*i, *j), term.clone());
                    self.places.insert(match left {
                        true => Place { angles, sine: *first, left: term, right: other },
                        false => Place { angles, sine: !*first, left: other, right: term },
                    });
                }
            }
        }
    }
}

fn without(monomial: &Monomial, a: Atom, b: Atom) -> Monomial {
    monomial.div(&Monomial::power(a, 1)).div(&Monomial::power(b, 1))
}

/// The atom of cos(a ∓ b) or sin(a ± b), whether it comes with a minus, and the new angle's atoms.
fn combined(
    graph: &mut Graph,
    atoms: &mut Atoms,
    a: Angle,
    b: Angle,
    sine: bool,
    equal: bool,
) -> Option<(Atom, bool, Option<Angle>)> {
    let argument = |graph: &Graph, atom: Atom| match graph.node(atoms.base(atom)?) {
        Node::Function(Function::Sin | Function::Cos, arguments) => Some(arguments[0]),
        _ => None,
    };
    let (x, y) = (argument(graph, a.sin)?, argument(graph, b.sin)?);
    // cos a cos b + sin a sin b = cos(a - b); sin a cos b + cos a sin b = sin(a + b).
    let angle = if sine == equal { graph.add(x, y) } else { graph.sub(x, y) };
    let (s, c) = (graph.sin(angle), graph.cos(angle));
    let value = if sine { s } else { c };
    let plain = |graph: &Graph, e: Expr| {
        let (number, factors) = graph.as_term(e);
        match factors.as_slice() {
            [(base, 1)] if matches!(graph.node(*base), Node::Function(..)) => Some((number, *base)),
            _ => None,
        }
    };
    let (number, base) = plain(graph, value)?;
    let minus = number.neg().is_one();
    if !(minus || number.is_one()) {
        return None;
    }
    let atom = atoms.of(graph, base);
    let pair = plain(graph, s).zip(plain(graph, c));
    let new = pair.map(|((_, s), (_, c))| Angle { sin: atoms.of(graph, s), cos: atoms.of(graph, c) });
    Some((atom, minus, new))
}
