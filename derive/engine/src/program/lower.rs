//! From the graph to units: each expression becomes one term, a coefficient of parameters times factors that change.

use super::angles::Rests;
use super::operation::Leaf;
use super::unit::{Bag, Id, Unit, Units, merge};
use crate::symbolic::{Expr, Function, Graph, Node, Rational, Stage, Symbol};
use std::collections::HashMap;

/// `coefficient·Π factor^exponent`. The coefficient holds numbers and parameters only.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Term {
    /// The coefficient, an expression.
    pub coefficient: Expr,
    /// The factors.
    pub factors: Bag,
}

/// How expressions are lowered.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub struct Manner {
    /// Only numbers are coefficients (in `prepare`); otherwise all that holds parameters only is.
    pub numeric: bool,
    /// Factors that several terms of a sum have in common are taken out.
    pub factor: bool,
}

/// The state of a lowering.
pub struct Lowering<'a> {
    /// The expressions; coefficients are computed here.
    pub graph: &'a mut Graph,
    /// The units so far.
    pub units: Units,
    /// How.
    pub manner: Manner,
    /// Sums of angles that were looked at before.
    pub(super) rests: &'a mut Rests,
    /// Terms of the expressions done, by index.
    terms: Vec<Option<Term>>,
    /// Sine and cosine of each angle.
    pub(super) turns: HashMap<Expr, (Term, Term)>,
    /// The collected terms of sums, so that an outer coefficient can still be multiplied in.
    open: HashMap<Expr, Vec<Term>>,
}

impl<'a> Lowering<'a> {
    /// A lowering over the graph.
    pub fn new(graph: &'a mut Graph, rests: &'a mut Rests, manner: Manner) -> Self {
        Lowering {
            graph,
            rests,
            units: Units::default(),
            manner,
            terms: Vec::new(),
            turns: HashMap::new(),
            open: HashMap::new(),
        }
    }

    /// The results as units, or the symbol that the function may not read.
    pub fn lower(&mut self, roots: &[Expr], place: &dyn Fn(Symbol) -> Option<Leaf>) -> Result<Vec<Id>, Symbol> {
        let order = self.graph.reachable(roots);
        let mut uses: HashMap<Expr, u32> = HashMap::new();
        for e in roots {
            *uses.entry(*e).or_default() += 1;
        }
        for e in &order {
            if !self.is_coefficient(*e) {
                for child in self.graph.node(*e).children() {
                    *uses.entry(child).or_default() += 1;
                }
            }
        }
        let splits = self.splits(&order);
        self.terms = vec![None; self.graph.len()];
        for e in order {
            if self.is_coefficient(e) {
                continue;
            }
            let term = match self.graph.node(e).clone() {
                Node::Number(_) => self.constant(e),
                Node::Symbol(symbol) => {
                    let leaf = place(symbol).ok_or(symbol)?;
                    let stage = self.graph.kind(symbol).stage();
                    self.of_unit(Unit::Leaf(leaf), stage)
                }
                Node::Sum { constant, terms } => self.sum(e, &constant, &terms),
                Node::Product(factors) => self.product(&factors, &uses),
                Node::Function(Function::Sin, arguments) => self.turn(arguments[0], &splits).0,
                Node::Function(Function::Cos, arguments) => self.turn(arguments[0], &splits).1,
                Node::Function(Function::Whole, arguments) => self.closed(arguments[0]),
                Node::Function(function, arguments) => self.function(function, &arguments),
            };
            self.terms[e.index()] = Some(term);
        }
        Ok(roots.iter().map(|e| self.term(*e)).collect::<Vec<_>>().into_iter().map(|t| self.unit_of(&t)).collect())
    }

    pub(super) fn is_coefficient(&self, e: Expr) -> bool {
        if self.manner.numeric { self.graph.as_number(e).is_some() } else { self.graph.stage(e) <= Stage::Parameter }
    }

    fn constant(&self, e: Expr) -> Term {
        Term { coefficient: e, factors: Bag::new() }
    }

    pub(super) fn of_unit(&mut self, unit: Unit, stage: Stage) -> Term {
        let id = self.units.intern(unit, stage);
        Term { coefficient: self.graph.one(), factors: vec![(id, 1)] }
    }

    /// The term of an expression that was lowered before, or of a coefficient.
    pub(super) fn term(&self, e: Expr) -> Term {
        match self.terms.get(e.index()) {
            Some(Some(term)) => term.clone(),
            _ => {
                debug_assert!(self.is_coefficient(e), "operands are lowered first");
                self.constant(e)
            }
        }
    }

    fn sum(&mut self, e: Expr, constant: &Rational, terms: &[(Rational, Expr)]) -> Term {
        let mut items = Vec::with_capacity(terms.len() + 1);
        if !constant.is_zero() {
            let constant = self.graph.number(constant.clone());
            items.push(self.constant(constant));
        }
        for (factor, term) in terms {
            let mut item = self.term(*term);
            item.coefficient = self.graph.scale(factor.clone(), item.coefficient);
            items.push(item);
        }
        let items = self.merged(items);
        let term = self.collect(items.clone(), 0);
        self.open.insert(e, items);
        term
    }

    fn product(&mut self, factors: &[(Expr, i32)], uses: &HashMap<Expr, u32>) -> Term {
        let mut powers: Vec<(Expr, i32)> = Vec::new();
        let mut rest: Vec<(Expr, i32)> = Vec::new();
        for (base, exponent) in factors {
            if self.is_coefficient(*base) {
                powers.push((*base, *exponent));
            } else {
                rest.push((*base, *exponent));
                powers.push((self.term(*base).coefficient, *exponent));
            }
        }
        let mut coefficient = self.graph.power_product(Rational::ONE, &powers);
        let mut scaled: Option<(Expr, Term)> = None;
        if !self.is_unit(coefficient) {
            for (base, exponent) in &rest {
                // A sum that is used here alone and multiplies each of its terms anyway takes the coefficient in.
                if *exponent == 1 && uses.get(base) == Some(&1) && self.absorbs(*base) {
                    let own = self.term(*base).coefficient;
                    let outer = self.graph.div(coefficient, own);
                    let mut items = self.open[base].clone();
                    for item in &mut items {
                        item.coefficient = self.graph.mul(outer, item.coefficient);
                    }
                    let term = self.collect(items, 0);
                    coefficient = term.coefficient;
                    scaled = Some((*base, term));
                    break;
                }
            }
        }
        let mut bag = Bag::new();
        for (base, exponent) in rest {
            let term = match &scaled {
                Some((sum, term)) if *sum == base => term.clone(),
                _ => self.term(base),
            };
            let mut powers = term.factors;
            for (id, k) in &mut powers {
                *k = k.saturating_mul(exponent.saturating_abs());
                if exponent < 0 {
                    *id = self.reciprocal(*id);
                }
            }
            powers.sort_unstable();
            bag = merge(&bag, &powers);
        }
        Term { coefficient, factors: bag }
    }

    fn reciprocal(&mut self, id: Id) -> Id {
        match self.units.get(id) {
            Unit::Reciprocal(inner) => *inner,
            _ => self.units.intern(Unit::Reciprocal(id), Stage::Constant),
        }
    }

    /// Whether every term of the sum has a coefficient of its own, so that one more costs nothing.
    fn absorbs(&self, e: Expr) -> bool {
        let Some(items) = self.open.get(&e) else { return false };
        let single = self.term(e).factors;
        let whole = matches!(single.as_slice(), [(id, 1)] if matches!(self.units.get(*id), Unit::Sum(_)));
        whole
            && self.graph.is_one(self.term(e).coefficient)
            && items.iter().all(|item| item.factors.is_empty() || !self.is_unit(item.coefficient))
    }

    /// Whether the coefficient is 1 or -1.
    pub(super) fn is_unit(&self, coefficient: Expr) -> bool {
        self.graph.as_number(coefficient).is_some_and(|n| n.is_one() || n.neg().is_one())
    }

    fn function(&mut self, function: Function, arguments: &[Expr]) -> Term {
        let of: Vec<Id> =
            arguments.iter().map(|a| self.term(*a)).collect::<Vec<_>>().iter().map(|t| self.unit_of(t)).collect();
        let unit = match (function, of.as_slice()) {
            (Function::Sqrt, [a]) => Unit::Root(*a),
            (function, arguments) => Unit::Call(function, arguments.into()),
        };
        self.of_unit(unit, Stage::Constant)
    }

    /// The term of an expression as one unit with its coefficient, which nothing that follows takes apart.
    fn closed(&mut self, e: Expr) -> Term {
        let term = self.term(e);
        let (negative, magnitude) = self.magnitude(term.coefficient);
        let id = self.magnitude_unit(magnitude, &term.factors);
        let one = self.graph.one();
        Term { coefficient: if negative { self.graph.neg(one) } else { one }, factors: vec![(id, 1)] }
    }

    /// The term as one unit, its sign as a `Negative`.
    pub(super) fn unit_of(&mut self, term: &Term) -> Id {
        let (negative, magnitude) = self.magnitude(term.coefficient);
        let id = self.magnitude_unit(magnitude, &term.factors);
        if negative { self.units.intern(Unit::Negative(id), Stage::Constant) } else { id }
    }

    /// `magnitude·Π factors` as one unit.
    pub(super) fn magnitude_unit(&mut self, magnitude: Expr, factors: &Bag) -> Id {
        let mut bag = factors.clone();
        if bag.is_empty() || !self.graph.is_one(magnitude) {
            let coefficient = self.coefficient(magnitude);
            if bag.is_empty() {
                return coefficient;
            }
            bag = merge(&vec![(coefficient, 1)], &bag);
        }
        match bag.as_slice() {
            [(id, 1)] => *id,
            _ => self.units.intern(Unit::Product(bag), Stage::Constant),
        }
    }

    fn coefficient(&mut self, e: Expr) -> Id {
        let stage = self.graph.stage(e);
        self.units.intern(Unit::Coefficient(e), stage)
    }

    /// Sign and magnitude of a coefficient: its first number decides, so that a - b and b - a share.
    pub(super) fn magnitude(&mut self, coefficient: Expr) -> (bool, Expr) {
        let negative = match self.graph.node(coefficient) {
            Node::Number(n) => n.is_negative(),
            Node::Sum { terms, .. } => terms[0].0.is_negative(),
            _ => false,
        };
        if negative { (true, self.graph.neg(coefficient)) } else { (false, coefficient) }
    }
}
