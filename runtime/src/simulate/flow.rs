//! What a run integrates: a rate over points of a fixed dimension, whatever coordinates these points are.

use super::charts::Chart;
use super::readings::Residuals;
use crate::{ConstrainedSystem, Error};

/// A point y of a flow: the state of an emitted chart, or the coordinates and carriers of the general chart.
pub(super) trait Point: Copy {
    /// The number of entries.
    fn len(&self) -> usize;
    /// Entry i.
    fn get(&self, i: usize) -> f64;
    /// Entry i, to be set.
    fn get_mut(&mut self, i: usize) -> &mut f64;

    /// Whether all entries are finite.
    fn is_finite(&self) -> bool {
        (0..self.len()).all(|i| self.get(i).is_finite())
    }
}

impl<A: AsRef<[f64]> + AsMut<[f64]> + Copy> Point for A {
    #[inline(always)]
    fn len(&self) -> usize {
        self.as_ref().len()
    }
    #[inline(always)]
    fn get(&self, i: usize) -> f64 {
        self.as_ref()[i]
    }
    #[inline(always)]
    fn get_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.as_mut()[i]
    }
}

/// ẏ = rate(t, y) with what a run asks about a point: its guards, the way back onto the constraints, the state that it stands for.
pub(super) trait Flow<M: ConstrainedSystem> {
    type Point: Point;
    /// What tells whether a point is a regular one; comes with the rate.
    type Guards: Copy;

    /// ẏ and the guards.
    fn rate(&mut self, t: f64, y: &Self::Point) -> (Self::Point, Self::Guards);

    /// Judges the guards of a point between two accepted ones.
    fn judge_stage(&self, t: f64, guards: &Self::Guards) -> Result<(), Error>;

    /// Judges the guards of a point that is to be accepted, and remembers them.
    fn judge(&mut self, t: f64, guards: &Self::Guards) -> Result<(), Error>;

    /// Judges a point that is to be accepted by what lies between it and the one before: a loss of rank that no figure shows.
    fn passed(&mut self, t: f64, y: &Self::Point) -> Result<(), Error>;

    /// Brings a point back onto the constraints, and tells whether it was moved.
    fn restore(&mut self, t: f64, y: &mut Self::Point) -> Result<bool, Error>;

    /// What remained of the constraints at the last point that was restored.
    fn residuals(&self) -> Residuals;

    /// The state that the point stands for, in the speeds of the first chart, and v.
    fn view(&self, t: f64, y: &Self::Point) -> (M::State<f64>, M::Velocities<f64>);

    /// The chart of these points.
    fn chart(&self) -> Chart;

    /// Whether the run is to go on in another chart.
    fn leaves(&mut self, t: f64, y: &Self::Point, guards: &Self::Guards) -> bool;

    /// Whether the run comes so near to a loss of rank that it is to look for a passage.
    fn nears(&mut self, t: f64, y: &Self::Point, guards: &Self::Guards) -> bool;

    /// The factor by which an error estimate counts more than it tells: near a pole of the rate it tells too little.
    fn strictness(&self, guards: &Self::Guards) -> f64;

    /// Why the run broke down between a regular point and a later time.
    fn diagnose(&mut self, times: (f64, f64), y: &Self::Point, broken: &Self::Point) -> Error;

    /// What comes near to being singular at a point, if anything does.
    fn suspect(&mut self, t: f64, y: &Self::Point) -> Option<Error>;
}
