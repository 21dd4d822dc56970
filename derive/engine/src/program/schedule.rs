//! Units as binary operations: operands first, then ordered by stage, so that work which changes seldom stands first.

use super::names::quantity;
use super::operation::{Code, Leaf, Operation, Reference};
use super::unit::{Bag, Id, Unit, Units, operands};
use crate::symbolic::{Expr, Graph, Node, Rational, Stage};
use std::collections::{BTreeMap, HashMap};

/// How parameter-only quantities are read.
pub trait Coefficients {
    /// The operation that gives the quantity.
    fn operation(&mut self, graph: &Graph, e: Expr) -> Operation;
}

struct Builder<'a> {
    units: &'a Units,
    uses: Vec<u32>,
    operations: Vec<Operation>,
    stages: Vec<Stage>,
    /// For look-up only.
    interned: HashMap<Operation, Reference>,
    done: Vec<Option<Reference>>,
}

/// The program that computes the roots.
pub fn schedule(units: &Units, roots: &[Id], graph: &Graph, coefficients: &mut dyn Coefficients) -> Code {
    let order = postorder(units, roots);
    let mut uses = vec![0; units.units.len()];
    for id in &order {
        for operand in operands(units.get(*id)) {
            uses[operand as usize] += 1;
        }
    }
    for root in roots {
        uses[*root as usize] += 1;
    }
    let mut builder = Builder {
        units,
        uses,
        operations: Vec::new(),
        stages: Vec::new(),
        interned: HashMap::new(),
        done: vec![None; units.units.len()],
    };
    let mut called = BTreeMap::new();
    for id in order {
        let reference = builder.unit(id, graph, coefficients);
        builder.done[id as usize] = Some(reference);
        if let Some((negative, function, angle)) = units.turns.get(&id)
            && let Some(angle) = quantity(graph, *angle)
        {
            let sign = if *negative { "minus_" } else { "" };
            called.entry(reference).or_insert(format!("{sign}{}_{angle}", function.name()));
        }
    }
    let outputs = roots.iter().map(|r| builder.get(*r)).collect();
    staged(Code { operations: builder.operations, outputs, called }, &builder.stages)
}

/// All units below the roots, operands first.
fn postorder(units: &Units, roots: &[Id]) -> Vec<Id> {
    let mut order = Vec::new();
    let mut seen = vec![false; units.units.len()];
    let mut stack: Vec<(Id, bool)> = roots.iter().rev().map(|r| (*r, false)).collect();
    while let Some((id, ready)) = stack.pop() {
        if ready {
            order.push(id);
        } else if !std::mem::replace(&mut seen[id as usize], true) {
            stack.push((id, true));
            stack.extend(operands(units.get(id)).into_iter().rev().map(|o| (o, false)));
        }
    }
    order
}

/// The operations that the outputs need, sorted by stage.
fn staged(code: Code, stages: &[Stage]) -> Code {
    let mut live = vec![false; code.operations.len()];
    for output in &code.outputs {
        live[*output as usize] = true;
    }
    for at in (0..live.len()).rev() {
        if live[at] {
            for operand in code.operations[at].operands() {
                live[operand as usize] = true;
            }
        }
    }
    let mut order: Vec<usize> = (0..live.len()).filter(|at| live[*at]).collect();
    order.sort_by_key(|at| stages[*at]);
    let mut moved = vec![0; live.len()];
    for (new, old) in order.iter().enumerate() {
        moved[*old] = new as Reference;
    }
    Code {
        operations: order.iter().map(|at| code.operations[*at].map(|r| moved[r as usize])).collect(),
        outputs: code.outputs.iter().map(|r| moved[*r as usize]).collect(),
        called: code
            .called
            .into_iter()
            .filter(|(r, _)| live[*r as usize])
            .map(|(r, text)| (moved[r as usize], text))
            .collect(),
    }
}

impl Builder<'_> {
    fn get(&self, id: Id) -> Reference {
        self.done[id as usize].expect("operands come first")
    }

    fn push(&mut self, operation: Operation) -> Reference {
        // The order of operands is kept for the reader, and makes no difference otherwise.
        let key = match operation {
            Operation::Add(a, b) if b < a => Operation::Add(b, a),
            Operation::Multiply(a, b) if b < a => Operation::Multiply(b, a),
            _ => operation.clone(),
        };
        if let Some(reference) = self.interned.get(&key) {
            return *reference;
        }
        let stage = match &operation {
            Operation::Read(leaf) => stage_of(*leaf),
            other => other.operands().into_iter().map(|r| self.stages[r as usize]).max(),
        };
        let reference = self.operations.len() as Reference;
        self.operations.push(operation);
        self.stages.push(stage.unwrap_or(Stage::Constant));
        self.interned.insert(key, reference);
        reference
    }

    fn unit(&mut self, id: Id, graph: &Graph, coefficients: &mut dyn Coefficients) -> Reference {
        let operation = match self.units.get(id) {
            Unit::Leaf(leaf) => Operation::Read(*leaf),
            Unit::Coefficient(e) => match graph.node(*e) {
                Node::Number(number) => Operation::Number(number.clone()),
                _ => coefficients.operation(graph, *e),
            },
            Unit::Sine(a) => Operation::Sine(self.get(*a)),
            Unit::Cosine(a) => Operation::Cosine(self.get(*a)),
            Unit::Root(a) => Operation::Root(self.get(*a)),
            Unit::Call(function, arguments) => {
                Operation::Call(*function, arguments.iter().map(|a| self.get(*a)).collect())
            }
            Unit::Reciprocal(a) => {
                let (one, a) = (self.push(Operation::Number(Rational::ONE)), self.get(*a));
                Operation::Divide(one, a)
            }
            Unit::Negative(a) => match self.units.get(*a) {
                // A difference that is used here alone is turned around instead.
                Unit::Sum(bag) if self.uses[*a as usize] == 1 && bag.iter().any(|(_, sign)| *sign < 0) => {
                    let turned: Bag = bag.iter().map(|(id, sign)| (*id, -sign)).collect();
                    return self.sum(&turned);
                }
                Unit::Coefficient(e) if graph.as_number(*e).is_some() => {
                    Operation::Number(graph.as_number(*e).map_or(Rational::ZERO, Rational::neg))
                }
                _ => Operation::Negate(self.get(*a)),
            },
            Unit::Product(bag) => return self.product(&bag.clone()),
            Unit::Sum(bag) => return self.sum(&bag.clone()),
        };
        self.push(operation)
    }

    /// Factors in order of stage, so that partial products stay where they change least; reciprocals that are used
    /// here alone become one division.
    fn product(&mut self, bag: &Bag) -> Reference {
        let mut above = Vec::new();
        let mut below = Vec::new();
        for (id, exponent) in bag {
            match self.units.get(*id) {
                Unit::Reciprocal(divisor) if *exponent == 1 && self.uses[*id as usize] == 1 => {
                    below.push(self.get(*divisor));
                }
                _ => above.extend(std::iter::repeat_n(self.get(*id), *exponent as usize)),
            }
        }
        let above = self.chain(above);
        match (above, self.chain(below)) {
            (Some(above), None) => above,
            (Some(above), Some(below)) => self.push(Operation::Divide(above, below)),
            (None, Some(below)) => {
                let one = self.push(Operation::Number(Rational::ONE));
                self.push(Operation::Divide(one, below))
            }
            (None, None) => self.push(Operation::Number(Rational::ONE)),
        }
    }

    /// The order of operands: by stage, what is read before what is computed, in the order of declaration.
    fn rank(&self, reference: Reference) -> (Stage, Option<Leaf>, bool, Reference) {
        let (leaf, number) = match &self.operations[reference as usize] {
            Operation::Read(leaf) => (Some(*leaf), false),
            Operation::Number(_) => (None, false),
            _ => (Some(Leaf::Input(usize::MAX)), true),
        };
        (self.stages[reference as usize], leaf, number, reference)
    }

    fn chain(&mut self, mut factors: Vec<Reference>) -> Option<Reference> {
        factors.sort_by_key(|r| self.rank(*r));
        let mut factors = factors.into_iter();
        let first = factors.next()?;
        Some(factors.fold(first, |product, factor| self.push(Operation::Multiply(product, factor))))
    }

    /// Terms in order of stage, a positive one first.
    fn sum(&mut self, bag: &Bag) -> Reference {
        let mut terms: Vec<(Reference, bool)> = bag.iter().map(|(id, sign)| (self.get(*id), *sign < 0)).collect();
        // Partial sums of one stage, each with a positive head if it has one.
        terms.sort_by_key(|(r, negative)| (self.stages[*r as usize], *negative, self.rank(*r)));
        let Some(head) = terms.iter().position(|(_, negative)| !negative) else {
            let positive: Bag = bag.iter().map(|(id, sign)| (*id, -sign)).collect();
            let sum = self.sum(&positive);
            return self.push(Operation::Negate(sum));
        };
        let (mut sum, _) = terms.remove(head);
        for (term, negative) in terms {
            sum = self.push(if negative { Operation::Subtract(sum, term) } else { Operation::Add(sum, term) });
        }
        sum
    }
}

fn stage_of(leaf: Leaf) -> Option<Stage> {
    Some(match leaf {
        Leaf::Pi => Stage::Constant,
        Leaf::Parameter(_) | Leaf::Value(_) => Stage::Parameter,
        Leaf::Time => Stage::Time,
        Leaf::StateCoordinate(_) | Leaf::Coordinate(_) => Stage::Coordinate,
        Leaf::StateSpeed(_) | Leaf::Speed(_) | Leaf::Carrier(_) | Leaf::Input(_) => Stage::Speed,
        Leaf::SpeedRate(_) | Leaf::CarrierRate(_) | Leaf::Multiplier(_) => Stage::Speed,
    })
}

/// The prepared values: parameters first, then quantities of parameters alone in order of first use.
#[derive(Clone, Debug)]
pub struct Registry {
    /// The quantities.
    pub quantities: Vec<Expr>,
    known: BTreeMap<Expr, usize>,
}

impl Registry {
    /// A registry that holds the parameters.
    pub fn new(parameters: &[Expr]) -> Self {
        let known = parameters.iter().enumerate().map(|(i, e)| (*e, i)).collect();
        Registry { quantities: parameters.to_vec(), known }
    }
}

impl Coefficients for Registry {
    fn operation(&mut self, _: &Graph, e: Expr) -> Operation {
        let next = self.quantities.len();
        let index = *self.known.entry(e).or_insert(next);
        if index == next {
            self.quantities.push(e);
        }
        Operation::Read(Leaf::Value(index))
    }
}

/// In the work of `prepare` itself every coefficient is a number; one too large to be folded is rounded.
pub struct Numbers;

impl Coefficients for Numbers {
    fn operation(&mut self, graph: &Graph, e: Expr) -> Operation {
        let value = graph.evaluate(&[e], &|_| f64::NAN)[0];
        Operation::Number(
            Rational::parse(&format!("{:e}", value.abs()))
                .map_or(Rational::ZERO, |n| if value < 0.0 { n.neg() } else { n }),
        )
    }
}
