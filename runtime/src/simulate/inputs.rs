//! Where the inputs of a run come from.

use crate::{ConstrainedSystem, Vector};

/// A source of inputs: [`NoInputs`], or a closure of the time and the state.
pub trait InputSource<M: ConstrainedSystem> {
    /// Whether the source gives inputs at all.
    const GIVEN: bool;
    /// The inputs at a time and a state.
    fn inputs(&mut self, t: f64, s: &M::State<f64>) -> M::Inputs<f64>;
}

/// For models without inputs.
#[derive(Copy, Clone, Debug, Default)]
pub struct NoInputs;

impl<M: ConstrainedSystem> InputSource<M> for NoInputs {
    const GIVEN: bool = false;

    #[inline(always)]
    fn inputs(&mut self, _: f64, _: &M::State<f64>) -> M::Inputs<f64> {
        M::Inputs::from_fn(|_| 0.0)
    }
}

impl<M, F> InputSource<M> for F
where
    M: ConstrainedSystem,
    F: FnMut(f64, &M::State<f64>) -> M::Inputs<f64>,
{
    const GIVEN: bool = true;

    #[inline(always)]
    fn inputs(&mut self, t: f64, s: &M::State<f64>) -> M::Inputs<f64> {
        self(t, s)
    }
}
