//! Extraction: the choice of one node for every class that makes all roots together cheap.
//!
//! egg's own extractors minimise the cost of a tree. Here every class carries the set of classes its choice needs, so
//! a class that is needed twice costs once. A second sweep, from the roots down, tries the other nodes of every class
//! in use against the cost of all roots together.

use super::cost::{DIVISION, OTHER, ROOT, SINCOS, squarings};
use super::language::{Classes, Term};
use super::limits::{EXTRACTION_BANS, EXTRACTION_PASSES, EXTRACTION_TRIALS, FACTOR_TERMS};
use crate::symbolic::{self, Expr, Function, Graph, Rational, Stage};
use egg::Id;
use std::collections::{BTreeMap, BTreeSet};

/// Classes as bits. Loops over them are written out: they run for every node of every class.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Set(Vec<u64>);

impl Set {
    fn empty(count: usize) -> Self {
        Set(vec![0; count.div_ceil(64)])
    }

    fn insert(&mut self, at: usize) {
        self.0.as_mut_slice()[at / 64] |= 1 << (at % 64);
    }

    fn contains(&self, at: usize) -> bool {
        self.0.as_slice()[at / 64] >> (at % 64) & 1 == 1
    }

    fn join(&mut self, other: &Set) {
        let (own, other) = (self.0.as_mut_slice(), other.0.as_slice());
        let mut i = 0;
        while i < own.len() {
            own[i] |= other[i];
            i += 1;
        }
    }

    fn meets(&self, other: &Set) -> bool {
        let (own, other) = (self.0.as_slice(), other.0.as_slice());
        let mut i = 0;
        while i < own.len() {
            if own[i] & other[i] != 0 {
                return true;
            }
            i += 1;
        }
        false
    }

    /// The sum over the members.
    fn total(&self, of: &[usize]) -> usize {
        let words = self.0.as_slice();
        let (mut i, mut total) = (0, 0);
        while i < words.len() {
            let mut left = words[i];
            while left != 0 {
                total += of[i * 64 + left.trailing_zeros() as usize];
                left &= left - 1;
            }
            i += 1;
        }
        total
    }
}

/// A node with its work: its own, and what it shares with every node that needs the same.
struct Node {
    term: Term,
    children: Vec<usize>,
    own: usize,
    once: Vec<(Once, usize)>,
}

/// Work that is done once for all who need it: the reciprocal of a class, sine and cosine of a class.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Once {
    Reciprocal(usize),
    Turn(usize),
}

/// The nodes of every class and the one chosen.
struct Choices {
    nodes: Vec<Vec<Node>>,
    chosen: Vec<Option<usize>>,
    /// Shared work that no choice may need.
    banned: BTreeSet<Once>,
}

/// The roots, rebuilt from the cheapest choice; `None` where it cannot be built within the limits.
pub fn extract(graph: &mut Graph, classes: &Classes, roots: &[Id]) -> Option<Vec<Expr>> {
    let mut ids: Vec<Id> = classes.classes().map(|c| c.id).collect();
    ids.sort();
    let places: BTreeMap<Id, usize> = ids.iter().enumerate().map(|(i, id)| (*id, i)).collect();
    let place = |id: &Id| places[&classes.find(*id)];
    let nodes: Vec<Vec<Node>> =
        ids.iter().map(|id| classes[*id].nodes.iter().map(|n| node(graph, classes, n, &place)).collect()).collect();
    let roots: Vec<usize> = roots.iter().map(place).collect();
    let mut choices = Choices { chosen: vec![None; nodes.len()], nodes, banned: BTreeSet::new() };
    choices.greedy();
    choices.improve(&roots)?;
    let mut built: Vec<Option<Expr>> = vec![None; ids.len()];
    for class in choices.order(&roots)? {
        let node = &choices.nodes[class][choices.chosen[class]?];
        let children: Vec<Expr> = node.children.iter().filter_map(|child| built[*child]).collect();
        built[class] = Some(make(graph, &node.term, &children)?);
    }
    roots.iter().map(|root| built[*root]).collect()
}

impl Choices {
    /// Chooses from the leaves up: for each class the node that is cheapest with all that it needs, each class once.
    fn greedy(&mut self) {
        let count = self.nodes.len();
        let mut best: Vec<Option<(usize, Set)>> = vec![None; count];
        let mut own = vec![0; count];
        self.chosen = vec![None; count];
        // The classes that changed their choice in the pass before, and in this one.
        let (mut before, mut changed) = (Set::empty(count), Set::empty(count));
        for pass in 0..EXTRACTION_PASSES {
            let mut settled = true;
            for class in 0..count {
                for (at, node) in self.nodes[class].iter().enumerate() {
                    if !self.allowed(node) {
                        continue;
                    }
                    let Some(mut needs) = needs(node, &best) else { continue };
                    // What needs nothing that changed costs what it did.
                    if needs.contains(class) || pass > 0 && !needs.meets(&before) && !needs.meets(&changed) {
                        continue;
                    }
                    let alone = node.own + node.once.iter().map(|(once, w)| share(once, *w)).sum::<usize>();
                    let total = alone + needs.total(&own);
                    if best[class].as_ref().is_none_or(|(old, _)| total < *old) {
                        needs.insert(class);
                        best[class] = Some((total, needs));
                        own[class] = alone;
                        self.chosen[class] = Some(at);
                        changed.insert(class);
                        settled = false;
                    }
                }
            }
            if settled {
                break;
            }
            before = std::mem::replace(&mut changed, Set::empty(count));
        }
    }

    /// Whether the node needs no shared work that is banned.
    fn allowed(&self, node: &Node) -> bool {
        node.once.is_empty() || !node.once.iter().any(|(once, _)| self.banned.contains(once))
    }

    /// Whether the roots can be built at all from what is allowed.
    fn possible(&self, roots: &[usize]) -> bool {
        let mut possible = vec![false; self.nodes.len()];
        let mut changed = true;
        while changed {
            changed = false;
            for (class, nodes) in self.nodes.iter().enumerate() {
                if !possible[class] && nodes.iter().any(|n| self.allowed(n) && n.children.iter().all(|c| possible[*c]))
                {
                    possible[class] = true;
                    changed = true;
                }
            }
        }
        roots.iter().all(|root| possible[*root])
    }

    /// Tries other nodes for the classes in use and keeps what makes the roots together cheaper.
    fn improve(&mut self, roots: &[usize]) -> Option<()> {
        let mut order = self.order(roots)?;
        let mut weight = self.weight(&order);
        // Work that is done once goes only when all who need it choose otherwise together.
        let shared: BTreeSet<Once> = order.iter().flat_map(|c| self.current(*c).map(|(once, _)| *once)).collect();
        for once in shared.into_iter().take(EXTRACTION_BANS) {
            let before = self.chosen.clone();
            self.banned.insert(once);
            if !self.possible(roots) {
                self.banned.remove(&once);
                continue;
            }
            self.greedy();
            match self.order(roots).map(|order| (self.weight(&order), order)) {
                Some((lower, new)) if lower < weight => (weight, order) = (lower, new),
                _ => {
                    self.banned.remove(&once);
                    self.chosen = before;
                }
            }
        }
        let mut trials = 0;
        let mut tried = vec![false; self.nodes.len()];
        while let Some(class) = order.iter().rev().copied().find(|c| self.nodes[*c].len() > 1 && !tried[*c]) {
            tried[class] = true;
            for at in 0..self.nodes[class].len() {
                let before = self.chosen[class];
                let known = self.nodes[class][at].children.iter().all(|c| self.chosen[*c].is_some());
                if before == Some(at) || !known || trials == EXTRACTION_TRIALS {
                    continue;
                }
                trials += 1;
                self.chosen[class] = Some(at);
                match self.order(roots).map(|order| (self.weight(&order), order)) {
                    Some((lower, new)) if lower < weight => (weight, order) = (lower, new),
                    _ => self.chosen[class] = before,
                }
            }
        }
        Some(())
    }

    /// The shared work of the chosen node.
    fn current(&self, class: usize) -> impl Iterator<Item = &(Once, usize)> {
        self.chosen[class].into_iter().flat_map(move |at| &self.nodes[class][at].once)
    }

    /// The classes that the roots need, children first; `None` where the choice runs in a circle.
    fn order(&self, roots: &[usize]) -> Option<Vec<usize>> {
        let mut order = Vec::new();
        let mut state = vec![0u8; self.nodes.len()];
        let mut stack: Vec<usize> = roots.to_vec();
        while let Some(class) = stack.last().copied() {
            match state[class] {
                0 => {
                    state[class] = 1;
                    for child in &self.nodes[class][self.chosen[class]?].children {
                        match state[*child] {
                            0 => stack.push(*child),
                            1 => return None,
                            _ => {}
                        }
                    }
                }
                other => {
                    stack.pop();
                    if other == 1 {
                        state[class] = 2;
                        order.push(class);
                    }
                }
            }
        }
        Some(order)
    }

    fn weight(&self, order: &[usize]) -> usize {
        let chosen = || order.iter().filter_map(|class| Some(&self.nodes[*class][self.chosen[*class]?]));
        let once: BTreeMap<Once, usize> = chosen().flat_map(|node| node.once.iter().copied()).collect();
        chosen().map(|node| node.own).sum::<usize>() + once.values().sum::<usize>()
    }
}

/// All that a node needs; `None` while a class of these has no choice yet.
fn needs(node: &Node, best: &[Option<(usize, Set)>]) -> Option<Set> {
    let mut needs = Set::empty(best.len());
    let (children, mut i) = (node.children.as_slice(), 0);
    while i < children.len() {
        needs.join(&best[children[i]].as_ref()?.1);
        i += 1;
    }
    Some(needs)
}

/// What of shared work one node bears while it is chosen alone.
fn share(once: &Once, weight: usize) -> usize {
    match once {
        Once::Reciprocal(_) => weight,
        Once::Turn(_) => weight / 2,
    }
}

fn make(graph: &mut Graph, node: &Term, children: &[Expr]) -> Option<Expr> {
    Some(match node {
        Term::Leaf(e) => *e,
        Term::Sum(constant, coefficients, _) => {
            let terms: Vec<(Rational, Expr)> = coefficients.iter().cloned().zip(children.iter().copied()).collect();
            graph.linear(constant.clone(), &terms)
        }
        Term::Product(exponents, _) => {
            let long =
                |e: &Expr| matches!(graph.node(*e), symbolic::Node::Sum { terms, .. } if terms.len() > FACTOR_TERMS);
            if children.iter().any(long) {
                return None;
            }
            let factors: Vec<(Expr, i32)> = children.iter().copied().zip(exponents.iter().copied()).collect();
            graph.power_product(Rational::ONE, &factors)
        }
        Term::Function(function, _) => graph.function(*function, children),
    })
}

/// A node with its work, its children done.
fn node(graph: &Graph, classes: &Classes, term: &Term, place: &dyn Fn(&Id) -> usize) -> Node {
    let fixed =
        |id: &Id| classes[*id].nodes.iter().any(|n| matches!(n, Term::Leaf(e) if graph.stage(*e) <= Stage::Parameter));
    let scaled =
        |id: &Id| classes[*id].nodes.iter().any(|n| matches!(n, Term::Product(_, ids) if ids.iter().any(fixed)));
    let mut once = Vec::new();
    let own = match term {
        Term::Leaf(_) => 0,
        Term::Sum(constant, coefficients, ids) => {
            let live: Vec<_> = coefficients.iter().zip(ids.iter()).filter(|(_, id)| !fixed(id)).collect();
            let products = live.iter().filter(|(c, id)| !c.is_one() && !c.neg().is_one() && !scaled(id)).count();
            let constants = usize::from(!constant.is_zero() || live.len() < ids.len());
            products + (live.len() + constants).saturating_sub(1)
        }
        Term::Product(exponents, ids) => {
            let live: Vec<(i32, usize)> =
                exponents.iter().zip(ids.iter()).filter(|(_, id)| !fixed(id)).map(|(k, id)| (*k, place(id))).collect();
            let below = live.iter().filter(|(k, _)| *k < 0);
            once.extend(below.map(|(_, class)| (Once::Reciprocal(*class), DIVISION)));
            let factors = live.len() + usize::from(live.len() < ids.len());
            factors.saturating_sub(1) + live.iter().map(|(k, _)| squarings(k.unsigned_abs())).sum::<usize>()
        }
        Term::Function(Function::Sin | Function::Cos, ids) => {
            once.push((Once::Turn(place(&ids[0])), SINCOS));
            0
        }
        Term::Function(Function::Whole, _) => 0,
        Term::Function(Function::Sqrt, _) => ROOT,
        Term::Function(Function::Select | Function::Sign | Function::Abs, _) => 1,
        Term::Function(..) => OTHER,
    };
    Node { term: term.clone(), children: egg::Language::children(term).iter().map(place).collect(), own, once }
}
