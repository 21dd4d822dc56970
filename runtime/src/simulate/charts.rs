//! Charts: which independent speeds a run works in, how good they are, and when it changes them.

use crate::carriers::Carriers;
use crate::manifold::lift;
use crate::math::double::sqrt;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Matrix, Prepared, Vector};

/// A chart that is steeper than this is left at the end of the step: what is divided by its pivots loses digits. Where the model
/// has another that is less than half as steep, that one is entered earlier.
pub const STEEP: f64 = 2.0;

/// Only a chart that is less steep than this is entered. Between the two a run stays where it is.
pub const FLAT: f64 = 1.5;

/// Which charts a run may use; see [`Simulation::charts`](super::Simulation::charts).
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
/// use holonomy::simulate::Charts;
///
/// // The speed ẋ does not describe the pendulum where the rod is level.
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let over_the_top = pendulum.simulate(PendulumState { x: 0.0, y: -0.5, dot_x: 5.5 });
/// let run = over_the_top.until(2.0)?;
/// assert!(run.statistics().chart_changes > 0);
///
/// let over_the_top = pendulum.simulate(PendulumState { x: 0.0, y: -0.5, dot_x: 5.5 });
/// let error = over_the_top.charts(Charts::Stay).until(2.0).unwrap_err().error;
/// assert!(matches!(error, Error::ChartSingularity { guard: "y", .. }));
/// # Ok::<(), Error>(())
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Charts {
    /// Leaves a chart before its pivots vanish, for the flattest of the model's charts, or for the general one if none is flat.
    #[default]
    Change,
    /// Stays in the chart of the state, and ends with an error where that breaks down.
    Stay,
    /// Works in the general chart throughout: the equations (3.5) in all velocities.
    General,
}

/// A chart in which a step was taken.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Chart {
    /// One of [`Description::charts`](crate::Description::charts).
    Emitted(usize),
    /// All velocities (or the rates of the configuration) with the numerical null space of C (3.5).
    General,
}

/// Judges charts by the largest |D_ij| √M_jj / √M_ii: how much faster than an independent speed others may change, in the
/// kinetic metric.
pub(super) struct Quality<M: ConstrainedSystem> {
    dual: Prepared<M, Dual>,
}

impl<M: ConstrainedSystem> Quality<M> {
    pub(super) fn new(model: &Prepared<M>) -> Result<Self, Error> {
        Ok(Quality { dual: lift(model)? })
    }

    /// The steepness of a chart at the coordinates of a state; infinite where the chart breaks down.
    ///
    /// For u = L v + l0 the place of 1/√M_ii is taken by the length of the row of L in the metric M⁻¹, M by its diagonal: the same
    /// for speeds that are entries of v.
    pub(super) fn steepness(&self, model: &Prepared<M>, chart: usize, t: f64, s: &M::State<f64>) -> f64 {
        let scales = units(&model.inertia(t, &model.coordinates(t, s)));
        let (lifted, time) = (convert(s, |_, value| Dual::constant(value)), Dual::constant(t));
        let mut steepest: f64 = 0.0;
        for i in 0..M::MODEL.state_speeds.len() {
            let seeded = |j: usize| Dual::new(0.0, if i == j { 1.0 } else { 0.0 });
            let pattern = Carriers::Chart(chart).velocities(&self.dual, time, &lifted, seeded).into();
            let entries = pattern.as_ref().iter().zip(&scales).map(|(v, scale)| (v.derivative * scale).abs());
            steepest = larger(steepest, entries.fold(0.0, larger) * self.length(chart, t, &lifted, i, &scales));
        }
        if chart == 0 && M::MODEL.reduced_speeds != M::MODEL.state_speeds {
            // Rows that bind accelerations have pivots of their own: D of all stages.
            let complement = model.complement(t, s);
            for (i, name) in M::MODEL.reduced_speeds.iter().enumerate() {
                let speed = M::MODEL.state_speeds.iter().position(|speed| speed == name).unwrap_or(0);
                let entries = scales.iter().enumerate().map(|(j, scale)| (complement.entry(i, j) * scale).abs());
                steepest = larger(steepest, entries.fold(0.0, larger) * self.length(0, t, &lifted, speed, &scales));
            }
        }
        steepest
    }

    /// The length of the row of L of a speed.
    fn length(&self, chart: usize, t: f64, s: &M::State<Dual>, speed: usize, scales: &[f64]) -> f64 {
        let mut square = 0.0;
        for (l, scale) in scales.iter().enumerate() {
            let seeded = M::Velocities::from_fn(|j| Dual::new(0.0, if j == l { 1.0 } else { 0.0 }));
            let u = M::chart_speeds(chart, self.dual.values(), Dual::constant(t), s, &seeded).into();
            let slope = u.as_ref()[speed].derivative / scale;
            square += slope * slope;
        }
        sqrt(square)
    }

    /// The flattest emitted chart other than the one that is left, if one is flat.
    pub(super) fn flattest(
        &self,
        model: &Prepared<M>,
        left: Option<Chart>,
        t: f64,
        s: &M::State<f64>,
    ) -> Option<usize> {
        let charts = (0..M::MODEL.charts.len().max(1)).filter(|chart| left != Some(Chart::Emitted(*chart)));
        let judged = charts.map(|chart| (chart, self.steepness(model, chart, t, s)));
        let flat = judged.filter(|(_, steepness)| *steepness < FLAT);
        flat.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(chart, _)| chart)
    }

    /// Whether an emitted chart other than this one is flat, and flatter than that.
    pub(super) fn has_flatter(&self, model: &Prepared<M>, here: usize, t: f64, s: &M::State<f64>, than: f64) -> bool {
        let mut others = (0..M::MODEL.charts.len()).filter(|chart| *chart != here);
        others.any(|chart| self.steepness(model, chart, t, s) < than.min(FLAT))
    }
}

/// The larger of two figures; what is not a number counts as infinite.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() || a.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// √M_jj; a velocity without inertia counts with the mean of the others.
fn units<A: Matrix<f64>>(inertia: &A) -> alloc::vec::Vec<f64> {
    let diagonal = (0..A::ROWS).map(|j| inertia.entry(j, j));
    let positive = |m: &f64| *m > 0.0 && m.is_finite();
    let count = diagonal.clone().filter(positive).count();
    let mean = diagonal.clone().filter(positive).sum::<f64>() / count.max(1) as f64;
    let spare = if count > 0 { mean } else { 1.0 };
    diagonal.map(|m| sqrt(if positive(&m) { m } else { spare })).collect()
}
