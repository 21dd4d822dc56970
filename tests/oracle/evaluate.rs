//! Expressions over any number, by walking them as they were written.

use super::given::given;
use super::number::Number;
use super::statements::{number, plain, rate_of, reaction_of, second_rate_of};
use std::cell::RefCell;
use std::collections::BTreeMap;
use syn::{BinOp, Block, Expr, Stmt, UnOp};

/// What the names stand for.
pub struct Scope<'a, N> {
    names: BTreeMap<&'a str, N>,
    rates: BTreeMap<&'a str, N>,
    second_rates: BTreeMap<&'a str, N>,
    reactions: BTreeMap<&'a str, N>,
    outputs: BTreeMap<&'a str, N>,
    definitions: &'a BTreeMap<String, Expr>,
    known: RefCell<BTreeMap<&'a str, N>>,
}

impl<'a, N: Number> Scope<'a, N> {
    /// A scope that knows the definitions only.
    pub fn new(definitions: &'a BTreeMap<String, Expr>) -> Self {
        let names = BTreeMap::from([("PI", N::constant(std::f64::consts::PI))]);
        let (rates, second_rates) = (BTreeMap::new(), BTreeMap::new());
        let (reactions, outputs) = (BTreeMap::new(), BTreeMap::new());
        Self { names, rates, second_rates, reactions, outputs, definitions, known: RefCell::default() }
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

    /// The value of an expression.
    ///
    /// # Panics
    /// On a name that is not in scope and on what is no expression of a model.
    pub fn value(&self, e: &Expr) -> N {
        match e {
            Expr::Paren(inner) => self.value(&inner.expr),
            Expr::Group(inner) => self.value(&inner.expr),
            Expr::Lit(_) => N::constant(number(e)),
            Expr::Unary(u) if matches!(u.op, UnOp::Neg(_)) => -self.value(&u.expr),
            Expr::Binary(b) => {
                let (left, right) = (self.value(&b.left), self.value(&b.right));
                match b.op {
                    BinOp::Add(_) => left + right,
                    BinOp::Sub(_) => left - right,
                    BinOp::Mul(_) => left * right,
                    BinOp::Div(_) => left / right,
                    _ => panic!("not an operation of a model"),
                }
            }
            Expr::Path(_) => self.named(&plain(e).expect("a plain name")),
            Expr::If(choice) => match &choice.else_branch {
                Some((_, otherwise)) if !self.holds(&choice.cond) => self.value(otherwise),
                Some(_) => self.last(&choice.then_branch),
                None => panic!("a choice needs both branches"),
            },
            Expr::Block(block) => self.last(&block.block),
            Expr::Call(_) if reaction_of(e).is_some() => {
                let name = reaction_of(e).expect("a reaction");
                *self.reactions.get(name.as_str()).unwrap_or_else(|| panic!("reaction({name}) is not in scope"))
            }
            Expr::Call(call) => match (rate_of(e), second_rate_of(e)) {
                (Some(name), _) => {
                    *self.rates.get(name.as_str()).unwrap_or_else(|| panic!("dot({name}) is not in scope"))
                }
                (_, Some(name)) => {
                    *self.second_rates.get(name.as_str()).unwrap_or_else(|| panic!("ddot({name}) is not in scope"))
                }
                _ => {
                    let arguments: Vec<&Expr> = call.args.iter().collect();
                    self.function(&plain(&call.func).expect("a function's name"), &arguments)
                }
            },
            _ => panic!("not an expression of a model"),
        }
    }

    /// The value of a block that is one expression.
    fn last(&self, block: &Block) -> N {
        let [Stmt::Expr(e, None)] = block.stmts.as_slice() else { panic!("not an expression of a model") };
        self.value(e)
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

    fn named(&self, name: &str) -> N {
        if let Some(value) = self.names.get(name).or(self.known.borrow().get(name)) {
            return *value;
        }
        let Some((name, definition)) = self.definitions.get_key_value(name) else {
            return *self.outputs.get(name).unwrap_or_else(|| panic!("`{name}` is not in scope"));
        };
        let value = self.value(definition);
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
