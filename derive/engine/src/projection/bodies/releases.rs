//! Reactions of joints that were never written as constraints.
//!
//! With ε̇ for one more speed, whose constraint is ε = 0, the row of (2.8) for it is
//!
//! ```text
//!     M_ε v̇ = h_ε + C_εᵀ λ + R
//! ```
//!
//! where R is the reaction that is asked for: what holds the joint gives the outer part the force R along the release. Nothing is
//! solved for it.

use super::Sums;
use super::further::Further;
use crate::model::mechanism::{Mechanism, Release};
use crate::model::{InitialSystem, Reaction};
use crate::symbolic::{Expr, Graph, Kind, Symbol};

/// The speeds, and those of what is released; ε itself is put to zero, only ε̇ is needed.
pub fn extended(system: &mut InitialSystem, mechanism: &mut Mechanism) -> Vec<Symbol> {
    let graph = &mut system.graph;
    let zeros: Vec<(Symbol, Expr)> =
        mechanism.releases.iter().map(|release| (release.coordinate, graph.zero())).collect();
    if !zeros.is_empty() {
        replace(graph, mechanism.expressions(), &zeros);
    }
    system.speeds.iter().copied().chain(mechanism.releases.iter().map(|release| release.rate)).collect()
}

/// ε̇ = 0 in how the nodes move, once it is known what it moves.
pub fn stopped(graph: &mut Graph, mechanism: &Mechanism) -> Mechanism {
    let mut held = mechanism.clone();
    let zeros: Vec<(Symbol, Expr)> = mechanism.releases.iter().map(|release| (release.rate, graph.zero())).collect();
    if !zeros.is_empty() {
        replace(graph, held.expressions(), &zeros);
    }
    held
}

/// ε̇ = 0 in all that was found.
pub fn hold(graph: &mut Graph, releases: &[Release], sums: &mut Sums, potential: &mut Option<Expr>) {
    let zeros = zeros(graph, releases);
    if zeros.is_empty() {
        return;
    }
    let entries = sums.inertia.entries_mut().iter_mut().chain(&mut sums.forces).chain([&mut sums.kinetic]);
    replace(graph, entries.chain(potential).collect(), &zeros);
}

fn zeros(graph: &Graph, releases: &[Release]) -> Vec<(Symbol, Expr)> {
    let symbols = releases.iter().flat_map(|release| [release.coordinate, release.rate]);
    symbols.map(|symbol| (symbol, graph.zero())).collect()
}

fn replace(graph: &mut Graph, mut all: Vec<&mut Expr>, map: &[(Symbol, Expr)]) {
    let written: Vec<Expr> = all.iter().map(|e| **e).collect();
    let replaced = graph.substitute(&written, map);
    all.iter_mut().zip(replaced).for_each(|(e, new)| **e = new);
}

/// ε̇ = 0 in what acts along the speeds.
pub fn hold_along(graph: &mut Graph, releases: &[Release], further: &mut Further, potential: &mut Option<Expr>) {
    let zeros = zeros(graph, releases);
    if zeros.is_empty() {
        return;
    }
    let entries = further.along.inertia.entries_mut().iter_mut().chain(&mut further.along.forces);
    replace(graph, entries.chain([&mut further.kinetic]).chain(potential).collect(), &zeros);
}

/// M_ε v̇ - h_ε of every release.
pub fn asked(system: &mut InitialSystem, releases: &[Release], sums: &Sums) -> Vec<Expr> {
    let n = system.speeds.len();
    let graph = &mut system.graph;
    let accelerations = graph.vars(&system.outputs.accelerations);
    let each = (n..n + releases.len()).map(|row| {
        let mut terms: Vec<Expr> =
            accelerations.iter().enumerate().map(|(j, rate)| graph.mul(sums.inertia.get(row, j), *rate)).collect();
        terms.push(graph.neg(sums.forces[row]));
        graph.sum(&terms)
    });
    each.collect()
}

/// Writes M_ε v̇ - h_ε - C_εᵀ λ for every reaction of a release that some output mentions.
pub fn tell(system: &mut InitialSystem, releases: &[Release], inertial: &[Expr]) {
    for (at, release) in releases.iter().enumerate() {
        let asked = system.outputs.reactions.iter().position(|reaction| reaction.name == release.name);
        let Some(asked) = asked else { continue };
        let asked = system.outputs.reactions.remove(asked);
        let mut terms: Vec<Expr> = vec![inertial[at]];
        for row in system.rows.clone() {
            let slope = row.released[at];
            if !system.graph.vanishes(slope) {
                let multiplier = reaction(system, &row.name, &asked);
                let part = system.graph.mul(slope, multiplier);
                terms.push(system.graph.neg(part));
            }
        }
        let value = system.graph.sum(&terms);
        let written: Vec<Expr> = system.outputs.entries.iter().map(|output| output.expr).collect();
        let told = system.graph.substitute(&written, &[(asked.symbol, value)]);
        system.outputs.entries.iter_mut().zip(told).for_each(|(output, expr)| output.expr = expr);
    }
}

/// The multiplier of a row, which the outputs mention from now on.
fn reaction(system: &mut InitialSystem, name: &str, asked: &Reaction) -> Expr {
    let known = system.outputs.reactions.iter().find(|reaction| reaction.name == name);
    let symbol = match known {
        Some(reaction) => reaction.symbol,
        None => {
            let symbol = system.graph.symbol(&format!("reaction({name})"), Kind::Speed);
            system.outputs.reactions.push(Reaction { name: name.to_owned(), symbol, span: asked.span });
            symbol
        }
    };
    system.graph.var(symbol)
}
