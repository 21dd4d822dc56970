//! The e-graph's language: our own nodes, n-ary and sorted, parameter-only expressions as leaves.

use super::cost::runs;
use crate::symbolic::{Expr, Function, Graph, Node, Rational};
use egg::{EGraph, Id, Language};
use std::collections::{BTreeMap, BTreeSet};

/// An e-node. Leaves are expressions of the arena, not interned strings, so nothing depends on the process.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Term {
    /// A number, a symbol, or an expression of parameters only.
    Leaf(Expr),
    /// `constant + Σ coefficient·term`.
    Sum(Rational, Box<[Rational]>, Box<[Id]>),
    /// `Π base^exponent`.
    Product(Box<[i32]>, Box<[Id]>),
    /// A function of its arguments.
    Function(Function, Box<[Id]>),
}

impl Language for Term {
    type Discriminant = u8;

    fn discriminant(&self) -> u8 {
        match self {
            Term::Leaf(_) => 0,
            Term::Sum(..) => 1,
            Term::Product(..) => 2,
            Term::Function(..) => 3,
        }
    }

    fn matches(&self, other: &Self) -> bool {
        match (self, other) {
            (Term::Leaf(a), Term::Leaf(b)) => a == b,
            (Term::Sum(c, k, x), Term::Sum(d, l, y)) => c == d && k == l && x.len() == y.len(),
            (Term::Product(k, x), Term::Product(l, y)) => k == l && x.len() == y.len(),
            (Term::Function(f, x), Term::Function(g, y)) => f == g && x.len() == y.len(),
            _ => false,
        }
    }

    fn children(&self) -> &[Id] {
        match self {
            Term::Leaf(_) => &[],
            Term::Sum(_, _, ids) | Term::Product(_, ids) | Term::Function(_, ids) => ids,
        }
    }

    fn children_mut(&mut self) -> &mut [Id] {
        match self {
            Term::Leaf(_) => &mut [],
            Term::Sum(_, _, ids) | Term::Product(_, ids) | Term::Function(_, ids) => ids,
        }
    }
}

/// An e-graph of our terms.
pub type Classes = EGraph<Term, ()>;

/// The node of `constant + Σ coefficient·term`, sorted and collected; `None` where it is a number.
pub fn sum_node(classes: &Classes, constant: Rational, terms: &[(Rational, Id)]) -> Option<Result<Term, Id>> {
    let mut collected: BTreeMap<Id, Rational> = BTreeMap::new();
    for (coefficient, id) in terms {
        let entry = collected.entry(classes.find(*id)).or_insert(Rational::ZERO);
        *entry = entry.add(coefficient);
    }
    collected.retain(|_, c| !c.is_zero());
    match collected.first_key_value() {
        None => None,
        Some((id, c)) if collected.len() == 1 && c.is_one() && constant.is_zero() => Some(Err(*id)),
        Some(_) => {
            let (ids, coefficients): (Vec<Id>, Vec<Rational>) = collected.into_iter().unzip();
            Some(Ok(Term::Sum(constant, coefficients.into(), ids.into())))
        }
    }
}

/// The class of `constant + Σ coefficient·term`.
pub fn sum(graph: &mut Graph, classes: &mut Classes, constant: Rational, terms: &[(Rational, Id)]) -> Id {
    match sum_node(classes, constant.clone(), terms) {
        Some(Ok(node)) => classes.add(node),
        Some(Err(id)) => id,
        None => classes.add(Term::Leaf(graph.number(constant))),
    }
}

/// The class of `Π base^exponent`, sorted; exponents of opposite signs stay apart. `None` for the empty product.
pub fn product(classes: &mut Classes, factors: &[(Id, i32)]) -> Option<Id> {
    let mut collected: BTreeMap<(Id, bool), i32> = BTreeMap::new();
    for (id, exponent) in factors.iter().filter(|f| f.1 != 0) {
        let entry = collected.entry((classes.find(*id), *exponent < 0)).or_insert(0);
        *entry = entry.saturating_add(*exponent);
    }
    let (keys, exponents): (Vec<(Id, bool)>, Vec<i32>) = collected.into_iter().unzip();
    let ids: Vec<Id> = keys.into_iter().map(|(id, _)| id).collect();
    match (ids.as_slice(), exponents.as_slice()) {
        ([], _) => None,
        ([id], [1]) => Some(*id),
        _ => Some(classes.add(Term::Product(exponents.into(), ids.into()))),
    }
}

/// The classes of the expressions; what was added before is found in `known`.
pub fn import(graph: &mut Graph, classes: &mut Classes, known: &mut BTreeMap<Expr, Id>, roots: &[Expr]) -> Vec<Id> {
    let mut order: BTreeSet<Expr> = BTreeSet::new();
    let mut stack: Vec<Expr> = roots.to_vec();
    while let Some(e) = stack.pop() {
        if !known.contains_key(&e) && order.insert(e) && runs(graph, e) {
            stack.extend(graph.node(e).children());
        }
    }
    for e in order {
        let id = match graph.node(e).clone() {
            _ if !runs(graph, e) => classes.add(Term::Leaf(e)),
            Node::Number(_) | Node::Symbol(_) => classes.add(Term::Leaf(e)),
            Node::Sum { constant, terms } => {
                let terms: Vec<_> = terms.iter().map(|(c, t)| (c.clone(), known[t])).collect();
                sum(graph, classes, constant, &terms)
            }
            Node::Product(factors) => {
                // The factors of parameters are one leaf.
                let (running, fixed): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|(b, _)| runs(graph, *b));
                let mut ids: Vec<(Id, i32)> = running.iter().map(|(b, k)| (known[b], *k)).collect();
                if !fixed.is_empty() {
                    let fixed = graph.power_product(Rational::ONE, &fixed);
                    ids.push((classes.add(Term::Leaf(fixed)), 1));
                }
                product(classes, &ids).unwrap_or_else(|| classes.add(Term::Leaf(e)))
            }
            Node::Function(function, arguments) => {
                let ids: Vec<Id> = arguments.iter().map(|a| known[a]).collect();
                classes.add(Term::Function(function, ids.into()))
            }
        };
        known.insert(e, id);
    }
    roots.iter().map(|root| known[root]).collect()
}
