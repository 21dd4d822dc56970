//! The charts beyond the first: other speeds, the same motion.

use super::check::Compared;
use super::condition::further_condition;
use super::kkt::UNIT;
use super::report::Report;
use nalgebra::DVector;

impl Compared<'_> {
    /// v, ẋ and v̇ in every chart are those of the state and of (2.8), and its speeds are what their names say.
    pub(super) fn charts(&self, report: &mut Report) {
        let claim = self.claim;
        let size = claim.velocities.iter().chain(&claim.coordinate_rates).fold(1.0_f64, |size, v| size.max(v.abs()));
        let vector = |values: &[f64]| DVector::from_column_slice(values);
        for (at, chart) in claim.charts.iter().enumerate() {
            let condition = further_condition(self.system, chart, &self.dynamics, &self.rows).max(self.chart);
            let bound = |n: usize, factor: f64| DVector::from_element(n, UNIT * factor * size);
            let what = |what: &str| format!("{what} in chart {}", at + 1);
            let (v, rates) = (vector(&claim.velocities), vector(&claim.coordinate_rates));
            report.bounded(&what("v"), &chart.velocities, &v, &bound(v.len(), condition.powi(2)));
            report.bounded(&what("ẋ"), &chart.coordinate_rates, &rates, &bound(rates.len(), condition.powi(2)));
            let error = self.acceleration_error() * (condition / self.chart).powi(2) * self.chart;
            report.bounded(&what("v̇"), &chart.velocity_rates, &self.motion.acceleration, &error);
            for (name, u) in chart.names.iter().zip(&chart.speeds) {
                if let Some(i) = self.system.model.speeds.iter().position(|v| v == name) {
                    report.number(&what(name), *u, claim.velocities[i], UNIT * condition * size);
                }
            }
            report.fact(&what("other speeds"), chart.names != claim.speed_names);
        }
        let declared = self.system.model.independent.len().max(1);
        report.fact("a chart for each choice of speeds", claim.charts.len() + 1 == declared);
    }
}
