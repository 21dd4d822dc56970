//! The equations as they come without any forms, where they are cheaper so.
//!
//! A form that is the cheapest of one entry may hide what the entry has in common with others. So the system is projected once
//! more as it stands, and where the program for a function is lighter so, the function takes these expressions. What a run
//! watches stays: they may divide by what is divided by already, by what vanishes only where that does, and by pivots of
//! D M Dᵀ and M_c, all of which are positive in one order of elimination where they are in another.

use crate::model::InitialSystem;
use crate::program::weight;
use crate::projection::{AsIs, COMPLIANCE_PIVOT, Equations, Guard, GuardKind, INERTIA_PIVOT, project};
use crate::simplify::limits::{DIVISOR_WORK, OPENED};
use crate::simplify::normalise_within;
use crate::symbolic::powers::Powers;
use crate::symbolic::{Expr, Graph, Node, Stage, Symbol};
use std::collections::BTreeSet;

/// The groups of functions of the state, the motion first.
const GROUPS: usize = 6;

/// The groups as they come without forms, over the symbols of the equations that they may stand in for.
pub struct Plain {
    groups: Vec<Vec<Expr>>,
    guards: Vec<Guard>,
    powers: Powers,
    /// Divisors that were judged.
    judged: Vec<(Expr, bool)>,
    work: usize,
}

/// What a group is compared with.
#[derive(Copy, Clone)]
struct Compared<'a> {
    own: &'a [Expr],
    plain: &'a [Expr],
}

impl Plain {
    /// Projects the system as it stands, into the arena of its equations; `None` where it gives no more than these.
    pub fn of(equations: &mut Equations, mut system: InitialSystem) -> Option<Self> {
        let assumed = system.graph.assumptions();
        system.graph = equations.graph.clone();
        let known = system.graph.assume_only(assumed);
        let mut plain = project(system, &mut AsIs).ok()?;
        if !about_the_same(equations, &mut plain) {
            return None;
        }
        let mut graph = std::mem::take(&mut plain.graph);
        graph.assume_only(known);
        let own = groups(equations);
        let watched = |e: &Equations| e.guards.iter().chain(&e.parameter_guards).cloned().collect::<Vec<Guard>>();
        let (guards, others) = (watched(equations), watched(&plain));
        // Pivots of the same matrices: where those of one order of elimination are positive, so are those of another.
        let matrices = |list: &[Guard]| -> BTreeSet<String> {
            list.iter().filter(|guard| definite(guard)).map(|guard| guard.origin.clone()).collect()
        };
        let definite = others.iter().filter(|guard| matrices(&guards) == matrices(&others) && definite(guard));
        let mut quantities: Vec<Expr> = guards.iter().chain(definite).map(|guard| guard.expr).collect();
        quantities.extend(divisors(&graph, &own.concat()));
        quantities.extend(equations.graph.cancelled());
        let powers = Powers::of(&graph, &quantities);
        let mut plain = Plain {
            groups: groups(&mut plain),
            guards: plain.guards,
            powers,
            judged: Vec::new(),
            work: DIVISOR_WORK,
        };
        let cancelled: Vec<Expr> = graph.cancelled().collect();
        let sound = cancelled.into_iter().all(|e| plain.covers(&mut graph, e));
        if !sound {
            return None;
        }
        equations.graph = graph;
        Some(plain)
    }

    /// A group, where it makes a lighter program than the one that the equations have, and divides by nothing new.
    pub fn lighter(&mut self, graph: &mut Graph, at: usize, own: &[Expr]) -> Option<Vec<Expr>> {
        let plain = self.groups.get(at)?.clone();
        let size = |roots: &[Expr]| graph.reachable_beyond(roots, Stage::Parameter).len();
        let lighter = plain != own
            && size(&plain) < 2 * size(own)
            && weight(graph, &plain) < weight(graph, own)
            && self.sound(graph, Compared { own, plain: &plain });
        lighter.then_some(plain)
    }

    /// Takes the motion, with what is watched, where it is lighter.
    pub fn lighten_motion(&mut self, equations: &mut Equations) {
        let own = groups(equations).swap_remove(0);
        let mut graph = std::mem::take(&mut equations.graph);
        let motion = self.groups[0][..self.groups[0].len() - self.guards.len()].to_vec();
        let (mut best, least) = (weight(&mut graph, &own), weight(&mut graph, &self.groups[0]));
        let mut found = None;
        if least < best && self.sound(&mut graph, Compared { own: &own[..motion.len()], plain: &motion }) {
            for told in [true, false] {
                let guards = self.at_hand(&mut graph, &equations.guards, told);
                let roots: Vec<Expr> = motion.iter().copied().chain(guards.iter().map(|guard| guard.expr)).collect();
                let weight = if roots == self.groups[0] { least } else { weight(&mut graph, &roots) };
                if weight < best {
                    (best, found) = (weight, Some((motion.clone(), guards)));
                }
                if best <= least {
                    break;
                }
            }
        }
        // What is watched more than the plain equations need makes them dearer still: then they stand in for all.
        if least < best && self.guards.clone().iter().all(|guard| self.covers(&mut graph, guard.expr)) {
            let others: Vec<Vec<Expr>> = groups(equations).split_off(1);
            let plain: Vec<Vec<Expr>> = self.groups[1..].to_vec();
            let sound = |(own, plain): (&Vec<Expr>, &Vec<Expr>)| self.sound(&mut graph, Compared { own, plain });
            if others.iter().zip(&plain).all(sound) {
                found = Some((motion, self.guards.clone()));
                for (group, plain) in equations.groups().into_iter().skip(1).zip(plain) {
                    group.into_iter().zip(plain).for_each(|(e, new)| *e = new);
                }
            }
        }
        if let Some((motion, guards)) = found {
            let (rates, accelerations) = motion.split_at(equations.coordinate_rates.len());
            equations.coordinate_rates = rates.to_vec();
            equations.accelerations = accelerations.to_vec();
            equations.guards = guards;
        }
        equations.graph = graph;
    }

    /// Whether a group is the same functions and divides by nothing new.
    fn sound(&mut self, graph: &mut Graph, group: Compared<'_>) -> bool {
        group.own.len() == group.plain.len()
            && divisors(graph, group.plain).into_iter().all(|e| self.covers(graph, e))
            && group.own.iter().zip(group.plain).all(|(own, plain)| graph.proven(*plain, *own))
    }

    /// Whether a divisor vanishes nowhere, or only where something does by which the equations divide already.
    fn covers(&mut self, graph: &mut Graph, divisor: Expr) -> bool {
        if let Some((_, known)) = self.judged.iter().find(|(e, _)| *e == divisor) {
            return *known;
        }
        let mut made = |graph: &mut Graph, e| graph.bounds(e).exclude_zero() || self.powers.find(graph, e).is_some();
        let small = graph.reachable_beyond(&[divisor], Stage::Parameter).len() <= OPENED;
        let known = made(graph, divisor) || small && {
            let normal = normalise_within(graph, divisor, &mut self.work);
            let factors = graph.as_term(normal).1;
            factors.into_iter().all(|(base, _)| base != divisor && made(graph, base))
        };
        self.judged.push((divisor, known));
        known
    }

    /// The guards in the form that the plain equations have at hand, which vanish where they do. If asked, those stay whose name
    /// is the text of their figure, unless the figure is the same.
    fn at_hand(&mut self, graph: &mut Graph, guards: &[Guard], told: bool) -> Vec<Guard> {
        let (mut found, mut open) = (guards.to_vec(), (0..guards.len()).collect::<Vec<usize>>());
        for plain in &self.guards {
            let Some(powers) = self.powers.find(graph, plain.expr) else { continue };
            let same = |at: &usize| guards[*at].kind == plain.kind && powers.contains(&(guards[*at].expr, 1));
            let Some(place) = open.iter().position(same) else { continue };
            let at = open[place];
            if graph.identical(guards[at].expr, plain.expr) {
                (found[at].expr, found[at].start) = (plain.expr, plain.start);
            } else if !told || guards[at].name != graph.display(guards[at].expr) {
                found[at] = plain.clone();
            } else {
                continue;
            }
            open.remove(place);
        }
        // Signed factors of pivots, cos θ of J cos² θ, are seen to change their sign; other pivots may be those of another order.
        if !told {
            let signed = |guard: &Guard| guard.kind == GuardKind::Pivot && PIVOTS.contains(&guard.origin.as_str());
            if !guards.iter().chain(&self.guards).any(signed) {
                found.retain(|guard| !definite(guard));
                found.extend(self.guards.iter().filter(|guard| definite(guard)).cloned());
            }
        }
        found
    }
}

/// Matrices whose pivots must stay positive.
const PIVOTS: [&str; 2] = [INERTIA_PIVOT, COMPLIANCE_PIVOT];

/// Whether it is a pivot of such a matrix.
fn definite(guard: &Guard) -> bool {
    guard.kind == GuardKind::Positive && PIVOTS.contains(&guard.origin.as_str())
}

fn groups(equations: &mut Equations) -> Vec<Vec<Expr>> {
    equations.groups().into_iter().take(GROUPS).map(|group| group.into_iter().map(|e| *e).collect()).collect()
}

/// Puts the symbols of these equations for those of the plain ones; `false` where they are about other quantities.
fn about_the_same(equations: &Equations, plain: &mut Equations) -> bool {
    let lists = |e: &Equations| [e.state_coordinates.clone(), e.state_speeds.clone(), e.reduced_speeds.clone()].concat();
    let (own, other) = (lists(equations), lists(plain));
    let named = |list: &[Symbol]| list.iter().map(|s| plain.graph.name(*s).to_owned()).collect::<Vec<_>>();
    if named(&own) != named(&other) {
        return false;
    }
    let differ = other.iter().zip(&own).filter(|(a, b)| a != b);
    let map: Vec<(Symbol, Expr)> = differ.map(|(a, b)| (*a, plain.graph.var(*b))).collect();
    if !map.is_empty() {
        let mut graph = std::mem::take(&mut plain.graph);
        for group in plain.groups() {
            let roots: Vec<Expr> = group.iter().map(|e| **e).collect();
            let renamed = graph.substitute(&roots, &map);
            group.into_iter().zip(renamed).for_each(|(e, new)| *e = new);
        }
        plain.graph = graph;
    }
    true
}

/// What is divided by.
fn divisors(graph: &Graph, roots: &[Expr]) -> BTreeSet<Expr> {
    let mut found = BTreeSet::new();
    for e in graph.reachable(roots) {
        if let Node::Product(factors) = graph.node(e) {
            found.extend(factors.iter().filter(|(_, k)| *k < 0).map(|(b, _)| *b));
        }
    }
    found
}
