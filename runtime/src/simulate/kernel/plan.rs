//! What a run is to do, and where its steps and outputs fall.

use super::SAME_TIME;
use crate::simulate::control::Tolerance;

/// A step is lengthened to reach the end if less than this part of it would remain.
const REMAINDER: f64 = 0.01;
/// With fixed steps only rounding is made up for.
const FIXED_REMAINDER: f64 = 1e-9;

/// Sizes of the steps.
#[derive(Copy, Clone, Debug)]
pub(in crate::simulate) enum Pace {
    Fixed { step: f64 },
    Adaptive { tolerance: Tolerance, longest: f64 },
}

/// What a run is to do; all figures are checked.
#[derive(Copy, Clone, Debug)]
pub(in crate::simulate) struct Plan {
    pub(in crate::simulate) start: f64,
    pub(in crate::simulate) end: f64,
    pub(in crate::simulate) pace: Pace,
    pub(in crate::simulate) every: Option<f64>,
    pub(in crate::simulate) dense: bool,
    pub(in crate::simulate) max_steps: usize,
}

impl Plan {
    /// 1 forwards in time, −1 backwards.
    pub(in crate::simulate) fn direction(&self) -> f64 {
        if self.end < self.start { -1.0 } else { 1.0 }
    }

    /// The end of the step at t, `size` long if the method may choose; no step reaches beyond the barrier. Fixed steps follow
    /// `taken` others since a time.
    pub(super) fn next(&self, t: f64, (since, taken): (f64, usize), size: f64, barrier: f64) -> f64 {
        let (next, remainder) = match self.pace {
            // From a count, so that the times do not gather rounding errors.
            Pace::Fixed { step } => {
                let next = since + self.direction() * step * (taken + 1) as f64;
                (next, FIXED_REMAINDER)
            }
            Pace::Adaptive { .. } => (t + self.direction() * size, REMAINDER),
        };
        if (barrier - next) * self.direction() <= remainder * size { barrier } else { next }
    }

    /// The time of the output after `count` ones; none where every step is kept.
    pub(super) fn output(&self, count: usize) -> Option<f64> {
        let every = self.every?;
        Some(self.start + self.direction() * every * (count + 1) as f64)
    }

    /// Whether the next output lies strictly before the end of the step.
    pub(super) fn output_within(&self, count: usize, next: f64, h: f64) -> Option<f64> {
        let within = |at: &f64| (next - at) * self.direction() > SAME_TIME * h.abs();
        self.output(count).filter(within)
    }

    /// Whether the end of the step is to be kept.
    pub(super) fn output_at(&self, count: usize, next: f64, h: f64) -> bool {
        let reached = |at: f64| (next - at) * self.direction() >= -SAME_TIME * h.abs();
        self.output(count).is_none_or(reached)
    }
}
