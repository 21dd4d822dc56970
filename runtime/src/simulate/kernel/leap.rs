//! One long step that was found as a whole: through a loss of rank.

use super::{Exit, Run, within};
use crate::simulate::flow::Flow;
use crate::{ConstrainedSystem, Error};

/// A step as a whole: its length, its end, and its polynomial.
pub(in crate::simulate) struct Leap<P> {
    pub(in crate::simulate) length: f64,
    pub(in crate::simulate) ahead: P,
    pub(in crate::simulate) coefficients: alloc::vec::Vec<P>,
}

impl<M: ConstrainedSystem, const S: usize> Run<'_, '_, M, S> {
    /// Takes the step from `y`, up to the barrier or to an event that cuts it, and tells which part of it.
    pub(in crate::simulate) fn leap<F: Flow<M>>(
        &mut self,
        flow: &mut F,
        y: &mut F::Point,
        leap: &Leap<F::Point>,
    ) -> Result<(f64, Exit), Error> {
        let (plan, t, h) = (self.plan, self.t, leap.length);
        let statistics = self.trajectory.statistics;
        if statistics.accepted + statistics.rejected >= plan.max_steps {
            return Err(Error::TooManySteps { steps: plan.max_steps, time: t });
        }
        let (mut next, mut ahead, mut exit) = (t + h, leap.ahead, Exit::Passed);
        if (self.barrier - next) * plan.direction() <= super::SAME_TIME * h.abs() {
            (next, exit) = (self.barrier, Exit::Barrier);
            ahead = within(&leap.coefficients, (next - t) / h);
            flow.restore(next, &mut ahead)?;
        }
        if !self.events.is_empty()
            && let Some((at, point, verdict)) = self.watch(flow, (t, next, h), &leap.coefficients)?
        {
            (next, ahead, exit) = (at, point, Exit::Event(verdict));
        }
        self.trajectory.accept(flow.chart(), flow.residuals());
        (self.t, *y, self.since) = (next, ahead, (next, 0));
        self.between(flow, (t, next, h), &leap.coefficients)?;
        let kept = plan.output_at(self.outputs, next, h);
        self.outputs += usize::from(kept);
        if kept || next == plan.end || matches!(exit, Exit::Event(_)) {
            let (s, v) = flow.view(next, y);
            self.trajectory.push(next, s, v);
        }
        self.tell(next);
        Ok(((next - t) / h, exit))
    }
}
