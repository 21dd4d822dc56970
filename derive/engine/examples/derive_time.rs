//! How long the derive takes for every model of this repository, step by step, as users have it: unoptimised.
//!
//! ```text
//! cargo run -p holonomy-engine --example derive_time [FILE..]
//! ```

use holonomy_engine::{Step, expand_observed};
use quote::quote;
use std::path::PathBuf;
use std::time::{Duration, Instant};

const STEPS: [Step; 6] =
    [Step::Syntax, Step::Model, Step::Projection, Step::Simplification, Step::Program, Step::Emission];

/// Runs of each model; the fastest counts, since everything else on the machine only adds.
const RUNS: usize = 3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("milliseconds by step; expressions in the arena after simplification; weight of the programs\n");
    println!(
        "{:24} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}",
        "model", "syntax", "model", "project", "simplify", "program", "emit", "total", "nodes", "weight"
    );
    for file in files()? {
        for item in syn::parse_file(&std::fs::read_to_string(&file)?)?.items {
            let syn::Item::Struct(item) = item else { continue };
            let tokens = quote!(#item);
            let fastest = (0..RUNS).map(|_| time(tokens.clone())).min_by_key(|run| run.total());
            if let Some(run) = fastest {
                run.print(&item.ident.to_string());
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
    for entry in std::fs::read_dir(top.join("tests/models"))? {
        files.push(entry?.path());
    }
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

    fn print(&self, name: &str) {
        print!("{name:24}");
        for duration in self.durations.iter().chain(std::iter::once(&self.total())) {
            print!(" {:8.1}", duration.as_secs_f64() * 1e3);
        }
        println!(" {:8} {:8}", self.left[3], self.left[4]);
    }
}
