//! The units that are known in the end.

use super::words::unit;
use super::{Checker, Dimension, table, units};
use crate::symbolic::Rational;
use crate::syntax::{Declarations, Speed, Unit};
use std::collections::BTreeMap;

/// Units as text: as they were declared, or as they follow. Pure numbers have the unit `1`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Units {
    names: BTreeMap<String, String>,
    outputs: BTreeMap<String, String>,
    multipliers: BTreeMap<String, String>,
}

impl Units {
    /// That of a parameter, a coordinate, a speed (`dot_x` is the rate of `x`) or an input.
    pub fn of(&self, name: &str) -> Option<&str> {
        self.names.get(name).map(String::as_str)
    }

    /// That of an output.
    pub fn of_output(&self, name: &str) -> Option<&str> {
        self.outputs.get(name).map(String::as_str)
    }

    /// A multiplier of several rows that are one is that of the row which stands in C.
    pub fn share(&mut self, multiplier: &str, row: &str) {
        match self.of_multiplier(row).map(str::to_owned) {
            Some(unit) => self.multipliers.insert(multiplier.to_owned(), unit),
            None => self.multipliers.remove(multiplier),
        };
    }

    /// That of the multiplier of a row.
    pub fn of_multiplier(&self, name: &str) -> Option<&str> {
        if let Some(unit) = self.multipliers.get(name) {
            return Some(unit);
        }
        let at = name.rfind("_axes")?;
        self.multipliers.get(&name[..at + "_axes".len()]).map(String::as_str)
    }
}

/// What the checker knows.
pub fn units(checker: &Checker<'_>) -> Units {
    let declarations = checker.declarations;
    let text = |dimension: &Dimension| {
        let resolved = checker.solver.resolved(dimension);
        resolved.unknowns().next().is_none().then(|| unit(&resolved))
    };
    let mut found = Units::default();
    let of = |name: &str| checker.table.get(name).map(|entry| entry.dimension.clone());
    let mut names: Vec<String> = declarations.fields.iter().map(|field| field.ident.to_string()).collect();
    names.extend(table::names(declarations).map(|name| name.ident.to_string()));
    names.extend(declarations.complement.iter().flat_map(|given| &given.rows).map(|row| row.name.to_string()));
    let quaternions = declarations.quaternions();
    for speed in declarations.all_speeds(&quaternions) {
        if !matches!(speed, Speed::Rate(_)) {
            names.push(declarations.speed_name(speed, &quaternions));
        }
    }
    found
        .names
        .extend(names.into_iter().filter_map(|name| Some((text(&of(&name)?)?, name)).map(|(unit, name)| (name, unit))));
    let further = declarations.configuration.iter().flat_map(|given| &given.further);
    for coordinate in declarations.coordinates.iter().chain(further) {
        let rate = of(&coordinate.ident.to_string()).map(|dimension| dimension.over(&checker.time));
        let rate = rate.and_then(|rate| text(&rate));
        found.names.extend(rate.map(|rate| (format!("dot_{}", coordinate.ident), rate)));
    }
    let outputs = checker.table.outputs.iter();
    found.outputs.extend(outputs.filter_map(|(name, dimension)| Some((name.clone(), text(dimension)?))));
    let multipliers = checker.reactions.iter();
    found.multipliers.extend(multipliers.filter_map(|(name, dimension)| Some((name.clone(), text(dimension)?))));
    as_declared(declarations, &mut found);
    found
}

/// Declared units stay as they are written.
fn as_declared(declarations: &Declarations, found: &mut Units) {
    let written = |unit: &Unit| {
        let factors = unit.factors.iter();
        units::written(factors.map(|(name, power)| (name.clone(), Rational::integer(i64::from(*power)))))
    };
    let fields = declarations.fields.iter().map(|field| (field.ident.to_string(), &field.unit));
    let lists = table::names(declarations).map(|name| (name.ident.to_string(), &name.unit));
    for (name, unit) in fields.chain(lists) {
        found.names.extend(unit.as_ref().map(|unit| (name, written(unit))));
    }
    for output in &declarations.outputs {
        let unit = output.name.unit.as_ref();
        found.outputs.extend(unit.map(|unit| (output.name.ident.to_string(), written(unit))));
    }
}
