//! How long the derive takes for every model of this repository, step by step, as users have it: unoptimised. And what the search for
//! cheaper forms is worth: the operations of a whole derivative without it, with canonical forms alone, and with the e-graph.
//!
//! ```text
//! cargo run -p holonomy-engine --example derive_time [FILE..]
//! ```

use holonomy_engine::program::programs;
use holonomy_engine::simplify::Search;
use holonomy_engine::{Step, analyse_by, expand_observed, expand_plainly};
use quote::quote;
use std::path::PathBuf;
use std::time::{Duration, Instant};

const STEPS: [Step; 6] =
    [Step::Syntax, Step::Model, Step::Projection, Step::Simplification, Step::Program, Step::Emission];

/// Runs of each model; the fastest counts, since everything else on the machine only adds.
const RUNS: usize = 3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "milliseconds by step, and of all without a search for cheaper forms; expressions in the arena before and after"
    );
    println!(
        "it; tokens; operations of a derivative (with sines and cosines) without, with canonical forms, with all\n"
    );
    println!(
        "{:24} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>10} {:>10} {:>10}",
        "model",
        "syntax",
        "model",
        "project",
        "simplify",
        "program",
        "emit",
        "total",
        "plain",
        "nodes",
        "after",
        "tokens",
        "raw",
        "forms",
        "all"
    );
    for file in files()? {
        for item in syn::parse_file(&std::fs::read_to_string(&file)?)?.items {
            let syn::Item::Struct(item) = item else { continue };
            let tokens = quote!(#item);
            let fastest = (0..RUNS).map(|_| time(tokens.clone())).min_by_key(|run| run.total());
            if let Some(run) = fastest {
                run.print(&item.ident.to_string(), tokens);
            }
        }
    }
    Ok(())
}

/// The files named on the command line, or every file with models.
fn files() -> std::io::Result<Vec<PathBuf>> {
    let named: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    if !named.is_empty() {
        return Ok(named);
    }
    let top = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = vec![top.join("examples/rolling_disk/models.rs")];
    for folder in ["tests/models", "tests/models/geometry"] {
        for entry in std::fs::read_dir(top.join(folder))? {
            files.push(entry?.path());
        }
    }
    files.retain(|path| path.is_file());
    files.sort();
    Ok(files)
}

/// One run of the derive.
struct Run {
    durations: [Duration; STEPS.len()],
    left: [usize; STEPS.len()],
}

fn time(tokens: proc_macro2::TokenStream) -> Run {
    let mut run = Run { durations: Default::default(), left: Default::default() };
    let mut clock = Instant::now();
    expand_observed(tokens, &mut |step, left| {
        if let Some(at) = STEPS.iter().position(|s| *s == step) {
            run.durations[at] = clock.elapsed();
            run.left[at] = left;
        }
        clock = Instant::now();
    });
    run
}

impl Run {
    fn total(&self) -> Duration {
        self.durations.iter().sum()
    }

    fn print(&self, name: &str, tokens: proc_macro2::TokenStream) {
        let milliseconds = |duration: &Duration| duration.as_secs_f64() * 1e3;
        let [syntax, model, project, simplify, program, emit] = self.durations.each_ref().map(milliseconds);
        let clock = Instant::now();
        expand_plainly(tokens.clone());
        let (total, plain) = (milliseconds(&self.total()), milliseconds(&clock.elapsed()));
        let [_, _, nodes, after, _, emitted] = self.left;
        let [raw, forms, all] =
            [Search::Off, Search::Forms, Search::Full].map(|search| operations(tokens.clone(), search));
        println!(
            "{name:24} {syntax:7.1} {model:7.1} {project:7.1} {simplify:8.1} {program:7.1} {emit:7.1} {total:7.1} {plain:7.1} \
             {nodes:7} {after:7} {emitted:7} {raw:>10} {forms:>10} {all:>10}"
        );
    }
}

/// What a whole derivative costs.
fn operations(tokens: proc_macro2::TokenStream, search: Search) -> String {
    let Ok(analysis) = analyse_by(tokens, search) else { return "refused".to_owned() };
    let programs = programs(&analysis.equations).expect("every symbol is known");
    let count = programs.function("derivative").expect("every model has one").count;
    format!("{} + {}", count.operations(), count.sincos)
}
