//! Identity decided by evaluation modulo primes.
//!
//! Two expressions are called identical where they agree at three fixed points modulo each of two primes. Symbols are
//! random residues; those of a unit quaternion are a random point of its sphere. An angle goes by the half-angle parameter τ of its base angles, sin = 2τ/(1+τ²),
//! cos = (1-τ²)/(1+τ²), so that every trigonometric identity with rational multiples of the base angles holds
//! exactly; exponentials, hyperbolic functions and real powers likewise by powers of a random base. Every residue has a root in the field with p² elements, so
//! only a root of what holds roots may make a point unfit, and another is drawn; the branch is fixed by the argument; |a| is
//! the root of a². A selection is b + σ (a - b), where σ is a random function of the condition with σ(-c) = 1 - σ(c): what
//! holds for every σ holds for 0 and 1. Logarithms and arcs are random functions of their arguments' values, the odd ones
//! odd. What this cannot relate is refused, never accepted: a wrong 'identical' needs a random
//! coincidence at all six points. Where roots occur the branch is a coin toss, so values in double precision, of
//! either sign, must not contradict.

use super::modular::{Element, Field, PRIMES, mix};
use super::{Expr, Function, Graph, Node, Rational, Symbol};

/// Denominators that divide this have exact angle multiples, decimals of four places among them: τ belongs to the angle over this
/// number.
const DENOMINATOR: i64 = 90_090_000;
const POINTS_PER_PRIME: usize = 3;
/// Points in all.
pub(super) const POINTS: usize = PRIMES.len() * POINTS_PER_PRIME;
const REDRAWS: usize = 1024;

/// The points of evaluation with the values found so far, one for each expression of the arena.
#[derive(Clone, Debug)]
pub struct Points(Vec<Point>);

#[derive(Clone, Debug)]
struct Point {
    field: Field,
    salt: u64,
    redraws: usize,
    /// `None` where a value is undefined (division by zero) at this point.
    values: Vec<Option<Element>>,
}

impl Default for Points {
    fn default() -> Self {
        let point = |i: usize| Point {
            field: Field(PRIMES[i % PRIMES.len()]),
            salt: mix(0x686f_6c6f_6e6f_6d79 + i as u64),
            redraws: 0,
            values: Vec::new(),
        };
        Points((0..POINTS).map(point).collect())
    }
}

/// A root of roots that does not exist at this point.
struct NotASquare;

impl Point {
    fn value(&mut self, graph: &Graph, e: Expr) -> Option<Element> {
        while self.values.len() <= e.index() {
            let next = Expr(self.values.len() as u32);
            match self.of(graph, next) {
                Ok(value) => self.values.push(value),
                Err(NotASquare) if self.redraws < REDRAWS => {
                    self.redraws += 1;
                    self.salt = mix(self.salt ^ 0x5eed);
                    self.values.clear();
                }
                Err(NotASquare) => self.values.push(None),
            }
        }
        self.values[e.index()]
    }

    fn drawn(&self, symbol: Symbol) -> Element {
        self.field.draw(self.salt.wrapping_add(mix(symbol.index() as u64 + 1)))
    }

    /// A point of the sphere by its stereographic projection: (1 - s·s, 2 s)/(1 + s·s).
    fn on_sphere(&self, four: &[Symbol; 4], at: usize) -> Option<Element> {
        let f = self.field;
        let s = [four[1], four[2], four[3]].map(|symbol| self.drawn(symbol));
        let square = s.iter().fold(Element::ZERO, |sum, s| f.add(sum, f.mul(*s, *s)));
        let over = match at.checked_sub(1) {
            Some(at) => f.add(s[at], s[at]),
            None => f.add(Element::ONE, f.neg(square)),
        };
        Some(f.mul(over, f.recip(f.add(Element::ONE, square))?))
    }

    fn child(&self, e: Expr) -> Option<Element> {
        self.values[e.index()]
    }

    fn of(&self, graph: &Graph, e: Expr) -> Result<Option<Element>, NotASquare> {
        let f = self.field;
        Ok(match graph.node(e) {
            Node::Number(number) => f.rational(number),
            Node::Symbol(symbol) => match graph.sphere_of(*symbol) {
                Some((four, at)) => self.on_sphere(four, at),
                None => Some(self.drawn(*symbol)),
            },
            Node::Sum { constant, terms } => self.linear(constant, terms),
            Node::Product(factors) => factors.iter().try_fold(Element::ONE, |total, (base, exponent)| {
                let base = self.child(*base)?;
                let power = f.pow(base, exponent.unsigned_abs().into());
                Some(f.mul(total, if *exponent < 0 { f.recip(power)? } else { power }))
            }),
            Node::Function(function, arguments) => match function {
                Function::Sin => self.turn(graph, arguments[0]).map(|(_, s)| s),
                Function::Cos => self.turn(graph, arguments[0]).map(|(c, _)| c),
                Function::Exp => self.exponential(graph, arguments[0]),
                Function::Whole => self.child(arguments[0]),
                Function::Sqrt => match self.child(arguments[0]) {
                    None => None,
                    Some(a) => Some(self.root(a)?),
                },
                Function::Abs | Function::Sign => match self.child(arguments[0]) {
                    None => None,
                    Some(a) if a.is_zero() => Some(a),
                    Some(a) => {
                        let magnitude = self.root(f.mul(a, a))?;
                        if *function == Function::Abs {
                            Some(magnitude)
                        } else {
                            f.recip(magnitude).map(|inverse| f.mul(a, inverse))
                        }
                    }
                },
                _ => {
                    let values: Option<Vec<Element>> = arguments.iter().map(|a| self.child(*a)).collect();
                    values.and_then(|values| self.function(graph, *function, arguments, &values))
                }
            },
        })
    }

    /// Functions without branches, from their arguments' values.
    fn function(&self, graph: &Graph, function: Function, arguments: &[Expr], values: &[Element]) -> Option<Element> {
        let f = self.field;
        match (function, values) {
            (Function::Sinh | Function::Cosh | Function::Tanh, _) => {
                let up = self.exponential(graph, arguments[0])?;
                let down = f.recip(up)?;
                let (twice_sinh, twice_cosh) = (f.add(up, f.neg(down)), f.add(up, down));
                let half = f.recip(f.integer(2))?;
                match function {
                    Function::Sinh => Some(f.mul(half, twice_sinh)),
                    Function::Cosh => Some(f.mul(half, twice_cosh)),
                    _ => Some(f.mul(twice_sinh, f.recip(twice_cosh)?)),
                }
            }
            // x^y = e^(y ln x)
            (Function::Power, [base, _]) => {
                let ln = self.hash(Function::Ln, &[*base]);
                self.power(self.multiples(graph, arguments[1], ln)?)
            }
            // acos x = π/2 - asin x
            (Function::Acos, [a]) => {
                let quarter = f.mul(self.child(graph.pi())?, f.recip(f.integer(2))?);
                Some(f.add(quarter, f.neg(self.odd(Function::Asin, *a))))
            }
            (Function::Asin | Function::Atan, [a]) => Some(self.odd(function, *a)),
            (Function::Atan2, [y, x]) if *x == Element::ONE => Some(self.odd(Function::Atan, *y)),
            (Function::Select, [condition, _, other]) if condition.is_zero() => Some(*other),
            (Function::Select, [condition, negative, other]) => {
                // An odd function of the condition, moved to ½.
                let odd = self.odd(function, *condition);
                let sigma = f.add(odd, f.recip(f.integer(2))?);
                Some(f.add(*other, f.mul(sigma, f.add(*negative, f.neg(*other)))))
            }
            _ => Some(self.hash(function, values)),
        }
    }

    /// The root with the branch that belongs to the argument.
    fn root(&self, a: Element) -> Result<Element, NotASquare> {
        let root = self.field.sqrt(a).ok_or(NotASquare)?;
        let flip = mix(self.salt ^ a.key()) & 1 == 1;
        Ok(if flip { self.field.neg(root) } else { root })
    }

    /// A random function of the arguments' values.
    fn hash(&self, function: Function, values: &[Element]) -> Element {
        let start = mix(self.salt ^ function.key());
        self.field.draw(values.iter().fold(start, |key, value| mix(key ^ value.key())))
    }

    /// A random odd function of the argument's value.
    fn odd(&self, function: Function, a: Element) -> Element {
        let opposite = self.field.neg(a);
        match a.key().cmp(&opposite.key()) {
            std::cmp::Ordering::Less => self.hash(function, &[a]),
            std::cmp::Ordering::Equal => Element::ZERO,
            std::cmp::Ordering::Greater => self.field.neg(self.hash(function, &[opposite])),
        }
    }

    fn linear(&self, constant: &Rational, terms: &[(Rational, Expr)]) -> Option<Element> {
        let f = self.field;
        terms
            .iter()
            .try_fold(f.rational(constant)?, |total, (c, e)| Some(f.add(total, f.mul(f.rational(c)?, self.child(*e)?))))
    }

    /// The argument of a function, times a factor, as integer multiples of base quantities: (multiple, key of the base).
    fn multiples(&self, graph: &Graph, argument: Expr, factor: Element) -> Option<Vec<(i64, u64)>> {
        let (constant, terms) = graph.as_sum(argument);
        let one = (!constant.is_zero()).then_some((constant, graph.one()));
        let mut parts = Vec::with_capacity(terms.len() + 1);
        for (coefficient, base) in terms.into_iter().chain(one) {
            let value = self.field.mul(factor, self.child(base)?);
            match coefficient.mul(&Rational::integer(DENOMINATOR)).as_integer() {
                Some(multiple) => parts.push((multiple, value.key())),
                // A multiple of no common base: an angle of its own.
                None => parts.push((1, mix(self.field.mul(self.field.rational(&coefficient)?, value).key() ^ 0xa1))),
            }
        }
        Some(parts)
    }

    /// Cosine and sine of the argument.
    fn turn(&self, graph: &Graph, argument: Expr) -> Option<(Element, Element)> {
        let f = self.field;
        let times = |(a, b): (Element, Element), (c, d): (Element, Element)| {
            (f.add(f.mul(a, c), f.neg(f.mul(b, d))), f.add(f.mul(a, d), f.mul(b, c)))
        };
        let mut total = (Element::ONE, Element::ZERO);
        for (multiple, key) in self.multiples(graph, argument, Element::ONE)? {
            let tau = f.draw(self.salt ^ mix(key ^ 0x7a));
            let square = f.mul(tau, tau);
            let below = f.recip(f.add(Element::ONE, square))?;
            let sine = f.mul(f.add(tau, tau), below);
            let mut base =
                (f.mul(f.add(Element::ONE, f.neg(square)), below), if multiple < 0 { f.neg(sine) } else { sine });
            let mut n = multiple.unsigned_abs();
            while n > 0 {
                if n & 1 == 1 {
                    total = times(total, base);
                }
                base = times(base, base);
                n >>= 1;
            }
        }
        Some(total)
    }

    fn exponential(&self, graph: &Graph, argument: Expr) -> Option<Element> {
        self.power(self.multiples(graph, argument, Element::ONE)?)
    }

    /// e to the power of the sum of the multiples.
    fn power(&self, multiples: Vec<(i64, u64)>) -> Option<Element> {
        let f = self.field;
        multiples.into_iter().try_fold(Element::ONE, |total, (multiple, key)| {
            let base = f.draw(self.salt ^ mix(key ^ 0xe));
            let base = if multiple < 0 { f.recip(base)? } else { base };
            Some(f.mul(total, f.pow(base, multiple.unsigned_abs())))
        })
    }
}

impl Graph {
    /// Whether the two expressions are one function. Decided, see the module.
    pub fn identical(&self, a: Expr, b: Expr) -> bool {
        a == b
            || self.agree(|point, graph| Some((point.value(graph, a)?, point.value(graph, b)?)))
                && !self.contradicted(a, b)
    }

    /// Whether a rewritten expression is what it was. One that is not identical is not used; one that is shown to be something
    /// else is remembered, since a rule must then be wrong: [`Graph::broken`].
    pub fn proven(&mut self, new: Expr, old: Expr) -> bool {
        let proven = self.identical(new, old);
        if !proven && self.broken.is_none() && self.refuted(new, old) {
            self.broken = Some((old, new));
        }
        proven
    }

    /// The first expression that was rewritten to something else, and what it became.
    pub fn broken(&self) -> Option<(Expr, Expr)> {
        self.broken
    }

    /// Whether the expression is zero for all values of its symbols.
    pub fn vanishes(&self, e: Expr) -> bool {
        self.identical(e, self.zero())
    }

    /// [`Graph::vanishes`] for each.
    pub fn vanishing(&self, expressions: &[Expr]) -> Vec<bool> {
        expressions.iter().map(|e| self.vanishes(*e)).collect()
    }

    /// A value modulo a prime at the k-th of six points, for callers that do linear algebra there; `None` where the
    /// expression is undefined.
    pub fn residue(&self, e: Expr, k: usize) -> Option<(Field, Element)> {
        let mut points = self.points.borrow_mut();
        let count = points.0.len();
        let point = &mut points.0[k % count];
        point.value(self, e).map(|value| (point.field, value))
    }

    fn agree(&self, mut pair: impl FnMut(&mut Point, &Graph) -> Option<(Element, Element)>) -> bool {
        let mut points = self.points.borrow_mut();
        points.0.iter_mut().all(|point| matches!(pair(point, self), Some((a, b)) if a == b))
    }
}
