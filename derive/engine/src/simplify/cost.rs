//! What expressions cost once they run.
//!
//! Shared nodes count once. Work on parameters alone moves to `prepare` and is free, so the parameter-only factors of
//! a product are together one factor and the parameter-only terms of a sum together one term. Signs are free.
//! A numeric coefficient joins a parameter-only factor of its term where no other expression shares that term.

use crate::symbolic::{Expr, Function, Graph, Node, Stage};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Operations of straight-line code at run time.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions; a reciprocal that serves several quotients is one.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
    /// Sine and cosine of one angle, together.
    pub sincos: usize,
    /// Other elementary functions.
    pub others: usize,
}

impl Cost {
    /// Additions, multiplications and divisions.
    pub fn operations(&self) -> usize {
        self.additions + self.multiplications + self.divisions
    }

    /// One number to compare by: each operation by its rough time in additions.
    pub fn weight(&self) -> usize {
        self.additions
            + self.multiplications
            + DIVISION * self.divisions
            + ROOT * self.roots
            + SINCOS * self.sincos
            + OTHER * self.others
    }
}

/// A division in additions.
pub(super) const DIVISION: usize = 4;
/// A root in additions.
pub(super) const ROOT: usize = 5;
/// A sine with its cosine in additions.
pub(super) const SINCOS: usize = 15;
/// Another function in additions.
pub(super) const OTHER: usize = 20;

/// Multiplications of the n-th power by repeated squaring.
pub(super) fn squarings(n: u32) -> usize {
    if n == 0 { 0 } else { (n.ilog2() + n.count_ones() - 1) as usize }
}

/// The cost of the roots together.
pub fn cost(graph: &Graph, roots: &[Expr]) -> Cost {
    let nodes = running(graph, roots);
    let uses = uses(graph, roots, &nodes);
    let mut cost = Cost::default();
    let mut angles = HashSet::new();
    let mut powers = HashSet::new();
    // Bases of reciprocals: how many products divide by the base, and whether the first could divide outright.
    let mut divisors: BTreeMap<(Expr, u32), (usize, bool)> = BTreeMap::new();
    for e in &nodes {
        match graph.node(*e) {
            Node::Number(_) | Node::Symbol(_) => {}
            Node::Sum { constant, terms } => {
                let live = terms.iter().filter(|(_, t)| runs(graph, *t));
                let mut count = 0;
                for (coefficient, term) in live {
                    count += 1;
                    let unit = coefficient.is_one() || coefficient.neg().is_one();
                    let joins = uses[term] == 1 && has_parameter_factor(graph, *term);
                    cost.multiplications += usize::from(!unit && !joins);
                }
                let fixed = !constant.is_zero() || count < terms.len();
                cost.additions += count + usize::from(fixed) - 1;
            }
            Node::Product(factors) => {
                let mut count = usize::from(factors.iter().any(|(b, _)| !runs(graph, *b)));
                for (base, exponent) in factors.iter().filter(|(b, _)| runs(graph, *b)) {
                    let n = exponent.unsigned_abs();
                    if n > 1 && powers.insert((*base, n)) {
                        cost.multiplications += squarings(n);
                    }
                    if *exponent > 0 {
                        count += 1;
                    }
                }
                for (base, exponent) in factors.iter().filter(|(b, k)| *k < 0 && runs(graph, *b)) {
                    let outright = count > 0;
                    count += usize::from(!outright);
                    let entry = divisors.entry((*base, exponent.unsigned_abs())).or_insert((0, outright));
                    entry.0 += 1;
                    if outright {
                        // Counted as the division itself where it stays the only one.
                        cost.multiplications += 1;
                    }
                }
                cost.multiplications += count.saturating_sub(1);
            }
            Node::Function(function, arguments) => match function {
                Function::Sin | Function::Cos => {
                    cost.sincos += usize::from(angles.insert(arguments[0]));
                }
                Function::Sqrt => cost.roots += 1,
                Function::Atan2 | Function::Exp | Function::Ln => cost.others += 1,
            },
        }
    }
    let mut bases: BTreeMap<Expr, (usize, bool)> = BTreeMap::new();
    for ((base, _), (count, outright)) in divisors {
        let entry = bases.entry(base).or_insert((0, outright));
        entry.0 += count;
    }
    for (count, outright) in bases.into_values() {
        cost.divisions += 1;
        if count == 1 && outright {
            cost.multiplications -= 1;
        }
    }
    cost
}

/// All work, parameters' included, roughly: the size of the expressions as shared trees. Only for ties in [`cost`].
pub(super) fn total(graph: &Graph, roots: &[Expr]) -> usize {
    let mut seen: HashSet<Expr> = HashSet::new();
    let mut stack: Vec<Expr> = roots.to_vec();
    let mut size = 0;
    while let Some(e) = stack.pop() {
        if seen.insert(e) {
            size += match graph.node(e) {
                Node::Number(_) | Node::Symbol(_) => 0,
                Node::Sum { constant, terms } => {
                    terms.len() + usize::from(!constant.is_zero()) + terms.iter().filter(|t| !t.0.is_one()).count()
                }
                Node::Product(factors) => factors.iter().map(|(_, k)| k.unsigned_abs() as usize).sum(),
                Node::Function(..) => 4,
            };
            for_children(graph, e, |child| stack.push(child));
        }
    }
    size
}

/// Whether the expression is computed while the system runs.
pub(super) fn runs(graph: &Graph, e: Expr) -> bool {
    graph.stage(e) > Stage::Parameter
}

fn has_parameter_factor(graph: &Graph, e: Expr) -> bool {
    matches!(graph.node(e), Node::Product(factors) if factors.iter().any(|(b, _)| !runs(graph, *b)))
}

/// The expressions that run, each once, in a fixed order.
fn running(graph: &Graph, roots: &[Expr]) -> Vec<Expr> {
    let mut seen = HashSet::new();
    let mut order: Vec<Expr> = Vec::new();
    let mut stack: Vec<Expr> = roots.to_vec();
    while let Some(e) = stack.pop() {
        if runs(graph, e) && seen.insert(e) {
            order.push(e);
            for_children(graph, e, |child| stack.push(child));
        }
    }
    order.sort();
    order
}

fn uses(graph: &Graph, roots: &[Expr], nodes: &[Expr]) -> HashMap<Expr, usize> {
    let mut uses: HashMap<Expr, usize> = HashMap::with_capacity(nodes.len());
    for root in roots {
        *uses.entry(*root).or_default() += 1;
    }
    for e in nodes {
        for_children(graph, *e, |child| *uses.entry(child).or_default() += 1);
    }
    uses
}

/// Visits the children without collecting them.
pub(super) fn for_children(graph: &Graph, e: Expr, mut visit: impl FnMut(Expr)) {
    match graph.node(e) {
        Node::Number(_) | Node::Symbol(_) => {}
        Node::Sum { terms, .. } => terms.iter().for_each(|(_, t)| visit(*t)),
        Node::Product(factors) => factors.iter().for_each(|(b, _)| visit(*b)),
        Node::Function(_, arguments) => arguments.iter().for_each(|a| visit(*a)),
    }
}
