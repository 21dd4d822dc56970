//! cos a·cos b + sin a·sin b = cos(a - b), and its kin, on polynomials.

use super::expand::{Angle, Atoms};
use super::limits::FOLDS;
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::symbolic::{Expr, Function, Graph, Node, Rational};
use std::collections::BTreeMap;

/// The polynomial with sums and differences of its angles drawn together wherever two terms allow it, or `None` where
/// none do. Each step lowers the degree.
pub fn fold(graph: &mut Graph, polynomial: &Polynomial, angles: &[Angle], atoms: &mut Atoms) -> Option<Polynomial> {
    let mut folded = polynomial.clone();
    let mut angles: Vec<Angle> = angles.to_vec();
    let mut steps = 0;
    'next: while steps < FOLDS {
        for Pair { angles: (i, j), sine, left, right, whole, equal } in pairs(&folded, &angles) {
            let (a, b) = (angles[i], angles[j]);
            // Both terms carry `whole`; what one has beyond it stays.
            let Some((atom, sign, angle)) = combined(graph, atoms, a, b, sine, equal) else { continue };
            let rest = without(&left, if sine { a.sin } else { a.cos }, b.cos);
            folded.push(left, whole.neg());
            folded.push(right, if equal { whole.neg() } else { whole.clone() });
            let coefficient = if sign { whole.neg() } else { whole };
            folded.push(rest.mul(&Monomial::power(atom, 1)), coefficient);
            if let Some(angle) = angle.filter(|new| angles.iter().all(|old| old.sin != new.sin)) {
                angles.push(angle);
            }
            steps += 1;
            continue 'next;
        }
        break;
    }
    (steps > 0).then_some(folded)
}

/// Two terms that differ by sin a·sin b in the place of cos a·cos b, or by cos a·sin b in that of sin a·cos b.
struct Pair {
    /// The positions of a and b, a behind b.
    angles: (usize, usize),
    /// Whether it is the second kind.
    sine: bool,
    left: Monomial,
    right: Monomial,
    /// The part of their coefficients that agrees up to sign.
    whole: Rational,
    /// Whether the signs are equal.
    equal: bool,
}

/// All pairs, in the order of their angles. Found term by term: a term has few angles, a polynomial may have hundreds.
fn pairs(polynomial: &Polynomial, angles: &[Angle]) -> Vec<Pair> {
    let mut places: BTreeMap<Atom, (usize, bool)> = BTreeMap::new();
    for (i, angle) in angles.iter().enumerate() {
        places.insert(angle.sin, (i, true));
        places.insert(angle.cos, (i, false));
    }
    let mut found = Vec::new();
    for (left, x) in &polynomial.0 {
        let there: Vec<(usize, bool)> =
            left.0.iter().filter(|(_, k)| *k >= 1).filter_map(|(atom, _)| places.get(atom).copied()).collect();
        for (i, sine) in &there {
            for (j, _) in there.iter().filter(|(j, second)| j < i && !second) {
                let (a, b) = (angles[*i], angles[*j]);
                let (first, other) = if *sine { (a.sin, a.cos) } else { (a.cos, a.sin) };
                let rest = without(left, first, b.cos);
                let right = rest.mul(&Monomial::power(other, 1)).mul(&Monomial::power(b.sin, 1));
                let Some(y) = polynomial.0.get(&right) else { continue };
                let size = |c: &Rational| if c.is_negative() { c.neg() } else { c.clone() };
                let least = size(x).min(size(y));
                found.push(Pair {
                    angles: (*i, *j),
                    sine: *sine,
                    left: left.clone(),
                    right,
                    whole: if x.is_negative() { least.neg() } else { least },
                    equal: x.is_negative() == y.is_negative(),
                });
            }
        }
    }
    found.sort_by_key(|pair| (pair.angles, pair.sine));
    found
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
