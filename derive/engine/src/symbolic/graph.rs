//! The arena: interning, names, stages and reachability.

use super::identity::Points;
use super::samples::Samples;
use super::tables::{Interned, Set};
use super::{Expr, Function, Given, Kind, Node, Rational, Stage, Symbol};
use std::cell::RefCell;
use std::collections::BTreeSet;

/// A hash-consed arena of expressions. Equal canonical forms have equal [`Expr`]s.
#[derive(Clone, Debug)]
pub struct Graph {
    pub(super) nodes: Vec<Node>,
    stages: Vec<Stage>,
    /// For look-up only: its order is never read.
    interned: Interned,
    symbols: Vec<(String, Kind, Expr)>,
    pub(super) nonzero: Set,
    /// What contains a function whose sign is a choice: a root, a magnitude, a sign.
    pub(super) branches: Set,
    pub(super) cancelled: BTreeSet<Expr>,
    pub(super) points: RefCell<Points>,
    pub(super) samples: RefCell<Samples>,
    pub(super) given: Vec<Given>,
    /// Symbols whose squares add up to one, by fours.
    pub(super) spheres: Vec<[Symbol; 4]>,
    /// What was rewritten to something else.
    pub(super) broken: Option<(Expr, Expr)>,
    pi: Symbol,
}

impl Default for Graph {
    fn default() -> Self {
        Self::new()
    }
}

impl Graph {
    /// An arena that holds zero, one and π.
    pub fn new() -> Self {
        let mut graph = Graph {
            nodes: Vec::new(),
            stages: Vec::new(),
            interned: Interned::default(),
            symbols: Vec::new(),
            nonzero: Set::default(),
            branches: Set::default(),
            cancelled: BTreeSet::new(),
            points: RefCell::default(),
            samples: RefCell::default(),
            given: Vec::new(),
            spheres: Vec::new(),
            broken: None,
            pi: Symbol(0),
        };
        graph.intern(Node::Number(Rational::ZERO));
        graph.intern(Node::Number(Rational::ONE));
        graph.pi = graph.symbol("PI", Kind::Constant);
        graph
    }

    /// A new symbol. Names are for people: two symbols of one name are two symbols.
    pub fn symbol(&mut self, name: &str, kind: Kind) -> Symbol {
        let symbol = Symbol(self.symbols.len() as u32);
        let expr = Expr(self.nodes.len() as u32);
        self.symbols.push((name.to_owned(), kind, expr));
        self.intern(Node::Symbol(symbol));
        symbol
    }

    /// The squares of four new symbols add up to one: identity is decided where they do. Of what is identical there, the
    /// derivatives along all directions that keep the sum are identical too, and those across it are not.
    pub fn on_sphere(&mut self, symbols: [Symbol; 4]) {
        self.spheres.push(symbols);
        self.points = RefCell::default();
        self.samples = RefCell::default();
    }

    /// The symbols whose squares add up to one, by fours.
    pub fn spheres(&self) -> Vec<[Symbol; 4]> {
        self.spheres.clone()
    }

    /// The sphere on which a symbol lies, and its place there.
    pub(super) fn sphere_of(&self, symbol: Symbol) -> Option<(&[Symbol; 4], usize)> {
        self.spheres.iter().find_map(|four| Some((four, four.iter().position(|other| *other == symbol)?)))
    }

    /// The symbol's name.
    pub fn name(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.index()].0
    }

    /// What the symbol stands for.
    pub fn kind(&self, symbol: Symbol) -> Kind {
        self.symbols[symbol.index()].1
    }

    /// All symbols, π first, then in the order of declaration.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> + use<> {
        (0..self.symbols.len() as u32).map(Symbol)
    }

    /// The symbol as an expression.
    pub fn var(&self, symbol: Symbol) -> Expr {
        self.symbols[symbol.index()].2
    }

    /// The symbols as expressions.
    pub fn vars(&self, symbols: &[Symbol]) -> Vec<Expr> {
        symbols.iter().map(|s| self.var(*s)).collect()
    }

    /// The number π.
    pub fn pi(&self) -> Expr {
        self.var(self.pi)
    }

    /// The symbol of π.
    pub fn pi_symbol(&self) -> Symbol {
        self.pi
    }

    /// Zero.
    pub fn zero(&self) -> Expr {
        Expr(0)
    }

    /// One.
    pub fn one(&self) -> Expr {
        Expr(1)
    }

    /// The node behind an expression.
    pub fn node(&self, e: Expr) -> &Node {
        &self.nodes[e.index()]
    }

    /// How many expressions the arena holds.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Never: an arena always holds zero and one.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The number that the expression is, structurally.
    pub fn as_number(&self, e: Expr) -> Option<&Rational> {
        match self.node(e) {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    /// The symbol that the expression is, structurally.
    pub fn as_symbol(&self, e: Expr) -> Option<Symbol> {
        match self.node(e) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }

    /// Whether the canonical form is zero. [`Graph::vanishes`] decides identity with zero.
    pub fn is_zero(&self, e: Expr) -> bool {
        e == self.zero()
    }

    /// Whether the canonical form is one.
    pub fn is_one(&self, e: Expr) -> bool {
        e == self.one()
    }

    /// The stage of the most changeable symbol in the expression.
    pub fn stage(&self, e: Expr) -> Stage {
        self.stages[e.index()]
    }

    /// Whether the expression is known not to vanish, see [`Graph::assume_nonzero`].
    pub fn is_nonzero(&self, e: Expr) -> bool {
        match self.node(e) {
            Node::Number(number) => !number.is_zero(),
            _ => self.nonzero.contains(e),
        }
    }

    /// Parameter-only bases that were cancelled against their reciprocals: `prepare` must check that they are not zero.
    pub fn cancelled(&self) -> impl Iterator<Item = Expr> + '_ {
        self.cancelled.iter().copied()
    }

    /// The expression of a canonical node.
    pub(super) fn intern(&mut self, node: Node) -> Expr {
        let hash = node.hash();
        if let Some(position) = self.interned.find(&self.nodes, &node, hash) {
            return Expr(position);
        }
        let mut stage = Stage::Constant;
        let mut branches = matches!(node, Node::Function(Function::Sqrt | Function::Abs | Function::Sign, _));
        match &node {
            Node::Symbol(symbol) => stage = self.kind(*symbol).stage(),
            other => other.for_children(|child| {
                if self.stage(child) > stage {
                    stage = self.stage(child);
                }
                branches |= self.branches.contains(child);
            }),
        }
        let expr = Expr(u32::try_from(self.nodes.len()).expect("fewer than 2^32 expressions"));
        self.nodes.push(node);
        self.stages.push(stage);
        self.interned.push(hash);
        if branches {
            self.branches.insert(expr);
        }
        expr
    }

    /// All expressions that the roots contain, roots included, children before parents.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        let mut set = Set::of(roots);
        set.close_under(&self.nodes, |_| true);
        set.to_vec()
    }

    /// What of the roots' contents changes more often than a stage, children before parents.
    pub fn reachable_beyond(&self, roots: &[Expr], stage: Stage) -> Vec<Expr> {
        let mut set = Set::of(roots);
        let stages = self.stages.as_slice();
        set.close_under(&self.nodes, |at| stages[at] > stage);
        let mut found = set.to_vec();
        found.retain(|e| stages[e.index()] > stage);
        found
    }

    /// The symbols in the expressions, in the order of declaration.
    pub fn symbols_of(&self, roots: &[Expr]) -> Vec<Symbol> {
        let mut symbols: Vec<Symbol> = self.reachable(roots).into_iter().filter_map(|e| self.as_symbol(e)).collect();
        symbols.sort();
        symbols
    }

    /// Whether the expression contains one of the symbols.
    pub fn contains(&self, e: Expr, symbols: &[Symbol]) -> bool {
        self.symbols_of(&[e]).iter().any(|s| symbols.contains(s))
    }
}
