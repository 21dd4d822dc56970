//! Everything that can be said of a run before its first step.

use super::Method;
use super::course::Course;
use super::crossing::{Approach, check_rank};
use super::emitted::check_inputs;
use super::guards::{Watch, figures};
use super::inputs::InputSource;
use super::kernel::{Pace, Plan};
use super::redundancy::Redundancy;
use super::simulation::Simulation;
use super::start::{check_position, check_velocity};
use crate::assemble::check_finite;
use crate::{ConstrainedSystem, Error};

/// Outputs closer than this fraction of the run would not fit into memory.
const SPACING: f64 = 1e-12;

impl<'a, M: ConstrainedSystem, I: InputSource<M>> Simulation<'a, M, I> {
    /// Everything that can be said before the first step.
    pub(super) fn check(mut self, end: f64) -> Result<(Plan, Course<'a, M, I>), Error> {
        let (model, start, from) = (self.model, self.start, self.from);
        check_finite::<M>(from, &start)?;
        if let Some(v) = &self.velocities
            && let Some(at) = (*v).into().as_ref().iter().position(|entry| !entry.is_finite())
        {
            return Err(Error::NonFinite { name: M::MODEL.velocities.get(at).copied().unwrap_or("velocity") });
        }
        if let Some((alpha, beta)) = self.baumgarte {
            for (name, gain) in [("first gain of `baumgarte`", alpha), ("second gain of `baumgarte`", beta)] {
                not_negative(name, gain)?;
            }
        }
        if !end.is_finite() {
            return Err(Error::NonFinite { name: "end" });
        }
        positive("longest step", self.longest)?;
        if let Some(every) = self.every {
            positive("spacing of the output", every)?;
            if every < SPACING * (end - from).abs() {
                return Err(Error::StepTooSmall { step: every, time: from });
            }
        }
        let pace = match self.method {
            Method::Rk4 { step } => {
                positive("step", step)?;
                Pace::Fixed { step: step.min((end - from).abs()) }
            }
            Method::DormandPrince | Method::Dop853 => {
                positive("relative tolerance", self.tolerance.relative)?;
                positive("absolute tolerance", self.tolerance.absolute)?;
                Pace::Adaptive { tolerance: self.tolerance, longest: self.longest }
            }
        };
        if let Some(period) = self.source.period() {
            positive("sampling period", period)?;
            if period < SPACING * (end - from).abs() {
                return Err(Error::StepTooSmall { step: period, time: from });
            }
        }
        if !I::GIVEN && !M::MODEL.inputs.is_empty() {
            return Err(Error::MissingInputs { inputs: M::MODEL.inputs });
        }
        check_inputs::<M>(&self.source.inputs(from, &start))?;
        // The guards stand between f and φ: where one vanishes, the velocities are not finite.
        let mut manifold = check_position(model, from, &start)?;
        // Where the rank is lost no other speeds would do either.
        if manifold.is_some() {
            check_rank(model, from, &start, manifold.as_mut())?;
        }
        let v = match self.velocities {
            Some(v) => {
                let watch = Watch::unjudged(model, 0, from, &start)?;
                watch.check_shared(from, figures(model, 0, from, &start).into().as_ref())?;
                v
            }
            None => {
                Watch::new(model, 0, from, &start)?;
                model.velocities(from, &start)
            }
        };
        // Velocities that are given need not satisfy what redundant rows are judged by.
        if self.velocities.is_some() {
            check_velocity(model, from, &start, &v)?;
        }
        let mut redundancy = Redundancy::new(model)?;
        if let Some(rows) = &mut redundancy {
            rows.check(model, from, (&start, &v), &self.source.inputs(from, &start))?;
        }
        if self.velocities.is_none() {
            check_velocity(model, from, &start, &v)?;
        }
        let plan = Plan { start: from, end, pace, every: self.every, dense: self.dense, max_steps: self.max_steps };
        let course = Course {
            model,
            source: self.source,
            // Stabilised constraints are not restored.
            manifold: manifold.filter(|_| self.baumgarte.is_none()),
            // Stabilised constraints hold nearly, and their rows follow from each other as nearly.
            redundancy: redundancy.filter(|_| self.baumgarte.is_none()),
            charts: self.charts,
            baumgarte: self.baumgarte,
            events: self.events,
            progress: self.progress,
            strength: None,
            crossing: self.crossing,
            tolerance: self.tolerance,
            approach: Approach::default(),
            inside: None,
        };
        Ok((plan, course))
    }
}

fn positive(name: &'static str, value: f64) -> Result<(), Error> {
    // Also false where the value is not a number.
    if value > 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
}

fn not_negative(name: &'static str, value: f64) -> Result<(), Error> {
    // Also false where the value is not a number.
    if value >= 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
}
