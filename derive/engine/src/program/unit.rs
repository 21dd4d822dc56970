//! n-ary sums and products over shared units: the form in which common work is found.

use super::operation::Leaf;
use crate::symbolic::{Expr, Function, Stage};
use std::collections::{BTreeMap, HashMap};

/// An index into [`Units`].
pub type Id = u32;

/// Members of a product with their exponents, or of a sum with their signs; ascending.
pub type Bag = Vec<(Id, i32)>;

/// A quantity that is computed once.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Unit {
    /// A given quantity that changes during a run.
    Leaf(Leaf),
    /// A number, or a quantity of parameters alone.
    Coefficient(Expr),
    /// Sine.
    Sine(Id),
    /// Cosine.
    Cosine(Id),
    /// Square root.
    Root(Id),
    /// Another function of its arguments.
    Call(Function, Box<[Id]>),
    /// `1 / a`
    Reciprocal(Id),
    /// `-a`
    Negative(Id),
    /// Units with positive exponents.
    Product(Bag),
    /// Units with signs, the first one positive.
    Sum(Bag),
}

/// Hash-consed units. Operands have smaller indices, until pairs are shared.
#[derive(Clone, Default, Debug)]
pub struct Units {
    /// The units.
    pub units: Vec<Unit>,
    /// How often each changes.
    pub stages: Vec<Stage>,
    /// Sines and cosines of angles that are made of those of others, and whether they are negative ones.
    pub turns: BTreeMap<Id, (bool, Function, Expr)>,
    /// For look-up only.
    interned: HashMap<Unit, Id>,
}

impl Units {
    /// The index of a unit.
    pub fn intern(&mut self, unit: Unit, own: Stage) -> Id {
        if let Some(id) = self.interned.get(&unit) {
            return *id;
        }
        let stage = operands(&unit).into_iter().map(|id| self.stages[id as usize]).fold(own, Stage::max);
        let id = self.units.len() as Id;
        self.units.push(unit.clone());
        self.stages.push(stage);
        self.interned.insert(unit, id);
        id
    }

    /// A new unit made of two, without look-up.
    pub fn push_pair(&mut self, unit: Unit) -> Id {
        let stage = operands(&unit).into_iter().map(|id| self.stages[id as usize]).max().unwrap_or(Stage::Constant);
        self.units.push(unit);
        self.stages.push(stage);
        self.units.len() as Id - 1
    }

    /// How often the unit changes.
    pub fn stage(&self, id: Id) -> Stage {
        self.stages[id as usize]
    }

    /// The unit.
    pub fn get(&self, id: Id) -> &Unit {
        &self.units[id as usize]
    }
}

/// What a unit is made of.
pub fn operands(unit: &Unit) -> Vec<Id> {
    match unit {
        Unit::Leaf(_) | Unit::Coefficient(_) => Vec::new(),
        Unit::Sine(a) | Unit::Cosine(a) | Unit::Root(a) | Unit::Reciprocal(a) | Unit::Negative(a) => vec![*a],
        Unit::Call(_, arguments) => arguments.to_vec(),
        Unit::Product(bag) | Unit::Sum(bag) => bag.iter().map(|(id, _)| *id).collect(),
    }
}

/// Two bags of factors as one.
pub fn merge(a: &Bag, b: &Bag) -> Bag {
    let mut merged: Bag = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        if j == b.len() || (i < a.len() && a[i].0 < b[j].0) {
            merged.push(a[i]);
            i += 1;
        } else if i == a.len() || b[j].0 < a[i].0 {
            merged.push(b[j]);
            j += 1;
        } else {
            merged.push((a[i].0, a[i].1.saturating_add(b[j].1)));
            i += 1;
            j += 1;
        }
    }
    merged
}
