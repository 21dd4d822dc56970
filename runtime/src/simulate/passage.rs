//! The way through a point where constraints lose their rank, and branches of a mechanism meet.
//!
//! The configurations are there a union of smooth branches, which cross on a set of one dimension less. A motion that arrives with
//! a velocity stays on its branch, on which everything is smooth: positions, velocities, their rates, as a limit the reactions. What
//! fails is numerical: at the distance ρ rounding of f by ε is a distance ε/ρ from the branch, ε/ρ² in the velocities and ε/ρ³ in
//! their rates, and a Runge-Kutta method, whose stages leave the branch by the errors of low orders, has to take ever smaller steps.
//!
//! So the passage is a single step by collocation at Gauss' points, the loss of rank in the middle between two of them: each point
//! is brought onto f = 0 and φ = 0 before its rate is taken, where these are regular, and the polynomial that joins them is of order
//! 2s at the end and s + 1 in between. It converges only where a smooth motion goes through, and its highest coefficients tell
//! whether it does: a jump to another branch would be a jump of the rates, and make them large.

use alloc::vec::Vec;

use super::collocation::{Gauss, dense, integral};
use super::control::Tolerance;
use super::flow::{Flow, Point};
use super::general::{General, GeneralPoint};
use super::inputs::InputSource;
use super::kernel::Leap;
use super::points::{Place, Points, Sense, rate};
use crate::ConstrainedSystem;
use crate::error::Obstacle;
use crate::manifold::ROUNDING;

/// Points of the step.
pub(super) const POINTS: usize = 10;
/// The most sweeps over the points.
const SWEEPS: usize = 60;
/// Sweeps that change the points by less than this, in units of what is tolerated, have converged.
const CONVERGED: f64 = 1e-4;
/// Where rounding keeps them from that, the mean is taken of so many.
const SETTLED: usize = 8;
/// The most changes of the length of the step until the loss of rank is in its middle.
const MOVES: usize = 8;
/// Where less than this is left of the rank at the start, the step is to reach beyond as far as `REACH` tells, in the same measure.
const SHORT: f64 = 0.1;
const REACH: f64 = 0.25;
/// The part of the step to come that tells how fast the rank is lost.
const PROBE: f64 = 0.01;
/// Nothing is restored where less than this is left of the rank.
const WORN: f64 = 0.01;
/// Where less than `WORN` is left at the start, this relative error is the least that can be asked for.
const COARSEST: f64 = 1e-8;
/// Where the energy changes along the step by less than this part of the kinetic energy, it is kept.
const KEPT: f64 = 1e-10;

/// What is known where a passage is looked for.
pub(super) enum Standpoint<P> {
    /// A regular point; the size of the next step.
    Regular(f64),
    /// A point so near to the loss of rank that its rate cannot be computed: the rate by the polynomial that led there, and the
    /// length of its step; the rows where it began.
    Within(P, f64, Sense),
}

/// A step through a loss of rank.
pub(super) struct Passage<P> {
    pub(super) leap: Leap<P>,
    /// Where the rank is lost, as parts of the step.
    pub(super) losses: Vec<f64>,
    /// Times between which points are not to be restored, about the loss of rank.
    pub(super) untouched: (f64, f64),
    /// The rate by the polynomial.
    pub(super) kappa: Vec<P>,
    /// The rows where it began.
    pub(super) start: Sense,
}

/// Looks for a step through the loss of rank that is ahead; none, where the rank is not being lost.
pub(super) fn find<M: ConstrainedSystem, I: InputSource<M>>(
    flow: &mut General<'_, M, I>,
    (t, y): (f64, &GeneralPoint<M>),
    from: Standpoint<GeneralPoint<M>>,
    direction: f64,
    tolerance: Tolerance,
) -> Result<Option<Passage<GeneralPoint<M>>>, Obstacle> {
    let gauss = &Gauss::new(POINTS);
    let size = match from {
        Standpoint::Within(rate, length, start) => {
            let search = Search { gauss, t, y, tolerance, start };
            return search.step(flow, &rate, length, Place::Anywhere, false).map(Some);
        }
        Standpoint::Regular(size) => size,
    };
    let (rate, left) = rate(flow, t, y)?;
    let start = Sense { span: flow.equations.span(), turned: false };
    let search = Search { gauss, t, y, tolerance, start };
    let probe = direction * PROBE * size;
    let (_, beside) = self::rate(flow, t + probe, &moved(y, probe, &rate))?;
    let fall = (left - beside) / probe.abs();
    if fall.is_nan() || fall <= 0.0 {
        return Ok(None);
    }
    if left < SHORT {
        // Far beyond, so that the points are not as near as the start is.
        let length = direction * (left + REACH) / fall;
        if let Ok(passage) = search.step(flow, &rate, length, Place::Anywhere, false) {
            return Ok(Some(passage));
        }
    }
    search.step(flow, &rate, direction * 2.0 * left / fall, Place::Middle, left < WORN).map(Some)
}

/// A search for a step from a point.
struct Search<'s, M: ConstrainedSystem> {
    gauss: &'s Gauss,
    t: f64,
    y: &'s GeneralPoint<M>,
    tolerance: Tolerance,
    start: Sense,
}

impl<M: ConstrainedSystem> Search<'_, M> {
    /// The step of a length, which is changed until the loss of rank is at a good place.
    fn step<I: InputSource<M>>(
        &self,
        flow: &mut General<'_, M, I>,
        rate: &GeneralPoint<M>,
        length: f64,
        place: Place,
        worn: bool,
    ) -> Result<Passage<GeneralPoint<M>>, Obstacle> {
        let (gauss, from) = (self.gauss, (self.t, self.y));
        let mut points = Points::new(flow, gauss, from, rate, length);
        let (mut moves, mut last) = (0, f64::INFINITY);
        let (mut settled, mut mean) = (0, Vec::new());
        for _ in 0..SWEEPS {
            points.sweep(flow, gauss, self.t, &self.start)?;
            let length = points.better_length(gauss, place);
            if moves < MOVES && length != points.length {
                (moves, last) = (moves + 1, f64::INFINITY);
                points = Points::new(flow, gauss, from, rate, length);
                continue;
            }
            let kappa = gauss.expand(&points.rates);
            let change = points.improve(gauss, self.y, &kappa, self.tolerance);
            let allowed = self.allowed(points.nearest(), worn);
            if settled == 0 {
                let stalls = change > 0.5 * last && change <= 10.0 * allowed;
                last = change;
                if !change.is_finite() {
                    return Err(Obstacle::Jump);
                }
                if change > CONVERGED && !stalls {
                    continue;
                }
                (mean, settled) = (kappa, if stalls { 1 } else { SETTLED });
            } else {
                settled += 1;
                let part = 1.0 / settled as f64;
                mean.iter_mut().zip(&kappa).for_each(|(mean, kappa)| *mean = towards(mean, kappa, part));
            }
            if settled < SETTLED {
                continue;
            }
            let norm = |m: usize| self.tolerance.norm(&mean[m], self.y);
            let tail = norm(POINTS - 1).max(norm(POINTS - 2));
            let error = points.length.abs() * tail / (2 * (2 * POINTS - 1)) as f64;
            if error.is_nan() || error > allowed {
                return Err(Obstacle::Jump);
            }
            return self.finish(flow, points, mean, allowed);
        }
        Err(Obstacle::Jump)
    }

    /// What the step may err, in units of what is tolerated: one, or what rounding makes of the velocities at the nearest points.
    fn allowed(&self, nearest: f64, worn: bool) -> f64 {
        let noise = if worn { COARSEST } else { (ROUNDING / (nearest * nearest)).min(COARSEST) };
        (self.tolerance.norm(self.y, self.y) * noise).max(1.0)
    }

    /// The end of the step, with its energy where it is kept.
    fn finish<I: InputSource<M>>(
        &self,
        flow: &mut General<'_, M, I>,
        points: Points<M>,
        kappa: Vec<GeneralPoint<M>>,
        allowed: f64,
    ) -> Result<Passage<GeneralPoint<M>>, Obstacle> {
        let (gauss, t, y, h) = (self.gauss, self.t, self.y, points.length);
        let found = integral(y, h, &kappa, 1.0);
        let mut ahead = found;
        flow.restore(t + h, &mut ahead).map_err(|_| Obstacle::Closed)?;
        let change = self.tolerance.norm(&moved(&ahead, -1.0, &found), &ahead);
        if change.is_nan() || change > 10.0 * allowed {
            return Err(Obstacle::Jump);
        }
        keep_energy(flow, (t, y), &points, gauss, &mut ahead);
        let place = points.place(gauss);
        let ends = [0.0].iter().chain(&gauss.points).zip(&gauss.points);
        let lost = ends.zip(&points.turned).filter(|(_, turned)| **turned);
        let losses = lost.map(|((from, to), _)| place.clamp(*from, *to)).collect();
        // The rank falls and rises with the distance.
        let steepness = gauss.points.iter().zip(&points.left).map(|(theta, left)| left / (theta - place).abs());
        let half = WORN / steepness.fold(0.0, f64::max);
        let (a, b) = (t + (place - half) * h, t + (place + half) * h);
        Ok(Passage {
            leap: Leap { length: h, ahead, coefficients: dense(gauss, y, h, &kappa, &ahead) },
            losses,
            untouched: (a.min(b), a.max(b)),
            kappa,
            start: self.start.clone(),
        })
    }
}

/// Gives the end of the step the energy of its start, where the outer points, which are the most exact, have it.
fn keep_energy<M: ConstrainedSystem, I: InputSource<M>>(
    flow: &General<'_, M, I>,
    (t, y): (f64, &GeneralPoint<M>),
    points: &Points<M>,
    gauss: &Gauss,
    ahead: &mut GeneralPoint<M>,
) {
    if I::GIVEN {
        return;
    }
    let Some((kinetic, potential)) = flow.energies(t, y) else { return };
    let all = kinetic + potential;
    let is_kept = |i: usize| {
        let found = flow.energies(t + gauss.points[i] * points.length, &points.at[i]);
        found.is_some_and(|(moving, at)| (moving + at - all).abs() <= KEPT * moving)
    };
    if ![0, 1, POINTS - 2, POINTS - 1].into_iter().all(is_kept) {
        return;
    }
    let mut scaled = *ahead;
    for _ in 0..3 {
        let Some((moving, at)) = flow.energies(t + points.length, &scaled) else { return };
        // T is a square form of the velocities. Those are right but for rounding.
        let factor = 1.0 + (all - moving - at) / (2.0 * moving);
        if (factor - 1.0).abs() < COARSEST {
            scaled.scale_carriers(factor);
        } else {
            return;
        }
    }
    *ahead = scaled;
}

/// The part of the way from one point to another.
fn towards<P: Point>(from: &P, to: &P, part: f64) -> P {
    let mut point = *from;
    for i in 0..point.len() {
        *point.get_mut(i) += part * (to.get(i) - from.get(i));
    }
    point
}

/// y + τ k.
fn moved<P: Point>(y: &P, later: f64, rate: &P) -> P {
    let mut point = *y;
    for i in 0..point.len() {
        *point.get_mut(i) += later * rate.get(i);
    }
    point
}
