//! The emitted chart as a flow: its points are the model's states.

use super::flow::Flow;
use super::guards::Watch;
use super::inputs::InputSource;
use super::trajectory::StateArray;
use crate::assemble::first_non_finite;
use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// A model with its inputs, its guards and its way back onto the constraints.
pub(super) struct Emitted<'r, M: ConstrainedSystem, I> {
    pub(super) model: &'r Prepared<M>,
    pub(super) source: &'r mut I,
    pub(super) watch: &'r mut Watch<M>,
    pub(super) manifold: Option<&'r mut Manifold<M>>,
}

impl<M: ConstrainedSystem, I: InputSource<M>> Flow<M> for Emitted<'_, M, I> {
    type Point = StateArray<M>;
    type Guards = M::Guards<f64>;

    #[inline(always)]
    fn rate(&mut self, t: f64, y: &Self::Point) -> (Self::Point, Self::Guards) {
        let s = (*y).into();
        let inputs = self.source.inputs(t, &s);
        let (rate, guards) = M::derivative(self.model.values(), t, &s, &inputs);
        (rate.into(), guards)
    }

    fn judge_stage(&self, t: f64, guards: &Self::Guards) -> Result<(), Error> {
        self.watch.check(t, (*guards).into().as_ref())
    }

    fn judge(&mut self, t: f64, guards: &Self::Guards) -> Result<(), Error> {
        self.watch.judge(t, (*guards).into().as_ref())
    }

    fn restore(&mut self, t: f64, y: &mut Self::Point) -> Result<bool, Error> {
        let Some(manifold) = &mut self.manifold else {
            return Ok(false);
        };
        let mut s = (*y).into();
        let moved = manifold.restore(self.model, t, &mut s)?;
        if moved {
            *y = s.into();
        }
        Ok(moved)
    }

    fn view(&self, _: f64, y: &Self::Point) -> M::State<f64> {
        (*y).into()
    }

    fn diagnose(&mut self, (t, next): (f64, f64), y: &Self::Point, broken: &Self::Point) -> Error {
        if let Some(error) = self.suspect(t, y) {
            return error;
        }
        let s = (*y).into();
        for at in [t, next] {
            if let Err(error) = check_inputs::<M>(&self.source.inputs(at, &s)) {
                return error;
            }
        }
        Error::Diverged { name: first_non_finite::<M>(&(*broken).into()).unwrap_or("derivative"), time: t }
    }

    fn suspect(&mut self, t: f64, y: &Self::Point) -> Option<Error> {
        self.watch.suspect(t, self.model.guards(t, &(*y).into()).into().as_ref())
    }
}

/// Inputs that a source gave must be finite.
pub(super) fn check_inputs<M: ConstrainedSystem>(inputs: &M::Inputs<f64>) -> Result<(), Error> {
    let array: <M::Inputs<f64> as Vector<f64>>::Array = (*inputs).into();
    match array.as_ref().iter().position(|input| !input.is_finite()) {
        Some(at) => Err(Error::NonFinite { name: M::MODEL.inputs.get(at).copied().unwrap_or("input") }),
        None => Ok(()),
    }
}
