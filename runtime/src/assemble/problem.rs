//! The equations of an assembly: for the coordinates first, then for the speeds.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::conditions::{Meeting, Sorted, entries, seeded};
use super::metric::kinetic_metric;
use super::newton::{Equations, STALLED, newton, worst};
use super::report::{AssemblyReport, Met};
use crate::manifold::{lift, term_sizes};
use crate::{ConstrainedSystem, Dual, Error, Prepared, Vector};

const PASSES: usize = 3;
/// A fixed entry is in the way if the residual falls along it by this fraction of what it could at most.
const CONFLICT: f64 = 1e-6;

/// An assembly at work.
pub(super) struct Problem<'a, M: ConstrainedSystem> {
    model: &'a Prepared<M>,
    time: f64,
    state: Vec<f64>,
    parameters: Vec<f64>,
    sorted: Sorted<M>,
    mass_weighted: bool,
}

/// An unknown of the equations.
#[derive(Copy, Clone, PartialEq)]
pub(super) enum Unknown {
    State(usize),
    Parameter(usize),
}

/// What is solved at one level.
pub(super) struct Level<'a, 'b, M: ConstrainedSystem> {
    problem: &'a Problem<'b, M>,
    dual: Prepared<M, Dual>,
    pub(super) unknowns: Vec<Unknown>,
    /// The entries of the state that this level would move, were they not fixed.
    fixed: Vec<usize>,
    rows: Rows,
    names: Vec<&'static str>,
    meetings: &'a [Meeting<M>],
}

/// The constraints of a level.
enum Rows {
    Positions,
    /// Places in `velocity_residual`.
    Velocities(Vec<usize>),
}

impl<'b, M: ConstrainedSystem> Problem<'b, M> {
    pub(super) fn new(
        model: &'b Prepared<M>,
        time: f64,
        sorted: Sorted<M>,
        mass_weighted: bool,
    ) -> Result<Self, Error> {
        let (state, parameters) = (sorted.state.clone(), entries(model.parameters()));
        Ok(Problem { model, time, state, parameters, sorted, mass_weighted })
    }

    pub(super) fn state(&self) -> M::State<f64> {
        M::State::from_fn(|i| self.state[i])
    }

    pub(super) fn parameters(&self) -> M::Parameters<f64> {
        M::Parameters::from_fn(|i| self.parameters[i])
    }

    /// Moves the coordinates, and the parameters that may change.
    pub(super) fn solve_positions(&mut self) -> Result<AssemblyReport, Error> {
        let level = self.positions()?;
        let mut y = level.guess();
        let report = level.close(&mut y)?;
        let (state, parameters) = level.point(&y);
        drop(level);
        self.move_to(state, parameters);
        Ok(report)
    }

    /// The equations for the coordinates, and for the parameters that may change.
    pub(super) fn positions(&self) -> Result<Level<'_, 'b, M>, Error> {
        let coordinates = 0..M::MODEL.state_coordinates.len();
        let names = M::MODEL.position_rows.to_vec();
        self.level(coordinates, true, Rows::Positions, names)
    }

    /// Goes on from another state and other parameters.
    pub(super) fn move_to(&mut self, state: Vec<f64>, parameters: Vec<f64>) {
        (self.state, self.parameters) = (state, parameters);
    }

    /// Moves the speeds, where something binds them.
    pub(super) fn solve_velocities(&mut self) -> Result<AssemblyReport, Error> {
        let nonlinear = M::MODEL.velocity_rows().enumerate().filter(|(_, row)| !row.linear);
        let (rows, names): (Vec<usize>, Vec<&'static str>) = nonlinear.map(|(at, row)| (at, row.name)).unzip();
        let speeds = M::MODEL.state_coordinates.len()..self.state.len();
        if rows.is_empty() && self.sorted.velocities.is_empty() {
            return Ok(AssemblyReport::default());
        }
        let (t, s) = (self.time, self.state());
        if entries(&self.model.velocities(t, &s)).iter().any(|v| !v.is_finite())
            && let Some((guard, value)) = self.model.lost_guard(t, &s, &[])
        {
            return Err(Error::ChartSingularity { guard, value, time: t });
        }
        let level = self.level(speeds, false, Rows::Velocities(rows), names)?;
        let mut y = level.guess();
        let report = level.close(&mut y)?;
        let (state, parameters) = level.point(&y);
        drop(level);
        self.move_to(state, parameters);
        Ok(report)
    }

    fn level(
        &self,
        range: core::ops::Range<usize>,
        with_parameters: bool,
        rows: Rows,
        mut names: Vec<&'static str>,
    ) -> Result<Level<'_, 'b, M>, Error> {
        let meetings = if with_parameters { &self.sorted.positions } else { &self.sorted.velocities };
        names.extend(meetings.iter().map(|meeting| meeting.name));
        let (fixed, free): (Vec<usize>, Vec<usize>) = range.partition(|at| self.sorted.fixed[*at]);
        let mut unknowns: Vec<Unknown> = free.into_iter().map(Unknown::State).collect();
        if with_parameters {
            unknowns.extend(self.sorted.parameters.iter().copied().map(Unknown::Parameter));
        }
        let given = self.parameters();
        let dual = Prepared::with_parameters(
            self.model.system().clone(),
            seeded::<M::Parameters<f64>, _>(&entries(&given), None),
        )?;
        Ok(Level { problem: self, dual, unknowns, fixed, rows, names, meetings })
    }
}

impl<M: ConstrainedSystem> Level<'_, '_, M> {
    /// Moves y until all is met; y is the nearest point found where that fails.
    pub(super) fn close(&self, y: &mut Vec<f64>) -> Result<AssemblyReport, Error> {
        let mut sizes = Vec::new();
        let mut r = Vec::new();
        for _ in 0..PASSES {
            // Far from the solution the terms are large, and so is their rounding: what counts is their size at the solution.
            sizes = self.sizes(y)?;
            r = newton(self, y, &mut sizes);
        }
        let report = self.report(y, &r, &sizes);
        let (row, ratio) = worst(&r, &sizes);
        if ratio > STALLED {
            return Err(Error::Assembly { constraint: self.names[row], residual: r[row], report: Box::new(report) });
        }
        Ok(report)
    }

    /// The unknowns as they are given.
    pub(super) fn guess(&self) -> Vec<f64> {
        self.unknowns.iter().map(|unknown| self.given(*unknown)).collect()
    }

    fn given(&self, unknown: Unknown) -> f64 {
        match unknown {
            Unknown::State(at) => self.problem.state[at],
            Unknown::Parameter(at) => self.problem.parameters[at],
        }
    }

    /// The state and the parameters of y.
    pub(super) fn point(&self, y: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut state, mut parameters) = (self.problem.state.clone(), self.problem.parameters.clone());
        for (unknown, value) in self.unknowns.iter().zip(y) {
            match unknown {
                Unknown::State(at) => state[*at] = *value,
                Unknown::Parameter(at) => parameters[*at] = *value,
            }
        }
        (state, parameters)
    }

    /// All equations and their derivatives along one unknown; `None` where the model refuses the parameters.
    fn evaluate(&self, y: &[f64], seed: Option<Unknown>) -> Option<Vec<Dual>> {
        let (state, parameters) = self.point(y);
        let (along_state, along_parameter) = match seed {
            Some(Unknown::State(at)) => (Some(at), None),
            Some(Unknown::Parameter(at)) => (None, Some(at)),
            None => (None, None),
        };
        let changed;
        let model = if self.unknowns.iter().any(|unknown| matches!(unknown, Unknown::Parameter(_))) {
            let parameters = seeded::<M::Parameters<f64>, _>(&parameters, along_parameter);
            changed = Prepared::with_parameters(self.problem.model.system().clone(), parameters).ok()?;
            &changed
        } else {
            &self.dual
        };
        let (t, s) = (Dual::constant(self.problem.time), seeded::<M::State<f64>, M::State<Dual>>(&state, along_state));
        let mut all = match &self.rows {
            Rows::Positions => entries(&model.position_residual_at(t, &s)),
            Rows::Velocities(places) if places.is_empty() => Vec::new(),
            Rows::Velocities(places) => {
                let residuals = entries(&model.velocity_residual_at(t, &s));
                places.iter().map(|at| residuals[*at]).collect()
            }
        };
        all.extend(self.meetings.iter().map(|wanted| (wanted.quantity)(model, t, &s) - Dual::constant(wanted.value)));
        Some(all)
    }

    /// ∂r along some of the entries.
    fn derivatives(&self, y: &[f64], along: impl Iterator<Item = Unknown>) -> Vec<Vec<f64>> {
        let lost = || vec![f64::NAN; self.names.len()];
        let column = |seed| match self.evaluate(y, Some(seed)) {
            Some(column) => column.iter().map(|entry| entry.derivative).collect(),
            None => lost(),
        };
        along.map(column).collect()
    }

    /// The size of each equation's terms.
    pub(super) fn sizes(&self, y: &[f64]) -> Result<Vec<f64>, Error> {
        let (state, parameters) = self.point(y);
        let parameters = M::Parameters::from_fn(|i| parameters[i]);
        let model = Prepared::with_parameters(self.problem.model.system().clone(), parameters)?;
        let (t, s) = (self.problem.time, M::State::from_fn(|i| state[i]));
        let (x, v) = (model.coordinates(t, &s), model.velocities(t, &s));
        let mut sizes = match &self.rows {
            Rows::Positions => term_sizes(&model, t, &x, &v, &|model, t, x, _| model.position_residual(t, x))?,
            Rows::Velocities(places) => {
                let sizes = term_sizes(&model, t, &x, &v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
                places.iter().map(|at| sizes[*at]).collect()
            }
        };
        let dual = lift(&model)?;
        let s = seeded::<M::State<f64>, M::State<Dual>>(&state, None);
        let own = self.meetings.iter().map(|wanted| {
            let quantity = (wanted.quantity)(&dual, Dual::constant(t), &s).value;
            wanted.value.abs() + if quantity.is_finite() { quantity.abs() } else { 0.0 }
        });
        sizes.extend(own);
        Ok(sizes)
    }

    fn report(&self, y: &[f64], r: &[f64], sizes: &[f64]) -> AssemblyReport {
        let entry = |(i, name): (usize, &&'static str)| {
            let met = worst(&r[i..=i], &sizes[i..=i]).1 <= STALLED;
            Met { name, residual: r[i], size: sizes[i], met }
        };
        let entries: Vec<Met> = self.names.iter().enumerate().map(entry).collect();
        let mut conflicts = Vec::new();
        if entries.iter().any(|entry| !entry.met) {
            // Where the free entries can do no more, the residual still falls along the fixed ones that are in the way.
            let scaled = |i: usize| if sizes[i] > 0.0 { 1.0 / sizes[i] } else { 1.0 };
            let columns = self.derivatives(y, self.fixed.iter().copied().map(Unknown::State));
            for (at, column) in self.fixed.iter().zip(columns) {
                let (mut along, mut most) = (0.0, 0.0);
                for (i, slope) in column.iter().enumerate() {
                    let product = slope * r[i] * scaled(i) * scaled(i);
                    along += product;
                    most += product.abs();
                }
                if along.abs() > CONFLICT * most {
                    conflicts.push(<M::State<f64> as Vector<f64>>::NAMES[*at]);
                }
            }
            let wanted = entries.iter().skip(self.names.len() - self.meetings.len());
            conflicts.extend(wanted.filter(|entry| !entry.met).map(|entry| entry.name));
        }
        AssemblyReport { entries, conflicts }
    }
}

impl<M: ConstrainedSystem> Equations for Level<'_, '_, M> {
    fn residual(&self, y: &[f64]) -> Vec<f64> {
        match self.evaluate(y, None) {
            Some(all) => all.iter().map(|entry| entry.value).collect(),
            None => vec![f64::NAN; self.names.len()],
        }
    }

    fn jacobian(&self, y: &[f64]) -> DMatrix<f64> {
        let columns = self.derivatives(y, self.unknowns.iter().copied());
        DMatrix::from_fn(self.names.len(), columns.len(), |i, j| columns[j][i])
    }

    fn measure(&self, y: &[f64]) -> DMatrix<f64> {
        let scale = |unknown: &Unknown| match unknown {
            Unknown::Parameter(_) => match self.given(*unknown).abs() {
                0.0 => 1.0,
                size => size,
            },
            Unknown::State(_) => 1.0,
        };
        let scales: Vec<f64> = self.unknowns.iter().map(scale).collect();
        let mut measure = DMatrix::from_diagonal(&scales.into());
        if self.problem.mass_weighted {
            let (state, _) = self.point(y);
            let free = self.unknowns.iter().filter_map(|unknown| match unknown {
                Unknown::State(at) => Some(*at),
                Unknown::Parameter(_) => None,
            });
            let free: Vec<usize> = free.collect();
            let metric = kinetic_metric(self.problem.model, &self.dual, self.problem.time, &state, &free);
            // M = L Lᵀ: the shortest z of L⁻ᵀ z is the change of least kinetic energy.
            if let Some(inverse) = metric.and_then(|metric| metric.cholesky()).and_then(|l| l.l().try_inverse()) {
                measure.view_mut((0, 0), (free.len(), free.len())).copy_from(&inverse.transpose());
            }
        }
        measure
    }
}
