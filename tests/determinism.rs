//! The same model gives the same bytes: in every process, and whatever was derived before it.

mod random;
mod support;

use quote::ToTokens;
use random::first;
use std::fs;
use std::path::Path;
use std::process::Command;
use support::declared;

/// Files with models, all of which go through the derive.
const SOURCES: [&str; 8] = [
    include_str!("../examples/rolling_disk/models.rs"),
    include_str!("models/blades.rs"),
    include_str!("models/bodies.rs"),
    include_str!("models/kinds.rs"),
    include_str!("models/linkages.rs"),
    include_str!("models/particles.rs"),
    include_str!("models/rolling_disc.rs"),
    include_str!("models/rolling_disk.rs"),
];
/// Random models beside them.
const RANDOM: usize = 20;
/// Names the file into which another process writes its expansions.
const WRITE_TO: &str = "HOLONOMY_EXPANSIONS";

/// The structs with statements of all sources, as the derive gets them.
fn models() -> Vec<syn::ItemStruct> {
    let generated = first(RANDOM, 7).into_iter().map(|model| model.source);
    let sources = SOURCES.iter().map(ToString::to_string).chain(generated);
    sources.flat_map(|source| declared::models(&source)).collect()
}

fn expansion(model: &syn::ItemStruct) -> String {
    let text = holonomy_engine::expand(model.to_token_stream()).to_string();
    assert!(!text.contains("compile_error"), "{} is refused", model.ident);
    text
}

fn all_expansions() -> Vec<String> {
    models().iter().map(expansion).collect()
}

/// The first place at which two expansions of a model differ, with what stands there.
fn difference(model: &syn::ItemStruct, a: &str, b: &str) -> Option<String> {
    let at = a.bytes().zip(b.bytes()).position(|(a, b)| a != b);
    let at = at.or((a.len() != b.len()).then(|| a.len().min(b.len())))?;
    let near = |text: &str| {
        let bytes = &text.as_bytes()[at.saturating_sub(60).min(text.len())..(at + 60).min(text.len())];
        String::from_utf8_lossy(bytes).into_owned()
    };
    Some(format!("{} at byte {at}:\n  {}\n  {}", model.ident, near(a), near(b)))
}

fn assert_same(what: &str, a: &[String], b: &[String]) {
    let models = models();
    assert!(a.len() == models.len() && b.len() == models.len(), "{what}: numbers of expansions");
    let differences: Vec<String> =
        models.iter().zip(a.iter().zip(b)).filter_map(|(model, (a, b))| difference(model, a, b)).collect();
    assert!(differences.is_empty(), "{what}:\n{}", differences.join("\n"));
}

/// Does nothing by itself; with [`WRITE_TO`] it is the other process.
#[test]
fn writes_its_expansions() {
    if let Some(path) = std::env::var_os(WRITE_TO) {
        let text = serde_json::to_string(&all_expansions()).expect("text");
        fs::write(path, text).expect("the expansions are written");
    }
}

#[test]
fn two_processes_give_the_same_bytes() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("expansions-{}.json", std::process::id()));
    let mut other = Command::new(std::env::current_exe().expect("this test"));
    let status = other.args(["--exact", "writes_its_expansions"]).env(WRITE_TO, &path).status().expect("it runs");
    assert!(status.success());
    let text = fs::read_to_string(&path).expect("the other process wrote its expansions");
    fs::remove_file(&path).expect("the file is there");
    let theirs: Vec<String> = serde_json::from_str(&text).expect("a list of texts");
    let ours = all_expansions();
    println!("{} models, {} bytes", ours.len(), ours.iter().map(String::len).sum::<usize>());
    assert_same("in another process", &ours, &theirs);
}

/// What is derived first leaves nothing behind: no interned name, no counter.
#[test]
fn the_order_of_the_models_does_not_matter() {
    let forwards = all_expansions();
    let mut backwards: Vec<String> = models().iter().rev().map(expansion).collect();
    backwards.reverse();
    assert_same("in another order", &forwards, &backwards);
}

/// rustc derives models on several threads of one process.
#[test]
fn models_derived_at_the_same_time_do_not_disturb_each_other() {
    let alone = all_expansions();
    let together: Vec<Vec<String>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..2).map(|_| scope.spawn(all_expansions)).collect();
        threads.into_iter().map(|thread| thread.join().expect("it derives")).collect()
    });
    for each in together {
        assert_same("beside another", &alone, &each);
    }
}
