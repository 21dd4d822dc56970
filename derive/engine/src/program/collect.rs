//! Sums: like terms together, equal coefficients and common factors taken out.

use super::lower::{Lowering, Term};
use super::unit::{Bag, Id, Unit};
use crate::symbolic::{Expr, Stage};
use std::collections::BTreeMap;

/// Common factors are taken out of sums nested at most so deep; each level lowers the degree.
const DEEPEST: usize = 24;

impl Lowering<'_> {
    /// Terms with the same factors as one; zeros gone.
    pub(super) fn merged(&mut self, mut items: Vec<Term>) -> Vec<Term> {
        items.sort_by(|a, b| a.factors.cmp(&b.factors));
        let mut merged: Vec<Term> = Vec::with_capacity(items.len());
        for item in items {
            match merged.last_mut() {
                Some(last) if last.factors == item.factors => {
                    last.coefficient = self.graph.add(last.coefficient, item.coefficient);
                }
                _ => merged.push(item),
            }
        }
        merged.retain(|item| !self.graph.is_zero(item.coefficient));
        merged
    }

    /// The sum of terms with distinct factors as one term.
    pub(super) fn collect(&mut self, mut items: Vec<Term>, depth: usize) -> Term {
        if self.manner.factor && depth < DEEPEST {
            items = self.factored(items, depth);
        }
        match items.as_slice() {
            [] => return Term { coefficient: self.graph.zero(), factors: Bag::new() },
            [single] => return single.clone(),
            _ => {}
        }
        // Groups of equal magnitude, in order of appearance.
        let mut groups: Vec<(Expr, Vec<(bool, Bag)>)> = Vec::new();
        let mut known: BTreeMap<Expr, usize> = BTreeMap::new();
        for item in items {
            let (negative, magnitude) = self.magnitude(item.coefficient);
            let at = *known.entry(magnitude).or_insert_with(|| {
                groups.push((magnitude, Vec::new()));
                groups.len() - 1
            });
            groups[at].1.push((negative, item.factors));
        }
        if let [(magnitude, members)] = groups.as_slice() {
            let (magnitude, members) = (*magnitude, members.clone());
            let (negative, sum) = self.signed_sum(members);
            let coefficient = if negative { self.graph.neg(magnitude) } else { magnitude };
            return Term { coefficient, factors: vec![(sum, 1)] };
        }
        let mut bag = Bag::new();
        for (magnitude, members) in groups {
            let several = members.iter().filter(|(_, factors)| !factors.is_empty()).count() > 1;
            if several && !self.graph.is_one(magnitude) {
                let (constant, rest): (Vec<_>, Vec<_>) = members.into_iter().partition(|(_, f)| f.is_empty());
                let (negative, sum) = self.signed_sum(rest);
                let id = self.magnitude_unit(magnitude, &vec![(sum, 1)]);
                bag.push((id, if negative { -1 } else { 1 }));
                for (negative, factors) in constant {
                    let id = self.magnitude_unit(magnitude, &factors);
                    bag.push((id, if negative { -1 } else { 1 }));
                }
            } else {
                for (negative, factors) in members {
                    let id = self.magnitude_unit(magnitude, &factors);
                    bag.push((id, if negative { -1 } else { 1 }));
                }
            }
        }
        let (negative, sum) = self.intern_sum(bag);
        let one = self.graph.one();
        let coefficient = if negative { self.graph.neg(one) } else { one };
        Term { coefficient, factors: vec![(sum, 1)] }
    }

    fn signed_sum(&mut self, members: Vec<(bool, Bag)>) -> (bool, Id) {
        let one = self.graph.one();
        let bag = members
            .into_iter()
            .map(|(negative, factors)| (self.magnitude_unit(one, &factors), if negative { -1 } else { 1 }))
            .collect();
        self.intern_sum(bag)
    }

    /// The sum with its first sign positive, and whether the signs were turned.
    fn intern_sum(&mut self, mut bag: Bag) -> (bool, Id) {
        bag.sort_unstable();
        let negative = bag.first().is_some_and(|(_, sign)| *sign < 0);
        if negative {
            bag.iter_mut().for_each(|(_, sign)| *sign = -*sign);
        }
        if let [(single, 1)] = bag.as_slice() {
            return (negative, *single);
        }
        (negative, self.units.intern(Unit::Sum(bag), Stage::Constant))
    }

    /// The factor that most terms share, taken out, again and again.
    fn factored(&mut self, mut items: Vec<Term>, depth: usize) -> Vec<Term> {
        loop {
            let mut counts: BTreeMap<Id, usize> = BTreeMap::new();
            for (id, _) in items.iter().flat_map(|item| &item.factors) {
                *counts.entry(*id).or_default() += 1;
            }
            let reciprocal = |id: Id| matches!(self.units.get(id), Unit::Reciprocal(_));
            let best = counts
                .into_iter()
                .filter(|(_, n)| *n > 1)
                .max_by_key(|(id, n)| (*n, reciprocal(*id), std::cmp::Reverse(*id)));
            let Some((common, _)) = best else { return items };
            let (with, without): (Vec<_>, Vec<_>) =
                items.into_iter().partition(|item| item.factors.iter().any(|(id, _)| *id == common));
            let inner = with
                .into_iter()
                .map(|mut item| {
                    for (id, k) in &mut item.factors {
                        if *id == common {
                            *k -= 1;
                        }
                    }
                    item.factors.retain(|(_, k)| *k != 0);
                    item
                })
                .collect();
            let inner = self.merged(inner);
            let inner = self.collect(inner, depth + 1);
            let factors = super::unit::merge(&inner.factors, &vec![(common, 1)]);
            items = without;
            if !self.graph.is_zero(inner.coefficient) {
                items.push(Term { coefficient: inner.coefficient, factors });
            }
            items = self.merged(items);
        }
    }
}
