//! Pairs of members with the bags that hold them, and the pair that occurs most often.
//!
//! Macros run unoptimised, and this is where a large program spends most of its time: pairs are numbers in an open table of their
//! own, and what orders them is one number as well.

use super::unit::Id;
use crate::symbolic::Stage;
use std::collections::BinaryHeap;

/// Two members, ascending, and for sums whether their signs agree.
pub type Pair = (Id, Id, bool);

/// How often each pair occurs, and where.
#[derive(Default)]
pub struct Pairs {
    /// Positions plus one; a power of two of them, at least half empty.
    slots: Vec<u32>,
    keys: Vec<u64>,
    counts: Vec<u32>,
    bags: Vec<Vec<u32>>,
    stages: Vec<Stage>,
    /// Pairs counted since the last one was asked for.
    changed: Vec<u32>,
    /// Counts with their pairs, possibly old ones: more frequent, earlier stages, smaller pairs first.
    order: BinaryHeap<u128>,
}

impl Pairs {
    /// Counts a pair in a bag; bags are counted one after the other.
    pub fn add(&mut self, pair: Pair, times: u32, bag: u32, stage: impl Fn() -> Stage) {
        let key = packed(pair);
        let at = match self.find(key) {
            Some(at) => at,
            None => self.enter(key, stage()),
        };
        self.counts[at] += times;
        let bags = &mut self.bags[at];
        // A repetition stands last.
        if bags.last() != Some(&bag) {
            bags.push(bag);
        }
        if self.counts[at] > 1 {
            self.changed.push(at as u32);
        }
    }

    /// Takes back so many occurrences of a pair.
    pub fn remove(&mut self, pair: Pair, times: u32) {
        if let Some(at) = self.find(packed(pair)) {
            self.counts[at] -= times;
        }
    }

    /// The bags that hold a pair, or held it once; they are forgotten.
    pub fn take_bags(&mut self, pair: Pair) -> Vec<u32> {
        self.find(packed(pair)).map_or(Vec::new(), |at| std::mem::take(&mut self.bags[at]))
    }

    /// The pair that occurs most often, if one occurs twice.
    pub fn most_frequent(&mut self) -> Option<Pair> {
        let mut changed = std::mem::take(&mut self.changed);
        changed.sort_unstable();
        changed.dedup();
        for at in changed {
            self.offer(at as usize);
        }
        loop {
            let top = self.order.pop()?;
            let (count, key) = ((top >> 72) as u32, !(top as u64));
            let at = self.find(key)?;
            let now = self.counts[at];
            if now == count {
                return Some(unpacked(key));
            }
            if now < count {
                self.offer(at);
            }
        }
    }

    fn offer(&mut self, at: usize) {
        if self.counts[at] > 1 {
            let earlier = u8::MAX - self.stages[at] as u8;
            let rank = u128::from(self.counts[at]) << 72 | u128::from(earlier) << 64 | u128::from(!self.keys[at]);
            self.order.push(rank);
        }
    }

    fn find(&self, key: u64) -> Option<usize> {
        let (slots, keys) = (self.slots.as_slice(), self.keys.as_slice());
        if slots.is_empty() {
            return None;
        }
        let mut at = hash(key) & (slots.len() - 1);
        while slots[at] != 0 {
            let position = slots[at] as usize - 1;
            if keys[position] == key {
                return Some(position);
            }
            at = (at + 1) & (slots.len() - 1);
        }
        None
    }

    fn enter(&mut self, key: u64, stage: Stage) -> usize {
        self.keys.push(key);
        self.counts.push(0);
        self.bags.push(Vec::new());
        self.stages.push(stage);
        let count = self.keys.len();
        if 2 * count <= self.slots.len() {
            place(self.slots.as_mut_slice(), key, count as u32);
        } else {
            self.slots = vec![0; (4 * count).next_power_of_two().max(64)];
            let mut at = 0;
            while at < count {
                place(self.slots.as_mut_slice(), self.keys.as_slice()[at], at as u32 + 1);
                at += 1;
            }
        }
        count - 1
    }
}

/// A pair as a number, in the order of pairs. Units are fewer than 2³¹.
fn packed((a, b, agree): Pair) -> u64 {
    (a as u64) << 33 | (b as u64) << 1 | agree as u64
}

fn unpacked(key: u64) -> Pair {
    ((key >> 33) as Id, (key >> 1) as Id & (Id::MAX >> 1), key & 1 == 1)
}

/// The high bits of a product with an odd constant (Knuth, The Art of Computer Programming, volume 3, section 6.4).
fn hash(key: u64) -> usize {
    (key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 24) as usize
}

fn place(slots: &mut [u32], key: u64, value: u32) {
    let mut at = hash(key) & (slots.len() - 1);
    while slots[at] != 0 {
        at = (at + 1) & (slots.len() - 1);
    }
    slots[at] = value;
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cmp::Reverse;
    use std::collections::BTreeMap;

    #[test]
    fn packing_keeps_pairs_and_their_order() {
        let pairs = [(0, 0, false), (0, 0, true), (0, 7, true), (3, 2_000_000_000, false), (4, 4, true)];
        assert_eq!(pairs.map(|pair| unpacked(packed(pair))), pairs);
        assert!(pairs.map(packed).is_sorted());
    }

    /// Against counting all pairs anew.
    #[test]
    fn the_most_frequent_pair_is_found_as_by_a_search() {
        let stage_of = |(a, b, _): Pair| if (a + b) % 3 == 0 { Stage::Speed } else { Stage::Coordinate };
        let mut pairs = Pairs::default();
        let mut counts: BTreeMap<Pair, u32> = BTreeMap::new();
        let mut seed = 5_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((seed >> 33) % below) as u32
        };
        for round in 0..300 {
            for _ in 0..20 {
                let (a, more) = (draw(8), draw(5));
                let pair = (a, a + more, draw(2) == 1);
                let times = 1 + draw(3);
                pairs.add(pair, times, round, || stage_of(pair));
                *counts.entry(pair).or_default() += times;
            }
            let searched = counts.iter().filter(|(_, n)| **n > 1);
            let searched = searched.max_by_key(|(pair, n)| (**n, Reverse((stage_of(**pair), **pair)))).map(|(p, _)| *p);
            let found = pairs.most_frequent();
            assert_eq!(found, searched);
            let Some(pair) = found else { continue };
            assert!(!pairs.take_bags(pair).is_empty());
            let all = counts[&pair];
            let taken = if round % 2 == 0 { all } else { all - 1 };
            pairs.remove(pair, taken);
            counts.insert(pair, all - taken);
            // What is left of it counts again once it is found again.
            pairs.add(pair, 1, round, || stage_of(pair));
            counts.insert(pair, all - taken + 1);
        }
    }
}
