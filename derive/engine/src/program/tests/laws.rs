//! Bounds of the emitted code, and names.

use super::check;
use super::disks::disk;
use super::models::{chain, outputs};
use crate::program::layout::{FLAT, LARGEST_FUNCTION, results};
use crate::program::names::{Namer, identifier};
use crate::program::{Layout, programs};
use std::collections::BTreeSet;

#[test]
fn long_programs_stand_in_blocks_and_functions() {
    let programs = check(&chain(2_500));
    let program = programs.function("multipliers").expect("it exists");
    assert!(program.count.operations() > 10_000, "{:?}", program.count);
    let Layout { parts, names } = &program.layout;
    assert!(parts.len() > 1);
    let mut seen: BTreeSet<u32> = BTreeSet::new();
    for part in parts {
        let lets: usize = part.blocks.iter().map(|b| b.lets.len()).sum();
        assert!(lets <= LARGEST_FUNCTION && part.blocks.len() <= FLAT);
        let mut scope: BTreeSet<u32> = part.enter.iter().copied().collect();
        assert!(scope.iter().all(|r| seen.contains(r)), "what enters was computed before");
        for block in &part.blocks {
            assert!(block.lets.len() <= FLAT);
            let own: BTreeSet<u32> = block.lets.iter().flat_map(results).collect();
            assert!(block.leave.iter().all(|r| own.contains(r)));
            seen.extend(&own);
            scope.extend(&block.leave);
        }
    }
    let distinct: BTreeSet<&String> = names.iter().flatten().collect();
    assert_eq!(distinct.len(), names.iter().flatten().count());
}

#[test]
fn the_same_model_gives_the_same_programs() {
    let [a, b] = [0, 1].map(|_| programs(&disk()).expect("the functions read what they may"));
    for (a, b) in a.functions.iter().zip(&b.functions) {
        assert_eq!((&a.code, &a.layout), (&b.code, &b.layout));
    }
    assert_eq!(a.names, b.names);
    assert_eq!((a.values.code, a.values.layout), (b.values.code, b.values.layout));
}

#[test]
fn names_say_what_they_stand_for() {
    let programs = check(&disk());
    assert!(programs.names.values.iter().any(|n| n == "m_r_r"));
    assert!(programs.names.values.iter().any(|n| n == "two_j_plus_m_r_r"));
    let derivative = programs.function("derivative").expect("it exists");
    let names: BTreeSet<&str> = derivative.layout.names.iter().flatten().map(String::as_str).collect();
    for name in ["sin_theta", "cos_theta", "sin_phi", "cos_phi"] {
        assert!(names.contains(name), "{names:?}");
    }
}

#[test]
fn names_never_collide() {
    let mut namer = Namer::avoiding(["p", "t"]);
    let given = ["p", "type", "type", "self", "a1", "closure.x"].map(|n| namer.unique(n));
    assert_eq!(given, ["p_2", "r#type", "type_2", "self_", "a1", "closure_x"]);
    assert_eq!(namer.numbered('a'), "a2");
    assert_eq!(identifier("2nd"), "_2nd");
    // A product and a speed of one name.
    let programs = check(&outputs(|g, v| {
        let a = g.mul(v[3], v[4]);
        let b = g.mul(a, v[5]);
        vec![a, b, g.sin(a)]
    }));
    let names = &programs.function("multipliers").expect("it exists").layout.names;
    let distinct: BTreeSet<&String> = names.iter().flatten().collect();
    assert_eq!(distinct.len(), names.iter().flatten().count());
}
