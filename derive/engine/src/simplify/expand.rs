//! From expressions to polynomials: which subexpressions are atoms, and expansion over them.

use super::cost::runs;
use super::polynomial::{Atom, Monomial, Polynomial, Work};
use crate::symbolic::{Expr, Function, Graph, Node, Rational};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// What expansion opens.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Every sum.
    Full,
    /// Sums that run; sums of parameters inside products are atoms.
    Running,
    /// The outermost sum only.
    Outermost,
}

/// The table of atoms: symbols, functions, and sums that are divided by or not opened.
///
/// A base that may vanish has two atoms, itself and its reciprocal, which never cancel. A base that is known not to
/// vanish, or holds parameters only, has one, with exponents of either sign.
#[derive(Debug, Default)]
pub struct Atoms {
    bases: Vec<(Expr, bool)>,
    index: HashMap<(Expr, bool), Atom>,
    cancels: Vec<bool>,
    runs: Vec<bool>,
    divisors: BTreeSet<Atom>,
}

impl Atoms {
    /// The atom and its exponent for a power of a base.
    pub fn power(&mut self, graph: &Graph, base: Expr, exponent: i32) -> (Atom, i32) {
        let cancels = graph.is_nonzero(base) || !runs(graph, base);
        let reciprocal = exponent < 0 && !cancels;
        let next = self.bases.len() as Atom;
        let atom = *self.index.entry((base, reciprocal)).or_insert(next);
        if atom == next {
            self.bases.push((base, reciprocal));
            self.cancels.push(cancels);
            self.runs.push(runs(graph, base));
        }
        if exponent < 0 {
            self.divisors.insert(atom);
        }
        (atom, if reciprocal { -exponent } else { exponent })
    }

    /// The atom of a base.
    pub fn of(&mut self, graph: &Graph, base: Expr) -> Atom {
        self.power(graph, base, 1).0
    }

    /// The base as a factor, for an atom to a power.
    pub fn factor(&self, atom: Atom, exponent: i32) -> (Expr, i32) {
        let (base, reciprocal) = self.bases[atom as usize];
        (base, if reciprocal { -exponent } else { exponent })
    }

    /// The base of an atom that is no reciprocal.
    pub fn base(&self, atom: Atom) -> Option<Expr> {
        let (base, reciprocal) = self.bases[atom as usize];
        (!reciprocal).then_some(base)
    }

    /// Whether the atom is computed while the system runs.
    pub fn runs(&self, atom: Atom) -> bool {
        self.runs[atom as usize]
    }

    /// Whether powers of the atom of opposite signs cancel.
    pub fn cancels(&self, atom: Atom) -> bool {
        self.cancels[atom as usize]
    }

    /// All atoms in order.
    pub fn all(&self) -> impl Iterator<Item = Atom> + use<> {
        0..self.bases.len() as Atom
    }

    /// Tells the graph which parameter-only bases may have cancelled against their reciprocals: `prepare` checks them.
    pub fn record(&self, graph: &mut Graph) {
        for atom in &self.divisors {
            let base = self.bases[*atom as usize].0;
            if !self.runs(*atom) && !graph.is_nonzero(base) {
                graph.div(base, base);
            }
        }
    }
}

/// Expands an expression; `None` beyond the limits.
pub fn expand(graph: &Graph, e: Expr, depth: Depth, atoms: &mut Atoms, work: &mut Work) -> Option<Polynomial> {
    let mut needed = BTreeSet::from([e]);
    let mut stack = vec![e];
    while let Some(e) = stack.pop() {
        let mut open = |child: Expr| {
            if needed.insert(child) {
                stack.push(child);
            }
        };
        match graph.node(e) {
            Node::Sum { terms, .. } => terms.iter().for_each(|(_, t)| open(*t)),
            Node::Product(factors) => {
                factors.iter().filter(|(b, k)| *k > 0 && opens(graph, *b, depth)).for_each(|(b, _)| open(*b));
            }
            _ => {}
        }
    }
    work.hopeful(estimate(graph, &needed, depth))?;
    let mut values: BTreeMap<Expr, Polynomial> = BTreeMap::new();
    for e in needed {
        let value = match graph.node(e) {
            Node::Number(number) => Polynomial::number(number.clone()),
            Node::Sum { constant, terms } => {
                let mut total = Polynomial::number(constant.clone());
                for (coefficient, term) in terms {
                    total.add_scaled(&values[term], coefficient, work)?;
                }
                total
            }
            Node::Product(factors) => {
                let mut monomial = Monomial::default();
                let mut total: Option<Polynomial> = None;
                for (base, exponent) in factors {
                    if *exponent > 0 && opens(graph, *base, depth) {
                        let power = values[base].powi(*exponent, work)?;
                        total = Some(match total {
                            Some(total) => total.mul(&power, work)?,
                            None => power,
                        });
                    } else {
                        let (atom, exponent) = atoms.power(graph, *base, *exponent);
                        monomial = monomial.mul(&Monomial::power(atom, exponent));
                    }
                }
                match total {
                    Some(total) => total.shift(&monomial),
                    None => Polynomial::term(monomial, Rational::ONE),
                }
            }
            Node::Symbol(_) | Node::Function(..) => {
                Polynomial::term(Monomial::power(atoms.of(graph, e), 1), Rational::ONE)
            }
        };
        values.insert(e, value);
    }
    values.remove(&e)
}

/// How many products of terms the expansion would form if no two terms were alike.
fn estimate(graph: &Graph, needed: &BTreeSet<Expr>, depth: Depth) -> f64 {
    let mut terms: BTreeMap<Expr, f64> = BTreeMap::new();
    let mut products = 0.0;
    for e in needed {
        let mut count = 1.0;
        match graph.node(*e) {
            Node::Sum { constant, terms: summands } => {
                count = summands.iter().fold(f64::from(u8::from(!constant.is_zero())), |n, (_, t)| n + terms[t]);
                products += count;
            }
            Node::Product(factors) => {
                for (base, exponent) in factors.iter().filter(|(b, k)| *k > 0 && opens(graph, *b, depth)) {
                    // Terms of a power: as many as there are ways to choose the factors.
                    let n = terms[base];
                    count *= (1..=*exponent).fold(1.0, |ways, k| ways * (n - 1.0 + f64::from(k)) / f64::from(k));
                }
                products += count;
            }
            Node::Number(_) | Node::Symbol(_) | Node::Function(..) => {}
        }
        terms.insert(*e, count);
    }
    products
}

fn opens(graph: &Graph, base: Expr, depth: Depth) -> bool {
    match graph.node(base) {
        Node::Number(_) => true,
        Node::Sum { .. } => match depth {
            Depth::Full => true,
            Depth::Running => runs(graph, base),
            Depth::Outermost => false,
        },
        _ => false,
    }
}

/// An atom whose square is a polynomial of other atoms.
#[derive(Clone, Debug)]
pub struct Square {
    /// The atom.
    pub atom: Atom,
    /// What its square is.
    pub value: Polynomial,
}

impl Square {
    /// Whether a power of the atom above the first occurs.
    pub fn applies(&self, polynomial: &Polynomial) -> bool {
        polynomial.0.keys().any(|m| m.exponent(self.atom) >= 2)
    }
}

/// The polynomial with every power of the atom above the first replaced.
pub fn reduce(polynomial: &Polynomial, square: &Square, work: &mut Work) -> Option<Polynomial> {
    let mut out = Polynomial::default();
    for (monomial, coefficient) in &polynomial.0 {
        let exponent = monomial.exponent(square.atom);
        if exponent < 2 {
            out.push(monomial.clone(), coefficient.clone());
            continue;
        }
        let rest = monomial.mul(&Monomial::power(square.atom, exponent % 2 - exponent));
        let power = square.value.powi(exponent / 2, work)?;
        out.add_scaled(&power.shift(&rest), coefficient, work)?;
    }
    Some(out)
}

/// An angle with the atoms of its sine and cosine.
#[derive(Copy, Clone, Debug)]
pub struct Angle {
    /// The atom of the sine.
    pub sin: Atom,
    /// The atom of the cosine.
    pub cos: Atom,
}

impl Angle {
    /// sin² = 1 - cos².
    pub fn sin_square(&self) -> Square {
        Square { atom: self.sin, value: one_minus_square(self.cos) }
    }

    /// cos² = 1 - sin².
    pub fn cos_square(&self) -> Square {
        Square { atom: self.cos, value: one_minus_square(self.sin) }
    }
}

fn one_minus_square(atom: Atom) -> Polynomial {
    let mut value = Polynomial::number(Rational::ONE);
    value.push(Monomial::power(atom, 2), Rational::MINUS_ONE);
    value
}

/// The squares of each unit quaternion among the atoms, by what the others leave of one.
pub fn spheres(graph: &Graph, atoms: &mut Atoms) -> Vec<Vec<Square>> {
    let mut found = Vec::new();
    for four in graph.spheres() {
        let bases = four.map(|symbol| graph.var(symbol));
        if !atoms.all().any(|atom| atoms.base(atom).is_some_and(|base| bases.contains(&base))) {
            continue;
        }
        let four = bases.map(|base| atoms.of(graph, base));
        let square = |atom: Atom| {
            let mut value = Polynomial::number(Rational::ONE);
            for other in four.iter().filter(|other| **other != atom) {
                value.push(Monomial::power(*other, 2), Rational::MINUS_ONE);
            }
            Square { atom, value }
        };
        found.push(four.map(square).to_vec());
    }
    found
}

/// The angles among the atoms; a sine without its cosine gets it, and the reverse.
pub fn angles(graph: &mut Graph, atoms: &mut Atoms) -> Vec<Angle> {
    let mut arguments: Vec<Expr> = Vec::new();
    for atom in atoms.all() {
        if let Some(base) = atoms.base(atom)
            && let Node::Function(Function::Sin | Function::Cos, argument) = graph.node(base)
            && !arguments.contains(&argument[0])
        {
            arguments.push(argument[0]);
        }
    }
    arguments
        .into_iter()
        .map(|argument| {
            let (sin, cos) = (graph.sin(argument), graph.cos(argument));
            Angle { sin: atoms.of(graph, sin), cos: atoms.of(graph, cos) }
        })
        .collect()
}
