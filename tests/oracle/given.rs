//! The users' functions that tests declare, over the oracle's own numbers: it takes no derivative that a model gives.

use super::number::{Dual, Number};

/// The functions by the names under which models declare them.
///
/// # Panics
/// On a name that is not here.
pub fn given<N: Number>(name: &str, x: N) -> N {
    match name {
        "wave" => N::constant(0.5) * x.sin_cos().0,
        "bump" => N::one() / (N::one() + x * x),
        _ => panic!("`{name}` is no function of a model"),
    }
}

/// A derivative of them.
///
/// # Panics
/// Beyond the third.
pub fn derivative<N: Number>(name: &str, order: usize, x: N) -> N {
    let once = Dual::moving(x, N::one());
    let twice = Dual::moving(once, Dual::constant(1.0));
    match order {
        0 => given(name, x),
        1 => given(name, once).rate,
        2 => given(name, twice).rate.rate,
        3 => given(name, Dual::moving(twice, Dual::constant(1.0))).rate.rate.rate,
        _ => panic!("no derivative of order {order} is known"),
    }
}
