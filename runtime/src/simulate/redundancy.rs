//! Rows that are marked redundant, looked at again in a run: whether they still follow from the others.
//!
//! The derive finds that a row depends on others at the start that the model names, and beside it. That is a statement about nominal
//! parameters and one branch of the mechanism: with other lengths Bricard's six hinges hold each other fast. A run that went on would
//! move by the rows that are kept and be pulled back by the others, and nothing would be right.

use alloc::vec::Vec;

use super::equations::Equations;
use crate::manifold::DEPENDENT;
use crate::{ConstrainedSystem, Error, Prepared};

/// The rows of a model of which some are marked.
pub(super) struct Redundancy<M: ConstrainedSystem> {
    equations: Equations<M>,
}

impl<M: ConstrainedSystem> Redundancy<M> {
    /// `None` where no row is marked.
    pub(super) fn new(model: &Prepared<M>) -> Result<Option<Self>, Error> {
        let marked = M::MODEL.rows.iter().any(|row| row.redundant);
        Ok(if marked { Some(Redundancy { equations: Equations::new(model)? }) } else { None })
    }

    /// Whether all marked rows say what the others say, at a state that satisfies them all.
    ///
    /// Their gradients must lie in what the others span. That is not enough where rows that contradict each other touch: bars of
    /// different lengths side by side are fast, and may still have velocities. There the accelerations of the others do not fit. Near a
    /// loss of rank these are known less exactly than the gradients, by the square of the smallest pivot.
    pub(super) fn check(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        (s, v): (&M::State<f64>, &M::Velocities<f64>),
        inputs: &M::Inputs<f64>,
    ) -> Result<(), Error> {
        let w = self.equations.carriers(model, t, s, v);
        // Where there is no solution others have the word.
        if self.equations.solve(model, t, s, &w, inputs, None).is_err() {
            return Ok(());
        }
        let pivot = self.equations.smallest_pivot();
        let sure = pivot * pivot;
        let part = |(row, sine): (usize, f64)| (row, sine.max(sure * self.equations.missed(row)));
        let left: Vec<(usize, f64)> =
            self.equations.left_out().map(part).filter(|(_, part)| *part > DEPENDENT).collect();
        let Some(value) = left.iter().map(|(_, part)| *part).reduce(f64::max) else { return Ok(()) };
        // Which row is one too many is no property of it: where it is one that is not marked, all that are marked may be meant.
        let named = left.iter().all(|(row, _)| M::MODEL.rows[*row].redundant);
        let counts = |row: usize| !named || left.iter().any(|(at, _)| *at == row);
        let marked = M::MODEL.rows.iter().enumerate().filter(|(at, row)| row.redundant && counts(*at));
        Err(Error::NotRedundant { rows: marked.map(|(_, row)| row.name).collect(), value, time: t })
    }
}
