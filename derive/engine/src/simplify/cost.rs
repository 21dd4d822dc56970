//! What expressions cost once they run.
//!
//! Shared nodes count once. Work on parameters alone moves to `prepare` and is free, so the parameter-only factors of
//! a product are together one factor and the parameter-only terms of a sum together one term. Signs are free.
//! Sine and cosine of the sum or difference of two other angles, or of twice another, follow from those by products.
//! A numeric coefficient joins a parameter-only factor of its term where no other expression shares that term.

use crate::symbolic::tables::{Set, Table};
use crate::symbolic::{Expr, Function, Graph, Node, Rational, Stage};
use std::collections::{BTreeMap, BTreeSet};

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
    /// Selections, signs and absolute values.
    pub selections: usize,
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
            + self.selections
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
    let mut angles = Set::default();
    let derived = derived_angles(graph, &nodes);
    let mut powers = BTreeSet::new();
    // Bases of reciprocals: how many products divide by the base, and whether the first could divide outright.
    let mut divisors: BTreeMap<(Expr, u32), (usize, bool)> = BTreeMap::new();
    for e in &nodes {
        if derived.get(e) == Some(&uses.count(*e)) {
            // The angle itself is not needed.
            continue;
        }
        match graph.node(*e) {
            Node::Number(_) | Node::Symbol(_) => {}
            Node::Sum { constant, terms } => {
                let live = terms.iter().filter(|(_, t)| runs(graph, *t));
                let mut count = 0;
                for (coefficient, term) in live {
                    count += 1;
                    let unit = coefficient.is_one() || coefficient.neg().is_one();
                    let joins = uses.count(*term) == 1 && has_parameter_factor(graph, *term);
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
                Function::Sin | Function::Cos if derived.contains_key(&arguments[0]) => {
                    cost.multiplications += 2;
                    cost.additions += 1;
                }
                Function::Sin | Function::Cos => {
                    cost.sincos += usize::from(angles.insert(arguments[0]));
                }
                Function::Whole => {}
                Function::Sqrt => cost.roots += 1,
                Function::Select | Function::Sign | Function::Abs => cost.selections += 1,
                _ => cost.others += 1,
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

/// Among more angles than this no sums are looked for.
const MOST_ANGLES: usize = 24;

/// The angles that are twice another one or the sum or difference of two others, simpler ones first, with how many of
/// sine and cosine are used.
fn derived_angles(graph: &Graph, nodes: &[Expr]) -> BTreeMap<Expr, usize> {
    let mut angles: BTreeMap<Expr, usize> = BTreeMap::new();
    for e in nodes {
        if let Node::Function(Function::Sin | Function::Cos, arguments) = graph.node(*e)
            && runs(graph, arguments[0])
        {
            *angles.entry(arguments[0]).or_default() += 1;
        }
    }
    let mut derived = BTreeMap::new();
    if angles.len() < 2 || angles.len() > MOST_ANGLES {
        return derived;
    }
    let mut forms: Vec<(AngleForm, Expr, usize)> =
        angles.into_iter().map(|(e, uses)| (AngleForm::of(graph, e), e, uses)).collect();
    forms.sort_by_cached_key(|(form, e, _)| (form.size(), *e));
    for (i, (angle, e, uses)) in forms.iter().enumerate() {
        let before = || forms[..i].iter().map(|(form, ..)| form);
        let follows = |a: &AngleForm| {
            let rest = angle.minus(a);
            before().any(|b| b.is_plus_or_minus(&rest))
        };
        if before().any(follows) {
            derived.insert(*e, *uses);
        }
    }
    derived
}

/// An angle as a sum: coefficients by term in ascending order, the constant as that of one.
struct AngleForm(Vec<(Expr, Rational)>);

impl AngleForm {
    fn of(graph: &Graph, e: Expr) -> Self {
        let (constant, terms) = graph.as_sum(e);
        let constant = (!constant.is_zero()).then(|| (graph.one(), constant));
        let mut terms: Vec<(Expr, Rational)> = terms.into_iter().map(|(c, t)| (t, c)).chain(constant).collect();
        terms.sort_unstable_by_key(|(term, _)| *term);
        AngleForm(terms)
    }

    /// Terms, and their coefficients' magnitudes together.
    fn size(&self) -> (usize, Rational) {
        let magnitude = |c: &Rational| if c.is_negative() { c.neg() } else { c.clone() };
        (self.0.len(), self.0.iter().fold(Rational::ZERO, |sum, (_, c)| sum.add(&magnitude(c))))
    }

    fn minus(&self, other: &AngleForm) -> AngleForm {
        let mut terms = Vec::with_capacity(self.0.len() + other.0.len());
        let (mut i, mut j) = (0, 0);
        while i < self.0.len() || j < other.0.len() {
            let first = i < self.0.len() && (j == other.0.len() || self.0[i].0 <= other.0[j].0);
            let second = j < other.0.len() && (i == self.0.len() || other.0[j].0 <= self.0[i].0);
            let term = if first { self.0[i].0 } else { other.0[j].0 };
            let coefficient = match (first, second) {
                (true, true) => self.0[i].1.add(&other.0[j].1.neg()),
                (true, false) => self.0[i].1.clone(),
                _ => other.0[j].1.neg(),
            };
            (i, j) = (i + usize::from(first), j + usize::from(second));
            if !coefficient.is_zero() {
                terms.push((term, coefficient));
            }
        }
        AngleForm(terms)
    }

    /// Whether the other is this angle or its opposite.
    fn is_plus_or_minus(&self, other: &AngleForm) -> bool {
        let (own, other) = (self.0.as_slice(), other.0.as_slice());
        if own.len() != other.len() || own.first().map(|(term, _)| *term) != other.first().map(|(term, _)| *term) {
            return false;
        }
        let pairs = || own.iter().zip(other);
        let same = pairs().all(|((a, c), (b, d))| a == b && c == d);
        same || pairs().all(|((a, c), (b, d))| a == b && *c == d.neg())
    }
}

/// All work, parameters' included, roughly: the size of the expressions as shared trees. Only for ties in [`cost`].
pub(super) fn total(graph: &Graph, roots: &[Expr]) -> usize {
    let mut size = 0;
    for e in graph.reachable(roots) {
        size += match graph.node(e) {
            Node::Number(_) | Node::Symbol(_) => 0,
            Node::Sum { constant, terms } => {
                terms.len() + usize::from(!constant.is_zero()) + terms.iter().filter(|t| !t.0.is_one()).count()
            }
            Node::Product(factors) => factors.iter().map(|(_, k)| k.unsigned_abs() as usize).sum(),
            Node::Function(..) => 4,
        };
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
pub(super) fn running(graph: &Graph, roots: &[Expr]) -> Vec<Expr> {
    graph.reachable_beyond(roots, Stage::Parameter)
}

fn uses(graph: &Graph, roots: &[Expr], nodes: &[Expr]) -> Table {
    let length = roots.iter().max().map_or(0, |e| e.index() + 1);
    let mut uses = Table::new(length);
    for root in roots {
        uses.add(*root);
    }
    for e in nodes {
        graph.node(*e).for_children(|child| uses.add(child));
    }
    uses
}
