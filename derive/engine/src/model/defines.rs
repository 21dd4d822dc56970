//! Defines in the order of their dependence, which need not be that of their appearance.

use super::context::Context;
use super::lower::Vocabulary;
use super::names::Meaning;
use crate::syntax::{Diagnostics, Term, messages};

/// Lowers every define; those in a cycle are reported and stay without a value.
pub(super) fn lower(vocabulary: &mut Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    let defines = &vocabulary.declarations.defines;
    let needs: Vec<Vec<usize>> = defines
        .iter()
        .map(|define| {
            let names = define.value.terms().iter().filter_map(|(term, _)| match term {
                Term::Name(name) => vocabulary.names.get(name),
                _ => None,
            });
            let mut needs: Vec<usize> = names
                .filter_map(|meaning| match meaning {
                    Meaning::Define(i) => Some(i),
                    _ => None,
                })
                .collect();
            needs.dedup();
            needs
        })
        .collect();
    let mut done = vec![false; defines.len()];
    // A define follows all that it needs; each pass takes those that are ready.
    loop {
        let ready: Vec<usize> = (0..defines.len()).filter(|&i| !done[i] && needs[i].iter().all(|&k| done[k])).collect();
        if ready.is_empty() {
            break;
        }
        for i in ready {
            vocabulary.defines[i] = vocabulary.lower(&defines[i].value, Context::DEFINE, diagnostics);
            done[i] = true;
        }
    }
    while let Some(start) = done.iter().position(|done| !done) {
        let cycle = cycle_from(start, &needs, &done);
        match cycle.iter().min() {
            Some(&first) => {
                let turn = cycle.iter().position(|&i| i == first).unwrap_or_default();
                let round = cycle.iter().cycle().skip(turn).take(cycle.len() + 1);
                let names: Vec<String> = round.map(|&i| format!("`{}`", defines[i].name)).collect();
                diagnostics.report_local(&defines[first].name, messages::cycle(names.join(" → ")));
                cycle.iter().for_each(|&i| done[i] = true);
            }
            None => done[start] = true,
        }
        // What only needs a cycle is not to blame: it has no value and no error of its own.
        loop {
            let ready = (0..done.len()).find(|&i| !done[i] && needs[i].iter().all(|&k| done[k]));
            let Some(i) = ready else { break };
            vocabulary.defines[i] = vocabulary.lower(&defines[i].value, Context::DEFINE, diagnostics);
            done[i] = true;
        }
    }
}

/// Follows the first open need of each define until one comes round again.
fn cycle_from(start: usize, needs: &[Vec<usize>], done: &[bool]) -> Vec<usize> {
    let mut path = vec![start];
    while let Some(next) = path.last().and_then(|&i| needs[i].iter().copied().find(|&k| !done[k])) {
        match path.iter().position(|&i| i == next) {
            Some(at) => return path.split_off(at),
            None => path.push(next),
        }
    }
    Vec::new()
}
