//! The choice of independent speeds where the model leaves it open.
//!
//! Pivots decide first: how dear they are, and where a chart breaks down. Among the choices that are no worse, the one is taken
//! whose motion weighs least as it is derived, found by exchanging one speed at a time. The names of the state follow from the
//! choice, so that nothing enters it but the declarations: no numbers for judging, no level of search, no clock. Pivots are judged
//! in canonical forms whatever the level, and the choice is made once for all who project the system.
//!
//! Two charts with pivots that may vanish break down at different places, and nobody knows which of them a motion comes to. There a
//! little is not worth a change: what is derived becomes cheaper by simplification, and by some hundredths more in one chart than
//! in another.

use crate::forms::Forms;
use crate::model::{Chosen, InitialSystem};
use crate::program::weight;
use crate::projection::{Alternative, Alternatives, Quality};
use crate::simplify::Search;
use crate::syntax::messages::counted;
use std::collections::BTreeSet;

/// Expressions of a system beyond which the pivots alone choose.
const EXPRESSIONS: usize = 1_000;
/// Expressions that the choices may make beyond those, all together.
const MADE: usize = 15_000;
/// Choices that are looked at.
const CHOICES: usize = 24;
/// The part of its weight that a motion must save to be worth a chart that breaks down elsewhere.
const WORTH: usize = 20;

/// A choice and what its motion weighs.
struct Weighed {
    found: Alternative,
    weight: usize,
}

/// Chooses, where there is a choice.
pub fn choose(system: &mut InitialSystem) {
    // The arena only grows, and what binds the carriers of a large system is not found in vain.
    if system.graph.len() > EXPRESSIONS {
        return;
    }
    let small = |alternatives: &Alternatives| alternatives.size() <= EXPRESSIONS;
    let Some(alternatives) = Alternatives::of(system).filter(small) else { return };
    system.chosen = Descent::of(&alternatives).map(Descent::chosen);
}

/// From the choice by pivots down to one that no exchange makes cheaper.
struct Descent<'a> {
    alternatives: &'a Alternatives,
    best: Weighed,
    /// The dependent speeds of the choice by pivots.
    first: Vec<bool>,
    /// Dependent speeds of what was looked at.
    tried: BTreeSet<Vec<bool>>,
    /// Weights of all choices that were as good when they were compared, in the order in which they were found.
    weights: Vec<(usize, Vec<bool>)>,
    made: usize,
}

impl<'a> Descent<'a> {
    fn of(alternatives: &'a Alternatives) -> Option<Self> {
        let best = weighed(alternatives, None, None)?;
        let first = best.found.dependent.clone();
        let (tried, weights) = (BTreeSet::from([first.clone()]), vec![(best.weight, first.clone())]);
        let mut descent = Descent { alternatives, made: best.found.graph.len(), best, first, tried, weights };
        while let Some(next) = descent.next() {
            descent.best = next;
        }
        Some(descent)
    }

    /// The lightest choice that is worth an exchange, the first of them in the order of the carriers.
    fn next(&mut self) -> Option<Weighed> {
        let mut next: Option<Weighed> = None;
        for (from, to) in self.best.found.exchanges.clone() {
            let mut dependent = self.best.found.dependent.clone();
            dependent.swap(from, to);
            if self.made > MADE || self.tried.len() >= CHOICES || !self.tried.insert(dependent.clone()) {
                continue;
            }
            let found = weighed(self.alternatives, Some(&dependent), Some(&self.best.found.quality));
            let Some(other) = found else { continue };
            self.made += other.found.graph.len() - self.alternatives.size();
            self.weights.push((other.weight, dependent));
            if self.worth(&other) && next.as_ref().is_none_or(|next| other.weight < next.weight) {
                next = Some(other);
            }
        }
        next
    }

    /// Whether the choice saves enough.
    fn worth(&self, other: &Weighed) -> bool {
        let saved = self.best.weight.saturating_sub(other.weight);
        let least = if other.found.quality.may_break_down() { self.best.weight / WORTH } else { 0 };
        saved > least
    }

    /// The choice, told to a person beside the lightest of the others.
    fn chosen(self) -> Chosen {
        let carriers = self.alternatives.carriers();
        let (own, chosen) = (self.best.weight, self.best.found.dependent);
        let names = |wanted: &dyn Fn(usize) -> bool| {
            let names = carriers.iter().enumerate().filter(|(j, _)| wanted(*j)).map(|(_, (_, name))| *name);
            names.collect::<Vec<_>>().join(", ")
        };
        let others = self.weights.iter().filter(|(_, other)| *other != chosen);
        let reason = others.min_by_key(|(weight, _)| *weight).map(|(weight, other)| {
            let by = if chosen == self.first && own >= *weight { "the cheapest pivots" } else { "cost" };
            let with = names(&|j| chosen[j] && !other[j]);
            let instead = names(&|j| !chosen[j] && other[j]);
            let figure = if *weight == own { "as".to_owned() } else { weight.to_string() };
            let little = if *weight < own { ", too little less for another chart" } else { "" };
            let weighs = counted(own, "operation", "operations");
            format!("chosen by {by}: as derived its motion weighs {weighs}, {figure} with {with} instead of {instead}{little}")
        });
        let independent = carriers.iter().zip(&chosen).filter(|(_, dependent)| !**dependent);
        Chosen { speeds: independent.map(|((speed, _), _)| *speed).collect(), reason }
    }
}

fn weighed(alternatives: &Alternatives, dependent: Option<&[bool]>, good: Option<&Quality>) -> Option<Weighed> {
    let mut found = alternatives.with(dependent, &mut Forms::new(Search::Off), good)?;
    let weight = weight(&mut found.graph, &found.motion);
    Some(Weighed { found, weight })
}

#[cfg(test)]
mod tests;
