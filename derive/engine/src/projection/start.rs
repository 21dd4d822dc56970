//! The start that the model names: numbers by which choices are judged, on the manifold f(x, t) = 0.
//!
//! A start is as good as a person can write it down: four digits of an angle do not close a loop. So f = 0 is closed first, by
//! Newton's method from there with changes of least norm, and where that ends elsewhere, by damped ones. What is judged then is
//! judged in a configuration that the mechanism has: a pivot that vanishes there, or rows that depend on each other there, are found
//! however roughly the start is given.

use super::carriers::Carriers;
use super::closing::{Loops, merit};
use super::constraints::DifferentiatedRow;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// How far values beside the start are from it, as a fraction of each, and of those that are zero.
const BESIDE: f64 = 0.02;
const LEAST: f64 = 1e-3;

/// Values of coordinates, speeds and parameters at t = 0, where the model names them.
#[derive(Clone, Debug)]
pub struct Start {
    pub(super) values: BTreeMap<Symbol, f64>,
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

    /// The values of several, each with the size of its terms.
    pub(super) fn all(&self, graph: &Graph, expressions: &[Expr]) -> Vec<(f64, f64)> {
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
        let loops = Loops::of(self, &graph, &residuals, &slopes, (&moved, &columns));
        let given = self.clone();
        let mut f = loops.by_newton(self);
        if loops.open(&f).next().is_some() {
            let reached = std::mem::replace(self, given);
            let damped = loops.by_damped_steps(self);
            // what is told is how near it came
            if merit(&damped, &loops.scales) < merit(&f, &loops.scales) {
                f = damped;
            } else {
                *self = reached;
            }
        }
        let open: Vec<(usize, f64)> = loops.open(&f).map(|i| (places[i], f[i].0)).collect();
        if open.is_empty() { Ok(()) } else { Err(open) }
    }
}

/// aᵀ b.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
