//! Units of the models of the repository: those that declare some hold together, and what follows from them is right.

mod support;

use holonomy::{ConstrainedSystem, Description, UnitKind};
use quote::ToTokens;
use std::path::{Path, PathBuf};
use support::declared::{models, rust_files};

#[path = "../examples/four_bar/models.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has them")]
mod four_bar;
#[path = "../examples/rolling_disk/models.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has them")]
mod rolling_disk;

use four_bar::FourBar;
use rolling_disk::RollingDisk;

/// All files with models.
fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders: Vec<PathBuf> =
        ["tests", "tests/models", "tests/models/geometry", "examples"].map(|f| root.join(f)).into();
    let examples =
        std::fs::read_dir(root.join("examples")).expect("examples").map(|entry| entry.expect("an entry").path());
    let mut examples: Vec<PathBuf> = examples.filter(|path| path.is_dir()).collect();
    examples.sort();
    folders.extend(examples);
    folders.iter().flat_map(|folder| rust_files(folder)).collect()
}

#[test]
fn every_model_with_units_holds_together() {
    let mut with_units = 0;
    for file in files() {
        let source = std::fs::read_to_string(&file).expect("a source");
        for model in models(&source) {
            let tokens = model.to_token_stream();
            let Ok(declarations) = holonomy_engine::syntax::parse(tokens.clone()) else { continue };
            let mut diagnostics = holonomy_engine::syntax::Diagnostics::new();
            holonomy_engine::dimensions::declared(&declarations, &mut diagnostics);
            let units = holonomy_engine::dimensions::check(&declarations, &mut diagnostics);
            let errors: Vec<&str> = diagnostics.iter().map(|error| error.message.as_str()).collect();
            assert!(errors.is_empty(), "{} in {}: {errors:#?}", model.ident, file.display());
            let declared = declarations.fields.iter().any(|field| field.unit.is_some());
            with_units += usize::from(declared);
            assert_eq!(declared, units != Default::default(), "{}", model.ident);
        }
    }
    assert!(with_units >= 15, "{with_units} models with units");
}

fn assert_units(model: &Description, expected: &[(UnitKind, &str, &str)]) {
    for (kind, name, unit) in expected {
        assert_eq!(model.unit(*kind, name), Some(*unit), "{name}");
    }
}

#[test]
fn units_of_the_rolling_disk_follow() {
    use UnitKind::{Coordinate, Multiplier, Output, Parameter, Speed};
    assert_units(
        RollingDisk::MODEL,
        &[
            (Parameter, "j", "kg*m*m"),
            (Parameter, "g", "m/s/s"),
            (Coordinate, "x", "m"),
            (Coordinate, "y", "m"),
            (Coordinate, "phi", "1"),
            (Coordinate, "theta", "1"),
            (Coordinate, "psi", "1"),
            (Speed, "v1", "m/s"),
            (Speed, "v3", "m/s"),
            (Speed, "v4", "1/s"),
            (Speed, "v6", "1/s"),
            (Multiplier, "no_slip_along", "N"),
            (Multiplier, "contact", "N"),
            (Output, "friction", "1"),
        ],
    );
}

#[test]
fn units_of_the_four_bar_follow() {
    use UnitKind::{Coordinate, Input, Multiplier, Parameter, Speed};
    assert_units(
        FourBar::MODEL,
        &[
            (Parameter, "a", "m"),
            (Coordinate, "crank", "1"),
            (Coordinate, "rocker", "1"),
            (Speed, "dot_crank", "1/s"),
            (Speed, "dot_coupler", "1/s"),
            (Input, "tau", "N*m"),
            (Multiplier, "closure_x", "N"),
            (Multiplier, "closure_y", "N"),
        ],
    );
    assert_eq!(FourBar::MODEL.unit(Coordinate, "tau"), None);
}
