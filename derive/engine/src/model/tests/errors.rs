//! Several errors at once, and what the tables of errors share.

use super::errors;

/// The errors of a model of two coordinates x, y with these statements; a statement that is not there is added. The
/// fields are m, l: f64 and track: String. Columns are those in the statements as written here.
pub(super) fn of(statements: &str) -> Vec<String> {
    let mut source = statements.to_owned();
    for (name, default) in
        [("coordinates", "#[coordinates(x, y)]"), ("inertia", "#[inertia(diag(m, m))]"), ("forces", "#[forces(0, 0)]")]
    {
        if !source.contains(&format!("#[{name}(")) {
            source.push_str(&format!("\n{default}"));
        }
    }
    source.push_str("\nstruct Model { m: f64, l: f64, track: String }");
    errors(&source)
}

#[test]
fn missing_statements() {
    assert_eq!(
        errors("struct Model;"),
        [
            "1:8 `Model`: the model has no `coordinates`; add `#[coordinates(..)]`",
            "1:8 `Model`: the model has no `inertia`; add `#[inertia(..)]`",
            "1:8 `Model`: the model has no `forces`; add `#[forces(..)]`",
        ]
    );
}

#[test]
fn names_of_fields() {
    let source = "#[coordinates(x)] #[inertia(diag(1))] #[forces(0)]
        struct Model { t: f64, PI: f64, x: f64, #[nominal(m)] m: f64, #[nominal(1)] n: String }";
    assert_eq!(
        errors(source),
        [
            "2:24 `t`: `t` is reserved for the time; choose another name",
            "2:32 `PI`: `PI` is reserved for the number π; choose another name",
            "1:15 `x`: `x` cannot be a coordinate: it is a field already",
            "2:59 `m`: `m` is a parameter, but this is a value for judging, which is made of numbers and `PI` only",
            "2:81 `1`: the field `n` is no parameter; `nominal` needs `f64` or a type parameter",
        ]
    );
}

/// Errors of all parts of a model come in one go, those in expressions that could not be read included.
#[test]
fn all_errors_at_once() {
    let source = "
        #[coordinates(x, y, x)]
        #[inertia(diag(m, M, m^2))]
        #[forces(-m*g*sin(thta), 1/0)]
        #[constraint(rod: x*x + y*y = l*l)]
        #[constraint(other: m == 2)]
        #[define(theta = x)]
        struct Model { m: f64, l: f64 }";
    let (declarations, mut diagnostics) = crate::syntax::read(source.parse().unwrap());
    // The constraint with `=` is lost, so the model is not checked before it is mended.
    assert!(!declarations.unwrap().complete);
    assert_eq!(diagnostics.iter().count(), 2);
    let source = source.replace("y*y = l", "y*y == l");
    let (declarations, more) = crate::syntax::read(source.parse().unwrap());
    let declarations = declarations.unwrap();
    assert!(declarations.complete);
    diagnostics = more;
    diagnostics.extend(super::build(&declarations).unwrap_err());
    assert_eq!(
        super::rendered(&source, &diagnostics),
        [
            "3:31 `^`: `^` is not a power in Rust; write `powi(x, 2)`",
            "2:29 `x`: `x` cannot be a coordinate: it is a coordinate already",
            "3:27 `M`: cannot find `M` in this model; did you mean `m`?",
            "4:11 `forces`: `forces` has 2 entries, but the model has 3 speeds",
            "4:21 `g`: cannot find `g` in this model",
            "4:27 `thta`: cannot find `thta` in this model; did you mean `theta`?",
            "4:35 `/`: division by zero",
            "6:22 `other`: the constraint `other` binds no coordinate and no speed",
        ]
    );
}
