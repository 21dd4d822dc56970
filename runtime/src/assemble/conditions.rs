//! What is asked for, sorted: entries of the state that are fixed, and equations for those that depend on it.

use alloc::rc::Rc;
use alloc::string::String;
use alloc::vec::Vec;

use crate::manifold::lift;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Level, OutputInfo, Prepared, Vector};

/// A name and the value that it is to have; without one, that of the guess.
#[derive(Clone, Debug)]
pub(super) struct Wish {
    pub(super) name: String,
    pub(super) value: Option<f64>,
}

/// A quantity over dual numbers.
pub(super) type Quantity<M> = dyn Fn(&Prepared<M, Dual>, Dual, &<M as ConstrainedSystem>::State<Dual>) -> Dual;

/// A quantity and the value that it is to have.
pub(super) struct Meeting<M: ConstrainedSystem> {
    pub(super) name: &'static str,
    pub(super) value: f64,
    pub(super) quantity: Rc<Quantity<M>>,
}

impl<M: ConstrainedSystem> Clone for Meeting<M> {
    fn clone(&self) -> Self {
        Meeting { name: self.name, value: self.value, quantity: Rc::clone(&self.quantity) }
    }
}

/// All that was asked for.
pub(super) struct Sorted<M: ConstrainedSystem> {
    /// The guess, with the values that were set.
    pub(super) state: Vec<f64>,
    /// Which entries of it stay.
    pub(super) fixed: Vec<bool>,
    /// The parameters that may change.
    pub(super) parameters: Vec<usize>,
    /// Equations for the coordinates.
    pub(super) positions: Vec<Meeting<M>>,
    /// Equations for the speeds.
    pub(super) velocities: Vec<Meeting<M>>,
}

/// Finds what the names mean.
pub(super) fn sort<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    guess: &M::State<f64>,
    wishes: Vec<Wish>,
    meetings: Vec<Meeting<M>>,
    parameters: &[String],
) -> Result<Sorted<M>, Error> {
    let mut state = entries(guess);
    let mut fixed = alloc::vec![false; state.len()];
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    let state_names = <M::State<f64> as Vector<f64>>::NAMES;
    for wish in wishes {
        let place = |names: &'static [&'static str]| names.iter().position(|name| *name == wish.name);
        if let Some(name) = known::<M>().find(|name| *name == wish.name)
            && wish.value.is_some_and(|value| !value.is_finite())
        {
            return Err(Error::NonFinite { name });
        }
        if let Some(at) = place(state_names) {
            state[at] = wish.value.unwrap_or(state[at]);
            fixed[at] = true;
        } else if let Some(at) = place(M::MODEL.coordinates) {
            let value = wish.value.unwrap_or_else(|| entries(&model.coordinates(t, guess))[at]);
            let quantity: Rc<Quantity<M>> = Rc::new(move |model, t, s| entries(&model.coordinates(t, s))[at]);
            positions.push(Meeting { name: M::MODEL.coordinates[at], value, quantity });
        } else if let Some(at) = place(M::MODEL.velocities) {
            let value = wish.value.unwrap_or_else(|| entries(&model.velocities(t, guess))[at]);
            let quantity: Rc<Quantity<M>> = Rc::new(move |model, t, s| entries(&model.velocities(t, s))[at]);
            velocities.push(Meeting { name: M::MODEL.velocities[at], value, quantity });
        } else if let Some(at) = M::MODEL.outputs.iter().position(|output| output.name == wish.name) {
            let kind = match holdable(&M::MODEL.outputs[at])? {
                true => &mut velocities,
                false => &mut positions,
            };
            kind.push(output(model, t, guess, at, wish.value));
        } else if let Some(define) = M::MODEL.defines.iter().find(|define| **define == wish.name) {
            return Err(Error::NotAnOutput { define });
        } else {
            return Err(Error::UnknownName { name: wish.name, known: known::<M>().collect() });
        }
    }
    for meeting in meetings {
        let kind = if asks_for_speeds(model, t, &state, &meeting)? { &mut velocities } else { &mut positions };
        kind.push(meeting);
    }
    let parameter = |name: &String| {
        let place = M::MODEL.parameters.iter().position(|entry| entry == name);
        place.ok_or_else(|| Error::UnknownName { name: name.clone(), known: M::MODEL.parameters.to_vec() })
    };
    let mut parameters: Vec<usize> = parameters.iter().map(parameter).collect::<Result<_, _>>()?;
    parameters.sort_unstable();
    parameters.dedup();
    Ok(Sorted { state, fixed, parameters, positions, velocities })
}

/// Whether an output asks for speeds.
fn holdable(output: &OutputInfo) -> Result<bool, Error> {
    let refused = |on| Err(Error::CannotHold { name: output.name, on });
    match output.level {
        Level::Acceleration => refused("accelerations or reactions"),
        _ if output.inputs => refused("inputs"),
        level => Ok(level == Level::Velocity),
    }
}

/// An output as an equation; without a value, it is to stay as in the guess.
fn output<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    guess: &M::State<f64>,
    at: usize,
    value: Option<f64>,
) -> Meeting<M> {
    let value = value.unwrap_or_else(|| entries(&model.outputs(t, guess, &M::Inputs::from_fn(|_| 0.0)))[at]);
    let quantity: Rc<Quantity<M>> =
        Rc::new(move |model, t, s| entries(&model.outputs(t, s, &M::Inputs::from_fn(|_| Dual::constant(0.0))))[at]);
    Meeting { name: M::MODEL.outputs[at].name, value, quantity }
}

/// All names that can be held, each once.
fn known<M: ConstrainedSystem>() -> impl Iterator<Item = &'static str> {
    let state = <M::State<f64> as Vector<f64>>::NAMES;
    let initial = M::MODEL.coordinates.iter().chain(M::MODEL.velocities).filter(move |name| !state.contains(name));
    let named = |name: &str| {
        state.contains(&name) || M::MODEL.coordinates.contains(&name) || M::MODEL.velocities.contains(&name)
    };
    let outputs = M::MODEL.outputs.iter().map(|output| output.name).filter(move |name| !named(name));
    state.iter().chain(initial).copied().chain(outputs)
}

/// Whether a quantity depends on a speed: at the guess, or at others, as a square does not show it at zero.
fn asks_for_speeds<M: ConstrainedSystem>(
    model: &Prepared<M>,
    t: f64,
    state: &[f64],
    meeting: &Meeting<M>,
) -> Result<bool, Error> {
    let dual = lift(model)?;
    let first = M::MODEL.state_coordinates.len();
    let moves = |shift: f64, at: usize| {
        let s: M::State<Dual> = M::State::from_fn(|i| {
            let shift = if i < first { 0.0 } else { shift + 0.31 * (i - first) as f64 };
            Dual::new(state[i] + shift, if i == at { 1.0 } else { 0.0 })
        });
        (meeting.quantity)(&dual, Dual::constant(t), &s).derivative != 0.0
    };
    Ok((first..state.len()).any(|at| moves(0.0, at) || moves(0.7, at)))
}

/// The entries of a vector.
pub(crate) fn entries<T: crate::Scalar, V: Vector<T>>(v: &V) -> Vec<T> {
    let array: V::Array = (*v).into();
    Vec::from(array.as_ref())
}

/// Numbers over dual numbers; the entry `seed` is the variable.
pub(super) fn seeded<V: Vector<f64>, W: Vector<Dual>>(numbers: &[f64], seed: Option<usize>) -> W {
    let v = V::from_fn(|i| numbers[i]);
    convert(&v, |i, value| Dual::new(value, if seed == Some(i) { 1.0 } else { 0.0 }))
}
