//! All roots: groups of them, their forms, an e-graph for each group, and the comparison with what went in.

use super::cost::{cost, running, runs, total};
use super::expand::{Atoms, Depth};
use super::extract::extract;
use super::language::{Classes, import};
use super::limits::{GROUP_LEAST, GROUP_NODES, GROUP_SEEDS, INNER_FORMS, MODEL_NODES, MODEL_WORK};
use super::normalise::{forms, normalise_within, rank};
use super::rules::grow;
use crate::symbolic::{Expr, Graph, Node};
use std::collections::{BTreeMap, BTreeSet};

/// What simplification may do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Whether to simplify at all.
    pub enabled: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options { enabled: true }
    }
}

/// The roots in cheaper forms, in their order. Each is identical to what went in, and together they are never dearer
/// by [`cost`].
pub fn simplify(graph: &mut Graph, roots: &[Expr], options: &Options) -> Vec<Expr> {
    if !options.enabled {
        return roots.to_vec();
    }
    let mut work = MODEL_WORK;
    let mut out = inner(graph, roots, &mut work);
    let mut nodes = MODEL_NODES;
    for group in groups(graph, &out) {
        let members: Vec<Expr> = group.iter().map(|i| out[*i]).collect();
        let better = one_group(graph, &members, &mut nodes, &mut work);
        for (i, e) in group.into_iter().zip(better) {
            out[i] = e;
        }
    }
    for (new, old) in out.iter_mut().zip(roots) {
        if new != old && !graph.identical(*new, *old) {
            *new = *old;
        }
    }
    if joint(graph, &out) <= joint(graph, roots) { out } else { roots.to_vec() }
}

/// Cost of all together; ties go by all work, parameters' included.
fn joint(graph: &Graph, roots: &[Expr]) -> (usize, usize) {
    (cost(graph, roots).weight(), total(graph, roots))
}

/// Denominators and arguments of functions, which expansion leaves closed, in normal form.
fn inner(graph: &mut Graph, roots: &[Expr], work: &mut usize) -> Vec<Expr> {
    let mut closed: BTreeSet<Expr> = BTreeSet::new();
    for e in graph.reachable(roots) {
        match graph.node(e) {
            Node::Product(factors) => closed.extend(factors.iter().filter(|(_, k)| *k < 0).map(|(b, _)| *b)),
            Node::Function(_, arguments) => closed.extend(arguments.iter().copied()),
            _ => {}
        }
    }
    let mut map: Vec<(Expr, Expr)> = Vec::new();
    closed.retain(|e| matches!(graph.node(*e), Node::Sum { .. } | Node::Product(_)));
    for e in closed.into_iter().take(INNER_FORMS) {
        let normal = normalise_within(graph, e, work);
        if normal != e {
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

fn one_group(graph: &mut Graph, roots: &[Expr], nodes: &mut usize, work: &mut usize) -> Vec<Expr> {
    let mut divisors: Vec<Atoms> = Vec::new();
    let mut seeds: Vec<Vec<Expr>> = Vec::with_capacity(roots.len());
    for root in roots {
        let mut all = vec![*root];
        if matches!(graph.node(*root), Node::Sum { .. } | Node::Product(_))
            && let Some((found, atoms)) =
                forms(graph, *root, Depth::Full, work).or_else(|| forms(graph, *root, Depth::Running, work))
        {
            let found: Vec<Expr> = found.into_iter().filter(|f| f != root && graph.identical(*f, *root)).collect();
            if !found.is_empty() {
                all.extend(found);
                divisors.push(atoms);
            }
        }
        seeds.push(all);
    }
    let cheapest: Vec<Expr> =
        seeds.iter().map(|all| all.iter().copied().min_by_key(|e| (rank(graph, *e), *e)).unwrap_or(all[0])).collect();
    let mut candidates = vec![roots.to_vec(), cheapest];
    candidates.extend(by_egraph(graph, &seeds, nodes));
    let best = candidates.into_iter().enumerate().min_by_key(|(i, c)| (joint(graph, c), *i)).map(|(_, c)| c);
    let best = best.unwrap_or_else(|| roots.to_vec());
    if best != roots {
        divisors.iter().for_each(|atoms| atoms.record(graph));
    }
    best
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
    *nodes -= grow(graph, &mut classes, &known).min(*nodes);
    extract(graph, &classes, &roots)
}
