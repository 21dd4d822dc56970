//! The names of a model with their dimensions.

use super::dimension::Dimension;
use super::solver::Solver;
use super::{Checker, units};
use crate::symbolic::Rational;
use crate::syntax::{Declarations, Diagnostics, Name, Speed, Unit};
use std::collections::{BTreeMap, BTreeSet};

/// What a name is.
#[derive(Clone, Debug)]
pub struct Entry {
    pub dimension: Dimension,
    /// The number that a define stands for.
    pub constant: Option<Rational>,
    /// Whether its unit is declared, or what it is for every model.
    pub declared: bool,
}

/// Names that have values; outputs apart.
#[derive(Debug, Default)]
pub struct Table {
    entries: BTreeMap<String, Entry>,
    pub outputs: BTreeMap<String, Dimension>,
}

impl Table {
    pub fn get(&self, name: &str) -> Option<&Entry> {
        self.entries.get(name)
    }

    /// A name of which nobody asks where its unit comes from.
    pub fn insert(&mut self, name: &str, dimension: Dimension) {
        self.entries.insert(name.to_owned(), Entry { dimension, constant: None, declared: true });
    }

    pub fn set_constant(&mut self, name: &str, constant: Rational) {
        if let Some(entry) = self.entries.get_mut(name) {
            entry.constant = Some(constant);
        }
    }
}

/// The names that are introduced in lists.
pub fn names(declarations: &Declarations) -> impl Iterator<Item = &Name> {
    let speeds = declarations.speeds.iter().flat_map(|speeds| &speeds.names);
    let configuration = declarations.configuration.iter();
    let further = configuration.flat_map(|given| given.further.iter().chain(&given.speeds));
    let free = declarations.velocities.iter().flat_map(|given| &given.further);
    let combined = declarations.independent.iter().flat_map(|list| list.combinations()).map(|(name, _)| name);
    declarations.coordinates.iter().chain(speeds).chain(further).chain(free).chain(combined).chain(&declarations.inputs)
}

/// What declared units measure, by the names of fields, lists and, apart, outputs.
#[derive(Default)]
pub struct Declared {
    pub names: BTreeMap<String, Dimension>,
    pub outputs: BTreeMap<String, Dimension>,
}

impl Declared {
    pub fn is_empty(&self) -> bool {
        self.names.is_empty() && self.outputs.is_empty()
    }

    /// Whether any of them is more than a number.
    fn measures(&self) -> bool {
        self.names.values().chain(self.outputs.values()).any(|dimension| !dimension.is_pure())
    }
}

/// The declared units, of which unknown names are reported.
pub fn declared(declarations: &Declarations, diagnostics: &mut Diagnostics) -> Declared {
    let mut declared = Declared::default();
    let mut of = |unit: &Option<Unit>| unit.as_ref().and_then(|unit| units::dimension(unit, diagnostics));
    for field in &declarations.fields {
        declared.names.extend(of(&field.unit).map(|dimension| (field.ident.to_string(), dimension)));
    }
    for name in names(declarations) {
        declared.names.extend(of(&name.unit).map(|dimension| (name.ident.to_string(), dimension)));
    }
    for output in &declarations.outputs {
        declared.outputs.extend(of(&output.name.unit).map(|dimension| (output.name.ident.to_string(), dimension)));
    }
    declared
}

impl<'a> Checker<'a> {
    pub fn new(declarations: &'a Declarations, units: &Declared, diagnostics: &'a mut Diagnostics) -> Self {
        let mut solver = Solver::default();
        let measures = units.measures();
        let [time, length, mass] = match measures {
            true => [
                Dimension::mechanical(0, 0, 1),
                Dimension::mechanical(0, 1, 0).times(&solver.fresh_scale()),
                Dimension::mechanical(1, 0, 0).times(&solver.fresh_scale()),
            ],
            false => std::array::from_fn(|_| solver.fresh()),
        };
        let energy = match declarations.geometry.bodies().next() {
            Some(_) => mass.times(&length.powi(2)).over(&time.powi(2)),
            None => solver.fresh(),
        };
        let mut table = Table::default();
        let mut enter = |name: String, solver: &mut Solver| {
            let found = units.names.get(&name);
            let dimension = found.cloned().unwrap_or_else(|| solver.fresh());
            table.entries.insert(name, Entry { dimension, constant: None, declared: found.is_some() });
        };
        let fields = declarations.fields.iter().map(|field| field.ident.to_string());
        let lists = names(declarations).map(|name| name.ident.to_string());
        let defines = declarations.defines.iter().map(|define| define.name.to_string());
        for name in fields.chain(lists).chain(defines) {
            enter(name, &mut solver);
        }
        table.insert("t", time.clone());
        table.insert("PI", Dimension::pure());
        table.insert("O", length.clone());
        for point in &declarations.geometry.points {
            table.insert(&point.name.to_string(), length.clone());
        }
        let quaternions = declarations.quaternions();
        for speed in declarations.all_speeds(&quaternions) {
            if matches!(speed, Speed::Angular(..) | Speed::Norm(_)) {
                table.insert(&declarations.speed_name(speed, &quaternions), time.powi(-1));
            }
        }
        for output in &declarations.outputs {
            let name = output.name.ident.to_string();
            let dimension = units.outputs.get(&name).cloned().unwrap_or_else(|| solver.fresh());
            table.outputs.insert(name, dimension);
        }
        let functions = declarations.functions.iter();
        let functions =
            functions.map(|function| (function.name.to_string(), [solver.fresh(), solver.fresh()])).collect();
        Checker {
            declarations,
            diagnostics,
            solver,
            table,
            reactions: BTreeMap::new(),
            functions,
            time,
            length,
            mass,
            energy,
            said: BTreeSet::new(),
            origin: String::new(),
        }
    }

    /// The dimension of a name; one of which nothing is known where it has none.
    pub fn of(&mut self, name: &str) -> Dimension {
        match self.table.get(name) {
            Some(entry) => entry.dimension.clone(),
            None => self.solver.fresh(),
        }
    }

    /// That of its rate.
    pub fn rate_of(&mut self, name: &str) -> Dimension {
        self.of(name).over(&self.time)
    }

    /// Energy over time.
    pub fn power(&self) -> Dimension {
        self.energy.over(&self.time)
    }

    /// The names of v with their dimensions.
    pub fn velocities(&mut self) -> Vec<(String, Dimension)> {
        let declarations = self.declarations;
        let quaternions = declarations.quaternions();
        let speeds = declarations.all_speeds(&quaternions).into_iter();
        let named = speeds.map(|speed| match speed {
            Speed::Rate(at) => {
                let coordinate = declarations.coordinates[at].ident.to_string();
                (format!("dot({coordinate})"), self.rate_of(&coordinate))
            }
            _ => {
                let name = declarations.speed_name(speed, &quaternions);
                let dimension = self.of(&name);
                (name, dimension)
            }
        });
        named.collect()
    }
}
