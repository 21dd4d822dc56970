// `rhs(x, p, out)`: the rate of a state under parameters, as a C function. Parameter-only work is done at the first call, as `prepare`
// does it for every run.

use holonomy::{ConstrainedSystem, Prepared, Vector};
use std::sync::OnceLock;

/// A model whose parameters come as numbers.
pub trait Peer: ConstrainedSystem + 'static {
    /// The model, and the inputs that stand among the parameters.
    fn read(p: &[f64]) -> (Self, Vec<f64>);
    /// How many parameters there are.
    const PARAMETERS: usize;
}

/// What does not change from call to call.
pub type Kept<M> = OnceLock<(Prepared<M>, <M as ConstrainedSystem>::Inputs<f64>)>;

/// # Safety
///
/// `x` and `out` have the length of the state, `p` that of the parameters.
pub unsafe fn rate<M: Peer>(kept: &Kept<M>, x: *const f64, p: *const f64, out: *mut f64) {
    let (model, inputs) = kept.get_or_init(|| {
        let (system, inputs) = M::read(unsafe { std::slice::from_raw_parts(p, M::PARAMETERS) });
        (system.prepare().expect("good parameters"), Vector::from_fn(|i| inputs[i]))
    });
    let s = M::State::<f64>::from_fn(|i| unsafe { *x.add(i) });
    let rate = model.derivative(0.0, &s, inputs).0.into();
    for (i, entry) in rate.as_ref().iter().enumerate() {
        unsafe { *out.add(i) = *entry };
    }
}
