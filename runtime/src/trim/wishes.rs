//! What is asked of a steady motion, sorted: entries that stay, rates, and equations for other quantities.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use super::Trim;
use crate::assemble::entries;
use crate::{ConstrainedSystem, Error, Prepared, Scalar, Vector};

/// A name and the value that it is to have; without one, that of the guess.
#[derive(Clone, Debug)]
pub(super) struct Wish {
    pub(super) name: String,
    pub(super) value: Option<f64>,
}

/// An entry of the state and the rate that it is to have; without one, any.
#[derive(Clone, Debug)]
pub(super) struct Rate {
    pub(super) entry: String,
    pub(super) value: Option<f64>,
}

/// A quantity that is no entry of the state: its place among its kind.
#[derive(Copy, Clone, Debug)]
pub(super) enum Quantity {
    Coordinate(usize),
    Velocity(usize),
    Output(usize),
}

impl Quantity {
    pub(super) fn name<M: ConstrainedSystem>(self) -> &'static str {
        match self {
            Quantity::Coordinate(at) => M::MODEL.coordinates[at],
            Quantity::Velocity(at) => M::MODEL.velocities[at],
            Quantity::Output(at) => M::MODEL.outputs[at].name,
        }
    }

    pub(super) fn value<M: ConstrainedSystem, T: Scalar>(
        self,
        model: &Prepared<M, T>,
        t: T,
        s: &M::State<T>,
        i: &M::Inputs<T>,
    ) -> T {
        match self {
            Quantity::Coordinate(at) => entries(&model.coordinates(t, s))[at],
            Quantity::Velocity(at) => entries(&model.velocities(t, s))[at],
            Quantity::Output(at) => entries(&model.outputs(t, s, i))[at],
        }
    }
}

/// All that was asked for.
pub(super) struct Sorted {
    /// The state's entries, then the inputs.
    pub(super) values: Vec<f64>,
    /// Which of these may change.
    pub(super) free: Vec<usize>,
    /// Entries of the state with the rates that they are to have.
    pub(super) rates: Vec<(usize, f64)>,
    pub(super) quantities: Vec<(Quantity, f64)>,
}

impl<M: ConstrainedSystem> Trim<'_, M> {
    /// Finds what the names mean.
    pub(super) fn sort(&self) -> Result<Sorted, Error> {
        let (state, inputs) = (<M::State<f64> as Vector<f64>>::NAMES, M::MODEL.inputs);
        let mut values = entries(&self.guess);
        values.extend(entries(&self.inputs));
        let mut stays = vec![false; state.len()];
        stays.resize(values.len(), true);
        for name in &self.free {
            stays[state.len() + place(inputs, name).ok_or_else(|| unknown(name, inputs.to_vec()))?] = false;
        }
        let mut quantities = Vec::new();
        for Wish { name, value } in &self.wishes {
            let at = place(state, name).or_else(|| place(inputs, name).map(|at| state.len() + at));
            let quantity = match at {
                Some(at) => {
                    values[at] = finite(value.unwrap_or(values[at]), state.iter().chain(inputs).nth(at))?;
                    stays[at] = true;
                    continue;
                }
                None => quantity::<M>(name)?,
            };
            let of_guess = || quantity.value(self.model, self.time, &self.guess, &self.inputs);
            quantities.push((quantity, finite(value.unwrap_or_else(of_guess), Some(&quantity.name::<M>()))?));
        }
        let mut wanted: Vec<Option<f64>> = vec![self.rest.then_some(0.0); M::MODEL.state_coordinates.len()];
        wanted.resize(state.len(), Some(0.0));
        for Rate { entry, value } in &self.rates {
            let at = place(state, entry).ok_or_else(|| unknown(entry, state.to_vec()))?;
            wanted[at] = value.map(|value| finite(value, Some(&state[at]))).transpose()?;
        }
        let rates = wanted.into_iter().enumerate().filter_map(|(at, value)| Some((at, value?))).collect();
        let free = (0..values.len()).filter(|at| !stays[*at]).collect();
        Ok(Sorted { values, free, rates, quantities })
    }
}

fn quantity<M: ConstrainedSystem>(name: &str) -> Result<Quantity, Error> {
    let output = M::MODEL.outputs.iter().position(|output| output.name == name);
    let found = place(M::MODEL.coordinates, name).map(Quantity::Coordinate);
    let found = found.or_else(|| place(M::MODEL.velocities, name).map(Quantity::Velocity));
    if let Some(found) = found.or_else(|| output.map(Quantity::Output)) {
        return Ok(found);
    }
    if let Some(define) = M::MODEL.defines.iter().find(|define| **define == name) {
        return Err(Error::NotAnOutput { define });
    }
    let state = <M::State<f64> as Vector<f64>>::NAMES;
    let names = state.iter().chain(M::MODEL.inputs).chain(M::MODEL.coordinates).chain(M::MODEL.velocities).copied();
    let mut known: Vec<&'static str> = Vec::new();
    for name in names.chain(M::MODEL.outputs.iter().map(|output| output.name)) {
        if !known.contains(&name) {
            known.push(name);
        }
    }
    Err(unknown(name, known))
}

fn place(names: &[&str], name: &str) -> Option<usize> {
    names.iter().position(|entry| *entry == name)
}

fn unknown(name: &str, known: Vec<&'static str>) -> Error {
    Error::UnknownName { name: name.into(), known }
}

fn finite(value: f64, name: Option<&&'static str>) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::NonFinite { name: name.copied().unwrap_or("value") }) }
}
