//! Rules over the e-graph: factoring, sin² + cos² = 1, double angles, opposite sums.
//!
//! Sums and products are n-ary and sorted, so there is no rule for associativity or commutativity. A rule reads each
//! term of a sum as a product in a few ways and adds what it finds to the sum's class. None cancels a base against
//! its reciprocal.

use super::language::{Classes, Term, product, sum, sum_node};
use super::limits::{GROUP_NODES, READINGS, ROUNDS};
use crate::symbolic::{Expr, Function, Graph, Rational};
use egg::Id;
use std::collections::{BTreeMap, BTreeSet};

type Factors = Vec<(Id, i32)>;

/// A term of a sum: its coefficient and the products it may be read as. The constant reads as the empty product.
struct Reading {
    coefficient: Rational,
    id: Option<Id>,
    products: Vec<Factors>,
}

/// Grows the e-graph by all rules until nothing changes or a limit is met; returns its nodes.
pub fn grow(graph: &mut Graph, classes: &mut Classes, known: &BTreeMap<Expr, Id>) -> usize {
    for _ in 0..ROUNDS {
        classes.rebuild();
        let before = (classes.total_size(), classes.number_of_classes());
        let mut snapshot: Vec<(Id, Vec<Term>)> = classes.classes().map(|c| (c.id, c.nodes.clone())).collect();
        snapshot.sort_by_key(|(id, _)| *id);
        let angles = angles(graph, classes, known);
        for (id, nodes) in snapshot {
            for node in nodes {
                if classes.total_size() > GROUP_NODES {
                    break;
                }
                if let Term::Sum(constant, coefficients, ids) = node {
                    let terms: Vec<_> = coefficients.iter().cloned().zip(ids.iter().copied()).collect();
                    opposite(classes, id, &constant, &terms);
                    let readings = readings(classes, &constant, &terms);
                    factor(graph, classes, id, &readings);
                    for angle in &angles {
                        pythagoras(graph, classes, id, &readings, angle);
                    }
                } else if let Term::Product(exponents, ids) = node {
                    let factors: Factors = ids.iter().copied().zip(exponents.iter().copied()).collect();
                    for angle in &angles {
                        half_sine(graph, classes, id, &factors, angle);
                    }
                }
            }
        }
        classes.rebuild();
        if (classes.total_size(), classes.number_of_classes()) == before || classes.total_size() > GROUP_NODES {
            break;
        }
    }
    classes.total_size()
}

/// The classes of an angle's sine and cosine, and of the sine and cosine of its double where they occur.
struct Turn {
    sin: Id,
    cos: Id,
    twice: Option<(Id, Id)>,
}

fn angles(graph: &mut Graph, classes: &mut Classes, known: &BTreeMap<Expr, Id>) -> Vec<Turn> {
    use crate::symbolic::Node;
    let mut arguments: BTreeSet<Expr> = BTreeSet::new();
    for e in known.keys() {
        if let Node::Function(Function::Sin | Function::Cos, argument) = graph.node(*e) {
            arguments.insert(argument[0]);
        }
    }
    let pair = |classes: &mut Classes, argument: Expr| {
        let id = *known.get(&argument)?;
        Some((
            classes.add(Term::Function(Function::Sin, Box::new([id]))),
            classes.add(Term::Function(Function::Cos, Box::new([id]))),
        ))
    };
    let mut turns = Vec::new();
    for argument in &arguments {
        let Some((sin, cos)) = pair(classes, *argument) else { continue };
        let double = graph.scale(Rational::integer(2), *argument);
        let twice = arguments.contains(&double).then(|| pair(classes, double)).flatten();
        if let Some((sin2, cos2)) = twice {
            // sin 2a = 2 sin a cos a, cos 2a = 1 - 2 sin² a: one sine and cosine less.
            if let (Some(both), Some(square)) = (product(classes, &[(sin, 1), (cos, 1)]), product(classes, &[(sin, 2)]))
            {
                let sine = sum(graph, classes, Rational::ZERO, &[(Rational::integer(2), both)]);
                let cosine = sum(graph, classes, Rational::ONE, &[(Rational::integer(-2), square)]);
                classes.union(sin2, sine);
                classes.union(cos2, cosine);
            }
        }
        turns.push(Turn { sin, cos, twice });
    }
    turns
}

fn readings(classes: &Classes, constant: &Rational, terms: &[(Rational, Id)]) -> Vec<Reading> {
    let mut out: Vec<Reading> = terms
        .iter()
        .map(|(coefficient, id)| {
            let mut products: Vec<Factors> = vec![vec![(classes.find(*id), 1)]];
            for node in &classes[*id].nodes {
                if let Term::Product(exponents, ids) = node
                    && products.len() < READINGS
                {
                    products.push(ids.iter().map(|id| classes.find(*id)).zip(exponents.iter().copied()).collect());
                }
            }
            Reading { coefficient: coefficient.clone(), id: Some(*id), products }
        })
        .collect();
    if !constant.is_zero() {
        out.push(Reading { coefficient: constant.clone(), id: None, products: vec![Vec::new()] });
    }
    out
}

/// The sum of the readings but those at two places, and of one more term.
fn replace(
    graph: &mut Graph,
    classes: &mut Classes,
    readings: &[Reading],
    without: &[usize],
    new: (Rational, &[(Id, i32)]),
) -> Id {
    let mut constant = Rational::ZERO;
    let mut terms = Vec::with_capacity(readings.len());
    for (_, reading) in readings.iter().enumerate().filter(|(i, _)| !without.contains(i)) {
        match reading.id {
            Some(id) => terms.push((reading.coefficient.clone(), id)),
            None => constant = constant.add(&reading.coefficient),
        }
    }
    match product(classes, new.1) {
        Some(id) => terms.push((new.0, id)),
        None => constant = constant.add(&new.0),
    }
    sum(graph, classes, constant, &terms)
}

/// a·b + a·c = a·(b + c), for every factor that two terms share.
fn factor(graph: &mut Graph, classes: &mut Classes, id: Id, readings: &[Reading]) {
    let mut shared: BTreeMap<(Id, bool), Vec<(usize, usize)>> = BTreeMap::new();
    for (i, reading) in readings.iter().enumerate() {
        for (j, product) in reading.products.iter().enumerate() {
            for (base, exponent) in product {
                let users = shared.entry((*base, *exponent < 0)).or_default();
                if users.last().is_none_or(|(last, _)| *last != i) {
                    users.push((i, j));
                }
            }
        }
    }
    for ((base, below), users) in shared {
        if users.len() < 2 {
            continue;
        }
        let step = if below { -1 } else { 1 };
        let mut constant = Rational::ZERO;
        let mut inner = Vec::with_capacity(users.len());
        for (i, j) in &users {
            let rest: Factors = readings[*i].products[*j]
                .iter()
                .map(|(b, k)| if *b == base && (*k < 0) == below { (*b, k - step) } else { (*b, *k) })
                .collect();
            match product(classes, &rest) {
                Some(rest) => inner.push((readings[*i].coefficient.clone(), rest)),
                None => constant = constant.add(&readings[*i].coefficient),
            }
        }
        let inner = sum(graph, classes, constant, &inner);
        let without: Vec<usize> = users.iter().map(|(i, _)| *i).collect();
        let new = replace(graph, classes, readings, &without, (Rational::ONE, &[(base, step), (inner, 1)]));
        classes.union(id, new);
    }
}

/// r·sin² + r·cos² = r, r - r·sin² = r·cos², r - r·cos² = r·sin², r·cos² - r·sin² = r·cos 2a where that occurs.
fn pythagoras(graph: &mut Graph, classes: &mut Classes, id: Id, readings: &[Reading], angle: &Turn) {
    let rests = |base: Id| {
        let mut out: Vec<(usize, Factors)> = Vec::new();
        for (i, reading) in readings.iter().enumerate() {
            for product in &reading.products {
                if product.iter().any(|(b, k)| *b == base && *k >= 2) {
                    out.push((i, lowered(product, base)));
                }
            }
        }
        out
    };
    let (sines, cosines) = (rests(classes.find(angle.sin)), rests(classes.find(angle.cos)));
    let mut found: Vec<([usize; 2], Rational, Factors)> = Vec::new();
    for (i, rest) in &sines {
        for (j, _) in cosines.iter().filter(|(j, other)| i != j && other == rest) {
            let (a, b) = (&readings[*i].coefficient, &readings[*j].coefficient);
            if a == b {
                found.push(([*i, *j], a.clone(), rest.clone()));
            } else if a.neg() == *b
                && let Some((_, cosine)) = angle.twice
            {
                found.push(([*i, *j], b.clone(), with(rest, cosine, 1)));
            }
        }
    }
    for (squares, other) in [(&sines, angle.cos), (&cosines, angle.sin)] {
        for (i, rest) in squares {
            for (j, reading) in readings.iter().enumerate().filter(|(j, _)| j != i) {
                let opposite = readings[*i].coefficient.neg() == reading.coefficient;
                if opposite && reading.products.iter().any(|p| sorted(p.clone()) == *rest) {
                    found.push(([*i, j], reading.coefficient.clone(), with(rest, other, 2)));
                }
            }
        }
    }
    for (places, coefficient, factors) in found {
        let new = replace(graph, classes, readings, &places, (coefficient, &factors));
        classes.union(id, new);
    }
}

/// sin a·cos a = sin(2a)/2, where sin 2a occurs.
fn half_sine(graph: &mut Graph, classes: &mut Classes, id: Id, factors: &Factors, angle: &Turn) {
    let Some((sine, _)) = angle.twice else { return };
    let (sin, cos) = (classes.find(angle.sin), classes.find(angle.cos));
    let positive = |base: Id| factors.iter().any(|(b, k)| *b == base && *k > 0);
    if !(positive(sin) && positive(cos)) {
        return;
    }
    let lower = |(b, k): (Id, i32)| if (b == sin || b == cos) && k > 0 { (b, k - 1) } else { (b, k) };
    let mut rest: Factors = factors.iter().copied().map(lower).collect();
    rest.push((sine, 1));
    if let (Some(rest), Some(half)) = (product(classes, &rest), Rational::fraction(1, 2)) {
        let new = sum(graph, classes, Rational::ZERO, &[(half, rest)]);
        classes.union(id, new);
    }
}

/// b - a is -(a - b) where a - b occurs.
fn opposite(classes: &mut Classes, id: Id, constant: &Rational, terms: &[(Rational, Id)]) {
    if terms.len() + usize::from(!constant.is_zero()) < 2 {
        return;
    }
    let negated: Vec<_> = terms.iter().map(|(c, id)| (c.neg(), *id)).collect();
    if let Some(Ok(node)) = sum_node(classes, constant.neg(), &negated)
        && let Some(other) = classes.lookup(node)
    {
        let minus = classes.add(Term::Sum(Rational::ZERO, Box::new([Rational::MINUS_ONE]), Box::new([other])));
        classes.union(id, minus);
    }
}

fn sorted(mut factors: Factors) -> Factors {
    factors.retain(|f| f.1 != 0);
    factors.sort();
    factors
}

fn lowered(product: &Factors, base: Id) -> Factors {
    sorted(product.iter().map(|(b, k)| if *b == base && *k >= 2 { (*b, k - 2) } else { (*b, *k) }).collect())
}

fn with(factors: &Factors, base: Id, exponent: i32) -> Factors {
    let mut factors = factors.clone();
    factors.push((base, exponent));
    factors
}
