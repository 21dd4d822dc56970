//! Rows that depend on each other, as errors that name them.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::null_space::{householder, scale_rows};
use super::{InitialEquations, NullSpace, NullSpaceMethod, RANK_THRESHOLD, dynamic_matrix};
use crate::{ConstrainedSystem, Error, GuardInfo, Prepared, Vector};

/// A row takes part in a combination if its coefficient is above this, rows scaled to one size.
const PART: f64 = 1e-6;

impl InitialEquations {
    /// The smallest singular value of C relative to the largest, rows scaled to one size; [`Error::Dependent`] if it counts as
    /// zero ([`RANK_THRESHOLD`]).
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumVelocities};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let v = PendulumVelocities::default();
    /// assert_eq!(pendulum.initial_equations(0.0, &[0.3, -0.4], &v, &[]).check_rank()?, 1.0);
    /// // At the point where the rod is fixed, its direction is lost.
    /// let error = pendulum.initial_equations(0.0, &[0.0, 0.0], &v, &[]).check_rank().unwrap_err();
    /// assert!(error.to_string().contains("`rod`"));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn check_rank(&self) -> Result<f64, Error> {
        let null = NullSpace::new(&self.constraint_matrix, NullSpaceMethod::Svd)?;
        let smallest = smallest(&null, self.rows.len());
        if null.rank < self.rows.len() { Err(self.dependent(&null)) } else { Ok(smallest) }
    }

    /// The same system with as many rows as are independent, the best ones, in their order: for the forms that need independent
    /// rows, where a model has redundant ones. Their λ are those of a system without the others.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumVelocities};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let v = PendulumVelocities::default();
    /// assert_eq!(pendulum.initial_equations(0.0, &[0.3, -0.4], &v, &[]).independent_rows()?.rows, ["rod"]);
    /// assert!(pendulum.initial_equations(0.0, &[0.0, 0.0], &v, &[]).independent_rows()?.rows.is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn independent_rows(&self) -> Result<Self, Error> {
        if self.constraint_matrix.iter().any(|entry| !entry.is_finite()) {
            return Err(Error::NonFinite { name: "C" });
        }
        let (scaled, _) = scale_rows(&self.constraint_matrix);
        let factors = householder(scaled.transpose(), RANK_THRESHOLD, self.rows.len());
        let mut picked = factors.order[..factors.rank].to_vec();
        picked.sort_unstable();
        Ok(self.with_picked_rows(&picked))
    }

    /// What made a matrix singular: rows that depend on each other, if any do.
    pub(super) fn explain(&self, error: Error) -> Error {
        match (&error, self.check_rank()) {
            (Error::SingularMatrix { .. }, Err(dependent)) => dependent,
            _ => error,
        }
    }

    fn dependent(&self, null: &NullSpace) -> Error {
        Error::Dependent {
            rows: self.names(&dependencies(&self.constraint_matrix, null.rank)),
            value: smallest(null, self.rows.len()),
            guard: None,
            time: None,
        }
    }

    /// The names of the rows that take part in combinations.
    pub(super) fn names(&self, combinations: &[Vec<usize>]) -> Vec<&'static str> {
        let part = |row: &usize| combinations.iter().any(|combination| combination.contains(row));
        (0..self.rows.len()).filter(part).map(|row| self.rows[row]).collect()
    }
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// [`InitialEquations::check_rank`] at a state. The error also names the guard that vanishes with the rank, if the
    /// model has one: formulas that need no division by it go on.
    ///
    /// Rows that the model has marked `redundant` do not count.
    ///
    /// A guard that vanishes while the rank is full tells of a chart that ends; other speeds go on.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// // The chart ends where the rod is level, the constraint does not.
    /// assert!(pendulum.check_rank(0.0, &PendulumState { x: 0.5, y: 0.0, dot_x: 0.0 }).is_ok());
    /// let error = pendulum.check_rank(0.0, &PendulumState::default()).unwrap_err();
    /// assert_eq!(error, Error::Dependent { rows: vec!["rod"], value: 0.0, guard: Some("y"), time: Some(0.0) });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn check_rank(&self, t: f64, s: &M::State<f64>) -> Result<f64, Error> {
        let (x, v) = (self.coordinates(t, s), self.velocities(t, s));
        let all = dynamic_matrix(&self.constraint_matrix(t, &x, &v));
        let kept: Vec<usize> = (0..all.nrows()).filter(|row| !M::MODEL.rows[*row].redundant).collect();
        let c = all.select_rows(&kept);
        let null = match (NullSpace::new(&c, NullSpaceMethod::Svd), self.lost_guard(t, s, &[])) {
            (Err(_), Some((guard, value))) => return Err(Error::ChartSingularity { guard, value, time: t }),
            (null, _) => null?,
        };
        let smallest = smallest(&null, c.nrows());
        if null.rank == c.nrows() {
            return Ok(smallest);
        }
        let combinations = dependencies(&c, null.rank);
        let part = |row: &usize| combinations.iter().any(|combination| combination.contains(row));
        let rows: Vec<&'static str> = (0..c.nrows()).filter(part).map(|row| M::MODEL.rows[kept[row]].name).collect();
        let guard = self.lost_guard(t, s, &rows).map(|(name, _)| name);
        Err(Error::Dependent { rows, value: smallest, guard, time: Some(t) })
    }

    /// The guard that is nearest to zero, where one counts as zero: of those that come from one of the rows, if any does.
    pub(crate) fn lost_guard(&self, t: f64, s: &M::State<f64>, rows: &[&str]) -> Option<(&'static str, f64)> {
        let array: <M::Guards<f64> as Vector<f64>>::Array = self.guards(t, s).into();
        let lost = |value: &f64| value.abs() <= RANK_THRESHOLD || !value.is_finite();
        let guards = M::MODEL.guards.iter().zip(array.as_ref()).filter(|(_, value)| lost(value));
        let (guard, value) = guards.min_by(|(a, x), (b, y)| {
            let apart = |guard: &GuardInfo| !guard.rows.iter().any(|row| rows.contains(row));
            apart(a).cmp(&apart(b)).then(x.abs().total_cmp(&y.abs()))
        })?;
        Some((guard.name, *value))
    }
}

/// The last figure; 1 without rows, and zero where there are more rows than velocities.
fn smallest(null: &NullSpace, rows: usize) -> f64 {
    match null.figures.last() {
        Some(figure) if null.figures.len() == rows => *figure,
        None if rows == 0 => 1.0,
        _ => 0.0,
    }
}

/// For each row beyond the rank the rows of the combination that vanishes: itself and those that give it.
pub(super) fn dependencies(c: &DMatrix<f64>, rank: usize) -> Vec<Vec<usize>> {
    let (scaled, _) = scale_rows(c);
    let factors = householder(scaled.transpose(), 0.0, rank);
    let rank = factors.rank;
    let others = factors.r.view((0, rank), (rank, c.nrows() - rank)).into_owned();
    let coefficients = factors.solve(&others);
    (0..c.nrows() - rank)
        .map(|at| {
            let parts = (0..rank).filter(|i| coefficients[(*i, at)].abs() > PART);
            let mut rows: Vec<usize> = parts.chain([rank + at]).map(|place| factors.order[place]).collect();
            rows.sort_unstable();
            rows
        })
        .collect()
}
