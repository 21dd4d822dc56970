//! States of a model, on its constraints and away from where it is singular.

use super::form::Point;
use crate::support::running::entries;
use crate::support::splitmix::SplitMix;
use holonomy::{ConstrainedSystem, Prepared, Vector};

/// How a coordinate is chosen.
#[derive(Copy, Clone)]
pub enum Choice {
    /// Anything between these.
    Between(f64, f64),
    /// Up to this much further than in the state before: a crank that turns, its loops closed from where they were.
    Further(f64),
}

/// How the states of a model are drawn.
pub struct Draw<'a> {
    /// The coordinates that are chosen; the others follow from the constraints.
    pub coordinates: &'a [(&'a str, Choice)],
    /// The bounds of the independent speeds.
    pub speeds: &'a [(f64, f64)],
}

impl Draw<'_> {
    /// The next state behind one of which the coordinates are given.
    ///
    /// # Panics
    /// If the loops do not close there.
    pub fn next<M: ConstrainedSystem>(&self, model: &Prepared<M>, before: &[f64], random: &mut SplitMix) -> Point {
        let names = M::MODEL.state_coordinates;
        let mut guess = before.to_vec();
        for (name, choice) in self.coordinates {
            let at = names.iter().position(|other| other == name).expect("a coordinate of the state");
            guess[at] = match *choice {
                Choice::Between(low, high) => random.between(low, high),
                Choice::Further(most) => before[at] + random.between(0.0, most),
            };
        }
        guess.extend(self.speeds.iter().map(|(low, high)| random.between(*low, *high)));
        assert_eq!(guess.len(), names.len() + M::MODEL.state_speeds.len(), "bounds for every speed");
        if M::MODEL.position_rows.is_empty() {
            return guess;
        }
        let held = self.coordinates.iter().map(|(name, _)| name);
        let assembly = model.assemble(M::State::<f64>::from_fn(|i| guess[i]));
        let closed = held.fold(assembly, |assembly, name| assembly.hold(name)).solve();
        entries(&closed.expect("the loops close"))
    }
}

/// The points at which every figure is at least this part of the largest magnitude that it has at any of them: where a
/// divisor nearly vanishes there is no accuracy to keep. A run judges its guards in the same way.
pub fn regular(points: Vec<Point>, part: f64, figures: impl Fn(&Point) -> Vec<f64>) -> Vec<Point> {
    let all: Vec<Vec<f64>> = points.iter().map(figures).collect();
    let count = all.first().map_or(0, Vec::len);
    let largest: Vec<f64> =
        (0..count).map(|i| all.iter().fold(0.0, |most: f64, list| most.max(list[i].abs()))).collect();
    let good = |list: &Vec<f64>| list.iter().zip(&largest).all(|(figure, most)| figure.abs() >= part * most);
    points.into_iter().zip(&all).filter(|(_, list)| good(list)).map(|(point, _)| point).collect()
}
