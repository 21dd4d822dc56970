//! How far the unknowns reach that do not turn: the lengths of the mechanism, as its equations tell them.

use alloc::vec::Vec;

use super::{Range, Space};
use crate::assemble::newton::Equations;
use crate::assemble::problem::Level;
use crate::{ConstrainedSystem, Error};

/// How often a reach is estimated at most, …
const STEPS: usize = 100;
/// … each time at this part of the one before, …
const PART: f64 = 0.1;
/// … as long as it falls to less than this fraction of it.
const FALLS: f64 = 0.7;

impl Space {
    /// Finds the reaches.
    ///
    /// What changes an equation by the size of its terms is as large as the others of its terms allow: |x| + l for x = l cos a;
    /// and about |x| + l²/(2 |x|) for x² = l², which comes to about l if it is repeated at a part of it. The least is taken: all
    /// equations must hold, and far away all terms are large.
    ///
    /// Nothing but the guess tells the unit of a length, and where that is next to zero the first figures are far too large. So
    /// each coordinate is moved from there, the others stay.
    pub(super) fn find_reaches<M: ConstrainedSystem>(&mut self, level: &Level<'_, '_, M>) -> Result<(), Error> {
        let lengths: Vec<usize> = self.coordinates(level).filter(|j| !self.ranges[*j].turning).collect();
        for j in lengths {
            let rows = told_by::<M>(&ratios(level, &self.start(1), j)?);
            let mut point = self.guess.clone();
            let mut reach = f64::INFINITY;
            for step in 0..STEPS {
                let told = ratios(level, &point, j)?.into_iter().take(rows).flatten().fold(f64::INFINITY, f64::min);
                if told < FALLS * reach {
                    reach = told;
                    point[j] = self.guess[j] + PART * told;
                } else if step == 0 {
                    // Where it is zero, squares tell nothing.
                    point[j] = self.guess[j] + 1.0;
                } else {
                    break;
                }
            }
            if reach.is_finite() {
                // Both signs of a length are within what is drawn.
                let drawn = reach + self.guess[j].abs();
                self.ranges[j] = Range { drawn, reach, ..self.ranges[j] };
            }
        }
        Ok(())
    }
}

/// The ratio of each equation's size to its slope along an unknown, where there is one.
fn ratios<M: ConstrainedSystem>(level: &Level<'_, '_, M>, point: &[f64], j: usize) -> Result<Vec<Option<f64>>, Error> {
    let (slopes, sizes) = (level.jacobian(point), level.sizes(point)?);
    let ratio = |(i, size): (usize, &f64)| Some(size / slopes[(i, j)].abs());
    let known = |ratio: &f64| ratio.is_finite() && *ratio > 0.0;
    Ok(sizes.iter().enumerate().map(|row| ratio(row).filter(known)).collect())
}

/// How many of the equations, from the first on, are to tell a reach: the constraints, where one does. Of other quantities the terms
/// are not known: one that is to vanish has the size of its own value, and tells no more than where it was looked at.
fn told_by<M: ConstrainedSystem>(ratios: &[Option<f64>]) -> usize {
    let constraints = M::MODEL.position_rows.len();
    if ratios.iter().take(constraints).any(Option::is_some) { constraints } else { ratios.len() }
}
