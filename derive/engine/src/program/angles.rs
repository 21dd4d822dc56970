//! Sines and cosines: one pair for each angle; an angle that is the sum or the difference of two others, or twice
//! another, takes products instead of a pair of its own.

use super::lower::{Lowering, Term};
use super::unit::{Unit, merge};
use crate::symbolic::{Expr, Function, Node, Rational, Stage};
use std::collections::{BTreeMap, BTreeSet};

/// Among more angles than this no sums are looked for.
const MOST_ANGLES: usize = 96;

/// `angle = ±first ± second`, the signs as factors.
#[derive(Copy, Clone, Debug)]
pub struct Split {
    first: (Expr, bool),
    second: (Expr, bool),
}

impl Lowering<'_> {
    /// The angles whose sine and cosine follow from those of two others.
    pub(super) fn splits(&mut self, order: &[Expr]) -> BTreeMap<Expr, Split> {
        let mut angles = BTreeSet::new();
        for e in order {
            if !self.is_coefficient(*e)
                && let Node::Function(Function::Sin | Function::Cos, arguments) = self.graph.node(*e)
            {
                angles.insert((self.graph.as_sum(arguments[0]).1.len(), arguments[0]));
            }
        }
        let mut splits = BTreeMap::new();
        if angles.len() > MOST_ANGLES {
            return splits;
        }
        // Simple angles first: each may rest on those before it.
        let mut known: BTreeSet<Expr> = BTreeSet::new();
        let coefficient = |lowering: &Self, e: Expr| {
            let (_, terms) = lowering.graph.as_sum(e);
            terms
                .iter()
                .map(|(c, _)| if c.is_negative() { c.neg() } else { c.clone() })
                .fold(Rational::ZERO, |a, b| a.add(&b))
        };
        let mut angles: Vec<(usize, Rational, Expr)> =
            angles.into_iter().map(|(n, e)| (n, coefficient(self, e), e)).collect();
        angles.sort();
        for (_, _, angle) in angles {
            if let Some(split) = self.split(angle, &known) {
                splits.insert(angle, split);
            }
            known.insert(angle);
        }
        splits
    }

    fn split(&mut self, angle: Expr, known: &BTreeSet<Expr>) -> Option<Split> {
        for first in known {
            for negative in [false, true] {
                let rest = if negative { self.graph.add(angle, *first) } else { self.graph.sub(angle, *first) };
                let opposite = self.graph.neg(rest);
                for (second, turned) in [(rest, false), (opposite, true)] {
                    if known.contains(&second) {
                        return Some(Split { first: (*first, negative), second: (second, turned) });
                    }
                }
            }
        }
        None
    }

    /// Sine and cosine of an angle.
    pub(super) fn turn(&mut self, angle: Expr, splits: &BTreeMap<Expr, Split>) -> (Term, Term) {
        // Angles that this one rests on come first; no chain is longer than the number of angles.
        let mut stack = vec![angle];
        while let Some(angle) = stack.pop() {
            if self.turns.contains_key(&angle) {
                continue;
            }
            let pair = match splits.get(&angle) {
                None => {
                    let term = self.term(angle);
                    let unit = self.unit_of(&term);
                    let sine = self.of_unit(Unit::Sine(unit), Stage::Constant);
                    (sine, self.of_unit(Unit::Cosine(unit), Stage::Constant))
                }
                Some(split) => {
                    let open: Vec<Expr> =
                        [split.first.0, split.second.0].into_iter().filter(|a| !self.turns.contains_key(a)).collect();
                    if !open.is_empty() {
                        stack.push(angle);
                        stack.extend(open);
                        continue;
                    }
                    self.of_sum(*split)
                }
            };
            self.turns.insert(angle, pair);
        }
        self.turns[&angle].clone()
    }

    /// sin(a + b) = sin a cos b + cos a sin b, cos(a + b) = cos a cos b - sin a sin b.
    fn of_sum(&mut self, split: Split) -> (Term, Term) {
        let signed = |lowering: &mut Self, (angle, negative): (Expr, bool)| {
            let (mut sine, cosine) = lowering.turns[&angle].clone();
            if negative {
                sine.coefficient = lowering.graph.neg(sine.coefficient);
            }
            (sine, cosine)
        };
        let (sin_a, cos_a) = signed(self, split.first);
        let (sin_b, cos_b) = signed(self, split.second);
        let product = |lowering: &mut Self, a: &Term, b: &Term, minus: bool| {
            let coefficient = lowering.graph.mul(a.coefficient, b.coefficient);
            let coefficient = if minus { lowering.graph.neg(coefficient) } else { coefficient };
            Term { coefficient, factors: merge(&a.factors, &b.factors) }
        };
        let sine = vec![product(self, &sin_a, &cos_b, false), product(self, &cos_a, &sin_b, false)];
        let cosine = vec![product(self, &cos_a, &cos_b, false), product(self, &sin_a, &sin_b, true)];
        let (sine, cosine) = (self.merged(sine), self.merged(cosine));
        (self.collect(sine, 0), self.collect(cosine, 0))
    }
}
