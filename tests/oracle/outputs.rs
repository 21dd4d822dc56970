//! Outputs, evaluated as they are declared: at v̇ and λ of the full system (2.8).

use super::check::Compared;
use super::kkt::UNIT;
use super::number::{Number, Scaled};
use super::report::Report;
use super::system::{Entry, lift};
use nalgebra::DVector;

impl Compared<'_> {
    /// Every output is what its declaration says, and in terms of the carriers it is the same.
    pub(super) fn outputs(&self, report: &mut Report) {
        let (claim, declared) = (self.claim, &self.system.model.outputs);
        let names = claim.outputs.iter().map(|(name, _)| name);
        report.fact("all outputs are given, in their order", names.eq(declared.iter().map(|(name, _)| name)));
        if declared.is_empty() || !self.reactions_are_known() {
            return;
        }
        for (i, expected) in self.expected_outputs().into_iter().enumerate() {
            let (name, claimed) = &claim.outputs[i];
            let bound = UNIT * self.chart * expected.size;
            report.number(&format!("output {name}"), *claimed, expected.value, bound);
            if let Some(carried) = &claim.carried_outputs {
                report.number(&format!("output {name} by carriers"), carried[i], expected.value, bound);
            }
        }
    }

    fn expected_outputs(&self) -> Vec<Entry> {
        let (claim, system, motion) = (self.claim, self.system, &self.motion);
        let known = |values: &[f64], errors: &[f64]| -> Vec<Entry> {
            let sized = |(value, error): (&f64, &f64)| Scaled { value: *value, size: value.abs().max(error / UNIT) };
            values.iter().zip(errors).map(sized).collect()
        };
        // speeds are computed from each other, each at the size of the largest
        let speeds = |values: &[f64]| -> Vec<Entry> {
            let size = values.iter().fold(1.0_f64, |size, v| size.max(v.abs()));
            values.iter().map(|&value| Scaled { value, size }).collect()
        };
        // what the scope borrows is there before it
        let named: Vec<String> = claim.speed_names.clone();
        let reactions = [self.named_reactions(), self.released()].concat();
        let (t, x, v) = (Entry::constant(claim.t), lift(&claim.coordinates), speeds(&claim.velocities));
        let rates = known(motion.acceleration.as_slice(), self.acceleration_error().as_slice());
        let coordinates = || system.model.state_coordinates().iter().map(String::as_str);
        let mut scope = system.accelerated(t, &x, &v, &rates);
        if system.model.configuration.is_some() {
            let error = &motion.second_rate_errors * self.chart.powi(2);
            let second = known(motion.second_rates.as_slice(), error.as_slice());
            scope = scope
                .with(coordinates(), &lift(&claim.state_coordinates))
                .with_rates(coordinates(), &speeds(&claim.coordinate_rates))
                .with_second_rates(coordinates(), &second);
        }
        let free = named.iter().map(String::as_str).filter(|name| !system.model.speeds.iter().any(|v| v == name));
        let free: Vec<(&str, f64)> = free.zip(self.free_speeds()).collect();
        let names: Vec<&str> = free.iter().map(|(name, _)| *name).collect();
        let values: Vec<f64> = free.iter().map(|(_, value)| *value).collect();
        let (constraints, lambda): (Vec<&str>, Vec<Entry>) =
            reactions.iter().map(|(name, value)| (name.as_str(), *value)).unzip();
        let mut scope = scope.with(names, &speeds(&values)).with_reactions(constraints, &lambda);
        let mut found = Vec::new();
        for (name, output) in &system.model.outputs {
            let value = scope.value(output);
            found.push(value);
            scope = scope.with_output(name, value);
        }
        found
    }

    /// The values of the state's speeds that are no speeds of the initial system.
    fn free_speeds(&self) -> Vec<f64> {
        let own = |name: &String| self.system.model.speeds.contains(name);
        let speeds = self.claim.speed_names.iter().zip(&self.claim.speeds);
        speeds.filter(|(name, _)| !own(name)).map(|(_, value)| *value).collect()
    }

    /// λ by name. The name of a row that is merged with another one has the share that its gradient has of that row's.
    pub(super) fn named_reactions(&self) -> Vec<(String, Entry)> {
        let (expected, bound) = self.multipliers();
        let carried: Vec<&str> =
            self.claim.carried_rows().iter().map(|(row, _)| self.claim.row_names[*row].as_str()).collect();
        let own = |i: usize| Scaled { value: expected[i], size: expected[i].abs().max(bound[i] / UNIT) };
        let gradient = |name: &str| -> Option<DVector<f64>> {
            let row = self.rows.names.iter().position(|other| other == name)?;
            Some(self.rows.c.row(row).map(|e| e.value).transpose())
        };
        let of = |name: &String| -> Option<(String, Entry)> {
            if let Some(i) = carried.iter().position(|other| other == name) {
                return Some((name.clone(), own(i)));
            }
            let merged = gradient(name)?;
            let parallel = |i: usize| -> Option<f64> {
                let row = gradient(carried[i])?;
                let share = merged.dot(&row) / row.dot(&row);
                ((&merged - &row * share).norm() <= 1e-9 * merged.norm()).then_some(share)
            };
            let (i, share) = (0..carried.len()).find_map(|i| Some((i, parallel(i)?)))?;
            Some((name.clone(), own(i) / Entry::constant(share)))
        };
        self.rows.names.iter().filter_map(of).collect()
    }
}
