//! Losses of rank on the way of a run: when it looks for a passage, and what follows.

use alloc::vec::Vec;

use super::charts::{Chart, Charts, Quality};
use super::collocation::slope;
use super::control::Tolerance;
use super::course::Course;
use super::equations::{Equations, Strength};
use super::flow::Flow;
use super::general::{General, GeneralPoint, point};
use super::guards::{Watch, figures};
use super::inputs::InputSource;
use super::kernel::{Exit, Run};
use super::passage::{self, Passage, Standpoint};
use super::points::Sense;
use super::trajectory::Standing;
use crate::carriers::Carriers;
use crate::drift::Drift;
use crate::error::Obstacle;
use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// A passage is looked for where no more than this is left of the rank.
const NEAR: f64 = 0.3;
/// After one that was not found, where no more than this part of what was left there is left.
const NEARER: f64 = 0.6;
/// Inside of a passage that was cut short a run goes on by ordinary steps where more than this is left.
const CLEAR: f64 = 0.1;
/// Steps are shortened at most so often before a passage.
const RETRIES: usize = 24;
/// A passage is found to this relative accuracy at least, or it is none: another branch would be as far away as its tangent tells.
const PASSAGE: f64 = 1e-6;

/// A start whose rows have no more than this, as a sine, between them lies where they depend on each other: rounding turns its
/// velocities by a hundredth.
const AT: f64 = 1e-7;

/// So does a start at which the slopes of a row, times the coordinates, are no more than this part of its terms. Terms may be large
/// because they are measured from far away, so that this is as little as leaves half of the digits.
const LEVEL: f64 = 1e-9;

/// What a run does where constraints lose their rank; see [`Simulation::crossing`](super::Simulation::crossing).
///
/// ```
/// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
/// use holonomy::simulate::Crossing;
/// use holonomy::{ConstrainedSystem, Error, State};
///
/// /// A bead on two wires that cross.
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(x, y)]
/// #[inertia(diag(m, m))]
/// #[forces(0, 0)]
/// #[constraint(wires: x*x - y*y == 0)]
/// #[independent(dot(x))]
/// struct Wires {
///     m: f64,
/// }
///
/// let wires = Wires { m: 1.0 }.prepare()?;
/// let start = State::<Wires> { x: -1.0, y: -1.0, dot_x: 1.0 };
/// // It stays on its wire.
/// let run = wires.simulate(start).until(2.0)?;
/// assert!((run.last().1.y - 1.0).abs() < 1e-9 && run.statistics().crossings == 1);
/// // A run that is told not to pass ends beside the crossing.
/// let stopped = wires.simulate(start).crossing(Crossing::Refuse).until(2.0).unwrap_err();
/// assert!(matches!(stopped.error, Error::Dependent { .. }));
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "derive"))] fn main() {}
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Crossing {
    /// Goes through on the branch on which it arrives, where the motion is smooth.
    #[default]
    Pass,
    /// Ends with [`Error::Dependent`].
    Refuse,
}

/// Watches how much is left of the rank.
pub(super) struct Approach<M: ConstrainedSystem> {
    /// What was left at the last look.
    last: f64,
    /// Below this a passage is looked for.
    bound: f64,
    /// How often steps were shortened since the last passage because one did not come to its end.
    retries: usize,
    /// Why, if nothing came of it yet.
    refused: Option<Error>,
    /// For points of emitted charts, whose rows nobody else looks at.
    equations: Option<Equations<M>>,
    /// The strength of the rows that these start from.
    pub(super) strength: Option<Strength>,
}

impl<M: ConstrainedSystem> Default for Approach<M> {
    fn default() -> Self {
        Approach { last: f64::INFINITY, bound: NEAR, retries: 0, refused: None, equations: None, strength: None }
    }
}

impl<M: ConstrainedSystem> Approach<M> {
    /// Whether a passage is to be looked for where so much is left of the rank.
    pub(super) fn nears(&mut self, left: f64) -> bool {
        let falls = left < self.last;
        self.last = left;
        if left > NEAR {
            self.bound = NEAR;
        }
        falls && left < self.bound
    }

    /// The same for a point of an emitted chart.
    pub(super) fn look(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        (s, v): (&M::State<f64>, &M::Velocities<f64>),
        inputs: &M::Inputs<f64>,
    ) -> bool {
        if self.equations.is_none() {
            self.equations = Equations::new(model).ok();
        }
        let Some(equations) = &mut self.equations else { return false };
        if let Some(strength) = self.strength.take() {
            equations.strength = strength;
        }
        let w = equations.carriers(model, t, s, v);
        let regular = equations.solve(model, t, s, &w, inputs, None).is_ok();
        if regular {
            equations.strengthen();
        }
        let left = if regular { equations.rank_left() } else { 0.0 };
        self.strength = Some(equations.strength.clone());
        self.nears(left)
    }
}

/// A passage that was cut short beside the loss of rank.
pub(super) struct Inside<M: ConstrainedSystem> {
    y: GeneralPoint<M>,
    slope: GeneralPoint<M>,
    length: f64,
    start: Sense,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Course<'_, M, I> {
    /// Whether the run passes losses of rank.
    ///
    /// Rows that are not linear in the velocities vanish where these do; there is no branch to stay on.
    pub(super) fn passes(&self) -> bool {
        self.crossing == Crossing::Pass
            && self.baumgarte.is_none()
            && self.charts != Charts::Stay
            && M::MODEL.rows.iter().all(|row| row.linear)
    }

    /// The steps in one chart, and through a loss of rank that comes near.
    pub(super) fn onward<const S: usize>(
        &mut self,
        chart: Chart,
        run: &mut Run<'_, '_, M, S>,
        quality: Option<&Quality<M>>,
        standing: &mut Standing<M>,
    ) -> Result<Exit, Error> {
        if core::mem::take(&mut run.nearing) || self.inside.is_some() {
            match self.pass(run, standing)? {
                Ok(exit) => return Ok(exit),
                Err(Some(_)) => self.approach.bound = NEARER * self.approach.last,
                Err(None) => {}
            }
        }
        match self.leg(chart, run, quality, standing) {
            Err(error @ (Error::Dependent { .. } | Error::Projection { .. })) if self.passes() => {
                let obstacle = match self.pass(run, standing)? {
                    Ok(exit) => return Ok(exit),
                    Err(obstacle) => obstacle,
                };
                // A step may have leapt over the crossing from afar: shorter ones come near it.
                let is_leap = !matches!(&error, Error::Dependent { value, .. } if *value > 0.0);
                self.approach.retries += 1;
                let retries = is_leap && self.approach.retries <= RETRIES;
                let error = match (obstacle, error) {
                    (Some(obstacle), Error::Dependent { rows, guard, time, .. }) => {
                        Error::Impassable { rows, guard, obstacle, time: time.unwrap_or(run.t) }
                    }
                    (_, error) => error,
                };
                if retries && run.shorten() {
                    self.approach.refused = Some(error);
                    return Ok(Exit::Nears);
                }
                Err(error)
            }
            // What steps were shortened for is nearer to the cause than that they became too short.
            Err(error @ Error::StepTooSmall { .. }) => Err(self.approach.refused.take().unwrap_or(error)),
            Ok(exit) => {
                self.approach.refused = None;
                Ok(exit)
            }
            other => other,
        }
    }

    /// Looks for a passage from where the run stands, and takes it; or what is in the way, if anything is.
    fn pass<const S: usize>(
        &mut self,
        run: &mut Run<'_, '_, M, S>,
        standing: &mut Standing<M>,
    ) -> Result<Result<Exit, Option<Obstacle>>, Error> {
        let result = self.try_to_pass(run, standing);
        self.manifold.iter_mut().for_each(|manifold| manifold.thorough = false);
        result
    }

    fn try_to_pass<const S: usize>(
        &mut self,
        run: &mut Run<'_, '_, M, S>,
        standing: &mut Standing<M>,
    ) -> Result<Result<Exit, Option<Obstacle>>, Error> {
        let (model, t, (s, v)) = (self.model, run.t, *standing);
        let mut equations = Equations::new(model)?;
        equations.strength = self.strength.clone().unwrap_or(equations.strength);
        let x = model.coordinates(t, &s);
        let (mut y, from) = match self.inside.take() {
            Some(inside) => (inside.y, Standpoint::Within(inside.slope, inside.length, inside.start)),
            None => (point::<M>(&s, equations.carriers(model, t, &s, &v)), Standpoint::Regular(run.size())),
        };
        let mut drift = Drift::new(model, Carriers::General, t, &x, &v)?;
        drift.iter_mut().for_each(|drift| drift.thorough = true);
        self.manifold.iter_mut().for_each(|manifold| manifold.thorough = true);
        let mut flow = General {
            model,
            watch: Watch::unjudged(model, 0, t, &s)?,
            drift,
            source: &mut self.source,
            equations: &mut equations,
            manifold: self.manifold.as_mut(),
            // Between here and the other side rows depend on each other beyond what is marked.
            redundancy: None,
            quality: None,
            baumgarte: None,
            failure: None,
            approach: None,
            untouched: None,
        };
        let tolerance = Tolerance {
            relative: self.tolerance.relative.min(PASSAGE),
            absolute: self.tolerance.absolute.min(PASSAGE),
        };
        let found = passage::find(&mut flow, (t, &y), from, run.plan.direction(), tolerance);
        run.trajectory.statistics.evaluations += core::mem::take(&mut flow.equations.solved);
        let Passage { leap, losses, untouched, kappa, mut start } = match found {
            Ok(Some(passage)) => passage,
            Ok(None) => return Ok(Err(None)),
            Err(obstacle) => return Ok(Err(Some(obstacle))),
        };
        flow.untouched = Some(untouched);
        let (part, exit) = run.leap(&mut flow, &mut y, &leap)?;
        let passed = losses.iter().filter(|theta| **theta < part).count();
        run.trajectory.pass(untouched, flow.equations.strength.clone(), passed);
        *standing = flow.view(run.t, &y);
        (self.approach.last, self.approach.bound, self.approach.retries) = (0.0, NEAR, 0);
        let goes_on = run.t != run.plan.end && !matches!(exit, Exit::Event(_) | Exit::Passed);
        if goes_on {
            let _ = flow.rate(run.t, &y);
            if flow.failure.is_some() || flow.equations.rank_left() < CLEAR {
                start.turned ^= passed % 2 == 1;
                self.inside = Some(Inside { y, slope: slope(&kappa, part), length: leap.length, start });
            } else {
                // It may still lie ahead.
                self.approach.last = f64::INFINITY;
            }
        }
        Ok(Ok(exit))
    }
}

/// Refuses a start at which the rank is lost: rows that depend on each other, or one that has no direction.
///
/// Rows that are not linear in the velocities vanish where these do, wherever that is.
pub(super) fn check_rank<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    manifold: Option<&mut Manifold<M>>,
) -> Result<(), Error> {
    if M::MODEL.rows.iter().any(|row| !row.linear) {
        return Ok(());
    }
    let refuse = |rows: Vec<&'static str>| {
        let watch = Watch::unjudged(model, 0, t, s)?;
        let guard = watch.of_rows(figures(model, 0, t, s).into().as_ref(), &rows);
        Err(Error::Impassable { rows, guard, obstacle: Obstacle::Start, time: t })
    };
    let mut equations = Equations::new(model)?;
    // The rows do not depend on the velocities, which the speeds of the start need not tell.
    let (w, none) = (M::Carriers::from_fn(|_| 0.0), M::Inputs::from_fn(|_| 0.0));
    let lost = match equations.solve(model, t, s, &w, &none, None) {
        Err(error) => Some(error),
        Ok(_) if equations.smallest_pivot() < AT => equations.weakest(t, f64::INFINITY),
        Ok(_) => None,
    };
    if let Some(Error::Dependent { rows, .. }) = lost {
        return refuse(rows);
    }
    // Where there are more rows than it takes, others do for one that has no direction.
    let independent = M::MODEL.rows.len() + M::MODEL.reduced_speeds.len() == M::MODEL.carriers.len();
    match manifold.and_then(|manifold| manifold.level(t, s, LEVEL)) {
        Some(row) if independent => refuse(M::MODEL.position_rows.get(row).copied().into_iter().collect()),
        _ => Ok(()),
    }
}
