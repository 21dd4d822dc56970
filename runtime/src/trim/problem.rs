//! The equations of a steady motion, solved.

use alloc::boxed::Box;
use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::TrimReport;
use super::wishes::Sorted;
use crate::assemble::newton::{Equations, STALLED, newton, worst};
use crate::assemble::{Met, entries};
use crate::manifold::{lift, term_sizes};
use crate::scalar::Measured;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Prepared, Scalar, Vector};

const PASSES: usize = 3;
/// No entry of the state and no input counts with less than this in the size of terms: a rate like −g sin a / l vanishes with a,
/// and so do its terms.
const LEAST: f64 = 1e-3;

/// r(y) = 0 for the free entries y of (s, i).
struct Steady<'a, M: ConstrainedSystem> {
    model: &'a Prepared<M>,
    dual: Prepared<M, Dual>,
    time: f64,
    sorted: Sorted,
    /// The places of the rows in `velocity_residual` that bind speeds of the state.
    nonlinear: Vec<usize>,
}

/// What was found: state, inputs, and how well all is met.
type Found<M> = (<M as ConstrainedSystem>::State<f64>, <M as ConstrainedSystem>::Inputs<f64>, TrimReport);

/// Moves the free entries until all is met.
pub(super) fn solve<M: ConstrainedSystem>(model: &Prepared<M>, time: f64, sorted: Sorted) -> Result<Found<M>, Error> {
    let nonlinear = M::MODEL.velocity_rows().enumerate().filter(|(_, row)| !row.linear).map(|(at, _)| at).collect();
    let steady = Steady { model, dual: lift(model)?, time, sorted, nonlinear };
    let mut y: Vec<f64> = steady.sorted.free.iter().map(|at| steady.sorted.values[*at]).collect();
    let (mut sizes, mut r) = (Vec::new(), Vec::new());
    for _ in 0..PASSES {
        // Far from the solution the terms are large, and so is their rounding: what counts is their size at the solution.
        sizes = steady.sizes(&y)?;
        r = newton(&steady, &mut y, &mut sizes);
    }
    let report = steady.report(&r, &sizes);
    let (row, ratio) = worst(&r, &sizes);
    if ratio > STALLED {
        let (constraints, rates) = (report.constraints.len(), report.rates.len());
        let (what, entry) = match row {
            row if row < constraints => ("the constraint", &report.constraints[row]),
            row if row < constraints + rates => ("the rate of", &report.rates[row - constraints]),
            row => ("the quantity", &report.quantities[row - constraints - rates]),
        };
        return Err(Error::NotSteady { what, name: entry.name, residual: entry.residual, report: Box::new(report) });
    }
    let (s, i) = steady.point(&y, |_, value| value);
    Ok((s, i, report))
}

impl<M: ConstrainedSystem> Steady<'_, M> {
    /// State and inputs, over any scalar.
    fn point<T: Scalar>(&self, y: &[f64], number: impl Fn(usize, f64) -> T) -> (M::State<T>, M::Inputs<T>) {
        let mut values = self.sorted.values.clone();
        self.sorted.free.iter().zip(y).for_each(|(at, value)| values[*at] = *value);
        let inputs = <M::State<f64> as Vector<f64>>::NAMES.len();
        (
            M::State::from_fn(|at| number(at, values[at])),
            M::Inputs::from_fn(|at| number(inputs + at, values[inputs + at])),
        )
    }

    /// f, φ, the rates and the other quantities, each less what it is to be.
    fn evaluate<T: Scalar>(&self, model: &Prepared<M, T>, s: &M::State<T>, i: &M::Inputs<T>) -> Vec<T> {
        let t = T::from_f64(self.time);
        let mut all = entries(&model.position_residual_at(t, s));
        if !self.nonlinear.is_empty() {
            let phi = entries(&model.velocity_residual_at(t, s));
            all.extend(self.nonlinear.iter().map(|at| phi[*at]));
        }
        let rate = entries(&model.derivative(t, s, i).0);
        all.extend(self.sorted.rates.iter().map(|(at, value)| rate[*at] - T::from_f64(*value)));
        let quantities = self.sorted.quantities.iter();
        all.extend(quantities.map(|(quantity, value)| quantity.value(model, t, s, i) - T::from_f64(*value)));
        all
    }

    /// The size of each equation's terms.
    fn sizes(&self, y: &[f64]) -> Result<Vec<f64>, Error> {
        let parameters = convert(self.model.parameters(), |_, value| Measured::given(value, 0.0));
        let measured: Prepared<M, Measured> = Prepared::with_parameters(self.model.system().clone(), parameters)?;
        let (s, i) = self.point(y, |_, value| Measured::given(value, LEAST));
        let known = |size: f64| if size.is_finite() { size } else { 0.0 };
        let mut sizes: Vec<f64> = self.evaluate(&measured, &s, &i).iter().map(|row| known(row.size)).collect();
        // Those of the constraints are measured as in all other places.
        let (t, (s, _)) = (self.time, self.point(y, |_, value| value));
        let (x, v) = (self.model.coordinates(t, &s), self.model.velocities(t, &s));
        let positions = term_sizes(self.model, t, &x, &v, &|model, t, x, _| model.position_residual(t, x))?;
        let velocities = term_sizes(self.model, t, &x, &v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
        let constraints = positions.into_iter().chain(self.nonlinear.iter().map(|at| velocities[*at]));
        sizes.iter_mut().zip(constraints).for_each(|(size, own)| *size = own);
        Ok(sizes)
    }

    fn report(&self, r: &[f64], sizes: &[f64]) -> TrimReport {
        let state = <M::State<f64> as Vector<f64>>::NAMES;
        let mut all = r.iter().zip(sizes).map(|(residual, size)| {
            let met = worst(&[*residual], &[*size]).1 <= STALLED;
            move |name| Met { name, residual: *residual, size: *size, met }
        });
        let rows: Vec<_> = M::MODEL.velocity_rows().collect();
        let constraints = M::MODEL.position_rows.iter().copied().chain(self.nonlinear.iter().map(|at| rows[*at].name));
        let mut met =
            |names: Vec<&'static str>| names.into_iter().zip(&mut all).map(|(name, entry)| entry(name)).collect();
        TrimReport {
            constraints: met(constraints.collect()),
            rates: met(self.sorted.rates.iter().map(|(at, _)| state[*at]).collect()),
            quantities: met(self.sorted.quantities.iter().map(|(quantity, _)| quantity.name::<M>()).collect()),
        }
    }
}

impl<M: ConstrainedSystem> Equations for Steady<'_, M> {
    fn residual(&self, y: &[f64]) -> Vec<f64> {
        let (s, i) = self.point(y, |_, value| value);
        self.evaluate(self.model, &s, &i)
    }

    fn jacobian(&self, y: &[f64]) -> DMatrix<f64> {
        let column = |seed: usize| {
            let (s, i) = self.point(y, |at, value| Dual::new(value, if at == seed { 1.0 } else { 0.0 }));
            self.evaluate(&self.dual, &s, &i)
        };
        let columns: Vec<Vec<Dual>> = self.sorted.free.iter().map(|at| column(*at)).collect();
        let constraints = M::MODEL.position_rows.len() + self.nonlinear.len();
        let rows = constraints + self.sorted.rates.len() + self.sorted.quantities.len();
        DMatrix::from_fn(rows, columns.len(), |i, j| columns[j][i].derivative)
    }

    fn measure(&self, y: &[f64]) -> DMatrix<f64> {
        DMatrix::identity(y.len(), y.len())
    }
}
