//! Errors inside expressions, each at its token.

use super::errors::of;

#[test]
fn every_message_about_an_expression() {
    let table: &[(&str, &[&str])] = &[
        (r#"#[forces(xx, 0)]"#, &["1:10 `xx`: cannot find `xx` in this model; did you mean `x`?"]),
        (
            r#"#[coordinates(theta, phi)] #[forces(thetta, Phi)]"#,
            &[
                "1:37 `thetta`: cannot find `thetta` in this model; did you mean `theta`?",
                "1:45 `Phi`: cannot find `Phi` in this model; did you mean `phi`?",
            ],
        ),
        (
            r#"#[forces(track, 0)]"#,
            &["1:10 `track`: the field `track` has the type `String`; equations need `f64` or a type parameter"],
        ),
        (
            r#"#[forces(dot_x, 0)]"#,
            &["1:10 `dot_x`: cannot find `dot_x` in this model; the rate of `x` is written `dot(x)`"],
        ),
        (
            r#"#[forces(N, O)]"#,
            &[
                "1:10 `N`: `N` stands for the inertial frame, which is not supported yet",
                "1:13 `O`: `O` stands for the origin, which is not supported yet",
            ],
        ),
        (
            r#"#[forces(sin, cos(x, y))]"#,
            &[
                "1:10 `sin`: `sin` is a function and needs an argument, such as `sin(x)`",
                "1:15 `cos`: `cos` takes 1 argument, not 2",
            ],
        ),
        (
            r#"#[forces(sine(x), log(x))]"#,
            &[
                "1:10 `sine`: there is no function `sine`; did you mean `sin`?",
                "1:19 `log`: there is no function `log`; did you mean `ln`?",
            ],
        ),
        (
            r#"#[forces(x(2), m(y + 1))]"#,
            &[
                "1:10 `x`: `x` is a coordinate, not a function; write `*` to multiply",
                "1:16 `m`: `m` is a field, not a function; write `*` to multiply",
            ],
        ),
        (
            r#"#[forces(foo(x), atan2(y))]"#,
            &["1:10 `foo`: there is no function `foo`", "1:18 `atan2`: `atan2` takes 2 arguments, not 1"],
        ),
        (r#"#[forces(1/0, 1/(x - x))]"#, &["1:11 `/`: division by zero", "1:16 `/`: division by zero"]),
        (
            r#"#[forces(1/(powi(sin(x), 2) + powi(cos(x), 2) - 1), powi(x - x, -1))]"#,
            &["1:11 `/`: division by zero", "1:53 `powi`: division by zero"],
        ),
        (
            r#"#[forces(powi(x, y), powi(x, 1/2))]"#,
            &[
                "1:10 `powi`: the exponent of `powi` is an integer between -999 and 999; use `powf` for other powers",
                "1:22 `powi`: the exponent of `powi` is an integer between -999 and 999; use `powf` for other powers",
            ],
        ),
        (
            r#"#[forces(powi(x, 1000), powi(x, 2 - 3))]"#,
            &["1:10 `powi`: the exponent of `powi` is an integer between -999 and 999; use `powf` for other powers"],
        ),
        (
            r#"#[forces(sqrt(-1), ln(0))]"#,
            &["1:10 `sqrt`: `sqrt` has no real value here", "1:20 `ln`: `ln` has no real value here"],
        ),
        (
            r#"#[forces(atan2(0, 0), ln(-2))]"#,
            &["1:10 `atan2`: `atan2` has no real value here", "1:23 `ln`: `ln` has no real value here"],
        ),
        (
            r#"#[forces(asin(2), acos(-3/2))]"#,
            &["1:10 `asin`: `asin` has no real value here", "1:19 `acos`: `acos` has no real value here"],
        ),
        (
            r#"#[forces(powf(-2, 1/3), powf(x - x, -3/2))]"#,
            &["1:10 `powf`: `powf` has no real value here", "1:25 `powf`: division by zero"],
        ),
        (
            r#"#[forces(pow(x, y), max(x, y, 1))]"#,
            &[
                "1:10 `pow`: there is no function `pow`; did you mean `powf`?",
                "1:21 `max`: `max` takes 2 arguments, not 3",
            ],
        ),
        (
            r#"#[forces(if x < yy { 1/0 } else { y }, 0)]"#,
            &["1:17 `yy`: cannot find `yy` in this model; did you mean `y`?", "1:23 `/`: division by zero"],
        ),
        (
            r#"#[forces(dot(x*y), dot(m))]"#,
            &[
                "1:10 `dot`: `dot` takes the name of a coordinate; apply the chain rule, or make the expression a coordinate",
                "1:20 `dot`: `m` is a field; `dot` takes the name of a coordinate or of a speed",
            ],
        ),
        (
            r#"#[forces(dot(x, y), dot(q))]"#,
            &[
                "1:10 `dot`: `dot` with two arguments is the scalar product of vectors, which is not supported yet",
                "1:25 `q`: cannot find `q` in this model",
            ],
        ),
        (
            r#"#[forces(ddot(x), dot(dot(x)))]"#,
            &[
                "1:10 `ddot`: `ddot(x)` is an acceleration, but forces may depend on parameters, coordinates of `coordinates`, speeds, inputs and `t` only",
                "1:19 `dot`: the rate of a rate is written `ddot(x)`, with the name of a coordinate",
            ],
        ),
        (
            r#"#[forces(dot(), ddot(x, y))]"#,
            &["1:10 `dot`: `dot` takes 1 argument, not 0", "1:17 `ddot`: `ddot` takes 1 argument, not 2"],
        ),
    ];
    for (statements, expected) in table {
        assert_eq!(of(statements), *expected, "{statements}");
    }
}

/// The graph's text of each force of a model with the coordinates x and y and the parameter m.
fn forces(entries: &str) -> Vec<String> {
    let source = format!("#[coordinates(x, y)] #[inertia(diag(m, m))] #[forces({entries})] struct Model {{ m: f64 }}");
    let system = super::super::build(&super::declarations(&source)).unwrap();
    system.forces.iter().map(|e| system.graph.display(*e)).collect()
}

#[test]
fn a_choice_is_a_selection_by_a_sign() {
    assert_eq!(
        forces("if x < y { m } else { 2 }, if x > y { m } else { 2 }"),
        ["if x - y < 0 { m } else { 2 }", "if y - x < 0 { m } else { 2 }"]
    );
    assert_eq!(
        forces("if x <= y { m } else { 2 }, if x >= y { m } else { 2 }"),
        ["if y - x < 0 { 2 } else { m }", "if x - y < 0 { 2 } else { m }"]
    );
    assert_eq!(
        forces("m*if x < 0 { 1 } else if x < 1 { y } else { 2 }, if 1 < 2 { x } else { y }"),
        ["m*(if x < 0 { 1 } else { if x - 1 < 0 { y } else { 2 } })", "x"]
    );
}

#[test]
fn functions_that_are_built_of_others() {
    assert_eq!(forces("min(x, y), max(y, x)"), ["if x - y < 0 { x } else { y }", "if x - y < 0 { y } else { x }"]);
    assert_eq!(forces("powf(x, 5/2), powf(m, x)"), ["powi(x, 2)*sqrt(x)", "powf(m, x)"]);
    assert_eq!(forces("abs(-2*x), sign(-2*x)"), ["2*abs(x)", "-sign(x)"]);
    assert_eq!(forces("asin(-x) + atan(1), cosh(-x)*tanh(-y)"), ["PI/4 - asin(x)", "-cosh(x)*tanh(y)"]);
}
