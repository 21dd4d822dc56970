//! Errors of statements and of the system, each at its token.

use super::errors::of;

#[test]
fn every_message_about_a_statement() {
    let table: &[(&str, &[&str])] = &[
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
            r#"#[inputs(u)] #[kinetic_energy(u*powi(dot(x), 2))]"#,
            &[
                "1:31 `u`: `u` is an input, but the kinetic energy may depend on parameters, coordinates of `coordinates`, speeds, rates and `t` only",
            ],
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
                "1:35 `u`: `u` is an input, but a constraint may depend on parameters, coordinates of `coordinates`, speeds, accelerations and `t` only",
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
                "1:56 `dot(u)`: `dot(u)` is an acceleration, which only `constraint` can bind",
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
            r#"#[constraint(a: ddot(x)*dot(x) == ddot(x)*ddot(x))]"#,
            &[
                "1:14 `a`: the constraint `a` is not linear in `ddot(x)`: constraints may be nonlinear in velocities, but not in accelerations",
            ],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = dot(y))] #[constraint(a: sqrt(dot(v)) == y)]"#,
            &[
                "1:68 `a`: the constraint `a` is not linear in `dot(v)`: constraints may be nonlinear in velocities, but not in accelerations",
            ],
        ),
        (
            r#"#[constraint(a: ddot(x) - ddot(x) == dot(y))]"#,
            &["1:14 `a`: the constraint `a` binds no acceleration: all its coefficients vanish; write it without them"],
        ),
        (
            r#"#[speeds(u, v)] #[kinematics(u = dot(x), v = dot(y))] #[constraint(a: ddot(v) == 0)]"#,
            &["1:71 `ddot`: `v` is a speed; its rate is written `dot(v)`, and `ddot` takes the name of a coordinate"],
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
                "1:69 `dot(u)`: `dot(u)` is an acceleration, which only `constraint` can bind",
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
