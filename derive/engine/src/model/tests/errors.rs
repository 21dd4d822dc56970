use super::errors;

/// The errors of a model of two coordinates x, y with these statements; a statement that is not there is added. The
/// fields are m, l: f64 and track: String. Columns are those in the statements as written here.
fn of(statements: &str) -> Vec<String> {
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
fn every_message_at_its_place() {
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
                "1:10 `powi`: the exponent of `powi` is an integer between -999 and 999; use `sqrt` or `exp` and `ln` for other powers",
                "1:22 `powi`: the exponent of `powi` is an integer between -999 and 999; use `sqrt` or `exp` and `ln` for other powers",
            ],
        ),
        (
            r#"#[forces(powi(x, 1000), powi(x, 2 - 3))]"#,
            &[
                "1:10 `powi`: the exponent of `powi` is an integer between -999 and 999; use `sqrt` or `exp` and `ln` for other powers",
            ],
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
            r#"#[forces(dot(x*y), dot(m))]"#,
            &[
                "1:10 `dot`: `dot` takes the name of a coordinate; apply the chain rule, or make the expression a coordinate",
                "1:20 `dot`: `m` is a field; `dot` takes the name of a coordinate",
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
                "1:10 `ddot`: `ddot(x)` is an acceleration; acceleration-level equations are not supported yet",
                "1:19 `dot`: the rate of a rate is an acceleration; acceleration-level equations are not supported yet",
            ],
        ),
        (
            r#"#[forces(dot(), ddot(x, y))]"#,
            &["1:10 `dot`: `dot` takes 1 argument, not 0", "1:17 `ddot`: `ddot` takes 1 argument, not 2"],
        ),
        (r#"#[forces(0, 0, 0)]"#, &["1:3 `forces`: `forces` has 3 entries, but the model has 2 speeds"]),
        (r#"#[forces(0)]"#, &["1:3 `forces`: `forces` has 1 entry, but the model has 2 speeds"]),
        (r#"#[inertia(diag(m))]"#, &["1:3 `inertia`: `inertia` has 1 entry, but the model has 2 speeds"]),
        (
            r#"#[inertia(diag(m, dot(x)))]"#,
            &["1:19 `dot`: `dot(x)` is a rate, but the inertia may depend on parameters, coordinates and `t` only"],
        ),
        (
            r#"#[inertia(matrix([m, 0], [l, m]))]"#,
            &["1:27 `l`: the inertia is not symmetric: entry (1, 2) is `0`, but entry (2, 1) is `l`"],
        ),
        (r#"#[inertia(matrix([m, x*m + m], [m*(1 + x), m]))]"#, &[]),
        (
            r#"#[inertia(matrix([m, _], [_, m]))]"#,
            &["1:27 `_`: this entry and the one across the diagonal are both `_`; write one of them out"],
        ),
        (
            r#"#[inertia(matrix([_, 0], [0, m]))]"#,
            &["1:19 `_`: an entry on the diagonal does not follow by symmetry; write it out"],
        ),
        (
            r#"#[inertia(matrix([m, 0, 0], [0, m]))]"#,
            &["1:18 `[m, 0, 0]`: this row of `inertia` has 3 entries, but the model has 2 speeds"],
        ),
        (r#"#[inertia(matrix([m, 0]))]"#, &["1:3 `inertia`: `inertia` has 1 entry, but the model has 2 speeds"]),
        (
            r#"#[inputs(u)] #[inertia(diag(u, m))]"#,
            &["1:29 `u`: `u` is an input, but the inertia may depend on parameters, coordinates and `t` only"],
        ),
        (
            r#"#[inputs(u)] #[potential_energy(u + dot(x))]"#,
            &[
                "1:33 `u`: `u` is an input, but the potential energy may depend on parameters, coordinates and `t` only",
                "1:37 `dot`: `dot(x)` is a rate, but the potential energy may depend on parameters, coordinates and `t` only",
            ],
        ),
        (
            r#"#[inputs(u, x, m, PI, dot_y)]"#,
            &[
                "1:13 `x`: `x` cannot be an input: it is a coordinate already",
                "1:16 `m`: `m` cannot be an input: it is a field already",
                "1:19 `PI`: `PI` is reserved for the number π; choose another name",
                "1:23 `dot_y`: `dot_y` is the name of the rate of `y` in the generated code; choose another name",
            ],
        ),
        (
            r#"#[inputs(u)] #[constraint(a: x == u)]"#,
            &[
                "1:35 `u`: `u` is an input, but a constraint may depend on parameters, coordinates of `coordinates`, speeds and `t` only",
            ],
        ),
        (
            r#"#[define(a = b, b = c + 1, c = 2*a)] #[forces(a, 0)]"#,
            &["1:10 `a`: the define is needed for its own value: `a` → `b` → `c` → `a`"],
        ),
        (
            r#"#[define(a = a)] #[define(d = a + 1)] #[forces(d, 0)]"#,
            &["1:10 `a`: the define is needed for its own value: `a` → `a`"],
        ),
        (r#"#[define(a = b)]"#, &["1:14 `b`: cannot find `b` in this model"]),
        (
            r#"#[define(a = dot(x))] #[inertia(diag(m*a, m))]"#,
            &[
                "1:40 `a`: the define `a` contains a rate, but the inertia may depend on parameters, coordinates and `t` only",
            ],
        ),
        (r#"#[speeds(u, v)]"#, &["1:3 `speeds`: named speeds need `kinematics` that tell what they are"]),
        (r#"#[kinematics(u = dot(x))]"#, &["1:3 `kinematics`: kinematics need named speeds: add `#[speeds(..)]`"]),
        (
            r#"#[speeds(u)] #[kinematics(u = dot(x))]"#,
            &[
                "1:3 `speeds`: there must be as many speeds as coordinates: found 1, expected 2; fewer of them become independent by constraints",
            ],
        ),
        (r#"#[speeds(u, v)] #[kinematics(u = dot(x))]"#, &["1:19 `kinematics`: the kinematics leave out `v`"]),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), dot(y) = v)]"#,
            &[
                "1:19 `kinematics`: the kinematics give some speeds and some rates; give all speeds, or all rates `dot(x)`",
            ],
        ),
        (r#"#[speeds(u, v)] #[kinematics(u = dot(x), u = dot(y), v = dot(y))]"#, &["1:42 `u`: `u` is given twice"]),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), w = dot(y), v = dot(y))]"#,
            &["1:42 `w`: cannot find `w` in this model"],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), x = 1, m = 2, dot(u) = 3, dot(z) = 4, v = dot(y))]"#,
            &[
                "1:42 `x`: `x` is a coordinate; its rate is `dot(x)`",
                "1:49 `m`: `m` is a field; kinematics give a speed or the rate of a coordinate",
                "1:56 `dot(u)`: `dot(u)` is an acceleration; acceleration-level equations are not supported yet",
                "1:68 `dot(z)`: cannot find `z` in this model",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x)*dot(y), v = sin(dot(y)))]"#,
            &[
                "1:34 `dot(x)*dot(y)`: the kinematics must be linear in the rates, but the coefficient of `dot(x)` here is `dot(y)`",
                "1:53 `sin(dot(y))`: the kinematics must be linear in the rates, but the coefficient of `dot(y)` here is `cos(dot(y))`",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x) + dot(y), v = 2*dot(x) + 2*dot(y))]"#,
            &["1:19 `kinematics`: the kinematics cannot be inverted: `v - 2*u` does not depend on the rates"],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = 3*t)]"#,
            &["1:19 `kinematics`: the kinematics cannot be inverted: `v` does not depend on the rates"],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = cos(x)*dot(x) + sin(x)*dot(y), v = cos(x)*sin(x)*dot(x) + powi(sin(x), 2)*dot(y))]"#,
            &["1:19 `kinematics`: the kinematics cannot be inverted: `v - u*sin(x)` does not depend on the rates"],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(dot(x) = u*l, dot(y) = u)]"#,
            &[
                "1:19 `kinematics`: the kinematics cannot be inverted: `dot(x) - l*dot(y)` does not depend on the speeds",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(dot(x) = dot(y), dot(y) = u*v)]"#,
            &[
                "1:39 `dot`: `dot(y)` is a rate, but the kinematics give a rate by parameters, coordinates, `t` and speeds",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = v, v = dot(y))]"#,
            &[
                "1:34 `v`: `v` is a speed, but the kinematics give a speed by parameters, coordinates, `t` and rates such as `dot(x)`",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = 2*dot(y), dot(x) = u, dot(y) = v)]"#,
            &[
                "1:19 `kinematics`: the two directions do not fit together: substituting the rates, `v` gets the coefficient `2` of `v`",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x) + 1, v = dot(y), dot(x) = u, dot(y) = v)]"#,
            &[
                "1:19 `kinematics`: the two directions do not fit together: substituting the rates, `u` gets the additional term `1`",
            ],
        ),
        (r#"#[constraint(a: m == l)]"#, &["1:14 `a`: the constraint `a` binds no coordinate and no speed"]),
        (r#"#[constraint(a: t == 0)]"#, &["1:14 `a`: the constraint `a` binds no coordinate and no speed"]),
        (r#"#[constraint(a: x - x == 0)]"#, &["1:14 `a`: the constraint `a` binds no coordinate and no speed"]),
        (
            r#"#[constraint(a: powi(sin(x), 2) + powi(cos(x), 2) == y - y)]"#,
            &["1:14 `a`: the constraint `a` binds no coordinate and no speed"],
        ),
        (
            r#"#[constraint(a: dot(x) == dot(x))]"#,
            &["1:14 `a`: the constraint `a` binds no speed: all its coefficients vanish"],
        ),
        (r#"#[constraint(a: x == 0)] #[constraint(a: y == 0)]"#, &["1:39 `a`: there is a constraint `a` already"]),
        (
            r#"#[constraint(a: dot(x)*dot(x) == 0)]"#,
            &[
                "1:14 `a`: the constraint `a` is not linear in `dot(x)`; nonlinear velocity constraints are not supported yet",
            ],
        ),
        (
            r#"#[constraint(a: sqrt(dot(x)) == y)]"#,
            &[
                "1:14 `a`: the constraint `a` is not linear in `dot(x)`; nonlinear velocity constraints are not supported yet",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = dot(y))] #[constraint(a: dot(v) == 0)]"#,
            &["1:71 `dot`: `dot(v)` is an acceleration; acceleration-level equations are not supported yet"],
        ),
        (r#"#[constraint(a: z == 0)]"#, &["1:17 `z`: cannot find `z` in this model"]),
        (
            r#"#[configuration(x = y, y = 1)]"#,
            &["1:21 `y`: `y` is itself given by `configuration`; give it by the remaining coordinates"],
        ),
        (r#"#[configuration(x = 1, x = 2)]"#, &["1:24 `x`: `x` is given twice"]),
        (
            r#"#[configuration(z = 1, m = 2)]"#,
            &[
                "1:17 `z`: cannot find `z` in this model",
                "1:24 `m`: `m` is a field; `configuration` gives coordinates of `coordinates`, further ones stand in `of(..)`",
            ],
        ),
        (
            r#"#[configuration(x = dot(y))]"#,
            &[
                "1:21 `dot`: `dot(y)` is a rate, but a coordinate is given by parameters, other coordinates and `t` in `configuration`",
            ],
        ),
        (
            r#"#[configuration(x = 1, y = 2)]"#,
            &["1:3 `configuration`: no coordinate remains free; leave one out or name further ones in `of(..)`"],
        ),
        (r#"#[configuration(of(s), x = 1)]"#, &["1:20 `s`: no coordinate is given by `s`"]),
        (
            r#"#[configuration(of(s, x), x = s)]"#,
            &["1:23 `x`: `x` cannot be a coordinate of `configuration`: it is a coordinate already"],
        ),
        (
            r#"#[configuration(of(s), x = s)] #[forces(s, dot(s))]"#,
            &[
                "1:41 `s`: `s` is a coordinate of `configuration`, but forces may depend on parameters, coordinates of `coordinates`, speeds, inputs and `t` only",
                "1:44 `dot`: `s` is a coordinate of `configuration`, but forces may depend on parameters, coordinates of `coordinates`, speeds, inputs and `t` only",
            ],
        ),
        (
            r#"#[define(k = 2*y)] #[configuration(x = k, y = 1)]"#,
            &[
                "1:40 `k`: `y` is itself given by `configuration`; give it by the remaining coordinates",
                "1:22 `configuration`: no coordinate remains free; leave one out or name further ones in `of(..)`",
            ],
        ),
        (r#"#[independent(x)]"#, &["1:15 `x`: `x` is a coordinate; its rate is `dot(x)`"]),
        (r#"#[independent(z)]"#, &["1:15 `z`: cannot find `z` in this model"]),
        (
            r#"#[independent(dot(m), m)]"#,
            &[
                "1:15 `dot(m)`: `m` is a field; expected a speed or the rate of a coordinate, such as `v1` or `dot(x)`",
                "1:23 `m`: `m` is a field; expected a speed or the rate of a coordinate, such as `v1` or `dot(x)`",
            ],
        ),
        (r#"#[independent(dot(x), dot(x))]"#, &["1:23 `dot(x)`: `dot(x)` stands in the list twice"]),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = dot(y))] #[independent(dot(u), uu)]"#,
            &[
                "1:69 `dot(u)`: `dot(u)` is an acceleration; acceleration-level equations are not supported yet",
                "1:77 `uu`: cannot find `uu` in this model; did you mean `u`?",
            ],
        ),
        (r#"#[complement(a = [1])]"#, &["1:18 `[1]`: the row `a` has 1 entry, but the model has 2 speeds"]),
        (r#"#[complement(a = [1, 0], a = [0, 1])]"#, &["1:26 `a`: there is a row `a` already"]),
        (
            r#"#[complement(x = [1, 0], b = [0, dot(x)])]"#,
            &[
                "1:34 `dot`: `dot(x)` is a rate, but the entries of D may depend on parameters, coordinates and `t` only",
                "1:14 `x`: `x` cannot be a row of D: it is a coordinate already",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = dot(y))] #[complement(u = [1, 0], v = [1, 1])]"#,
            &[
                "1:68 `u`: the row `u` takes the name of a speed, but D's column for that speed is not a unit vector; choose another name",
            ],
        ),
        (
            r#"#[complement(a = [1, 0])] #[independent(dot(x))]"#,
            &["1:29 `independent`: `complement` names the independent speeds already; leave out one of the two"],
        ),
        (
            r#"#[start(z = 1, m = 2, x = y, y = 1/0)]"#,
            &[
                "1:9 `z`: cannot find `z` in this model",
                "1:16 `m`: `m` is a field; `start` gives values of coordinates and speeds",
                "1:27 `y`: `y` is a coordinate, but this is a value for judging, which is made of numbers and `PI` only",
                "1:35 `/`: division by zero",
            ],
        ),
        (
            r#"#[start(x = 1, x = 2, y = exp(1000000))]"#,
            &["1:16 `x`: `x` has a value already", "1:27 `exp(1000000)`: this value is not finite"],
        ),
    ];
    for (statements, expected) in table {
        assert_eq!(of(statements), *expected, "{statements}");
    }
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
