//! What a right side is, and its text in the notation of models.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

/// One side of an equation: a tree.
///
/// [`str::parse`] and [`Equation::formula`](crate::Equation::formula) read it from the notation of models, and `Display` writes
/// it so: what is written is read again as the same formula. Sums and products have two members or more, vectors and matrices
/// stand outermost, and a difference is a sum with [`Negative`](Formula::Negative) terms.
///
/// ```
/// use holonomy::equations::Formula;
///
/// let formula: Formula = "m*powi(r, 2) - j/2".parse()?;
/// let Formula::Sum(terms) = &formula else { panic!("a sum") };
/// let Formula::Product(factors) = &terms[0] else { panic!("a product") };
/// assert_eq!(factors[0], Formula::Symbol("m".into()));
/// assert!(matches!(factors[1], Formula::Power { exponent: 2, .. }));
/// assert!(matches!(terms[1], Formula::Negative(_)));
/// assert_eq!(formula.to_string(), "m*powi(r, 2) - j/2");
/// assert_eq!(formula.latex(), r"m r^{2} - \frac{j}{2}");
/// # Ok::<(), holonomy::equations::Unreadable>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Formula {
    /// A number that is not negative, by its decimal digits: they are exact and may be many. A rational number is a quotient
    /// of two.
    Number(String),
    /// A name: `theta`, an array's element `m[3]`, a rate `dot(x)`, a part `e1`, the number `PI`.
    Symbol(String),
    /// −a.
    Negative(Box<Formula>),
    /// a + b + …
    Sum(Vec<Formula>),
    /// a b …
    Product(Vec<Formula>),
    /// a/b.
    Quotient {
        /// a.
        numerator: Box<Formula>,
        /// b.
        denominator: Box<Formula>,
    },
    /// a to the power n.
    Power {
        /// a.
        base: Box<Formula>,
        /// n.
        exponent: i32,
    },
    /// A function of its arguments: an elementary one (`sin`, `cos`, `sqrt`, `exp`, `ln`, `asin`, `acos`, `atan`, `atan2(y, x)`,
    /// `sinh`, `cosh`, `tanh`, `abs`, `sign`, `powf(base, exponent)`) or one of the model's own.
    Call {
        /// Its name.
        function: String,
        /// What it is taken of.
        arguments: Vec<Formula>,
    },
    /// One of two, by the sign of a third.
    Select {
        /// What is compared with zero.
        condition: Box<Formula>,
        /// The value where the condition is negative.
        negative: Box<Formula>,
        /// The value elsewhere.
        otherwise: Box<Formula>,
    },
    /// The entries of a column.
    Vector(Vec<Formula>),
    /// The rows, all of one length.
    Matrix(Vec<Vec<Formula>>),
}

/// How tightly a text binds: a sum, a product, an atom.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

impl Formula {
    fn binding(&self) -> Binding {
        match self {
            Formula::Negative(_) | Formula::Sum(_) | Formula::Select { .. } => Binding::Sum,
            Formula::Product(_) | Formula::Quotient { .. } => Binding::Product,
            _ => Binding::Atom,
        }
    }

    /// In parentheses where it binds less tightly than its place asks for.
    fn write_at(&self, f: &mut fmt::Formatter<'_>, least: Binding) -> fmt::Result {
        if self.binding() >= least { write!(f, "{self}") } else { write!(f, "({self})") }
    }

    /// As the first factor: a quotient needs no parentheses there, `a/b*c` is read from the left.
    fn write_first(&self, f: &mut fmt::Formatter<'_>, least: Binding) -> fmt::Result {
        let open = matches!(self, Formula::Quotient { .. });
        self.write_at(f, if open { Binding::Product } else { least })
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Formula::Number(text) | Formula::Symbol(text) => f.write_str(text),
            Formula::Negative(of) => {
                f.write_str("-")?;
                of.write_at(f, Binding::Product)
            }
            Formula::Sum(terms) => {
                for (at, term) in terms.iter().enumerate() {
                    let (sign, term) = match term {
                        Formula::Negative(of) => (if at == 0 { "-" } else { " - " }, &**of),
                        term => (if at == 0 { "" } else { " + " }, term),
                    };
                    f.write_str(sign)?;
                    term.write_at(f, Binding::Product)?;
                }
                Ok(())
            }
            Formula::Product(factors) => {
                for (at, factor) in factors.iter().enumerate() {
                    if at == 0 {
                        factor.write_first(f, Binding::Atom)?;
                    } else {
                        f.write_str("*")?;
                        factor.write_at(f, Binding::Atom)?;
                    }
                }
                Ok(())
            }
            Formula::Quotient { numerator, denominator } => {
                numerator.write_at(f, Binding::Product)?;
                f.write_str("/")?;
                denominator.write_at(f, Binding::Atom)
            }
            Formula::Power { base, exponent } => write!(f, "powi({base}, {exponent})"),
            Formula::Call { function, arguments } => {
                write!(f, "{function}(")?;
                list(f, arguments)?;
                f.write_str(")")
            }
            Formula::Select { condition, negative, otherwise } => {
                write!(f, "if {condition} < 0 {{ {negative} }} else {{ {otherwise} }}")
            }
            Formula::Vector(entries) => {
                f.write_str("[")?;
                list(f, entries)?;
                f.write_str("]")
            }
            Formula::Matrix(rows) => {
                f.write_str("[")?;
                for (at, row) in rows.iter().enumerate() {
                    f.write_str(if at == 0 { "[" } else { ", [" })?;
                    list(f, row)?;
                    f.write_str("]")?;
                }
                f.write_str("]")
            }
        }
    }
}

fn list(f: &mut fmt::Formatter<'_>, entries: &[Formula]) -> fmt::Result {
    for (at, entry) in entries.iter().enumerate() {
        if at > 0 {
            f.write_str(", ")?;
        }
        write!(f, "{entry}")?;
    }
    Ok(())
}
