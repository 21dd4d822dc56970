//! cos a·cos b + sin a·sin b = cos(a - b), and its kin, on polynomials.

use super::expand::{Angle, Atoms};
use super::limits::FOLDS;
use super::polynomial::{Atom, Monomial, Polynomial};
use crate::symbolic::{Expr, Function, Graph, Node, Rational};

/// The polynomial with sums and differences of its angles drawn together wherever two terms allow it, or `None` where
/// none do. Each step lowers the degree.
pub fn fold(graph: &mut Graph, polynomial: &Polynomial, angles: &[Angle], atoms: &mut Atoms) -> Option<Polynomial> {
    let mut folded = polynomial.clone();
    let mut angles: Vec<Angle> = angles.to_vec();
    let mut steps = 0;
    'next: while steps < FOLDS {
        for (i, a) in angles.iter().enumerate() {
            for b in &angles[..i] {
                for (first, second, sine) in
                    [((a.cos, b.cos), (a.sin, b.sin), false), ((a.sin, b.cos), (a.cos, b.sin), true)]
                {
                    let Some((left, right, whole, equal)) = pair(&folded, first, second) else { continue };
                    // Both terms carry `whole`; what one has beyond it stays.
                    let Some((atom, sign, angle)) = combined(graph, atoms, *a, *b, sine, equal) else { continue };
                    let rest = left.div(&Monomial::power(first.0, 1)).div(&Monomial::power(first.1, 1));
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
            }
        }
        break;
    }
    (steps > 0).then_some(folded)
}

/// Two terms that differ by `first` in the place of `second`, with the part of their coefficients that agrees up to
/// sign, and whether the signs are equal.
fn pair(
    polynomial: &Polynomial,
    first: (Atom, Atom),
    second: (Atom, Atom),
) -> Option<(Monomial, Monomial, Rational, bool)> {
    polynomial.0.iter().find_map(|(left, x)| {
        if left.exponent(first.0) < 1 || left.exponent(first.1) < 1 {
            return None;
        }
        let rest = left.div(&Monomial::power(first.0, 1)).div(&Monomial::power(first.1, 1));
        let right = rest.mul(&Monomial::power(second.0, 1)).mul(&Monomial::power(second.1, 1));
        let y = polynomial.0.get(&right)?;
        let size = |c: &Rational| if c.is_negative() { c.neg() } else { c.clone() };
        let equal = x.is_negative() == y.is_negative();
        let least = size(x).min(size(y));
        Some((left.clone(), right, if x.is_negative() { least.neg() } else { least }, equal))
    })
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
