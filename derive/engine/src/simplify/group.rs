//! All roots: groups of them, their forms, an e-graph for each group, and the comparison with what went in.

use super::cost::{cost, running, runs, total};
use super::expand::{Atoms, Depth};
use super::extract::extract;
use super::language::{Classes, import};
use super::limits::{GROUP_LEAST, GROUP_NODES, GROUP_SEEDS, INNER_FORMS, MODEL_NODES, MODEL_WORK, OPENED_TOGETHER};
use super::normalise::{forms, normalise_within, rank};
use super::rules::grow;
use crate::symbolic::{Expr, Function, Graph, Node};
use std::collections::{BTreeMap, BTreeSet};

/// How far cheaper forms are searched.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Search {
    /// Not at all.
    Off,
    /// Canonical forms of each expression alone.
    Forms,
    /// These, and what an e-graph finds among them.
    #[default]
    Full,
}

/// The roots in cheaper forms, in their order. Each is identical to what went in, and together they are never dearer
/// by [`cost`].
pub fn simplify(graph: &mut Graph, roots: &[Expr], search: Search) -> Vec<Expr> {
    let found = candidates(graph, roots, search).into_iter().chain([roots.to_vec()]);
    found.enumerate().min_by_key(|(i, out)| (joint(graph, out), *i)).map(|(_, out)| out).unwrap_or_default()
}

/// All roots in the forms that the search found, what it found by more of it first; each is identical to what went in.
pub fn candidates(graph: &mut Graph, roots: &[Expr], search: Search) -> Vec<Vec<Expr>> {
    if search == Search::Off {
        return Vec::new();
    }
    let mut work = MODEL_WORK;
    let mut forms = inner(graph, roots, &mut work);
    let mut all = forms.clone();
    let mut nodes = if search == Search::Full { MODEL_NODES } else { 0 };
    for group in groups(graph, &forms) {
        let members: Vec<Expr> = group.iter().map(|i| forms[*i]).collect();
        let (simpler, cheaper) = one_group(graph, &members, &mut nodes, &mut work);
        for ((i, form), e) in group.into_iter().zip(simpler).zip(cheaper) {
            (forms[i], all[i]) = (form, e);
        }
    }
    for found in [&mut forms, &mut all] {
        for (new, old) in found.iter_mut().zip(roots) {
            if new != old && !graph.proven(*new, *old) {
                *new = *old;
            }
        }
    }
    if forms == all { vec![all] } else { vec![all, forms] }
}

/// Cost of all together; ties go by all work, parameters' included.
fn joint(graph: &Graph, roots: &[Expr]) -> (usize, usize) {
    (cost(graph, roots).weight(), total(graph, roots))
}

/// Denominators and arguments of functions, which expansion leaves closed, in normal form.
fn inner(graph: &mut Graph, roots: &[Expr], work: &mut usize) -> Vec<Expr> {
    let (mut closed, mut angles): (BTreeSet<Expr>, BTreeSet<Expr>) = Default::default();
    for e in graph.reachable(roots) {
        match graph.node(e) {
            Node::Product(factors) => closed.extend(factors.iter().filter(|(_, k)| *k < 0).map(|(b, _)| *b)),
            Node::Function(function, arguments) => {
                closed.extend(arguments.iter().copied());
                if matches!(function, Function::Sin | Function::Cos) {
                    angles.extend(arguments.iter().copied());
                }
            }
            _ => {}
        }
    }
    let mut map: Vec<(Expr, Expr)> = Vec::new();
    closed.retain(|e| matches!(graph.node(*e), Node::Sum { .. } | Node::Product(_)));
    for e in closed.into_iter().take(INNER_FORMS) {
        let normal = normalise_within(graph, e, work);
        // Angles are told by their terms: one that is no sum any more could not be related to itself.
        let related = !angles.contains(&e) || {
            let (before, after) = (graph.sin(e), graph.sin(normal));
            graph.identical(before, after)
        };
        if normal != e && related {
            if graph.is_nonzero(e) {
                graph.assume_nonzero(normal);
            }
            map.push((e, normal));
        }
    }
    graph.replace(roots, &map)
}

/// Places of the roots that run, in order, packed while the expressions of a group stay few.
fn groups(graph: &Graph, roots: &[Expr]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut members: Vec<Expr> = Vec::new();
    for (i, root) in roots.iter().enumerate().filter(|(_, root)| runs(graph, **root)) {
        members.push(*root);
        match groups.last_mut() {
            Some(group) if running(graph, &members).len() <= GROUP_SEEDS => group.push(i),
            _ => {
                members = vec![*root];
                groups.push(vec![i]);
            }
        }
    }
    groups
}

/// One group by canonical forms alone, and by these and the e-graph.
fn one_group(graph: &mut Graph, roots: &[Expr], nodes: &mut usize, work: &mut usize) -> (Vec<Expr>, Vec<Expr>) {
    let mut divisors: Vec<Atoms> = Vec::new();
    let mut seeds: Vec<Vec<Expr>> = Vec::with_capacity(roots.len());
    for root in roots {
        let mut all = vec![*root];
        if matches!(graph.node(*root), Node::Sum { .. } | Node::Product(_))
            && running(graph, &[*root]).len() <= OPENED_TOGETHER
            && let Some((found, atoms)) =
                forms(graph, *root, Depth::Full, work).or_else(|| forms(graph, *root, Depth::Running, work))
        {
            let found: Vec<Expr> = found.into_iter().filter(|f| f != root && graph.proven(*f, *root)).collect();
            if !found.is_empty() {
                all.extend(found);
                divisors.push(atoms);
            }
        }
        seeds.push(all);
    }
    let cheapest: Vec<Expr> =
        seeds.iter().map(|all| all.iter().copied().min_by_key(|e| (rank(graph, *e), *e)).unwrap_or(all[0])).collect();
    let weighed = |graph: &Graph, form: Vec<Expr>| (joint(graph, &form), form);
    let (raw, cheapest) = (weighed(graph, roots.to_vec()), weighed(graph, cheapest));
    let forms = if cheapest.0 < raw.0 { cheapest } else { raw };
    let best = match by_egraph(graph, &seeds, nodes).map(|found| weighed(graph, found)) {
        Some(found) if found.0 < forms.0 => found.1,
        _ => forms.1.clone(),
    };
    if best != roots || forms.1 != roots {
        divisors.iter().for_each(|atoms| atoms.record(graph));
    }
    (forms.1, best)
}

/// The group through an e-graph that holds every seed.
fn by_egraph(graph: &mut Graph, seeds: &[Vec<Expr>], nodes: &mut usize) -> Option<Vec<Expr>> {
    let raw: Vec<Expr> = seeds.iter().map(|all| all[0]).collect();
    let size = running(graph, &raw).len();
    if *nodes < GROUP_NODES || !(GROUP_LEAST..=GROUP_NODES / 2).contains(&size) {
        return None;
    }
    let mut classes = Classes::new(());
    let mut known = BTreeMap::new();
    let roots = import(graph, &mut classes, &mut known, &raw);
    for (all, root) in seeds.iter().zip(&roots) {
        for form in &all[1..] {
            if classes.total_size() > GROUP_NODES {
                break;
            }
            let id = import(graph, &mut classes, &mut known, &[*form])[0];
            classes.union(*root, id);
        }
    }
    classes.rebuild();
    let before = (classes.total_size(), classes.number_of_classes());
    *nodes -= grow(graph, &mut classes, &known).min(*nodes);
    // Where no rule finds anything, the best of what is there is known already.
    if before == (classes.total_size(), classes.number_of_classes()) {
        return None;
    }
    extract(graph, &classes, &roots)
}
