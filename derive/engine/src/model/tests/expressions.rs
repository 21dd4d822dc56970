//! Errors inside expressions, each at its token.

use super::errors::of;
use crate::symbolic::Expr;

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
                "1:10 `N`: `N` is a frame; its axes are `N.x`, `N.y` and `N.z`",
                "1:13 `O`: expected a scalar, found a vector; write a component such as `dot(a, N.x)`, or `norm(a)`",
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
            &["1:10 `dot`: `dot` takes vectors, such as `A.x` or a point", "1:25 `q`: cannot find `q` in this model"],
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

/// What a model with families says is what it says with every name written out.
#[test]
fn families_are_what_they_stand_for() {
    let families = "
        #[size(n = 3, last = n - 1)]
        #[coordinates(a[n])]
        #[speeds(w[n])]
        #[inputs(tau[n])]
        #[kinematics(dot(a[i]) = w[i] for i in 0..n)]
        #[define(s[0] = l[0]*sin(a[0]), s[i] = s[i - 1] + l[i]*sin(a[i]) for i in 1..n)]
        #[inertia(matrix([l[i]*l[j]*sum(max(i, j)..n, |k| m[k]) for j in 0..n] for i in 0..n))]
        #[forces(tau[i] - sum(i..n, |k| m[k])*g*l[i]*sin(a[i])/n + product(0..i, |k| s[k]) for i in 0..n)]
        #[constraint(chain[i]: a[i] == a[i + 1] + w[last] for i in 0..last)]
        #[independent(w[i] for i in last..=last)]
        #[start(a[i] = (i + 1)/10 for i in 0..n)]
        struct Model { m: [f64; 3], l: [f64; 3], g: f64 }";
    let written = "
        #[coordinates(a_0, a_1, a_2)]
        #[speeds(w_0, w_1, w_2)]
        #[inputs(tau_0, tau_1, tau_2)]
        #[kinematics(dot(a_0) = w_0, dot(a_1) = w_1, dot(a_2) = w_2)]
        #[define(s_0 = l_0*sin(a_0), s_1 = s_0 + l_1*sin(a_1), s_2 = s_1 + l_2*sin(a_2))]
        #[inertia(matrix(
            [l_0*l_0*(m_0 + m_1 + m_2), l_0*l_1*(m_1 + m_2), l_0*l_2*m_2],
            [l_1*l_0*(m_1 + m_2), l_1*l_1*(m_1 + m_2), l_1*l_2*m_2],
            [l_2*l_0*m_2, l_2*l_1*m_2, l_2*l_2*m_2],
        ))]
        #[forces(
            tau_0 - (m_0 + m_1 + m_2)*g*l_0*sin(a_0)/3 + 1,
            tau_1 - (m_1 + m_2)*g*l_1*sin(a_1)/3 + s_0,
            tau_2 - m_2*g*l_2*sin(a_2)/3 + s_0*s_1,
        )]
        #[constraint(chain_0: a_0 == a_1 + w_2, chain_1: a_1 == a_2 + w_2)]
        #[independent(w_2)]
        #[start(a_0 = 1/10, a_1 = 2/10, a_2 = 3/10)]
        struct Model { m_0: f64, m_1: f64, m_2: f64, l_0: f64, l_1: f64, l_2: f64, g: f64 }";
    assert_eq!(text(families), text(written));
}

/// Coordinates that a configuration gives are no arrays that it introduces; its speeds are. A word follows every entry.
#[test]
fn families_in_configurations_and_words_about_them() {
    let families = "
        #[size(n = 2)]
        #[coordinates(x[n], y[n])]
        #[inertia(diag(1 for i in 0..2*n))]
        #[forces(x[i] for i in 0..n, y[i] for i in 0..n)]
        #[configuration(
            of(a[n]),
            speeds(u[n]),
            dot(a[i]) = (i + 1)*u[i] for i in 0..n,
            x[i] = sum(0..=i, |j| sin(a[j])) for i in 0..n,
            y[i] = sum(0..=i, |j| cos(a[j])) for i in 0..n,
        )]
        #[constraint(first[i]: dot(x[i]) == 0 for i in 0..n)]
        #[constraint(again[i]: 2*dot(x[i]) == 0 for i in 0..n, redundant)]
        struct Model { m: f64 }";
    let written = "
        #[coordinates(x_0, x_1, y_0, y_1)]
        #[inertia(diag(1, 1, 1, 1))]
        #[forces(x_0, x_1, y_0, y_1)]
        #[configuration(
            of(a_0, a_1),
            speeds(u_0, u_1),
            dot(a_0) = u_0,
            dot(a_1) = 2*u_1,
            x_0 = sin(a_0),
            x_1 = sin(a_0) + sin(a_1),
            y_0 = cos(a_0),
            y_1 = cos(a_0) + cos(a_1),
        )]
        #[constraint(first_0: dot(x_0) == 0)]
        #[constraint(first_1: dot(x_1) == 0)]
        #[constraint(again_0: 2*dot(x_0) == 0, redundant)]
        #[constraint(again_1: 2*dot(x_1) == 0, redundant)]
        struct Model { m: f64 }";
    let said = text(families);
    assert_eq!(said, text(written));
    assert!(said.2.contains("[false, false, true, true]"), "{}", said.2);
}

/// A system in words: its expressions, the names of its rows, and what else is said.
fn text(source: &str) -> (Vec<String>, Vec<String>, String) {
    let system = super::super::build(&super::declarations(source)).unwrap();
    let rows = system.rows.iter().map(|row| match row.kind {
        super::super::RowKind::Position(e) | super::super::RowKind::Velocity(e) => e,
        _ => panic!("neither"),
    });
    let all: Vec<Expr> =
        system.inertia.entries().iter().copied().chain(system.forces.iter().copied()).chain(rows).collect();
    let names: Vec<String> = system.rows.iter().map(|row| row.name.clone()).collect();
    let redundant: Vec<bool> = system.rows.iter().map(|row| row.redundant).collect();
    (system.graph.display_all(&all), names, format!("{:?} {redundant:?}", system.start))
}

#[test]
fn arrays_are_named_by_their_entries() {
    assert_eq!(
        of("#[coordinates(a[2])] #[inertia(diag(1, 1))] #[forces(a, b[0])]"),
        [
            "1:54 `a`: `a` is an array of 2; name an entry, such as `a[0]`",
            "1:57 `b`: cannot find `b_0` in this model; did you mean `a_0`?",
        ]
    );
}

#[test]
fn functions_of_the_model() {
    let table: &[(&str, &[&str])] = &[
        (
            "#[function(road(s), derivatives = [droad])] #[forces(road, road(x, y))]",
            &[
                "1:54 `road`: `road` is a function and needs an argument, such as `road(x)`",
                "1:60 `road`: `road` takes 1 argument, not 2",
            ],
        ),
        (
            "#[function(road(s))] #[forces(raod(x), 0)]",
            &["1:31 `raod`: there is no function `raod`; did you mean `road`?"],
        ),
        (
            "#[function(sin(s))] #[function(x(s))]",
            &[
                "1:12 `sin`: `sin` cannot be a function of the model: it is a function of the language already",
                "1:32 `x`: `x` cannot be a function: it is a coordinate already",
            ],
        ),
    ];
    for (statements, expected) in table {
        assert_eq!(of(statements), *expected, "{statements}");
    }
}
