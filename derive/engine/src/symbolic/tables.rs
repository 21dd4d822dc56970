//! Sets of expressions and tables over them, by position in the arena.
//!
//! Macros run unoptimised, where a look-up in a hash map passes through some dozens of functions. An expression is a
//! position already, so a bit or a cell of an array does, and the loops over them are written out.

use super::{Expr, Node};

/// A set of expressions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Set(Vec<u64>);

impl Set {
    /// The set of the given expressions.
    pub fn of(expressions: &[Expr]) -> Self {
        let mut set = Set::default();
        for e in expressions {
            set.insert(*e);
        }
        set
    }

    /// Whether the expression is in the set.
    pub fn contains(&self, e: Expr) -> bool {
        let words = self.0.as_slice();
        let at = e.0 as usize / 64;
        at < words.len() && words[at] >> (e.0 % 64) & 1 == 1
    }

    /// Adds an expression; whether it is new.
    pub fn insert(&mut self, e: Expr) -> bool {
        let at = e.0 as usize / 64;
        if at >= self.0.len() {
            self.0.resize(at + 1, 0);
        }
        let word = &mut self.0.as_mut_slice()[at];
        let new = *word >> (e.0 % 64) & 1 == 0;
        *word |= 1 << (e.0 % 64);
        new
    }

    /// The expressions in ascending order.
    pub fn to_vec(&self) -> Vec<Expr> {
        let words = self.0.as_slice();
        let (mut at, mut count) = (0, 0);
        while at < words.len() {
            count += words[at].count_ones() as usize;
            at += 1;
        }
        let mut found = vec![Expr(0); count];
        let out = found.as_mut_slice();
        let mut n = 0;
        at = 0;
        while at < words.len() {
            let mut left = words[at];
            while left != 0 {
                out[n] = Expr(at as u32 * 64 + left.trailing_zeros());
                left &= left - 1;
                n += 1;
            }
            at += 1;
        }
        found
    }

    /// Adds what the expressions of the set contain, but for what stands below expressions that `opens` keeps closed.
    pub(super) fn close_under(&mut self, nodes: &[Node], opens: impl Fn(usize) -> bool) {
        let words = self.0.as_mut_slice();
        let mut at = words.len();
        while at > 0 {
            at -= 1;
            // Children stand before their parents: while a word is gone through from above, bits appear below only.
            let mut below = u64::MAX;
            while words[at] & below != 0 {
                let bit = 63 - (words[at] & below).leading_zeros();
                below = (1 << bit) - 1;
                let position = at * 64 + bit as usize;
                if opens(position) {
                    nodes[position].for_children(|child| words[child.0 as usize / 64] |= 1 << (child.0 % 64));
                }
            }
        }
    }
}

/// An expression or a count for some expressions.
#[derive(Clone, Debug)]
pub struct Table(Vec<u32>);

impl Table {
    /// An empty table for the first expressions of an arena, `length` of them.
    pub fn new(length: usize) -> Self {
        Table(vec![0; length])
    }

    /// What stands there, if something does.
    pub fn get(&self, e: Expr) -> Option<Expr> {
        let cells = self.0.as_slice();
        let at = e.0 as usize;
        if at < cells.len() && cells[at] != 0 { Some(Expr(cells[at] - 1)) } else { None }
    }

    /// Enters an expression.
    pub fn set(&mut self, e: Expr, value: Expr) {
        self.0.as_mut_slice()[e.0 as usize] = value.0 + 1;
    }

    /// How often the expression was counted.
    pub fn count(&self, e: Expr) -> usize {
        let cells = self.0.as_slice();
        let at = e.0 as usize;
        if at < cells.len() { cells[at] as usize } else { 0 }
    }

    /// Counts the expression once more.
    pub fn add(&mut self, e: Expr) {
        self.0.as_mut_slice()[e.0 as usize] += 1;
    }
}

/// Where the nodes of an arena stand, by their contents: open addressing over positions.
#[derive(Clone, Debug, Default)]
pub struct Interned {
    /// Positions plus one; a power of two of them, at least half empty.
    slots: Vec<u32>,
    /// The hash of each node.
    hashes: Vec<u64>,
}

impl Interned {
    /// The position of an equal node.
    pub fn find(&self, nodes: &[Node], node: &Node, hash: u64) -> Option<u32> {
        let (slots, hashes) = (self.slots.as_slice(), self.hashes.as_slice());
        if slots.is_empty() {
            return None;
        }
        let mut at = hash as usize & (slots.len() - 1);
        while slots[at] != 0 {
            let position = slots[at] as usize - 1;
            if hashes[position] == hash && nodes[position] == *node {
                return Some(slots[at] - 1);
            }
            at = (at + 1) & (slots.len() - 1);
        }
        None
    }

    /// Enters the next node of the arena.
    pub fn push(&mut self, hash: u64) {
        self.hashes.push(hash);
        let hashes = self.hashes.as_slice();
        if 2 * hashes.len() <= self.slots.len() {
            enter(self.slots.as_mut_slice(), hash, hashes.len() as u32);
            return;
        }
        self.slots = vec![0; (4 * hashes.len()).next_power_of_two().max(64)];
        let mut at = 0;
        while at < hashes.len() {
            enter(self.slots.as_mut_slice(), hashes[at], at as u32 + 1);
            at += 1;
        }
    }
}

fn enter(slots: &mut [u32], hash: u64, value: u32) {
    let mut at = hash as usize & (slots.len() - 1);
    while slots[at] != 0 {
        at = (at + 1) & (slots.len() - 1);
    }
    slots[at] = value;
}
