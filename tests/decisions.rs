//! What the derive decides for every model of the tests, as text: its speeds and charts, notes with their reasons, what it guards,
//! its outputs, and what its functions cost.
//!
//! The texts stand in `data/decisions`, one for each file of tests that declares models and for each file of `models`, and one beside
//! each model of that folder itself, where there are models of whose kind there is none among the others. `HOLONOMY_BLESS=1` writes them anew: a change of a decision, of a
//! reason or of a cost is then read as text. Other tests say whether the equations are right.

mod support;

use holonomy_engine::program::{Programs, programs};
use holonomy_engine::projection::{Equations, Guard};
use holonomy_engine::symbolic::Symbol;
use quote::ToTokens;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use support::declared::{models, rust_files};
use support::{kept, parallel};

fn guard(guard: &Guard) -> String {
    let start = guard.start.map_or(String::new(), |value| format!(", {value:.3e} at the start"));
    let rows = if guard.rows.is_empty() { String::new() } else { format!(" of {}", guard.rows.join(", ")) };
    format!("{} ({:?}; {}{rows}{start})", guard.name, guard.kind, guard.origin)
}

fn cost(programs: &Programs) -> impl Iterator<Item = String> {
    let all = programs.functions.iter().chain(&programs.charts);
    all.filter(|program| program.count.weight() > 0).map(|program| {
        let count = program.count;
        let [others, roots, selections] =
            [(count.others, "other functions"), (count.roots, "roots"), (count.selections, "selections")]
                .map(|(n, what)| if n > 0 { format!(", {n} {what}") } else { String::new() });
        format!(
            "{}: {} + {} * {} / {} sincos{roots}{selections}{others}",
            program.entry.name, count.additions, count.multiplications, count.divisions, count.sincos
        )
    })
}

fn decisions(model: &syn::ItemStruct) -> String {
    let mut out = format!("{}\n", model.ident);
    let e = holonomy_engine::analyse(model.to_token_stream())
        .unwrap_or_else(|errors| panic!("{}: {:?}", model.ident, errors.iter().map(|e| &e.message).collect::<Vec<_>>()))
        .equations;
    let Equations { graph, .. } = &e;
    let names = |symbols: &[Symbol]| symbols.iter().map(|s| graph.name(*s)).collect::<Vec<_>>().join(", ");
    let mut line = |text: String| writeln!(out, "    {text}").expect("text");
    line(format!("state {}; {}", names(&e.state_coordinates), names(&e.state_speeds)));
    if e.reduced_speeds != e.state_speeds {
        line(format!("reduced to {}", names(&e.reduced_speeds)));
    }
    for row in &e.rows {
        let linear = if row.linear { "" } else { ", not linear" };
        let redundant = if row.redundant { ", redundant" } else { "" };
        line(format!("row {}: {:?}{linear}{redundant}", row.name, row.level));
    }
    for (name, _) in e.multiplier_names.iter().zip(&e.multiplier_rows).filter(|(_, row)| row.is_none()) {
        line(format!("multiplier {name} of no row of its own"));
    }
    e.notes.iter().for_each(|note| line(format!("note {note}")));
    e.guards.iter().for_each(|g| line(format!("guard {}", guard(g))));
    e.parameter_guards.iter().for_each(|g| line(format!("parameters {}", guard(g))));
    for (at, pivot) in e.relative_pivots.iter().enumerate() {
        if let Some(pivot) = pivot {
            line(format!("chart {at}: relative pivot {pivot:.3e}"));
        }
    }
    for (at, chart) in e.charts.iter().enumerate() {
        line(format!("chart {} in {}", at + 1, names(&chart.speeds)));
        chart.guards.iter().for_each(|g| line(format!("chart {} guard {}", at + 1, guard(g))));
    }
    let values = graph.display_all(&e.outputs.values);
    let carried = graph.display_all(&e.outputs.carried);
    for (at, (name, facts)) in e.outputs.names.iter().zip(e.output_facts()).enumerate() {
        let inputs = if facts.inputs { ", inputs" } else { "" };
        line(format!("output {name}: {:?}{inputs}, divides by [{}]", facts.level, facts.divisors.join(", ")));
        line(format!("    = {} = {}", values[at], carried[at]));
    }
    let programs = programs(&e).expect("every symbol is known");
    cost(&programs).for_each(&mut line);
    out
}

#[test]
fn decisions_are_as_they_were_read() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let folder = tests.join("data/decisions");
    let folders = [tests.clone(), tests.join("models"), folder.clone()];
    let files: Vec<_> = folders.iter().flat_map(|folder| rust_files(folder)).collect();
    let changed = parallel::each(files.len(), |number| {
        let file = &files[number];
        let source = fs::read_to_string(file).expect("the file can be read");
        let text: String = models(&source).iter().map(decisions).collect();
        if text.is_empty() {
            return None;
        }
        // Some files of tests have the name of a file with models.
        let own = if file.parent() == Some(&tests) { "of_" } else { "" };
        let name = format!("{own}{}.txt", file.file_stem().expect("a name").to_string_lossy());
        kept::changed(&folder.join(name), &text)
    });
    let changed: Vec<String> = changed.into_iter().flatten().collect();
    assert!(changed.is_empty(), "{}", changed.join("\n"));
}
