//! Common work of many sums and products: the pair of members that occurs most often becomes a unit of its own, again
//! and again, until no pair occurs twice. x⁴ becomes the square of a square on the way.

use super::pairs::{Pair, Pairs};
use super::unit::{Bag, Id, Unit, Units};

/// Longer bags are cut into pieces first: the work stays linear in the program.
const LONGEST_BAG: usize = 48;

struct Sharing<'a> {
    units: &'a mut Units,
    product: bool,
    /// The unit behind each bag.
    owners: Vec<Id>,
    bags: Vec<Bag>,
    pairs: Pairs,
}

/// Shares pairs among all products, then among all sums.
pub fn share(units: &mut Units) {
    for product in [true, false] {
        cut(units, product);
        let mut owners = Vec::new();
        let mut bags = Vec::new();
        for (id, unit) in units.units.iter().enumerate() {
            match unit {
                Unit::Product(bag) if product => bags.push(bag.clone()),
                Unit::Sum(bag) if !product => bags.push(bag.clone()),
                _ => continue,
            }
            owners.push(id as Id);
        }
        let mut sharing = Sharing { units, product, owners, bags, pairs: Pairs::default() };
        sharing.run();
    }
}

fn cut(units: &mut Units, product: bool) {
    for id in 0..units.units.len() {
        let bag = match &units.units[id] {
            Unit::Product(bag) if product && bag.len() > LONGEST_BAG => bag.clone(),
            Unit::Sum(bag) if !product && bag.len() > LONGEST_BAG => bag.clone(),
            _ => continue,
        };
        let pieces = bag.chunks(LONGEST_BAG).map(|piece| {
            let sign = if product { 1 } else { piece[0].1 };
            let piece: Bag = piece.iter().map(|(id, weight)| (*id, weight * sign)).collect();
            (units.push_pair(if product { Unit::Product(piece) } else { Unit::Sum(piece) }), sign)
        });
        let whole: Bag = pieces.collect();
        units.units[id] = if product { Unit::Product(whole) } else { Unit::Sum(whole) };
    }
}

impl Sharing<'_> {
    fn run(&mut self) {
        for at in 0..self.bags.len() {
            for (pair, times) in self.pairs_of(at, None) {
                self.count_in(pair, times, at);
            }
        }
        while let Some(pair) = self.pairs.most_frequent() {
            self.extract(pair);
        }
        for (owner, bag) in self.owners.iter().zip(&self.bags) {
            self.units.units[*owner as usize] =
                if self.product { Unit::Product(bag.clone()) } else { Unit::Sum(bag.clone()) };
        }
    }

    fn extract(&mut self, pair: Pair) {
        let (a, b, agree) = pair;
        let occurrences = self.pairs.take_bags(pair);
        let bag = if a == b { vec![(a, 2)] } else { vec![(a, 1), (b, if self.product || agree { 1 } else { -1 })] };
        let new = self.units.push_pair(if self.product { Unit::Product(bag) } else { Unit::Sum(bag) });
        for at in occurrences {
            let at = at as usize;
            let times = self.times(at, pair);
            if times == 0 {
                continue;
            }
            let touched = [a, b, new];
            for (other, n) in self.pairs_of(at, Some(&touched)) {
                self.pairs.remove(other, n);
            }
            let bag = &mut self.bags[at];
            let sign = bag.iter().find(|(id, _)| *id == a).map_or(1, |(_, weight)| *weight);
            if self.product {
                for (id, k) in bag.iter_mut() {
                    if *id == a || *id == b {
                        *k -= if a == b { 2 * times } else { times } as i32;
                    }
                }
                bag.retain(|(_, k)| *k != 0);
                bag.push((new, times as i32));
            } else {
                bag.retain(|(id, _)| *id != a && *id != b);
                bag.push((new, sign));
            }
            for (other, n) in self.pairs_of(at, Some(&touched)) {
                self.count_in(other, n, at);
            }
        }
    }

    fn count_in(&mut self, pair: Pair, times: u32, at: usize) {
        let stage = || self.units.stage(pair.0).max(self.units.stage(pair.1));
        self.pairs.add(pair, times, at as u32, stage);
    }

    /// How often the pair stands in the bag.
    fn times(&self, at: usize, (a, b, agree): Pair) -> u32 {
        let weight = |id: Id| self.bags[at].iter().find(|(other, _)| *other == id).map_or(0, |(_, w)| *w);
        let (x, y) = (weight(a), weight(b));
        match (self.product, a == b) {
            (true, true) => x as u32 / 2,
            (true, false) => x.min(y) as u32,
            (false, _) => u32::from(x != 0 && y != 0 && ((x > 0) == (y > 0)) == agree),
        }
    }

    /// All pairs of the bag, or those with one of the given members.
    fn pairs_of(&self, at: usize, with: Option<&[Id]>) -> Vec<(Pair, u32)> {
        let members = &self.bags[at];
        let mut pairs = Vec::new();
        for (i, (a, x)) in members.iter().enumerate() {
            let wanted = with.is_none_or(|ids| ids.contains(a));
            if self.product && *x > 1 && wanted {
                pairs.push(((*a, *a, true), *x as u32 / 2));
            }
            for (b, y) in &members[i + 1..] {
                if !wanted && !with.is_none_or(|ids| ids.contains(b)) {
                    continue;
                }
                let (low, high) = if a < b { (*a, *b) } else { (*b, *a) };
                let (agree, times) = if self.product { (true, *x.min(y) as u32) } else { ((*x > 0) == (*y > 0), 1) };
                pairs.push(((low, high, agree), times));
            }
        }
        pairs
    }
}
