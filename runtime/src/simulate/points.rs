//! The points of a collocation step through a loss of rank.

use alloc::vec::Vec;

use super::collocation::{Gauss, integral};
use super::control::Tolerance;
use super::flow::{Flow, Point};
use super::general::{General, GeneralPoint};
use super::inputs::InputSource;
use super::passage::POINTS;
use crate::error::Obstacle;
use crate::tangent::Span;
use crate::{ConstrainedSystem, Error};

/// So far from the middle the loss of rank may be, as a part of the step.
const OFF_CENTRE: f64 = 0.02;
/// By these the length of a step is changed to move the points away from the loss of rank.
const LONGER: [f64; 4] = [1.1, 1.2, 1.35, 1.5];

/// The rows of C at the start of a step.
#[derive(Clone)]
pub(super) struct Sense {
    /// The rows there, or before it.
    pub(super) span: Span,
    /// Whether they have turned over since then.
    pub(super) turned: bool,
}

/// Where in the step the loss of rank is to lie.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// In the middle between two points.
    Middle,
    /// Where it is, not too near to a point.
    Anywhere,
}

/// The points of a step in the making.
pub(super) struct Points<M: ConstrainedSystem> {
    pub(super) length: f64,
    pub(super) at: Vec<GeneralPoint<M>>,
    pub(super) rates: Vec<GeneralPoint<M>>,
    /// What is left of the rank at each.
    pub(super) left: Vec<f64>,
    /// Whether the rows have turned over since the point before.
    pub(super) turned: Vec<bool>,
}

impl<M: ConstrainedSystem> Points<M> {
    /// First guesses of the points of a step from y, by the rate there.
    pub(super) fn new<I: InputSource<M>>(
        flow: &General<'_, M, I>,
        gauss: &Gauss,
        (t, y): (f64, &GeneralPoint<M>),
        rate: &GeneralPoint<M>,
        length: f64,
    ) -> Self {
        let at = gauss.points.iter().map(|theta| flow.guess(t, y, rate, theta * length)).collect();
        Points { length, at, rates: alloc::vec![*rate; POINTS], left: Vec::new(), turned: Vec::new() }
    }

    /// The rates at the points, each brought onto the constraints.
    pub(super) fn sweep<I: InputSource<M>>(
        &mut self,
        flow: &mut General<'_, M, I>,
        gauss: &Gauss,
        t: f64,
        start: &Sense,
    ) -> Result<(), Obstacle> {
        (self.left, self.turned) = (Vec::with_capacity(POINTS), Vec::with_capacity(POINTS));
        let mut before = start.clone();
        for ((theta, at), found) in gauss.points.iter().zip(&self.at).zip(&mut self.rates) {
            let (time, mut point) = (t + theta * self.length, *at);
            if !point.is_finite() {
                return Err(Obstacle::Jump);
            }
            flow.restore(time, &mut point).map_err(|_| Obstacle::Closed)?;
            let left;
            (*found, left) = rate(flow, time, &point)?;
            self.left.push(left);
            self.turned.push(flow.equations.is_turned(&before.span) != before.turned);
            before = Sense { span: flow.equations.span(), turned: false };
        }
        Ok(())
    }

    /// Where the least is left of the rank, as a part of the step: what is left falls and rises by straight lines.
    pub(super) fn place(&self, gauss: &Gauss) -> f64 {
        let (theta, left) = (&gauss.points, &self.left);
        let least = (0..POINTS).fold(0, |least, i| if left[i] < left[least] { i } else { least });
        let zero = |a: usize, b: usize| theta[b] - left[b] * (theta[b] - theta[a]) / (left[b] - left[a]);
        match least {
            0 => zero(2, 1),
            _ if least == POINTS - 1 => zero(POINTS - 3, POINTS - 2),
            _ => {
                let other = if left[least - 1] < left[least + 1] { least - 1 } else { least + 1 };
                theta[least] + (theta[other] - theta[least]) * left[least] / (left[least] + left[other])
            }
        }
    }

    /// The points by the polynomial of their rates; the largest change, in units of what is tolerated.
    pub(super) fn improve(
        &mut self,
        gauss: &Gauss,
        y: &GeneralPoint<M>,
        kappa: &[GeneralPoint<M>],
        tolerance: Tolerance,
    ) -> f64 {
        let mut largest: f64 = 0.0;
        for (theta, at) in gauss.points.iter().zip(&mut self.at) {
            let better = integral(y, self.length, kappa, *theta);
            let mut change = better;
            for i in 0..change.len() {
                *change.get_mut(i) -= at.get(i);
            }
            let size = tolerance.norm(&change, &better);
            largest = if size.is_nan() { f64::INFINITY } else { largest.max(size) };
            *at = better;
        }
        largest
    }

    /// What is left of the rank at the nearest point.
    pub(super) fn nearest(&self) -> f64 {
        self.left.iter().copied().fold(1.0, f64::min)
    }

    /// The length of the step for which the loss of rank lies at a better place, or its own.
    pub(super) fn better_length(&self, gauss: &Gauss, wanted: Place) -> f64 {
        let (length, place) = (self.length, self.place(gauss));
        if !place.is_finite() {
            return length;
        }
        if wanted == Place::Middle {
            let off = (place - 0.5).abs() > OFF_CENTRE;
            return if off { length * 2.0 * place.clamp(0.2, 1.2) } else { length };
        }
        let distance =
            |factor: f64| gauss.points.iter().map(|theta| (theta * factor - place).abs()).fold(f64::INFINITY, f64::min);
        // Half of the smallest gap next to the ends is as good as it gets there.
        if distance(1.0) >= 0.5 * gauss.points[0] {
            return length;
        }
        let better = |best: f64, factor: f64| if distance(factor) > distance(best) { factor } else { best };
        length * LONGER.into_iter().fold(1.0, better)
    }
}

/// A rate, and what is left of the rank.
pub(super) fn rate<M: ConstrainedSystem, I: InputSource<M>>(
    flow: &mut General<'_, M, I>,
    t: f64,
    y: &GeneralPoint<M>,
) -> Result<(GeneralPoint<M>, f64), Obstacle> {
    let (rate, guards) = flow.rate(t, y);
    match flow.judge_stage(t, &guards) {
        Err(Error::Dependent { .. }) => Err(Obstacle::Lost),
        Err(_) => Err(Obstacle::Jump),
        Ok(()) => Ok((rate, flow.equations.rank_left())),
    }
}
