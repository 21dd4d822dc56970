//! A model on its way through a plan.

use alloc::boxed::Box;

use super::emitted::Emitted;
use super::flow::Flow;
use super::guards::Watch;
use super::inputs::InputSource;
use super::kernel::{Plan, Run};
use super::tableau::Tableau;
use super::trajectory::{StateArray, Trajectory};
use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared};

/// A model with its inputs, its guards and its way back onto the constraints.
pub(super) struct Course<'a, M: ConstrainedSystem, I> {
    pub(super) model: &'a Prepared<M>,
    pub(super) source: I,
    pub(super) watch: Watch<M>,
    pub(super) manifold: Option<Manifold<M>>,
    pub(super) progress: Option<Box<dyn FnMut(f64) + 'a>>,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Course<'_, M, I> {
    /// Takes all steps from the start of the plan to its end.
    pub(super) fn run<const S: usize>(
        mut self,
        tableau: &'static Tableau<S>,
        plan: &Plan,
        trajectory: &mut Trajectory<M>,
    ) -> Result<(), Error> {
        let mut y: StateArray<M> = (*trajectory.last().1).into();
        let mut run = Run::new(tableau, plan, trajectory, self.progress.take());
        let mut flow = Emitted {
            model: self.model,
            source: &mut self.source,
            watch: &mut self.watch,
            manifold: self.manifold.as_mut(),
        };
        let result = run.steps(&mut flow, &mut y);
        // What there is of an interrupted run ends at its last regular state.
        if run.trajectory.last().0 != run.t {
            run.trajectory.push(run.t, flow.view(run.t, &y));
        }
        result
    }
}
