//! Reactions of the constraints, by name.

use core::fmt;

use crate::{ConstrainedSystem, Matrix, Scalar, Vector};

/// The generalised forces that the constraints exert, in the base of the velocities v; made by
/// [`Prepared::reactions`](crate::Prepared::reactions).
#[derive(Clone)]
pub struct Reactions<M: ConstrainedSystem, T: Scalar = f64> {
    matrix: M::ConstraintMatrix<T>,
    multipliers: M::Multipliers<T>,
}

impl<M: ConstrainedSystem, T: Scalar> Reactions<M, T> {
    pub(super) fn new(matrix: M::ConstraintMatrix<T>, multipliers: M::Multipliers<T>) -> Self {
        Reactions { matrix, multipliers }
    }

    /// The reaction of one constraint, r_i* = C_iᵀ λ_i (3.7); `None` if no row of C carries that name.
    pub fn get(&self, name: &str) -> Option<M::Velocities<T>> {
        let at = M::MODEL.multipliers.iter().position(|entry| entry.name == name)?;
        self.reaction(at)
    }

    /// All constraints that a row of C carries, with their reactions. Names that were merged into one row share its reaction.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, M::Velocities<T>)> + '_ {
        M::MODEL.multipliers.iter().enumerate().filter_map(|(at, entry)| Some((entry.name, self.reaction(at)?)))
    }

    /// The sum over the rows: Cᵀ λ.
    pub fn total(&self) -> M::Velocities<T> {
        let rows = <M::ConstraintMatrix<T> as Matrix<T>>::ROWS;
        M::Velocities::from_fn(|column| {
            (0..rows).fold(T::default(), |sum, row| {
                let carrier = M::MODEL.multipliers.iter().position(|entry| entry.row == Some(row));
                match carrier.and_then(|at| self.multiplier(at)) {
                    Some(multiplier) => sum + self.matrix.entry(row, column) * multiplier,
                    None => sum,
                }
            })
        })
    }

    fn reaction(&self, at: usize) -> Option<M::Velocities<T>> {
        let row = M::MODEL.multipliers[at].row?;
        let multiplier = self.multiplier(at)?;
        Some(M::Velocities::from_fn(|column| self.matrix.entry(row, column) * multiplier))
    }

    fn multiplier(&self, at: usize) -> Option<T> {
        let array: <M::Multipliers<T> as Vector<T>>::Array = self.multipliers.into();
        array.as_ref().get(at).copied()
    }
}

impl<M: ConstrainedSystem, T: Scalar> fmt::Debug for Reactions<M, T> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_map().entries(self.iter()).finish()
    }
}
