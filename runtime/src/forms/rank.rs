//! Rows that depend on each other, as errors that name them.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::null_space::{householder, scale_rows};
use super::{InitialEquations, NullSpace, NullSpaceMethod, dynamic_matrix};
use crate::{ConstrainedSystem, Error, GuardKind, Prepared, Vector};

/// A row takes part in a combination if its coefficient is above this, rows scaled to one size.
const PART: f64 = 1e-6;

impl InitialEquations {
    /// The smallest singular value of C relative to the largest, rows scaled to one size; [`Error::Dependent`] if it counts as
    /// zero ([`RANK_THRESHOLD`](super::RANK_THRESHOLD)).
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
    /// [`InitialEquations::check_rank`] at a state. The error also names the guard that is nearest to zero there, if the model
    /// has one that vanishes with the rank.
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
        let c = dynamic_matrix(&self.constraint_matrix(t, &x, &v));
        let guard = self.lost_guard(t, s);
        let null = match (NullSpace::new(&c, NullSpaceMethod::Svd), guard) {
            (Err(_), Some((guard, value))) => return Err(Error::ChartSingularity { guard, value, time: t }),
            (null, _) => null?,
        };
        let smallest = smallest(&null, c.nrows());
        if null.rank == c.nrows() {
            return Ok(smallest);
        }
        let part = |row: &usize| dependencies(&c, null.rank).iter().any(|combination| combination.contains(row));
        let rows = (0..c.nrows()).filter(part).map(|row| M::MODEL.rows[row].name).collect();
        Err(Error::Dependent { rows, value: smallest, guard: guard.map(|(name, _)| name), time: Some(t) })
    }

    /// The pivot that is nearest to zero, where one counts as zero.
    fn lost_guard(&self, t: f64, s: &M::State<f64>) -> Option<(&'static str, f64)> {
        let array: <M::Guards<f64> as Vector<f64>>::Array = self.guards(t, s).into();
        let pivots = M::MODEL.guards.iter().zip(array.as_ref()).filter(|(guard, _)| guard.kind == GuardKind::Pivot);
        let (guard, value) = pivots.min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))?;
        (value.abs() <= super::RANK_THRESHOLD || !value.is_finite()).then_some((guard.name, *value))
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
