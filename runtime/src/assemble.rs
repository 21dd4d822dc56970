//! Assembly: closing the position constraints from a guess.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use nalgebra::{DMatrix, DVector};

use crate::manifold::Manifold;
use crate::{ConstrainedSystem, Error, Prepared, Vector};

/// A residual below this many units of rounding of its terms is met.
const MET: f64 = 8.0 * f64::EPSILON;
/// Where Newton's method makes no more progress, a residual below this fraction of its terms is met.
const STALLED: f64 = 1e-12;
/// Singular values below this fraction of the largest count as zero.
const RANK: f64 = 1e-10;
const PASSES: usize = 3;
const ITERATIONS: usize = 200;
const HALVINGS: usize = 40;

/// A configuration in the making; from [`Prepared::assemble`].
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let guess = PendulumState { x: 0.3, y: -1.0, dot_x: 0.0 };
/// let start = pendulum.assemble(guess).hold("x").solve()?;
/// assert_eq!(start.x, 0.3);
/// assert!((start.y + 0.4).abs() < 1e-15);
///
/// // The rod is too short for x = 0.7.
/// let guess = PendulumState { x: 0.7, y: -1.0, dot_x: 0.0 };
/// let error = pendulum.assemble(guess).hold("x").solve().unwrap_err();
/// assert!(matches!(error, Error::Assembly { constraint: "rod", .. }));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct Assembly<'a, M: ConstrainedSystem> {
    model: &'a Prepared<M>,
    guess: M::State<f64>,
    time: f64,
    held: Vec<String>,
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// Closes the position constraints by moving the coordinates of a guess as little as Newton's method needs; see [`Assembly`].
    ///
    /// The independent speeds stay as they are: with them, all velocities satisfy the velocity constraints by construction.
    pub fn assemble(&self, guess: M::State<f64>) -> Assembly<'_, M> {
        Assembly { model: self, guess, time: 0.0, held: Vec::new() }
    }
}

impl<M: ConstrainedSystem> Assembly<'_, M> {
    /// Keeps a coordinate at its value in the guess. Speeds are always kept.
    #[must_use]
    pub fn hold(mut self, name: &str) -> Self {
        self.held.push(name.into());
        self
    }

    /// The time at which the constraints are to be met, for constraints that move; zero otherwise.
    #[must_use]
    pub fn at_time(mut self, t: f64) -> Self {
        self.time = t;
        self
    }

    /// A state that meets all position constraints to rounding, or the constraint that is missed most.
    pub fn solve(self) -> Result<M::State<f64>, Error> {
        let names = <M::State<f64> as Vector<f64>>::NAMES;
        let mut free = alloc::vec![true; M::MODEL.state_coordinates.len()];
        for name in self.held {
            match names.iter().position(|entry| *entry == name) {
                Some(at) => free.iter_mut().skip(at).take(1).for_each(|free| *free = false),
                None => return Err(Error::UnknownName { name, known: names.to_vec() }),
            }
        }
        check_finite::<M>(self.time, &self.guess)?;
        let mut s = self.guess;
        for _ in 0..PASSES {
            // Far from the solution the terms are large, and so is their rounding: what counts is their size at the solution.
            let mut manifold = Manifold::new(self.model, self.time, &s)?;
            s = newton(self.model, &mut manifold, self.time, s, &free)?;
        }
        Ok(s)
    }
}

impl<M: ConstrainedSystem> fmt::Debug for Assembly<'_, M> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Assembly")
            .field("guess", &self.guess)
            .field("time", &self.time)
            .field("held", &self.held)
            .finish_non_exhaustive()
    }
}

/// A time and a state that a caller gave must be finite.
pub(crate) fn check_finite<M: ConstrainedSystem>(t: f64, s: &M::State<f64>) -> Result<(), Error> {
    if !t.is_finite() {
        return Err(Error::NonFinite { name: "t" });
    }
    match first_non_finite::<M>(s) {
        Some(name) => Err(Error::NonFinite { name }),
        None => Ok(()),
    }
}

/// The name of the first entry of a state that is infinite or not a number.
pub(crate) fn first_non_finite<M: ConstrainedSystem>(s: &M::State<f64>) -> Option<&'static str> {
    let array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
    let at = array.as_ref().iter().position(|entry| !entry.is_finite())?;
    Some(<M::State<f64> as Vector<f64>>::NAMES.get(at).copied().unwrap_or("state"))
}

/// Newton's method with steps of least norm, halved until the residual falls.
fn newton<M: ConstrainedSystem>(
    model: &Prepared<M>,
    manifold: &mut Manifold<M>,
    t: f64,
    guess: M::State<f64>,
    free: &[bool],
) -> Result<M::State<f64>, Error> {
    let mut s = guess;
    let mut f = model.position_residual_at(t, &s).into();
    for _ in 0..ITERATIONS {
        if manifold.worst(f.as_ref()).1 <= MET {
            return Ok(s);
        }
        manifold.differentiate(t, &s);
        if manifold.worst(f.as_ref()).1 <= MET {
            return Ok(s);
        }
        let Some(step) = least_norm_step(manifold, f.as_ref(), free) else {
            break;
        };
        let Some((next, residual)) = descend(model, t, &s, &step, &manifold.sizes, f.as_ref()) else {
            break;
        };
        (s, f) = (next, residual.into());
    }
    let (row, ratio) = manifold.worst(f.as_ref());
    if ratio <= STALLED {
        return Ok(s);
    }
    Err(Error::Assembly {
        constraint: M::MODEL.position_rows.get(row).copied().unwrap_or("position"),
        residual: f.as_ref().get(row).copied().unwrap_or(f64::NAN),
    })
}

/// The shortest step over the free coordinates that meets the linearised constraints, or comes nearest to it.
fn least_norm_step<M: ConstrainedSystem>(manifold: &Manifold<M>, f: &[f64], free: &[bool]) -> Option<DVector<f64>> {
    let weight = |i: usize| {
        if manifold.sizes[i] > 0.0 { 1.0 / manifold.sizes[i] } else { 1.0 }
    };
    let columns = manifold.columns;
    let jacobian =
        DMatrix::from_fn(
            f.len(),
            columns,
            |i, j| {
                if free[j] { manifold.jacobian[i * columns + j] * weight(i) } else { 0.0 }
            },
        );
    let residual = DVector::from_fn(f.len(), |i, _| -f[i] * weight(i));
    // The decomposition does not end on numbers that are not finite.
    if jacobian.iter().chain(residual.iter()).any(|entry| !entry.is_finite()) {
        return None;
    }
    let svd = jacobian.try_svd(true, true, f64::EPSILON, 1000)?;
    let threshold = RANK * svd.singular_values.max();
    if threshold <= 0.0 {
        return None;
    }
    let mut step = svd.solve(&residual, threshold).ok()?;
    // Held coordinates move by rounding errors of the decomposition otherwise.
    step.iter_mut().zip(free).filter(|(_, free)| !**free).for_each(|(delta, _)| *delta = 0.0);
    Some(step)
}

/// The longest of the step, its half, its quarter … that makes the residual smaller.
fn descend<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    s: &M::State<f64>,
    step: &DVector<f64>,
    sizes: &[f64],
    f: &[f64],
) -> Option<(M::State<f64>, M::PositionRows<f64>)> {
    let square = |f: &[f64]| -> f64 {
        f.iter().zip(sizes).map(|(f, size)| if *size > 0.0 { f / size } else { *f }).map(|ratio| ratio * ratio).sum()
    };
    let before = square(f);
    let mut fraction = 1.0;
    for _ in 0..HALVINGS {
        let mut array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        for (q, delta) in array.as_mut().iter_mut().zip(step.iter()) {
            *q += fraction * delta;
        }
        let next = array.into();
        let residual = model.position_residual_at(t, &next);
        let entries = residual.into();
        // Also false where the residual is not a number.
        if square(entries.as_ref()) <= (1.0 - 0.1 * fraction) * before {
            return Some((next, residual));
        }
        fraction *= 0.5;
    }
    None
}
