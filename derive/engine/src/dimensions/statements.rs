//! Defines, kinematics, inertia, forces, energies, and what is given as a function of something else.

use super::Checker;
use super::dimension::Dimension;
use crate::syntax::{Expression, InertiaEntry, InertiaForm, List, Quantity, Term};

/// Numbers that defines stand for are looked for so many times, one that needs another after it.
const ROUNDS: usize = 8;

impl Checker<'_> {
    /// Defines that are numbers: exponents, and zeros that fit anything.
    pub fn constants(&mut self) {
        for _ in 0..ROUNDS {
            let mut found = false;
            for define in &self.declarations.defines {
                let name = define.name.to_string();
                let known = self.table.get(&name).is_none_or(|entry| entry.constant.is_some());
                if !known && let Some(number) = self.constant(&define.value) {
                    self.table.set_constant(&name, number);
                    found = true;
                }
            }
            if !found {
                break;
            }
        }
    }

    /// Defines; those that tell reactions wait for the constraints.
    pub fn defines(&mut self, of_reactions: bool) {
        let tells = |term: &Term| matches!(term, Term::Call(function, _) if function == "reaction");
        for define in &self.declarations.defines {
            if define.value.terms().iter().any(|(term, _)| tells(term)) != of_reactions {
                continue;
            }
            self.origin = format!("the define `{}`", define.name);
            self.assigned(&define.name.to_string(), &define.value);
        }
    }

    /// `name = value`
    fn assigned(&mut self, name: &str, value: &Expression) {
        let dimension = self.of(name);
        self.expected(value, &format!("`{name}`"), &dimension);
    }

    /// `v1 = value` or `dot(x) = value`
    fn given(&mut self, entries: &[(Quantity, Expression)]) {
        for (left, value) in entries {
            match left {
                Quantity::Name(name) => self.assigned(&name.to_string(), value),
                Quantity::Rate(name, _) => {
                    let rate = self.rate_of(&name.to_string());
                    self.expected(value, &format!("`{left}`"), &rate);
                }
            }
        }
    }

    pub fn statements(&mut self) {
        let declarations = self.declarations;
        if let Some(kinematics) = &declarations.kinematics {
            self.origin = "`kinematics`".to_owned();
            self.given(&kinematics.entries);
        }
        if let Some(configuration) = &declarations.configuration {
            self.origin = "`configuration`".to_owned();
            for map in &configuration.map {
                self.assigned(&map.name.to_string(), &map.value);
            }
            self.given(&configuration.kinematics);
        }
        if let Some(velocities) = &declarations.velocities {
            self.origin = "`velocities`".to_owned();
            self.given(&velocities.map);
        }
        for (name, value) in declarations.independent.iter().flat_map(|list| list.combinations()) {
            self.origin = "`independent`".to_owned();
            self.assigned(&name.ident.to_string(), value);
        }
        let velocities = self.velocities();
        if let Some(inertia) = &declarations.inertia {
            self.origin = "`inertia`".to_owned();
            self.mass_matrix(&inertia.form, &velocities);
        }
        let energies =
            [("kinetic_energy", &declarations.kinetic_energy), ("potential_energy", &declarations.potential_energy)];
        for (statement, energy) in energies {
            if let Some(energy) = energy {
                self.origin = format!("`{statement}`");
                let expected = self.energy.clone();
                self.expected(energy, &format!("`{statement}`"), &expected);
            }
        }
        if let Some(List { entries, .. }) = &declarations.forces {
            self.origin = "`forces`".to_owned();
            for (entry, (name, velocity)) in entries.iter().zip(&velocities) {
                let force = self.power().over(velocity);
                self.expected(entry, &format!("the force whose power is that with `{name}`"), &force);
            }
        }
        self.complement();
    }

    /// M_ij v_i v_j is an energy.
    fn mass_matrix(&mut self, form: &InertiaForm, velocities: &[(String, Dimension)]) {
        let entry = |checker: &mut Self, value: &Expression, i: usize, j: usize| {
            let (Some((first, a)), Some((second, b))) = (velocities.get(i), velocities.get(j)) else { return };
            let expected = checker.energy.over(&a.times(b));
            let what = format!("the inertia whose energy is that with `{first}` and `{second}`");
            checker.expected(value, &what, &expected);
        };
        match form {
            InertiaForm::Diagonal(entries) => {
                entries.iter().enumerate().for_each(|(i, value)| entry(self, value, i, i));
            }
            InertiaForm::Matrix(rows) => {
                for (i, row) in rows.iter().enumerate() {
                    for (j, value) in row.entries.iter().enumerate() {
                        if let InertiaEntry::Given(value) = value {
                            entry(self, value, i, j);
                        }
                    }
                }
            }
        }
    }

    /// v = Dᵀ u over the carriers of the motion.
    fn complement(&mut self) {
        let declarations = self.declarations;
        let Some(complement) = &declarations.complement else { return };
        self.origin = "`complement`".to_owned();
        let carriers: Vec<Dimension> = match &declarations.configuration {
            Some(configuration) if !configuration.speeds.is_empty() => {
                configuration.speeds.iter().map(|speed| self.of(&speed.ident.to_string())).collect()
            }
            Some(configuration) => {
                let given = |name: &&crate::syntax::Name| configuration.map.iter().all(|map| map.name != name.ident);
                let kept = declarations.coordinates.iter().filter(given).chain(&configuration.further);
                kept.map(|name| self.rate_of(&name.ident.to_string())).collect()
            }
            None => self.velocities().into_iter().map(|(_, dimension)| dimension).collect(),
        };
        for row in &complement.rows {
            let name = row.name.to_string();
            if self.table.get(&name).is_none() {
                let dimension = self.solver.fresh();
                self.table.insert(&name, dimension);
            }
            let speed = self.of(&name);
            for (value, carrier) in row.entries.iter().zip(&carriers) {
                self.expected(value, &format!("this entry of `{name}`"), &carrier.over(&speed));
            }
        }
    }

    pub fn outputs(&mut self) {
        for output in &self.declarations.outputs {
            let name = output.name.ident.to_string();
            self.origin = format!("the output `{name}`");
            let Some(dimension) = self.table.outputs.get(&name).cloned() else { continue };
            self.expected(&output.value, &format!("`{name}`"), &dimension);
        }
    }
}
