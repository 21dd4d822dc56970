//! Programs against the graph they come from.

pub(crate) mod models;

use super::*;
use crate::projection::Equations;
use crate::symbolic::Symbol;
use models::{disk, disk_stage, pendulum};

/// A value for each symbol: fixed, away from zero, different from run to run.
fn value(run: usize) -> impl Fn(Symbol) -> f64 {
    move |symbol| 0.35 + ((symbol.index() * 7919 + run * 104_729) % 1009) as f64 / 1009.0
}

/// Every function of the model at a few points against the graph.
pub(crate) fn check(equations: &Equations) -> Programs {
    let programs = programs(equations).expect("the functions read what they may");
    for run in 0..3 {
        let values = value(run);
        for program in &programs.functions {
            let exact = equations.graph.evaluate(&program.entry.roots(), &values);
            let found = programs.evaluate(equations, program.entry.name, &values).expect("a known function");
            for (k, (a, b)) in exact.iter().zip(&found).enumerate() {
                assert!(
                    (a - b).abs() <= 1e-11 * (1.0 + a.abs()),
                    "{} {}: {a} and {b}",
                    program.entry.name,
                    program.entry.labels()[k]
                );
            }
        }
    }
    programs
}

#[test]
fn programs_equal_their_expressions() {
    for equations in [pendulum(), disk(), disk_stage()] {
        check(&equations);
    }
}

#[test]
fn show() {
    for equations in [pendulum(), disk(), disk_stage()] {
        let programs = check(&equations);
        for p in &programs.functions {
            println!("{} {:?} {}", p.entry.name, p.count, p.count.operations());
        }
        println!("values {:?}: {:?}", programs.values.count, programs.names.values);
    }
}
