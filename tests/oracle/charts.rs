//! Charts: what their lists say of a motion, against what a derivation claims in their speeds.

use super::check::Compared;
use super::claim::ChartClaim;
use super::declaration::Chosen;
use super::evaluate::Scope;
use super::kkt::{UNIT, conditioned_rank, roots};
use super::linear::{along, fixed, seeded, solve, unit};
use super::number::{Dual, Number, Scaled};
use super::report::Report;
use super::statements::{plain, rate_of};
use super::system::{Entry, System, lift};
use nalgebra::{DMatrix, DVector};

impl System<'_> {
    /// u as a list says, of the state's coordinates and the carriers: v, or with a configuration the rates of its coordinates.
    pub(super) fn listed<N: Number>(&self, list: &[Chosen], t: N, q: &[N], w: &[N]) -> Vec<N> {
        let Some(configuration) = &self.model.configuration else {
            let scope = self.moving(t, q, w);
            return list.iter().map(|chosen| self.chosen(&scope, chosen)).collect();
        };
        let x = self.coordinates(Dual::moving(t, N::one()), &along(q, w));
        let (x, xdot): (Vec<N>, Vec<N>) = x.iter().map(|x| (x.value, x.rate)).unzip();
        let v = self.velocities(t, &x, &xdot);
        let coordinates = || configuration.coordinates.iter().map(String::as_str);
        let scope = self
            .scope(t, &x)
            .with(self.model.speeds.iter().map(String::as_str), &v)
            .with_rates(self.model.coordinates.iter().map(String::as_str), &xdot)
            .with(coordinates(), q)
            .with_rates(coordinates(), w)
            .with(configuration.speeds.iter().map(String::as_str), &self.quasi_velocities(t, q, w));
        list.iter().map(|chosen| self.chosen(&scope, chosen)).collect()
    }

    /// An entry of a list; a name alone may be that of a combination in another list.
    fn chosen<N: Number>(&self, scope: &Scope<'_, N>, chosen: &Chosen) -> N {
        let mut named =
            self.model.charts.iter().flatten().filter_map(|other| Some((other.name.as_ref()?, &other.value)));
        let other = plain(&chosen.value).and_then(|name| named.find(|(other, _)| **other == name));
        scope.value(other.map_or(&chosen.value, |(_, value)| value))
    }

    /// The quasi-velocities of a configuration, in whichever direction they are given (4.3).
    fn quasi_velocities<N: Number>(&self, t: N, q: &[N], qdot: &[N]) -> Vec<N> {
        let Some(configuration) = &self.model.configuration else { return Vec::new() };
        let names = || configuration.speeds.iter().map(String::as_str);
        let of = |name: &String| configuration.quasi.iter().find(|(left, _)| plain(left).as_ref() == Some(name));
        if let Some(given) = configuration.speeds.iter().map(of).collect::<Option<Vec<_>>>() {
            let scope = self.generalised(t, q).with_rates(configuration.coordinates.iter().map(String::as_str), qdot);
            let x = self.coordinates(Dual::moving(t, N::one()), &along(q, qdot));
            let (x, xdot): (Vec<N>, Vec<N>) = x.iter().map(|x| (x.value, x.rate)).unzip();
            let initial = || self.model.coordinates.iter().map(String::as_str);
            let scope = scope.with(initial(), &x).with_rates(initial(), &xdot);
            return given.iter().map(|(_, right)| scope.value(right)).collect();
        }
        let of = |q: &String| configuration.quasi.iter().find(|(left, _)| rate_of(left).as_ref() == Some(q));
        let rates: Vec<_> =
            configuration.coordinates.iter().map(|q| of(q).expect("the rate of each coordinate")).collect();
        let still = vec![N::zero(); q.len()];
        let bias = self.generalised(t, q).with(names(), &still);
        let columns: Vec<Vec<N>> = (0..q.len())
            .map(|j| {
                let scope = self.generalised(Dual::fixed(t), &fixed(q)).with(names(), &unit(q.len(), j));
                rates.iter().map(|(_, right)| scope.value(right).rate).collect()
            })
            .collect();
        let a = (0..q.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect();
        solve(a, rates.iter().zip(qdot).map(|((_, right), rate)| *rate - bias.value(right)).collect())
    }

    /// Parameters, time, and the coordinates of the state; the initial coordinates follow from them.
    fn generalised<N: Number>(&self, t: N, q: &[N]) -> Scope<'_, N> {
        let names = self.model.state_coordinates().iter().map(String::as_str);
        self.scope(t, &self.coordinates(t, q)).with(names, q)
    }
}

/// A list at the state of a claim.
struct Listed {
    /// u.
    speeds: DVector<Entry>,
    /// u̇ along the motion that the full system gives.
    rates: DVector<Entry>,
    /// ∂u/∂w.
    gradient: DMatrix<f64>,
    /// How much inverting the rows together with the list amplifies rounding.
    condition: f64,
}

impl Compared<'_> {
    /// Every chart: u of v, v of u, the rates of the state's coordinates and of u.
    pub(super) fn charts(&self, report: &mut Report) {
        let (claim, model) = (self.claim, self.system.model);
        report.fact("a chart for each list", claim.charts.len() == model.charts.len().max(1));
        let size = claim.velocities.iter().fold(1.0_f64, |size, v| size.max(v.abs()));
        if let Some(first) = claim.charts.first() {
            let bound = DVector::from_element(claim.speeds.len(), UNIT * self.chart.powi(2) * size);
            report.bounded("u of v", &first.speeds, &DVector::from_column_slice(&claim.speeds), &bound);
        }
        for (at, (list, chart)) in model.charts.iter().zip(&claim.charts).enumerate() {
            self.chart(report, at, list, chart);
        }
    }

    fn chart(&self, report: &mut Report, at: usize, list: &[Chosen], chart: &ChartClaim) {
        let claim = self.claim;
        let listed = self.at_state(list, &chart.guards);
        let what = |quantity: &str| format!("chart {at}: {quantity}");
        // the carriers were computed by the first chart
        let unit = UNIT * self.chart;
        let size = claim.velocities.iter().chain(&claim.coordinate_rates).fold(1.0_f64, |size, v| size.max(v.abs()));
        let terms = listed.gradient.abs() * DVector::from_element(listed.gradient.ncols(), size);
        let bound = (terms + listed.speeds.map(|u| u.size)) * unit;
        report.bounded(&what("u"), &chart.speeds, &listed.speeds.map(|u| u.value), &bound);
        let bound = UNIT * self.chart * listed.condition * size;
        let bounds = |n: usize| DVector::from_element(n, bound);
        let (v, rates) = (&claim.velocities, &claim.coordinate_rates);
        report.bounded(&what("v"), &chart.velocities, &DVector::from_column_slice(v), &bounds(v.len()));
        let rates = DVector::from_column_slice(rates);
        // A multiplies what is wrong in v
        let of_rates = bounds(rates.len()) * (1.0 + self.dynamics.a.iter().fold(0.0_f64, |size, e| size.max(e.size)));
        report.bounded(&what("rates of the coordinates"), &chart.coordinate_rates, &rates, &of_rates);
        let wrong = self.carried_error() * listed.condition.powi(2);
        let bound = listed.gradient.abs() * wrong + listed.rates.map(|u| u.size) * (unit * listed.condition.powi(2));
        report.bounded(&what("u̇"), &chart.accelerations, &listed.rates.map(|u| u.value), &bound);
    }

    /// What rounding may do to the rates of the carriers.
    fn carried_error(&self) -> DVector<f64> {
        match self.system.model.configuration {
            None => self.acceleration_error(),
            Some(_) => &self.motion.generalised_error * self.chart.powi(2),
        }
    }

    /// The carriers w.
    fn carriers(&self) -> Vec<f64> {
        match self.system.model.configuration {
            None => self.claim.velocities.clone(),
            Some(_) => self.claim.coordinate_rates.clone(),
        }
    }

    /// [C; L] over the carriers in the kinetic metric, C the rows that speeds follow from; and the smallest guard beside its entries.
    fn chart_condition(&self, gradient: &DMatrix<f64>, guards: &[f64]) -> f64 {
        let (claim, system) = (self.claim, self.system);
        let c = self.rows.c.map(|e| e.value);
        let linear: Vec<usize> = (0..c.nrows()).filter(|&i| self.rows.linear[i]).collect();
        let (c, metric) = match &system.model.configuration {
            None => (c.select_rows(&linear), self.dynamics.m.map(|e| e.value)),
            Some(_) => {
                let partial = system.partial_velocities(claim.t, &claim.state_coordinates, &claim.coordinate_rates).0;
                let partial = partial.map(|e| e.value);
                let metric = partial.transpose() * self.dynamics.m.map(|e| e.value) * &partial;
                (c.select_rows(&linear) * &partial, metric)
            }
        };
        let root = roots(&metric);
        let rows = c.row_iter().chain(gradient.row_iter()).map(|row| row.into_owned());
        let scaled = rows.map(|row| row.transpose().component_div(&root));
        // a row that the configuration satisfies is none
        let kept = scaled.filter(|row| row.norm() > 1e-9).map(|row| (&row / row.norm()).transpose());
        let matrix = DMatrix::from_rows(&kept.collect::<Vec<_>>());
        let entries = matrix.iter().chain(c.iter()).chain(gradient.iter()).fold(1.0_f64, |size, e| size.max(e.abs()));
        let growth = guards.iter().fold(1.0_f64, |growth, guard| growth.max(entries / guard.abs()));
        conditioned_rank(&matrix).1.max(growth)
    }

    /// The condition of a list at the state of the claim.
    pub(super) fn condition_of(&self, list: &[Chosen], guards: &[f64]) -> f64 {
        self.at_state(list, guards).condition
    }

    fn at_state(&self, list: &[Chosen], guards: &[f64]) -> Listed {
        let (claim, system) = (self.claim, self.system);
        let (t, q, w) = (Scaled::constant(claim.t), lift(&claim.state_coordinates), lift(&self.carriers()));
        let speeds = DVector::from_vec(system.listed(list, t, &q, &w));
        let column = |j: usize| system.listed(list, Dual::fixed(t), &fixed(&q), &seeded(&w, j));
        let columns: Vec<Vec<Dual<Scaled>>> = (0..w.len()).map(column).collect();
        let gradient = DMatrix::from_fn(list.len(), w.len(), |i, j| columns[j][i].rate.value);
        let rates_of_carriers = match system.model.configuration {
            None => lift(self.motion.acceleration.as_slice()),
            Some(_) => lift(self.motion.generalised.as_slice()),
        };
        let moving = along(&q, &lift(&claim.coordinate_rates));
        let rates = system.listed(list, Dual::moving(t, Scaled::one()), &moving, &along(&w, &rates_of_carriers));
        let condition = self.chart_condition(&gradient, guards);
        Listed { speeds, rates: DVector::from_iterator(list.len(), rates.iter().map(|u| u.rate)), gradient, condition }
    }
}
