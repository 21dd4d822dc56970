//! The start that the model names: numbers by which choices are judged, on the manifold f(x, t) = 0.
//!
//! A start is as good as a person can write it down: four digits of an angle do not close a loop. So f = 0 is closed first, by
//! Newton's method from there with changes of least norm. What is judged then is judged in a configuration that the mechanism
//! has: a pivot that vanishes there, or rows that depend on each other there, are found however roughly the start is given.

use super::carriers::Carriers;
use super::constraints::DifferentiatedRow;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// Below this fraction of its terms f counts as closed.
const CLOSED: f64 = 1e-10;

/// A row of ∂f/∂q that keeps less than this of its length beside the others leads nowhere.
const SPENT: f64 = 1e-10;

/// Steps of Newton's method, and halvings of one step.
const STEPS: usize = 100;
const HALVINGS: usize = 30;

/// How far values beside the start are from it, as a fraction of each, and of those that are zero.
const BESIDE: f64 = 0.02;
const LEAST: f64 = 1e-3;

/// Values of coordinates, speeds and parameters at t = 0, where the model names them.
#[derive(Clone, Debug)]
pub struct Start {
    values: BTreeMap<Symbol, f64>,
}

impl Start {
    /// The values of `start` and `nominal`, as they are written.
    pub fn of(system: &InitialSystem) -> Self {
        let mut values: BTreeMap<Symbol, f64> = system.start.iter().chain(&system.nominal).copied().collect();
        values.insert(system.time, 0.0);
        values.insert(system.graph.pi_symbol(), std::f64::consts::PI);
        Start { values }
    }

    /// Values near these, a little later: as many different ones as are asked for. Nothing of them is closed.
    pub fn beside(&self, system: &InitialSystem, at: usize) -> Self {
        let mut near = self.clone();
        for (place, (symbol, _)) in system.start.iter().enumerate() {
            let value = near.values.entry(*symbol).or_default();
            // the golden section spreads them between -1 and 1
            let drawn = 2.0 * (0.618_034 * ((place + 1) * at) as f64 + 0.37 * at as f64).fract() - 1.0;
            *value += drawn * (BESIDE * value.abs() + LEAST);
        }
        near.values.insert(system.time, LEAST * at as f64);
        near
    }

    /// Whether there is a value for everything that an expression depends on.
    pub fn knows(&self, graph: &Graph, e: Expr) -> bool {
        graph.symbols_of(&[e]).iter().all(|symbol| self.values.contains_key(symbol)) && graph.given_in(&[e]).is_empty()
    }

    /// The value of an expression, and the size of its terms.
    pub fn value(&self, graph: &Graph, e: Expr) -> (f64, f64) {
        self.all(graph, &[e])[0]
    }

    fn all(&self, graph: &Graph, expressions: &[Expr]) -> Vec<(f64, f64)> {
        graph.evaluate_scaled(expressions, &|symbol| self.values.get(&symbol).copied().unwrap_or(f64::NAN))
    }

    /// Closes f = 0. Where f depends on something that has no value nothing is moved.
    ///
    /// # Errors
    ///
    /// The rows that do not close, with what is left of each.
    pub fn close(
        &mut self,
        system: &InitialSystem,
        rows: &[DifferentiatedRow],
        carriers: &Carriers,
    ) -> Result<(), Vec<(usize, f64)>> {
        if system.start.is_empty() {
            return Ok(());
        }
        // Nothing of this enters the equations: all new expressions stay in a copy.
        let mut graph = system.graph.clone();
        let (places, residuals): (Vec<usize>, Vec<Expr>) =
            rows.iter().enumerate().filter_map(|(i, row)| Some((i, row.position?))).unzip();
        let residuals = graph.substitute(&residuals, &carriers.map);
        if residuals.iter().any(|f| !self.knows(&graph, *f)) {
            return Ok(());
        }
        let slopes = graph.jacobian(&residuals, &carriers.coordinates);
        let moved: Vec<Symbol> = carriers.coordinates.iter().copied().filter(|q| self.values.contains_key(q)).collect();
        let columns: Vec<usize> =
            moved.iter().filter_map(|q| carriers.coordinates.iter().position(|other| other == q)).collect();
        let mut f = self.all(&graph, &residuals);
        let scales: Vec<f64> = f.iter().map(|(_, size)| *size).collect();
        for _ in 0..STEPS {
            if merit(&f, &scales) == 0.0 {
                break;
            }
            let entries = self.all(&graph, slopes.entries());
            let entry = |i: usize, j: usize| entries[i * slopes.columns() + columns[j]].0;
            let matrix: Vec<Vec<f64>> =
                (0..residuals.len()).map(|i| (0..columns.len()).map(|j| entry(i, j)).collect()).collect();
            let step = least_change(&matrix, &f);
            let Some(next) = self.descend(&graph, &residuals, &moved, &step, (&f, &scales)) else { break };
            f = next;
        }
        let closed = |(value, size): &(f64, f64)| value.abs() <= CLOSED * size;
        let open = places.iter().zip(&f).filter(|(_, f)| !closed(f));
        let open: Vec<(usize, f64)> = open.map(|(row, (value, _))| (*row, *value)).collect();
        if open.is_empty() { Ok(()) } else { Err(open) }
    }

    /// Moves along a step as far as it makes f smaller; `None`, and nothing moved, where it does not.
    fn descend(
        &mut self,
        graph: &Graph,
        residuals: &[Expr],
        moved: &[Symbol],
        step: &[f64],
        (before, scales): (&[(f64, f64)], &[f64]),
    ) -> Option<Vec<(f64, f64)>> {
        let kept = self.values.clone();
        let mut part = 1.0;
        for _ in 0..HALVINGS {
            for (symbol, change) in moved.iter().zip(step) {
                self.values.insert(*symbol, kept[symbol] + part * change);
            }
            let f = self.all(graph, residuals);
            if merit(&f, scales) < merit(before, scales) {
                return Some(f);
            }
            part /= 2.0;
        }
        self.values = kept;
        None
    }
}

/// The square sum of f, each on its scale.
fn merit(f: &[(f64, f64)], scales: &[f64]) -> f64 {
    let part = |((value, _), scale): (&(f64, f64), &f64)| if *value == 0.0 { 0.0 } else { (value / scale).powi(2) };
    f.iter().zip(scales).map(part).sum()
}

/// The step of least norm with J dq = -f, over the rows of J that are independent.
fn least_change(jacobian: &[Vec<f64>], f: &[(f64, f64)]) -> Vec<f64> {
    let mut step = vec![0.0; jacobian.first().map_or(0, Vec::len)];
    let mut basis: Vec<(Vec<f64>, f64)> = Vec::new();
    for (row, (value, _)) in jacobian.iter().zip(f) {
        let (mut rest, mut right) = (row.clone(), -value);
        // Twice is enough.
        for _ in 0..2 {
            for (direction, part) in &basis {
                let along = dot(&rest, direction);
                rest.iter_mut().zip(direction).for_each(|(r, d)| *r -= along * d);
                right -= along * part;
            }
        }
        let (length, whole) = (dot(&rest, &rest).sqrt(), dot(row, row).sqrt());
        if length > SPENT * whole && length.is_finite() {
            basis.push((rest.iter().map(|r| r / length).collect(), right / length));
        }
    }
    for (direction, part) in &basis {
        step.iter_mut().zip(direction).for_each(|(s, d)| *s += part * d);
    }
    step
}

/// aᵀ b.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_change_meets_independent_rows() {
        let rows = [vec![1.0, 2.0, 2.0], vec![0.0, 1.0, -1.0], vec![1.0, 3.0, 1.0]];
        let step = least_change(&rows, &[(-9.0, 9.0), (2.0, 2.0), (-7.0, 7.0)]);
        assert!((dot(&rows[0], &step) - 9.0).abs() < 1e-14 && (dot(&rows[1], &step) + 2.0).abs() < 1e-14);
        // It lies in the space of the rows: nothing of it is across them.
        assert!(dot(&[-4.0, 1.0, 1.0], &step).abs() < 1e-14);
    }
}
