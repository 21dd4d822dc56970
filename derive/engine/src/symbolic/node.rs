//! What an expression is.

use super::Rational;

/// An expression: an index into its [`Graph`](super::Graph). Children have smaller indices than their parents, so
/// a loop over indices is a sweep in topological order.
#[derive(Copy, Clone, Eq, PartialEq, Ord, PartialOrd, Hash, Debug)]
pub struct Expr(pub(super) u32);

impl Expr {
    /// The position in the arena.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A named variable of the model.
#[derive(Copy, Clone, Eq, PartialEq, Ord, PartialOrd, Hash, Debug)]
pub struct Symbol(pub(super) u32);

impl Symbol {
    /// The order of declaration.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a symbol stands for.
#[derive(Copy, Clone, Eq, PartialEq, Ord, PartialOrd, Hash, Debug)]
pub enum Kind {
    /// A number with a name: π.
    Constant,
    /// A field of the user's struct.
    Parameter,
    /// Time t.
    Time,
    /// A generalised coordinate, x or q.
    Coordinate,
    /// A generalised speed, v or u.
    Speed,
    /// An input.
    Input,
}

/// How often a quantity changes, by the most changeable symbol it contains.
#[derive(Copy, Clone, Eq, PartialEq, Ord, PartialOrd, Hash, Debug)]
pub enum Stage {
    /// A number.
    Constant,
    /// Parameters only: computed once, in `prepare`.
    Parameter,
    /// Time and parameters.
    Time,
    /// Coordinates: once per configuration.
    Coordinate,
    /// Speeds and inputs.
    Speed,
}

impl Kind {
    /// The stage of a symbol of this kind.
    pub fn stage(self) -> Stage {
        match self {
            Kind::Constant => Stage::Constant,
            Kind::Parameter => Stage::Parameter,
            Kind::Time => Stage::Time,
            Kind::Coordinate => Stage::Coordinate,
            Kind::Speed | Kind::Input => Stage::Speed,
        }
    }
}

/// An elementary function. `tan` is built from sine and cosine, `min` and `max` from a selection.
#[derive(Copy, Clone, Eq, PartialEq, Ord, PartialOrd, Hash, Debug)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Square root.
    Sqrt,
    /// Angle of (x, y) from the x axis; arguments y, x.
    Atan2,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Inverse sine, in [-π/2, π/2].
    Asin,
    /// Inverse cosine, in [0, π].
    Acos,
    /// Inverse tangent, in (-π/2, π/2).
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value.
    Abs,
    /// -1, 0 or 1.
    Sign,
    /// A real power; arguments base, exponent.
    Power,
    /// The second argument where the first is negative, else the third.
    Select,
    /// Its argument, a sum, computed once and never opened.
    Whole,
    /// A function of the user's, or one of its derivatives: a position in the graph's table.
    Given(u32),
}

impl Function {
    /// A number of its own, the same in every process.
    pub fn key(self) -> u64 {
        let given = if let Function::Given(at) = self { u64::from(at) } else { 0 };
        self.name().bytes().fold(given, |key, byte| super::modular::mix(key ^ u64::from(byte)))
    }

    /// Name as written in a model; [`Graph::function_name`](super::Graph::function_name) knows those of the user's.
    pub fn name(self) -> &'static str {
        match self {
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Sqrt => "sqrt",
            Function::Atan2 => "atan2",
            Function::Exp => "exp",
            Function::Ln => "ln",
            Function::Asin => "asin",
            Function::Acos => "acos",
            Function::Atan => "atan",
            Function::Sinh => "sinh",
            Function::Cosh => "cosh",
            Function::Tanh => "tanh",
            Function::Abs => "abs",
            Function::Sign => "sign",
            Function::Power => "powf",
            Function::Select => "select",
            Function::Whole => "whole",
            Function::Given(_) => "given",
        }
    }
}

/// One node of the arena, in canonical form.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// An exact number.
    Number(Rational),
    /// A variable.
    Symbol(Symbol),
    /// `constant + Σ coefficient·term`: terms ascending and distinct, coefficients non-zero.
    Sum {
        /// The constant part.
        constant: Rational,
        /// Coefficient and term.
        terms: Box<[(Rational, Expr)]>,
    },
    /// `Π base^exponent`: ascending, without a numeric coefficient. A base may stand twice, with a positive and with
    /// a negative exponent, where it is not known to be non-zero.
    Product(Box<[(Expr, i32)]>),
    /// A function of its arguments.
    Function(Function, Box<[Expr]>),
}

impl Node {
    /// Visits the children in the node's order, without collecting them.
    pub fn for_children(&self, mut visit: impl FnMut(Expr)) {
        let mut i = 0;
        match self {
            Node::Number(_) | Node::Symbol(_) => {}
            Node::Sum { terms, .. } => {
                while i < terms.len() {
                    visit(terms[i].1);
                    i += 1;
                }
            }
            Node::Product(factors) => {
                while i < factors.len() {
                    visit(factors[i].0);
                    i += 1;
                }
            }
            Node::Function(_, arguments) => {
                while i < arguments.len() {
                    visit(arguments[i]);
                    i += 1;
                }
            }
        }
    }

    /// Whether one of the children is of a kind.
    pub fn any_child(&self, mut is: impl FnMut(Expr) -> bool) -> bool {
        let mut found = false;
        self.for_children(|child| found = found || is(child));
        found
    }

    /// A number of its own for the node's contents, the same in every process.
    pub(super) fn hash(&self) -> u64 {
        let step = |key: u64, value: u64| {
            let product = (key ^ value).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            product ^ (product >> 32)
        };
        let rational = |key: u64, number: &Rational| match number {
            Rational::Small(n, d) => step(step(key, *n as u64), *d as u64),
            Rational::Big(big) => big.numer().iter_u64_digits().chain(big.denom().iter_u64_digits()).fold(key, step),
        };
        let mut i = 0;
        match self {
            Node::Number(number) => rational(1, number),
            Node::Symbol(symbol) => step(2, symbol.0.into()),
            Node::Sum { constant, terms } => {
                let mut key = rational(3, constant);
                while i < terms.len() {
                    key = step(rational(key, &terms[i].0), terms[i].1.0.into());
                    i += 1;
                }
                key
            }
            Node::Product(factors) => {
                let mut key = 4;
                while i < factors.len() {
                    key = step(key, u64::from(factors[i].0.0) << 32 | u64::from(factors[i].1 as u32));
                    i += 1;
                }
                key
            }
            Node::Function(function, arguments) => {
                let mut key = step(5, function.key());
                while i < arguments.len() {
                    key = step(key, arguments[i].0.into());
                    i += 1;
                }
                key
            }
        }
    }

    /// The children, in the node's order.
    pub fn children(&self) -> Vec<Expr> {
        match self {
            Node::Number(_) | Node::Symbol(_) => Vec::new(),
            Node::Sum { terms, .. } => terms.iter().map(|(_, e)| *e).collect(),
            Node::Product(factors) => factors.iter().map(|(e, _)| *e).collect(),
            Node::Function(_, arguments) => arguments.to_vec(),
        }
    }
}
