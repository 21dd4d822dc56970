//! Expressions over any number, by walking them as they were written.

use super::declaration::Declaration;
use super::given::given;
use super::motion::Rates;
use super::number::Number;
use super::statements::{number, plain, rate_of, reaction_of, second_rate_of};
use super::vectors::{Axes, Value};
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use syn::{BinOp, Block, Expr, Stmt, UnOp};

/// What the names stand for.
pub struct Scope<'a, N> {
    pub(super) model: &'a Declaration,
    pub(super) names: BTreeMap<&'a str, N>,
    pub(super) rates: BTreeMap<&'a str, N>,
    pub(super) second_rates: BTreeMap<&'a str, N>,
    reactions: BTreeMap<&'a str, N>,
    outputs: BTreeMap<&'a str, N>,
    known: RefCell<BTreeMap<&'a str, Value<N>>>,
    pub(super) turned: RefCell<BTreeMap<&'a str, Axes<N>>>,
    /// How the same scope is had along the motion, once and twice; `None` where no motion is in scope.
    pub(super) along: [Option<Along<'a, N>>; 2],
    /// The same scope along the motion, once and twice.
    pub(super) moving: [OnceCell<Box<dyn Rates<N> + 'a>>; 2],
}

/// What makes the scope along the motion.
///
/// A pointer and not a call: the scope along the motion has another type, that of its scope along the motion yet another, and so on.
pub type Along<'a, N> = fn(&Scope<'a, N>) -> Box<dyn Rates<N> + 'a>;

impl<'a, N: Number> Scope<'a, N> {
    /// A scope that knows the definitions, frames and points only.
    pub fn new(model: &'a Declaration) -> Self {
        Self {
            model,
            names: BTreeMap::from([("PI", N::constant(std::f64::consts::PI))]),
            rates: BTreeMap::new(),
            second_rates: BTreeMap::new(),
            reactions: BTreeMap::new(),
            outputs: BTreeMap::new(),
            known: RefCell::default(),
            turned: RefCell::default(),
            along: [None, None],
            moving: [OnceCell::new(), OnceCell::new()],
        }
    }

    /// Adds names with their values.
    pub fn with(mut self, names: impl IntoIterator<Item = &'a str>, values: &[N]) -> Self {
        self.names.extend(names.into_iter().zip(values.iter().copied()));
        self
    }

    /// Adds the values of `dot(name)`.
    pub fn with_rates(mut self, names: impl IntoIterator<Item = &'a str>, values: &[N]) -> Self {
        self.rates.extend(names.into_iter().zip(values.iter().copied()));
        self
    }

    /// Adds the values of `ddot(name)`.
    pub fn with_second_rates(mut self, names: impl IntoIterator<Item = &'a str>, values: &[N]) -> Self {
        self.second_rates.extend(names.into_iter().zip(values.iter().copied()));
        self
    }

    /// Adds the values of `reaction(name)`.
    pub fn with_reactions(mut self, names: impl IntoIterator<Item = &'a str>, values: &[N]) -> Self {
        self.reactions.extend(names.into_iter().zip(values.iter().copied()));
        self
    }

    /// Adds the value of an output, which counts where nothing else has its name.
    pub fn with_output(mut self, name: &'a str, value: N) -> Self {
        self.outputs.insert(name, value);
        self
    }

    /// The value of an expression that is a scalar.
    ///
    /// # Panics
    /// On a name that is not in scope and on what is no expression of a model.
    pub fn value(&self, e: &Expr) -> N {
        self.evaluate(e).scalar()
    }

    /// The value of an expression.
    ///
    /// # Panics
    /// On a name that is not in scope and on what is no expression of a model.
    pub fn evaluate(&self, e: &Expr) -> Value<N> {
        match e {
            Expr::Paren(inner) => self.evaluate(&inner.expr),
            Expr::Group(inner) => self.evaluate(&inner.expr),
            Expr::Lit(_) => Value::Scalar(N::constant(number(e))),
            Expr::Unary(u) if matches!(u.op, UnOp::Neg(_)) => self.evaluate(&u.expr).times(-N::one()),
            Expr::Binary(b) => {
                let (left, right) = (self.evaluate(&b.left), self.evaluate(&b.right));
                match b.op {
                    BinOp::Add(_) => left.plus(right),
                    BinOp::Sub(_) => left.minus(right),
                    BinOp::Mul(_) => match left {
                        Value::Scalar(left) => right.times(left),
                        Value::Vector(_) => left.times(right.scalar()),
                    },
                    BinOp::Div(_) => left.over(right.scalar()),
                    _ => panic!("not an operation of a model"),
                }
            }
            Expr::Path(_) => self.named(&plain(e).expect("a plain name")),
            Expr::Field(_) => Value::Vector(self.axis(e)),
            Expr::If(choice) => match &choice.else_branch {
                Some((_, otherwise)) if !self.holds(&choice.cond) => self.evaluate(otherwise),
                Some(_) => self.last(&choice.then_branch),
                None => panic!("a choice needs both branches"),
            },
            Expr::Block(block) => self.last(&block.block),
            Expr::Call(_) if reaction_of(e).is_some() => {
                let name = reaction_of(e).expect("a reaction");
                let known = self.reactions.get(name.as_str());
                Value::Scalar(*known.unwrap_or_else(|| panic!("reaction({name}) is not in scope")))
            }
            Expr::Call(call) => match (rate_of(e), second_rate_of(e)) {
                (Some(name), _) if self.rates.contains_key(name.as_str()) => Value::Scalar(self.rates[name.as_str()]),
                (_, Some(name)) if self.second_rates.contains_key(name.as_str()) => {
                    Value::Scalar(self.second_rates[name.as_str()])
                }
                _ => {
                    let arguments: Vec<&Expr> = call.args.iter().collect();
                    let name = plain(&call.func).expect("a function's name");
                    self.of_vectors(&name, &arguments)
                        .unwrap_or_else(|| Value::Scalar(self.function(&name, &arguments)))
                }
            },
            _ => panic!("not an expression of a model"),
        }
    }

    /// The value of a block that is one expression.
    fn last(&self, block: &Block) -> Value<N> {
        let [Stmt::Expr(e, None)] = block.stmts.as_slice() else { panic!("not an expression of a model") };
        self.evaluate(e)
    }

    fn holds(&self, condition: &Expr) -> bool {
        match condition {
            Expr::Paren(inner) => self.holds(&inner.expr),
            Expr::Binary(b) => {
                let (left, right) = (|| self.value(&b.left).value(), || self.value(&b.right).value());
                match b.op {
                    BinOp::Lt(_) => left() < right(),
                    BinOp::Le(_) => left() <= right(),
                    BinOp::Gt(_) => left() > right(),
                    BinOp::Ge(_) => left() >= right(),
                    BinOp::And(_) => self.holds(&b.left) && self.holds(&b.right),
                    BinOp::Or(_) => self.holds(&b.left) || self.holds(&b.right),
                    _ => panic!("not a condition of a model"),
                }
            }
            _ => panic!("not a condition of a model"),
        }
    }

    fn named(&self, name: &str) -> Value<N> {
        if let Some(value) = self.names.get(name) {
            return Value::Scalar(*value);
        }
        if let Some(value) = self.known.borrow().get(name) {
            return *value;
        }
        if name == "O" {
            return Value::Vector([N::zero(); 3]);
        }
        let points = &self.model.geometry.points;
        let Some((name, definition)) = self.model.definitions.get_key_value(name).or(points.get_key_value(name)) else {
            return Value::Scalar(*self.outputs.get(name).unwrap_or_else(|| panic!("`{name}` is not in scope")));
        };
        let value = self.evaluate(definition);
        self.known.borrow_mut().insert(name, value);
        value
    }

    fn function(&self, name: &str, arguments: &[&Expr]) -> N {
        let first = self.value(arguments[0]);
        match name {
            "sin" => first.sin_cos().0,
            "cos" => first.sin_cos().1,
            "tan" => {
                let (sin, cos) = first.sin_cos();
                sin / cos
            }
            "asin" => first.asin(),
            "acos" => first.acos(),
            "atan" => first.atan2(N::one()),
            "sinh" => first.sinh_cosh().0,
            "cosh" => first.sinh_cosh().1,
            "tanh" => {
                let (sinh, cosh) = first.sinh_cosh();
                sinh / cosh
            }
            "asinh" => (first + (first * first + N::one()).sqrt()).ln(),
            "acosh" => (first + (first * first - N::one()).sqrt()).ln(),
            "atanh" => N::constant(0.5) * ((N::one() + first) / (N::one() - first)).ln(),
            "abs" => first.abs(),
            "sign" => N::constant(if first.value() == 0.0 { 0.0 } else { first.value().signum() }),
            "min" | "max" => {
                let second = self.value(arguments[1]);
                if (first.value() < second.value()) == (name == "min") { first } else { second }
            }
            "powf" => (self.value(arguments[1]) * first.ln()).exp(),
            "sqrt" => first.sqrt(),
            "exp" => first.exp(),
            "ln" => first.ln(),
            "atan2" => first.atan2(self.value(arguments[1])),
            "powi" => first.powi(number(arguments[1]) as i32),
            // of the user's
            _ => given(name, first),
        }
    }
}
