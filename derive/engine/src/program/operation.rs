//! The straight-line program: binary operations in an order in which operands come first.

use crate::symbolic::{Function, Rational};
use std::collections::{BTreeMap, HashMap};

/// A position in a [`Code`].
pub type Reference = u32;

/// What a program reads.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Leaf {
    /// π.
    Pi,
    /// A parameter of the model: only in the work of `prepare`.
    Parameter(usize),
    /// A prepared value: a parameter, or a quantity of parameters alone.
    Value(usize),
    /// t.
    Time,
    /// A coordinate of the state.
    StateCoordinate(usize),
    /// An independent speed of the state.
    StateSpeed(usize),
    /// An entry of x.
    Coordinate(usize),
    /// An entry of v.
    Speed(usize),
    /// An entry of v̇.
    SpeedRate(usize),
    /// An entry of the carriers w.
    Carrier(usize),
    /// An entry of ẇ.
    CarrierRate(usize),
    /// A multiplier.
    Multiplier(usize),
    /// An input.
    Input(usize),
}

/// One step.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Operation {
    /// A given quantity.
    Read(Leaf),
    /// An exact number.
    Number(Rational),
    /// `-a`
    Negate(Reference),
    /// `a + b`
    Add(Reference, Reference),
    /// `a - b`
    Subtract(Reference, Reference),
    /// `a * b`
    Multiply(Reference, Reference),
    /// `a / b`
    Divide(Reference, Reference),
    /// Sine of an angle; sine and cosine of one angle are one call.
    Sine(Reference),
    /// Cosine of an angle.
    Cosine(Reference),
    /// Square root.
    Root(Reference),
    /// Another function of its arguments.
    Call(Function, Box<[Reference]>),
}

impl Operation {
    /// The operands, in order.
    pub fn operands(&self) -> Vec<Reference> {
        match self {
            Operation::Read(_) | Operation::Number(_) => Vec::new(),
            Operation::Negate(a) | Operation::Sine(a) | Operation::Cosine(a) | Operation::Root(a) => vec![*a],
            Operation::Add(a, b) | Operation::Subtract(a, b) | Operation::Multiply(a, b) | Operation::Divide(a, b) => {
                vec![*a, *b]
            }
            Operation::Call(_, arguments) => arguments.to_vec(),
        }
    }

    /// The same step over other operands.
    pub fn map(&self, f: impl Fn(Reference) -> Reference) -> Operation {
        match self {
            Operation::Read(_) | Operation::Number(_) => self.clone(),
            Operation::Negate(a) => Operation::Negate(f(*a)),
            Operation::Sine(a) => Operation::Sine(f(*a)),
            Operation::Cosine(a) => Operation::Cosine(f(*a)),
            Operation::Root(a) => Operation::Root(f(*a)),
            Operation::Add(a, b) => Operation::Add(f(*a), f(*b)),
            Operation::Subtract(a, b) => Operation::Subtract(f(*a), f(*b)),
            Operation::Multiply(a, b) => Operation::Multiply(f(*a), f(*b)),
            Operation::Divide(a, b) => Operation::Divide(f(*a), f(*b)),
            Operation::Call(function, arguments) => {
                Operation::Call(*function, arguments.iter().map(|a| f(*a)).collect())
            }
        }
    }

    /// Whether nothing is computed: a given quantity or a number.
    pub fn is_leaf(&self) -> bool {
        matches!(self, Operation::Read(_) | Operation::Number(_))
    }
}

/// What a program costs. Negations are free, sine and cosine of one angle are one `sincos`.
#[derive(Copy, Clone, PartialEq, Eq, Default, Debug)]
pub struct Count {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
    /// Distinct angles.
    pub sincos: usize,
    /// Selections, signs and absolute values.
    pub selections: usize,
    /// Other functions.
    pub others: usize,
}

impl Count {
    /// Operations as they are commonly quoted: additions, subtractions, multiplications, divisions and roots.
    pub fn operations(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.roots
    }

    /// A measure for choosing between two programs: a division or a root weighs as four multiplications.
    pub fn weight(&self) -> usize {
        self.additions
            + self.multiplications
            + self.selections
            + 4 * (self.divisions + self.roots)
            + 20 * (self.sincos + self.others)
    }
}

/// A straight-line program.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Code {
    /// The steps.
    pub operations: Vec<Operation>,
    /// The results.
    pub outputs: Vec<Reference>,
    /// What steps are, where their operands do not tell.
    pub called: BTreeMap<Reference, String>,
}

impl Code {
    /// What the steps cost, each counted once.
    pub fn count(&self) -> Count {
        let mut count = Count::default();
        let mut angles: HashMap<Reference, ()> = HashMap::new();
        for operation in &self.operations {
            match operation {
                Operation::Read(_) | Operation::Number(_) | Operation::Negate(_) => {}
                Operation::Add(..) | Operation::Subtract(..) => count.additions += 1,
                Operation::Multiply(..) => count.multiplications += 1,
                Operation::Divide(..) => count.divisions += 1,
                Operation::Root(_) => count.roots += 1,
                Operation::Sine(a) | Operation::Cosine(a) => {
                    angles.insert(*a, ());
                }
                Operation::Call(Function::Select | Function::Sign | Function::Abs, _) => count.selections += 1,
                Operation::Call(..) => count.others += 1,
            }
        }
        count.sincos = angles.len();
        count
    }

    /// How often each step is used, results included.
    pub fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0; self.operations.len()];
        for operation in &self.operations {
            for operand in operation.operands() {
                uses[operand as usize] += 1;
            }
        }
        for output in &self.outputs {
            uses[*output as usize] += 1;
        }
        uses
    }
}
