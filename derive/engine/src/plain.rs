//! The equations as they come without any forms, where they are cheaper so.
//!
//! A form that is the cheapest of one entry may hide what the entry has in common with others. So the system is projected once
//! more as it stands, and where the program for a function is lighter so, the function takes these expressions. What a run
//! watches stays: they may divide by what is divided by already, by what vanishes only where that does, and by pivots of
//! D M Dᵀ and M_c, all of which are positive in one order of elimination where they are in another.

use crate::model::InitialSystem;
use crate::program::weight;
use crate::projection::guards::drop_cancelled_pivots;
use crate::projection::{AsIs, COMPLIANCE_PIVOT, Equations, Guard, GuardKind, INERTIA_PIVOT, TANGENT_PIVOT, project};
use crate::simplify::limits::{DIVISOR_WORK, OPENED};
use crate::simplify::normalise_within;
use crate::symbolic::powers::Powers;
use crate::symbolic::{Expr, Graph, Node, Stage, Symbol};
use std::collections::BTreeSet;

/// The groups of functions of the state, the motion first.
const GROUPS: usize = 6;

/// Differences of weights below this part of them are looked at twice.
const DOUBT: usize = 50;

/// The groups as they come without forms, over the symbols of the equations that they may stand in for.
pub struct Plain {
    groups: Vec<Vec<Expr>>,
    guards: Vec<Guard>,
    powers: Powers,
    /// Divisors that were judged.
    judged: Vec<(Expr, bool)>,
    work: usize,
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
        let mut plain =
            Plain { groups: groups(&mut plain), guards: plain.guards, powers, judged: Vec::new(), work: DIVISOR_WORK };
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
            && self.sound(graph, own, &plain);
        lighter.then_some(plain)
    }

    /// Takes the motion, with what is watched, where it is lighter; whether what is left is lighter beyond doubt: the same
    /// functions make slightly different programs in different arenas.
    pub fn lighten_motion(&mut self, equations: &mut Equations) -> bool {
        let own = groups(equations).swap_remove(0);
        let mut graph = std::mem::take(&mut equations.graph);
        let motion = self.groups[0][..self.groups[0].len() - self.guards.len()].to_vec();
        let (mut best, least) = (weight(&mut graph, &own), weight(&mut graph, &self.groups[0]));
        let mut found = None;
        if least < best && self.sound(&mut graph, &own[..motion.len()], &motion) {
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
            let sound = |(own, plain): (&Vec<Expr>, &Vec<Expr>)| self.sound(&mut graph, own, plain);
            if others.iter().zip(&plain).all(sound) {
                let mut guards = self.at_hand(&mut graph, &equations.guards, false);
                guards.retain(|guard| self.guards.iter().any(|plain| plain.expr == guard.expr));
                let rest = self.guards.iter().filter(|plain| guards.iter().all(|guard| guard.expr != plain.expr));
                let rest: Vec<Guard> = rest.cloned().collect();
                (best, found) = (least, Some((motion, [guards, rest].concat())));
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
        best + best / DOUBT < least
    }

    /// The equations as they come, with all that they watch, where the motion is dearer than theirs in spite of all: what nothing
    /// was gained for is emitted as it was stated.
    pub fn instead_of(equations: Equations, system: InitialSystem) -> Equations {
        let Ok(plain) = project(system, &mut AsIs) else { return equations };
        let cost = |equations: &Equations| {
            let mut watched = equations.clone();
            drop_cancelled_pivots(&mut watched, TANGENT_PIVOT);
            let motion = groups(&mut watched).swap_remove(0);
            weight(&mut watched.graph, &motion)
        };
        if cost(&plain) < cost(&equations) { plain } else { equations }
    }

    /// Whether a group is the same functions and divides by nothing new.
    fn sound(&mut self, graph: &mut Graph, own: &[Expr], plain: &[Expr]) -> bool {
        own.len() == plain.len()
            && divisors(graph, plain).into_iter().all(|e| self.covers(graph, e))
            && own.iter().zip(plain).all(|(own, plain)| graph.proven(*plain, *own))
    }

    /// Whether a divisor vanishes nowhere, or only where something does by which the equations divide already.
    fn covers(&mut self, graph: &mut Graph, divisor: Expr) -> bool {
        if let Some((_, known)) = self.judged.iter().find(|(e, _)| *e == divisor) {
            return *known;
        }
        let mut made = |graph: &mut Graph, e| graph.bounds(e).exclude_zero() || self.powers.find(graph, e).is_some();
        let small = graph.reachable_beyond(&[divisor], Stage::Parameter).len() <= OPENED;
        let known = made(graph, divisor)
            || small && {
                let normal = normalise_within(graph, divisor, &mut self.work);
                let factors = graph.as_term(normal).1;
                factors.into_iter().all(|(base, _)| base != divisor && made(graph, base))
            };
        self.judged.push((divisor, known));
        known
    }

    /// The guards in the form that the plain equations have at hand, which vanish where they do. A guard keeps its name where the
    /// figure differs by a factor that does not change during a run; if it is `told`, by the text of its figure, it keeps the figure.
    fn at_hand(&mut self, graph: &mut Graph, guards: &[Guard], told: bool) -> Vec<Guard> {
        let (mut found, mut open) = (guards.to_vec(), (0..guards.len()).collect::<Vec<usize>>());
        for plain in &self.guards {
            let Some(powers) = self.powers.find(graph, plain.expr) else { continue };
            let same = |at: &usize| guards[*at].kind == plain.kind && powers.contains(&(guards[*at].expr, 1));
            let Some(place) = open.iter().position(same) else { continue };
            let at = open.remove(place);
            let varying = powers.iter().filter(|(e, _)| graph.stage(*e) > Stage::Parameter).count();
            if graph.identical(guards[at].expr, plain.expr) {
                (found[at].expr, found[at].start) = (plain.expr, plain.start);
            } else if told && guards[at].name == graph.display(guards[at].expr) {
                continue;
            } else if varying == 1 {
                (found[at].expr, found[at].start) = (plain.expr, plain.start);
            } else {
                found[at] = plain.clone();
            }
        }
        // Signed factors of pivots, cos θ of J cos² θ, are seen to change their sign; other pivots may be those of another order.
        if !told && open.iter().any(|at| definite(&guards[*at])) {
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
    let lists =
        |e: &Equations| [e.state_coordinates.clone(), e.state_speeds.clone(), e.reduced_speeds.clone()].concat();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    fn guard(expr: Expr, name: &str, kind: GuardKind, origin: &str) -> Guard {
        Guard { expr, name: name.to_owned(), kind, origin: origin.to_owned(), rows: Vec::new(), start: None }
    }

    fn dividing(graph: &Graph, quantities: &[Expr], guards: Vec<Guard>) -> Plain {
        let powers = Powers::of(graph, quantities);
        Plain { groups: Vec::new(), guards, powers, judged: Vec::new(), work: DIVISOR_WORK }
    }

    /// cos θ, sin θ and a parameter.
    fn turn(graph: &mut Graph) -> [Expr; 3] {
        let (theta, m) = (graph.symbol("theta", Kind::Coordinate), graph.symbol("m", Kind::Parameter));
        let (theta, m) = (graph.var(theta), graph.var(m));
        [graph.cos(theta), graph.sin(theta), m]
    }

    /// What vanishes nowhere else may be divided by, and nothing else may.
    #[test]
    fn a_divisor_must_vanish_only_where_known_ones_do() {
        let graph = &mut Graph::new();
        let [cos, sin, m] = turn(graph);
        let mut plain = dividing(graph, &[cos, m], Vec::new());
        let (one, two) = (graph.one(), graph.integer(2));
        let square = graph.powi(sin, 2);
        let [left, away, half] = [graph.sub(one, square), graph.add(two, sin), graph.sub(two, m)];
        let scaled = graph.mul(left, m);
        let product = graph.mul(cos, away);
        let near = graph.add(cos, one);
        for (e, known) in [(scaled, true), (away, true), (product, true), (sin, false), (near, false), (half, false)] {
            assert_eq!(plain.covers(graph, e), known, "{}", graph.display(e));
        }
    }

    /// A guard keeps a name that is true, and its figure where that is asked.
    #[test]
    fn guards_keep_their_names() {
        let graph = &mut Graph::new();
        let [cos, sin, m] = turn(graph);
        let scaled = graph.mul(cos, m);
        let terms = [cos, sin].map(|e| {
            let square = graph.powi(e, 2);
            graph.mul(square, m)
        });
        let spread = graph.sum(&terms);
        let long = graph.mul(scaled, spread);
        let own = [guard(cos, "cos(theta)", GuardKind::Pivot, "a pivot")];
        let plain = guard(long, "pivot of rod", GuardKind::Pivot, "a pivot");
        for (told, expr) in [(true, cos), (false, long)] {
            let found = dividing(graph, &[cos, m], vec![plain.clone()]).at_hand(graph, &own, told);
            let [found] = found.as_slice() else { panic!("one guard") };
            assert_eq!((found.expr, found.name.as_str()), (expr, "cos(theta)"));
        }
        // With a factor that changes along the motion the name would not be true any more.
        let further = graph.mul(long, sin);
        let plain = guard(further, "pivot of rod", GuardKind::Pivot, "a pivot");
        let found = dividing(graph, &[cos, sin, m], vec![plain.clone()]).at_hand(graph, &own, false);
        assert_eq!(found, [plain]);
    }

    /// Pivots of another order of elimination take the place of pivots of the same matrix; signed factors of pivots stay.
    #[test]
    fn pivots_of_another_order_stand_in() {
        let graph = &mut Graph::new();
        let [cos, sin, _] = turn(graph);
        let one = graph.one();
        let [a, b] = [cos, sin].map(|e| {
            let square = graph.powi(e, 2);
            graph.add(one, square)
        });
        let other = guard(b, "second", GuardKind::Positive, INERTIA_PIVOT);
        let first = [guard(a, "first", GuardKind::Positive, INERTIA_PIVOT)];
        let mut plain = dividing(graph, &[a, b], vec![other.clone()]);
        assert_eq!(plain.at_hand(graph, &first, false), [other]);
        assert_eq!(plain.at_hand(graph, &first, true), first);
        let signed = guard(cos, "cos(theta)", GuardKind::Pivot, INERTIA_PIVOT);
        let [first] = first;
        let both = [first, signed];
        assert_eq!(plain.at_hand(graph, &both, false), both);
    }
}
