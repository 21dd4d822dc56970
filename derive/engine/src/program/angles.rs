//! Sines and cosines: one pair for each angle; an angle that is the sum or the difference of two others, or twice
//! another, takes products instead of a pair of its own.

use super::lower::{Lowering, Term};
use super::unit::{Unit, merge};
use crate::symbolic::{Expr, Function, Node, Stage};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// For each angle so many others with a common part are tried as summands.
const TRIED: usize = 16;

/// Differences and sums of pairs of angles, with their opposites: the same in every function of a model.
#[derive(Clone, Default, Debug)]
pub struct Rests {
    /// For look-up only.
    pairs: HashMap<(Expr, Expr), [(Expr, Expr); 2]>,
}

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
                angles.insert(arguments[0]);
            }
        }
        let mut splits = BTreeMap::new();
        // In the order of the arena: a sum comes after its parts, and each angle may rest on those before it.
        let mut known: Vec<(Expr, Vec<Expr>)> = Vec::new();
        for angle in angles {
            let parts: Vec<Expr> = self.graph.as_sum(angle).1.into_iter().map(|(_, e)| e).collect();
            if let Some(split) = self.split(angle, &parts, &known) {
                splits.insert(angle, split);
            }
            known.push((angle, parts));
        }
        splits
    }

    fn split(&mut self, angle: Expr, parts: &[Expr], known: &[(Expr, Vec<Expr>)]) -> Option<Split> {
        let is_known = |e: Expr| known.binary_search_by_key(&e, |(angle, _)| *angle).is_ok();
        let related = known.iter().filter(|(_, other)| other.iter().any(|e| parts.contains(e)));
        for (first, _) in related.take(TRIED) {
            let rests = self.rests(angle, *first);
            for (negative, (rest, opposite)) in [false, true].into_iter().zip(rests) {
                if is_known(rest) {
                    return Some(Split { first: (*first, negative), second: (rest, false) });
                }
                if is_known(opposite) {
                    return Some(Split { first: (*first, negative), second: (opposite, true) });
                }
            }
        }
        None
    }

    fn rests(&mut self, angle: Expr, first: Expr) -> [(Expr, Expr); 2] {
        if let Some(rests) = self.rests.pairs.get(&(angle, first)) {
            return *rests;
        }
        let difference = self.graph.sub(angle, first);
        let sum = self.graph.add(angle, first);
        let rests = [difference, sum].map(|rest| (rest, self.graph.neg(rest)));
        self.rests.pairs.insert((angle, first), rests);
        rests
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
                    let pair = self.of_sum(*split);
                    self.remember(angle, &pair);
                    pair
                }
            };
            self.turns.insert(angle, pair);
        }
        self.turns[&angle].clone()
    }

    /// Notes which units are sine and cosine of the angle: their names say more than products of other angles' do.
    fn remember(&mut self, angle: Expr, (sine, cosine): &(Term, Term)) {
        for (function, term) in [(Function::Sin, sine), (Function::Cos, cosine)] {
            let [(unit, 1)] = term.factors[..] else { continue };
            let (negative, magnitude) = self.magnitude(term.coefficient);
            if !self.graph.is_one(magnitude) {
                continue;
            }
            let turn = match (negative, function) {
                (true, Function::Sin) => (false, function, self.graph.neg(angle)),
                _ => (negative, function, angle),
            };
            self.units.turns.entry(unit).or_insert(turn);
        }
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
