//! How far a state is from where the model changes between its cases.

use super::declaration::Declaration;
use super::system::System;
use syn::visit::Visit;
use syn::{Expr, ExprIf};

/// The conditions of `if`s.
#[derive(Default)]
struct Conditions<'a>(Vec<&'a Expr>);

impl<'a> Visit<'a> for Conditions<'a> {
    fn visit_expr_if(&mut self, choice: &'a ExprIf) {
        self.0.push(&choice.cond);
        syn::visit::visit_expr_if(self, choice);
    }
}

impl Declaration {
    /// The conditions of all `if`s of the model.
    pub fn conditions(&self) -> Vec<&Expr> {
        let mut conditions = Conditions::default();
        self.expressions().into_iter().for_each(|e| conditions.visit_expr(e));
        conditions.0
    }

    /// Every expression of the mechanics; outputs, which may ask for accelerations and reactions, are none of it.
    fn expressions(&self) -> Vec<&Expr> {
        let rates = self.rates.iter().chain(&self.speeds_by_rates).flatten();
        let energies = self.kinetic_energy.iter().chain(&self.potential_energy);
        let rows = self.constraints.iter().flat_map(|row| [&row.left, &row.right]);
        let map = self.configuration.iter().flat_map(|configuration| configuration.map.values());
        let quasi = self.configuration.iter().flat_map(|configuration| configuration.quasi.iter().map(|(_, e)| e));
        let lists = self.charts.iter().flatten().map(|chosen| &chosen.value);
        rates
            .chain(lists)
            .chain(self.inertia.iter().flatten().flatten())
            .chain(energies)
            .chain(&self.forces)
            .chain(rows)
            .chain(map)
            .chain(quasi)
            .chain(self.definitions.values())
            .collect()
    }
}

impl System<'_> {
    /// The least distance of the two sides of a condition; conditions are in positions, speeds and rates.
    pub fn to_next_case(&self, t: f64, q: &[f64], x: &[f64], v: &[f64]) -> f64 {
        let conditions = self.model.conditions();
        if conditions.is_empty() {
            return f64::INFINITY;
        }
        let scope = self.moving(t, x, v).with(self.model.state_coordinates().iter().map(String::as_str), q);
        let distance = |e: &&Expr| match e {
            Expr::Binary(b) => (scope.value(&b.left) - scope.value(&b.right)).abs(),
            _ => panic!("not a comparison"),
        };
        conditions.iter().map(distance).fold(f64::INFINITY, f64::min)
    }
}
