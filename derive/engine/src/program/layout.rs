//! Which results get a `let`, in which block and in which function.
//!
//! rustc does not survive thousands of flat `let`s with debug information, and nested blocks are also the fastest form.

use super::names::{ARGUMENTS, Namer, Names};
use super::operation::{Code, Leaf, Operation, Reference};
use std::collections::BTreeMap;

/// A program with no more `let`s than this stands flat.
pub const FLAT: usize = 200;
/// `let`s in a block of a longer program.
const BLOCK: usize = 150;
/// A function above this many operations is split ...
pub const LARGEST_FUNCTION: usize = 8_000;
/// ... into functions of about this many.
const FUNCTION: usize = 6_000;
/// An expression longer than this many characters is split into two `let`s.
const WIDEST: usize = 96;

/// One `let`.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum Let {
    /// One result.
    One(Reference),
    /// Sine and cosine of one angle, those that are used.
    SineCosine {
        /// The angle.
        angle: Reference,
        /// The sine.
        sine: Option<Reference>,
        /// The cosine.
        cosine: Option<Reference>,
    },
}

/// `let`s in a scope of their own, and the results that leave it.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Block {
    /// The `let`s.
    pub lets: Vec<Let>,
    /// What later blocks or the results need.
    pub leave: Vec<Reference>,
}

/// Blocks in a function of their own. The last part of a program computes its results.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Part {
    /// What earlier parts computed and this one or a later one needs.
    pub enter: Vec<Reference>,
    /// The blocks.
    pub blocks: Vec<Block>,
}

/// How a program is written down.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Layout {
    /// The name of every step that has one; the others are written where they are used.
    pub names: Vec<Option<String>>,
    /// The functions; one for all but very large programs.
    pub parts: Vec<Part>,
}

impl Layout {
    /// The layout of a program whose results have the given labels; a weak label yields to a description.
    pub fn new(code: &Code, names: &Names, labels: &[(&str, bool)]) -> Self {
        let bound = bound(code, names);
        let names = name(code, names, labels, &bound);
        let (lets, homes) = lets(code, &bound);
        Layout { names, parts: parts(code, lets, &homes) }
    }
}

/// The steps that get a name: used twice, or too long to stand inside of another expression.
fn bound(code: &Code, names: &Names) -> Vec<bool> {
    let uses = code.uses();
    let mut bound = vec![false; code.operations.len()];
    let mut length = vec![0usize; code.operations.len()];
    for (at, operation) in code.operations.iter().enumerate() {
        let width = |r: Reference, bound: &[bool]| if bound[r as usize] { 8 } else { length[r as usize] };
        match operation {
            Operation::Read(leaf) => length[at] = Names::place(*leaf).len() + names.of(*leaf).len(),
            Operation::Number(number) => {
                length[at] = 16;
                bound[at] = uses[at] > 2 && super::names::word(number).is_some();
            }
            Operation::Sine(_) | Operation::Cosine(_) => bound[at] = true,
            other => {
                let mut operands: Vec<Reference> = other.operands();
                operands.sort_by_key(|r| std::cmp::Reverse(width(*r, &bound)));
                let mut total = 5 + operands.iter().map(|r| width(*r, &bound)).sum::<usize>();
                for r in &operands {
                    if total > WIDEST && !bound[*r as usize] && !code.operations[*r as usize].is_leaf() {
                        total = total + 8 - length[*r as usize];
                        bound[*r as usize] = true;
                    }
                }
                length[at] = total;
                let trivial = match other {
                    Operation::Negate(a) => matches!(code.operations[*a as usize], Operation::Read(_)),
                    _ => false,
                };
                bound[at] = uses[at] > 1 && !trivial;
            }
        }
    }
    bound
}

fn name(code: &Code, names: &Names, labels: &[(&str, bool)], bound: &[bool]) -> Vec<Option<String>> {
    let reads = |of: fn(&Leaf) -> bool| code.operations.iter().any(|o| matches!(o, Operation::Read(leaf) if of(leaf)));
    let (coordinates, carriers) =
        (reads(|leaf| matches!(leaf, Leaf::Coordinate(_))), reads(|leaf| matches!(leaf, Leaf::Carrier(_))));
    let rates = reads(|leaf| matches!(leaf, Leaf::CarrierRate(_)));
    let locals = names.coordinates.iter().filter(|_| coordinates);
    let locals = locals.chain(names.carriers.iter().filter(|_| carriers));
    let locals = locals.chain(names.carrier_rates.iter().filter(|_| rates)).map(String::as_str);
    let mut namer = Namer::avoiding(ARGUMENTS.iter().copied().chain(locals));
    let mut label: BTreeMap<Reference, (&str, bool)> = BTreeMap::new();
    for (output, text) in code.outputs.iter().zip(labels) {
        label.entry(*output).or_insert(*text);
    }
    let mut given: Vec<Option<String>> = vec![None; bound.len()];
    let mut texts: Vec<Option<String>> = vec![None; bound.len()];
    for (at, operation) in code.operations.iter().enumerate() {
        let called = code.called.get(&(at as Reference)).cloned();
        let described = called.or_else(|| names.describe(operation, &|r| texts[r as usize].clone()));
        if !bound[at] {
            texts[at] = described;
            continue;
        }
        let turn = matches!(operation, Operation::Sine(_) | Operation::Cosine(_));
        let plain = turn || matches!(operation, Operation::Number(_));
        let name = match (label.get(&(at as Reference)).filter(|_| !plain), described) {
            (Some((_, true)), Some(text)) => Some(namer.unique(&text)),
            (Some((label, _)), _) => Some(namer.unique(&label.to_lowercase())),
            (None, Some(text)) => Some(namer.unique(&text)),
            (None, None) => match operation {
                Operation::Sine(a) => Some(namer.unique(&format!("sin_{}", angle(&given, *a)))),
                Operation::Cosine(a) => Some(namer.unique(&format!("cos_{}", angle(&given, *a)))),
                _ => None,
            },
        };
        texts[at] = name.as_ref().map(|n| n.trim_start_matches("r#").to_owned());
        given[at] = Some(name.unwrap_or_else(|| namer.numbered('a')));
    }
    given
}

fn angle(given: &[Option<String>], angle: Reference) -> &str {
    given[angle as usize].as_deref().unwrap_or("angle")
}

/// The `let`s in order, and for every named step the first `let` it stands in and the last one that needs it.
fn lets(code: &Code, bound: &[bool]) -> (Vec<Let>, Vec<(usize, usize)>) {
    let mut lets: Vec<Let> = Vec::new();
    let mut at_angle: BTreeMap<Reference, usize> = BTreeMap::new();
    let mut homes = vec![(0, 0); bound.len()];
    for at in (0..bound.len()).filter(|at| bound[*at]) {
        let reference = at as Reference;
        let position = match &code.operations[at] {
            Operation::Sine(a) | Operation::Cosine(a) => {
                let position = *at_angle.entry(*a).or_insert_with(|| {
                    lets.push(Let::SineCosine { angle: *a, sine: None, cosine: None });
                    lets.len() - 1
                });
                if let Let::SineCosine { sine, cosine, .. } = &mut lets[position] {
                    match &code.operations[at] {
                        Operation::Sine(_) => *sine = Some(reference),
                        _ => *cosine = Some(reference),
                    }
                }
                position
            }
            _ => {
                lets.push(Let::One(reference));
                lets.len() - 1
            }
        };
        homes[at].0 = position;
    }
    // A step without a name is computed where its user is; results stand behind the last `let`.
    let end = lets.len();
    let mut place = vec![0; bound.len()];
    for output in &code.outputs {
        place[*output as usize] = end;
    }
    for at in (0..bound.len()).rev() {
        homes[at].1 = place[at];
        let home = if bound[at] { homes[at].0 } else { place[at] };
        if !bound[at] {
            homes[at].0 = home;
        }
        for operand in code.operations[at].operands() {
            let place = &mut place[operand as usize];
            *place = (*place).max(home);
        }
    }
    (lets, homes)
}

fn parts(code: &Code, lets: Vec<Let>, homes: &[(usize, usize)]) -> Vec<Part> {
    let named = |reference: Reference| homes[reference as usize];
    if lets.len() <= FLAT {
        return vec![Part { enter: Vec::new(), blocks: vec![Block { lets, leave: Vec::new() }] }];
    }
    let mut cost = vec![0usize; lets.len() + 1];
    let mut total = 0;
    for (at, operation) in code.operations.iter().enumerate() {
        if !operation.is_leaf() {
            cost[homes[at].0] += 1;
            total += 1;
        }
    }
    let limit = if total > LARGEST_FUNCTION { FUNCTION } else { usize::MAX };
    let mut parts = vec![Part::default()];
    let mut work = 0;
    for start in (0..lets.len()).step_by(BLOCK) {
        let end = (start + BLOCK).min(lets.len());
        let own: usize = cost[start..end].iter().sum();
        if work + own > limit && work > 0 {
            let enter = lets[..start].iter().flat_map(results).filter(|r| named(*r).1 >= start).collect();
            parts.push(Part { enter, blocks: Vec::new() });
            work = 0;
        }
        work += own;
        let leave = lets[start..end].iter().flat_map(results).filter(|r| named(*r).1 >= end).collect();
        let part = parts.last_mut().expect("one part at least");
        part.blocks.push(Block { lets: lets[start..end].to_vec(), leave });
    }
    parts
}

/// The names that a `let` binds.
pub fn results(statement: &Let) -> Vec<Reference> {
    match statement {
        Let::One(reference) => vec![*reference],
        Let::SineCosine { sine, cosine, .. } => sine.iter().chain(cosine).copied().collect(),
    }
}
