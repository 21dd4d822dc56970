//! How other crates depend on the derive: without std, under strict lints, by another name.
//!
//! Each is written, built and run as a user's crate would be: what is emitted into this workspace's own tests shows neither the
//! lints on public items nor what happens without std.

mod crates;

use crates::Crate;
use holonomy::prelude::*;

/// A pendulum that every crate below shares.
const PENDULUM: &str = r#"
/// A pendulum in the plane.
#[derive(ConstrainedSystem, Clone, Copy, Debug)]
#[coordinates(
    /// To the right.
    x,
    y,
)]
#[inertia(diag(m, m))]
#[forces(tau, -m*g)]
#[inputs(
    /// A push to the right.
    tau
)]
#[potential_energy(m*g*y)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x))]
pub struct Pendulum {
    /// Mass.
    #[unit(kg)]
    pub m: f64,
    /// Length.
    #[unit(m)]
    pub l: f64,
    /// Gravity.
    #[nominal(9.81)]
    pub g: f64,
}
"#;

/// A library without std that simulates, and a program with std that prints what it says.
#[test]
fn a_crate_without_std() {
    let library = format!(
        r#"#![no_std]
//! A pendulum for small machines.

use holonomy::{{ConstrainedSystem, Error}};
{PENDULUM}
/// Where the pendulum is after a second.
pub fn after_a_second() -> Result<[f64; 3], Error> {{
    let pendulum = Pendulum {{ m: 2.0, l: 0.5, g: 9.81 }}.prepare()?;
    let start = PendulumState {{ x: 0.3, y: -0.4, dot_x: 0.0 }};
    let push = |t: f64, _: &PendulumState| PendulumInputs {{ tau: t }};
    let run = pendulum.simulate(start).inputs(push).tolerance(1e-12, 1e-12).until(1.0)?;
    Ok((*run.last().1).into())
}}
"#
    );
    let program = "fn main() {\n    let state = bare::after_a_second().expect(\"a run\");\n    println!(\"{} {} {}\", state[0], state[1], state[2]);\n}\n";
    let features = r#"default-features = false, features = ["libm", "derive"]"#;
    let made = Crate::new("bare", features, "", &[("lib.rs", &library), ("main.rs", program)]);
    let printed = made.cargo("run", &[]);
    let there: Vec<f64> = printed.split_whitespace().map(|x| x.parse().expect("a number")).collect();

    let pendulum = here::Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().expect("a pendulum");
    let start = here::PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let push = |t: f64, _: &here::PendulumState| here::PendulumInputs { tau: t };
    let run = pendulum.simulate(start).inputs(push).tolerance(1e-12, 1e-12).until(1.0).expect("a run");
    let here: [f64; 3] = (*run.last().1).into();
    for (a, b) in there.iter().zip(here) {
        assert!((a - b).abs() < 1e-10, "{there:?} {here:?}");
    }
    // std came in by no other feature
    let tree = made.cargo("tree", &["--edges", "normal,features", "--invert", "holonomy"]);
    assert!(tree.contains("\"libm\"") && !tree.contains("\"std\""), "{tree}");
}

/// The same pendulum with std.
mod here {
    use holonomy::ConstrainedSystem;

    #[derive(ConstrainedSystem, Clone)]
    #[coordinates(x, y)]
    #[inertia(diag(m, m))]
    #[forces(tau, -m*g)]
    #[inputs(tau)]
    #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    #[independent(dot(x))]
    pub struct Pendulum {
        pub m: f64,
        pub l: f64,
        pub g: f64,
    }
}

/// Everything that warns, and what warns only where it is asked to, is an error.
const STRICT: &str = "#![forbid(unsafe_code)]
#![deny(
    warnings,
    missing_docs,
    missing_debug_implementations,
    missing_copy_implementations,
    elided_lifetimes_in_paths,
    explicit_outlives_requirements,
    future_incompatible,
    keyword_idents,
    let_underscore_drop,
    macro_use_extern_crate,
    meta_variable_misuse,
    non_ascii_idents,
    nonstandard_style,
    redundant_lifetimes,
    rust_2018_idioms,
    rust_2021_compatibility,
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    unit_bindings,
    unreachable_pub,
    unused,
    unused_import_braces,
    unused_lifetimes,
    unused_macro_rules,
    unused_qualifications,
    unused_results,
    variant_size_differences,
    clippy::all,
    clippy::pedantic,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    clippy::float_arithmetic,
    clippy::many_single_char_names,
    clippy::missing_inline_in_public_items,
    clippy::single_char_lifetime_names,
    clippy::shadow_unrelated,
    clippy::default_trait_access
)]
#![allow(clippy::duplicated_attributes, reason = \"clippy takes the two masses of `diag(m, m)` for attributes\")]
//! A model under every lint.

use holonomy::ConstrainedSystem;
";

/// Larger models beside it.
const DISK: &str = include_str!("../examples/rolling_disk/models.rs");

fn disk() -> &'static str {
    let start = DISK.find("/// (6.2)").expect("the first disk");
    &DISK[start..]
}

#[test]
fn a_crate_under_strict_lints() {
    let library = format!("{STRICT}{PENDULUM}\n{}", disk().replace("Clone)]", "Clone, Copy, Debug)]"));
    let made = Crate::new("strict", "", "", &[("lib.rs", &library)]);
    made.cargo("build", &[]);
    made.cargo("doc", &["--no-deps"]);
    if made.attempt("clippy", &["--version"]).status.success() {
        made.cargo("clippy", &[]);
    }
}

/// A model that is private, whose emitted items are as private: nobody uses most of them, and no lint says so.
#[test]
fn a_private_model_in_a_strict_program() {
    let private =
        PENDULUM.replace("pub struct", "struct").replace("pub m", "m").replace("pub l", "l").replace("pub g", "g");
    let program = format!(
        "{STRICT}{private}\nfn main() -> Result<(), holonomy::Error> {{\n    \
         let _ = Pendulum {{ m: 2.0, l: 0.5, g: 9.81 }}.prepare()?;\n    Ok(())\n}}\n"
    );
    let made = Crate::new("strict-program", "", "", &[("main.rs", &program)]);
    made.cargo("run", &[]);
    if made.attempt("clippy", &["--version"]).status.success() {
        made.cargo("clippy", &[]);
    }
}

/// The package under another name, and the runtime reached through a crate that re-exports it.
#[test]
fn a_crate_that_calls_the_runtime_otherwise() {
    let runtime = format!(
        "mechanics = {{ path = {:?}, package = \"holonomy\" }}\n",
        concat!(env!("CARGO_MANIFEST_DIR"), "/runtime")
    );
    let program = format!(
        "use mechanics::ConstrainedSystem;\n{}\nfn main() -> Result<(), mechanics::Error> {{\n    \
         let pendulum = Pendulum {{ m: 2.0, l: 0.5, g: 9.81 }}.prepare()?;\n    \
         println!(\"{{}}\", pendulum.energy(0.0, &PendulumState {{ x: 0.0, y: -0.5, dot_x: 1.0 }}));\n    Ok(())\n}}\n",
        PENDULUM.replace("#[coordinates", "#[holonomy(crate = mechanics)]\n#[coordinates")
    );
    let made = Crate::with_dependencies("renamed", &runtime, &[("main.rs", &program)]);
    let energy: f64 = made.cargo("run", &[]).trim().parse().expect("a number");
    assert!((energy - (1.0 - 9.81)).abs() < 1e-12);
}

/// Without std and without libm there is one error, the runtime's own.
#[test]
fn a_crate_without_elementary_functions() {
    let library = format!("#![no_std]\nuse holonomy::ConstrainedSystem;\n{PENDULUM}");
    let features = r#"default-features = false, features = ["derive"]"#;
    let made = Crate::new("nothing", features, "", &[("lib.rs", &library)]);
    let output = made.attempt("build", &[]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success());
    let errors = said.lines().filter(|line| line.starts_with("error")).collect::<Vec<_>>();
    assert!(errors[0].contains("enable the feature `std` (default) or `libm`"), "{said}");
    assert_eq!(errors.len(), 2, "{said}");
    assert!(errors[1].contains("could not compile `holonomy`"), "{said}");
}
