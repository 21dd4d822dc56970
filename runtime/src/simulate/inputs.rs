//! Where the inputs of a run come from.

use crate::{ConstrainedSystem, Vector};

/// A source of inputs: [`NoInputs`], or a closure of the time and the state.
pub trait InputSource<M: ConstrainedSystem> {
    /// Whether the source gives inputs at all.
    const GIVEN: bool;
    /// The inputs at a time and a state.
    fn inputs(&mut self, t: f64, s: &M::State<f64>) -> M::Inputs<f64>;

    /// The time between two samples, for a source that holds what it gave in between; the steps end at every sample.
    fn period(&self) -> Option<f64> {
        None
    }

    /// Takes a sample.
    fn sample(&mut self, t: f64, s: &M::State<f64>) {
        let _ = (t, s);
    }
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

/// A digital controller: the inputs are computed at every sample and held until the next one; made by
/// [`Simulation::sampled`](super::Simulation::sampled).
#[derive(Clone, Debug)]
pub struct Sampled<F, V> {
    period: f64,
    controller: F,
    held: Option<V>,
}

impl<F, V> Sampled<F, V> {
    pub(super) fn new(period: f64, controller: F) -> Self {
        Sampled { period, controller, held: None }
    }
}

impl<M, F> InputSource<M> for Sampled<F, M::Inputs<f64>>
where
    M: ConstrainedSystem,
    F: FnMut(f64, &M::State<f64>) -> M::Inputs<f64>,
{
    const GIVEN: bool = true;

    #[inline(always)]
    fn inputs(&mut self, t: f64, s: &M::State<f64>) -> M::Inputs<f64> {
        *self.held.get_or_insert_with(|| (self.controller)(t, s))
    }

    fn period(&self) -> Option<f64> {
        Some(self.period)
    }

    fn sample(&mut self, t: f64, s: &M::State<f64>) {
        self.held = Some((self.controller)(t, s));
    }
}
