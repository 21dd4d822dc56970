use super::super::read;
use super::errors;

/// The errors of `#[attribute] struct Model;`, whose first column is that of the attribute.
fn of(attribute: &str) -> Vec<String> {
    errors(&format!("#[{attribute}] struct Model;"))
}

/// The errors of a constraint with this right-hand side.
fn of_expression(expression: &str) -> Vec<String> {
    of(&format!("constraint(c: 0 == {expression})"))
}

/// Each attribute with its errors; the text before the message is `line:column` and the culprit.
#[test]
fn forms_of_statements() {
    let table: &[(&str, &[&str])] = &[
        (r#"coordinate(x)"#, &["1:3 `coordinate`: there is no statement `coordinate`; did you mean `coordinates`?"]),
        (r#"cordinates(x)"#, &["1:3 `cordinates`: there is no statement `cordinates`; did you mean `coordinates`?"]),
        (r#"unit(kg)"#, &["1:3 `unit`: the statement `unit` belongs on a field, not on the struct"]),
        (r#"coordinates"#, &["1:3 `coordinates`: expected a list in parentheses: `#[coordinates(..)]`"]),
        (r#"coordinates = "x""#, &["1:3 `coordinates`: expected a list in parentheses: `#[coordinates(..)]`"]),
        (r#"coordinates[x]"#, &["1:3 `coordinates`: expected a list in parentheses: `#[coordinates(..)]`"]),
        (r#"coordinates()"#, &["1:3 `coordinates`: `coordinates` is empty"]),
        (
            r#"coordinates(x)] #[coordinates(y)"#,
            &["1:21 `coordinates`: `coordinates` is given twice; make it one statement"],
        ),
        (r#"coordinates(x y)"#, &["1:17 `y`: expected `,` after `x`"]),
        (r#"coordinates(x,,y)"#, &["1:17 `,`: expected a name"]),
        (
            r#"coordinates(a[n], b[0])"#,
            &[
                "1:16 `[n]`: the length of an array is an integer from 1 to 4096, or a size",
                "1:22 `[0]`: the length of an array is an integer from 1 to 4096, or a size",
            ],
        ),
        (
            r#"size(n = 2, m = k)"#,
            &["1:15 `m = k`: a size is an integer: `n = 20`, or one made of sizes above it by `+ - * / %`"],
        ),
        (r#"size(n = 2, n = 3)"#, &["1:15 `n`: the size `n` is given twice"]),
        (
            r#"forces(1 for i in n, 2 for i)"#,
            &[
                "1:21 `n`: expected a range of integers such as `0..n`: literals, sizes and indices with `+ - * / %`, `min` and `max`",
                "1:26 `for`: a family is written `entry for i in 0..n`",
            ],
        ),
        (
            r#"forces(sum(0..2, j*j), sum(x..2, |j| j))"#,
            &[
                "1:10 `sum`: expected `sum(0..n, |j| expression)`",
                "1:30 `x..2`: expected a range of integers such as `0..n`: literals, sizes and indices with `+ - * / %`, `min` and `max`",
            ],
        ),
        (
            r#"coordinates(a[3])] #[forces(a[3], a[i - 4] for i in 0..1, a[1/0])"#,
            &[
                "1:33 `3`: the index 3 is out of range: `a` has 3 entries",
                "1:39 `i - 4`: the index -4 is out of range: `a` has 3 entries",
                "1:62 `[`: an index is an integer of literals, sizes and indices of families",
            ],
        ),
        (
            r#"forces(1 for i in 0..100000 for j in 0..100000)"#,
            &["1:31 `for`: families come to more than 400000 tokens when they are written out"],
        ),
        (
            r#"coordinates(type, r#type, _, 3, #[cfg(a)] b)"#,
            &[
                "1:15 `type`: `type` is a keyword of Rust and cannot be a name here",
                "1:21 `r#type`: the raw identifier `r#type` cannot be a name in equations; choose another name",
                "1:29 `_`: `_` is a keyword of Rust and cannot be a name here",
                "1:32 `3`: expected a name",
                "1:36 `[cfg(a)]`: only doc comments and `#[unit(..)]` can stand before a name here",
            ],
        ),
        (
            r#"holonomy(simplfy = off, crate = "x", simplify = maybe)"#,
            &[
                "1:12 `simplfy`: there is no option `simplfy`; did you mean `simplify`? (the options are `crate`, `simplify` and `elimination`)",
                "1:35 `\"x\"`: expected a path, such as `crate = ::holonomy`",
                "1:51 `maybe`: expected `on` or `off`",
            ],
        ),
        (r#"holonomy(crate = a, crate = b)"#, &["1:23 `crate`: the option `crate` is given twice"]),
        (
            r#"holonomy(crate)"#,
            &["1:12 `crate`: expected `crate = path`, `simplify = off` or `elimination = recursive`"],
        ),
        (
            r#"kinematics(v1 == dot(x), v2, dot(x, y) = 1, dot x = 2, 3 = 3)"#,
            &[
                "1:14 `v1 == dot(x)`: expected `v1 = expression` or `dot(x) = expression`",
                "1:28 `v2`: expected `v1 = expression` or `dot(x) = expression`",
                "1:35 `(x, y)`: expected a name or the rate of a coordinate, such as `v1` or `dot(x)`",
                "1:47 `dot x = 2`: expected a name or the rate of a coordinate, such as `v1` or `dot(x)`",
                "1:58 `3 = 3`: expected a name or the rate of a coordinate, such as `v1` or `dot(x)`",
            ],
        ),
        (r#"kinematics(v1 = )"#, &["1:17 `=`: expected an expression"]),
        (r#"inertia(m)"#, &["1:11 `m`: expected `diag(a, b, ..)` or `matrix([a, b, ..], [_, c, ..], ..)`"]),
        (
            r#"inertia(diag(a), diag(b))"#,
            &["1:11 `diag(a), diag(b)`: expected `diag(a, b, ..)` or `matrix([a, b, ..], [_, c, ..], ..)`"],
        ),
        (
            r#"inertia(matrix(a, [b]))"#,
            &["1:18 `a`: expected a row in brackets: `[a, b, ..]`, with `_` for an entry that follows by symmetry"],
        ),
        (
            r#"inertia(diag(_, a^2))"#,
            &[
                "1:16 `_`: `_` stands for an entry by symmetry in `inertia(matrix(..))` only",
                "1:20 `^`: `^` is not a power in Rust; write `powi(x, 2)`",
            ],
        ),
        (
            r#"constraint(x == 0)"#,
            &["1:14 `x == 0`: expected `name: left == right`; the name is that of the constraint's reaction"],
        ),
        (
            r#"constraint(c: x)"#,
            &[
                "1:14 `c: x`: a constraint is an equation or a joint: expected `left == right`, or for example `spherical(P, Q)`",
            ],
        ),
        (r#"constraint(c: x = 0)"#, &["1:19 `=`: a constraint is written with `==`"]),
        (r#"constraint(c: x == 0 == 1)"#, &["1:24 `==`: a constraint is one equation, this is a second `==`"]),
        (
            r#"constraint(c x == 0)"#,
            &["1:14 `c x == 0`: expected `name: left == right`; the name is that of the constraint's reaction"],
        ),
        (r#"constraint(c: == 0)"#, &["1:15 `:`: expected an expression"]),
        (r#"constraint(c: x ==)"#, &["1:20 `=`: expected an expression"]),
        (
            r#"constraint(c::x == 0)"#,
            &["1:14 `c::x == 0`: expected `name: left == right`; the name is that of the constraint's reaction"],
        ),
        (
            r#"function(road)] #[function(road(a, b))] #[function(a + b(x))] #[function(road(s), [droad])"#,
            &[
                "1:12 `road`: expected `road(s), derivatives = [droad, ddroad, ..]`: functions from f64 to f64 in scope",
                "1:34 `(a, b)`: functions of the user's take one argument: expected one name, such as `road(s)`",
                "1:54 `a + b(x)`: expected the path of a function, such as `road` or `tracks::road`",
                "1:85 `[droad]`: expected `road(s), derivatives = [droad, ddroad, ..]`: functions from f64 to f64 in scope",
            ],
        ),
        (r#"potential_energy(a, b)"#, &["1:23 `b`: expected one expression, found another after the comma"]),
        (r#"complement(w1 = 3)"#, &["1:14 `w1 = 3`: expected `w1 = [e1, .., en]`"]),
        (r#"complement(w1 [3])"#, &["1:14 `w1`: expected `w1 = [e1, .., en]`"]),
        (
            r#"independent(v1 + v2, dot(v), 3)"#,
            &[
                "1:15 `v1 + v2`: expected a name or the rate of a coordinate, such as `v1` or `dot(x)`",
                "1:32 `3`: expected a name or the rate of a coordinate, such as `v1` or `dot(x)`",
            ],
        ),
        (
            r#"configuration(of(3), x == 2)"#,
            &["1:20 `3`: expected a name", "1:24 `x == 2`: expected `x = expression` or `of(alpha)`"],
        ),
    ];
    for (attribute, expected) in table {
        assert_eq!(of(attribute), *expected, "{attribute}");
    }
}

#[test]
fn rust_that_is_no_equation() {
    let table: &[(&str, &[&str])] = &[
        (r#"x^2"#, &["1:23 `^`: `^` is not a power in Rust; write `powi(x, 2)`"]),
        (
            r#"x ^ (y % 2)"#,
            &[
                "1:24 `^`: `^` is not a power in Rust; write `powi(x, 2)`",
                "1:29 `%`: the operator `%` is not part of an equation: use `+`, `-`, `*` and `/`",
            ],
        ),
        (r#"sin(x).cos()"#, &["1:29 `cos`: functions are not called as methods; write `cos(x)` instead of `x.cos()`"]),
        (r#"self.m"#, &["1:27 `m`: fields are visible by name; write `m` instead of `self.m`"]),
        (r#"A.w"#, &["1:24 `w`: there is no component `.w`: the axes of a frame are `A.x`, `A.y` and `A.z`"]),
        (r#"a.0"#, &["1:24 `0`: there is no component `.0`: the axes of a frame are `A.x`, `A.y` and `A.z`"]),
        (r#"std::f64::consts::PI"#, &["1:40 `PI`: write `PI`, without a path"]),
        (r#"f64::sin(x)"#, &["1:30 `(`: only functions with a plain name can be called, such as `sin(theta)`"]),
        (r#"f64::MAX"#, &["1:27 `MAX`: paths are not part of an equation: use plain names"]),
        (r#"m[k]"#, &["1:23 `[`: an index is an integer of literals, sizes and indices of families"]),
        (r#"m[0 - 2]"#, &["1:24 `0 - 2`: the index -2 is negative"]),
        (r#"[1, 2]"#, &["1:22 `[`: an array is no number; name its entries one by one"]),
        (r#"[1; 2]"#, &["1:22 `[`: an array is no number; name its entries one by one"]),
        (r#"(1, 2)"#, &["1:22 `(`: a tuple is not a number; separate entries by commas without parentheses"]),
        (r#"()"#, &["1:22 `(`: a tuple is not a number; separate entries by commas without parentheses"]),
        (
            r#"if a < b { 1 }"#,
            &["1:22 `if`: an `if` without `else` has no value where its condition does not hold; add `else { .. }`"],
        ),
        (
            r#"if a { 1 } else { 2 }"#,
            &["1:25 `a`: the condition of an `if` compares two expressions, by `<`, `<=`, `>` or `>=`"],
        ),
        (
            r#"if a + b { c^2 } else { 2 }"#,
            &[
                "1:27 `+`: the condition of an `if` compares two expressions, by `<`, `<=`, `>` or `>=`",
                "1:34 `^`: `^` is not a power in Rust; write `powi(x, 2)`",
            ],
        ),
        (
            r#"if a < b && c < d { 1 } else { 2 }"#,
            &["1:31 `&&`: conditions cannot be joined; nest one `if` in another"],
        ),
        (
            r#"if (a == b) { 1 } else { 2 }"#,
            &["1:25 `(a == b)`: the condition of an `if` compares two expressions, by `<`, `<=`, `>` or `>=`"],
        ),
        (
            r#"if a != b { 1 } else { 2 }"#,
            &["1:27 `!=`: numbers of a motion are equal at instants only; compare by `<`, `<=`, `>` or `>=`"],
        ),
        (
            r#"if a < b { let c = 1; c } else { 2 }"#,
            &["1:31 `{ let c = 1; c }`: a branch holds one expression, its value; name parts of it with `define`"],
        ),
        (
            r#"if a < b { } else if a < c { 1 } else { d; }"#,
            &[
                "1:31 `{ }`: a branch holds one expression, its value; name parts of it with `define`",
                "1:60 `{ d; }`: a branch holds one expression, its value; name parts of it with `define`",
            ],
        ),
        (r#"match x {}"#, &["1:22 `match`: `match` is not part of an equation; write `if a < b { .. } else { .. }`"]),
        (r#"x as f64"#, &["1:24 `as`: casts are not needed: every expression is a number"]),
        (r#"_"#, &["1:22 `_`: `_` stands for an entry by symmetry in `inertia(matrix(..))` only"]),
        (r#"&x"#, &["1:22 `&`: the operator `&` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (r#"*x"#, &["1:22 `*`: the operator `*` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (r#"!x"#, &["1:22 `!`: the operator `!` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (r#"x?"#, &["1:23 `?`: the operator `?` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (
            r#"{ x }"#,
            &["1:22 `{`: not part of an equation: use numbers, names, `+ - * /`, parentheses, functions and `if`"],
        ),
        (
            r#"foo!(x)"#,
            &["1:25 `!`: not part of an equation: use numbers, names, `+ - * /`, parentheses, functions and `if`"],
        ),
        (
            r#"|x| x"#,
            &["1:22 `|`: not part of an equation: use numbers, names, `+ - * /`, parentheses, functions and `if`"],
        ),
        (
            r#"x..y"#,
            &["1:22 `x`: not part of an equation: use numbers, names, `+ - * /`, parentheses, functions and `if`"],
        ),
        (r#""text""#, &["1:22 `\"text\"`: only integers and decimal fractions are numbers here"]),
        (r#"true"#, &["1:22 `true`: only integers and decimal fractions are numbers here"]),
        (r#"1.0f64"#, &["1:22 `1.0f64`: write `1.0` without the suffix `f64`: numbers are exact and have no type"]),
        (r#"2u8"#, &["1:22 `2u8`: write `2` without the suffix `u8`: numbers are exact and have no type"]),
        (
            r#"1e999"#,
            &["1:22 `1e999`: the number 1e999 is out of range: numerators and denominators have up to 256 bits"],
        ),
        (r#"a <= b"#, &["1:24 `<`: the operator `<=` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (r#"a && b"#, &["1:24 `&`: the operator `&&` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (r#"a += b"#, &["1:24 `+`: the operator `+=` is not part of an equation: use `+`, `-`, `*` and `/`"]),
        (r#"a b"#, &["1:24 `b`: cannot read this expression: expected an operator"]),
        (r#"a +"#, &["1:24 `+`: cannot read this expression: unexpected end of input, expected an expression"]),
        (r#"+ a"#, &["1:22 `+`: cannot read this expression: expected an expression"]),
        (r#"(a)(b)"#, &["1:25 `(`: only functions with a plain name can be called, such as `sin(theta)`"]),
        (r#"#[cfg(x)] a"#, &["1:22 `#`: attributes cannot stand inside an expression"]),
        (
            r#"a = b"#,
            &["1:24 `=`: an equation cannot stand inside an expression; equations are stated by `constraint`"],
        ),
        (
            r#"return"#,
            &["1:22 `return`: not part of an equation: use numbers, names, `+ - * /`, parentheses, functions and `if`"],
        ),
        (r#"async"#, &["1:22 `async`: cannot read this expression: expected an expression"]),
        (r#"-"#, &["1:22 `-`: cannot read this expression: unexpected end of input, expected an expression"]),
    ];
    for (expression, expected) in table {
        assert_eq!(of_expression(expression), *expected, "{expression}");
    }
}

/// Comparisons, and choices one beside the other, may be many: they do not descend.
#[test]
fn choices_do_not_add_up() {
    let choice = "if f(a) <= g(b) { -c } else if a > b { 0 } else { h(c, 2) }";
    let sum: Vec<String> = (0..100).map(|_| format!("2*({choice})")).collect();
    assert_eq!(of_expression(&sum.join(" + ")), [""; 0]);
}

#[test]
fn what_stands_in_the_wrong_place() {
    assert_eq!(
        errors("enum Model {}"),
        ["1:1 `enum`: a mechanism is declared on a struct with named fields, not on an enum"]
    );
    assert_eq!(
        errors("union Model { a: f64 }"),
        ["1:1 `union`: a mechanism is declared on a struct with named fields, not on a union"]
    );
    assert_eq!(
        errors("struct Model(f64);"),
        ["1:13 `(`: the parameters of a mechanism need names: use a struct with named fields"]
    );
    let fields = "struct Model {
    #[coordinates(x)] a: f64,
    #[units(kg)] b: f64,
    #[unit(kg + m)] c: f64,
    #[unit(3*kg)] d: f64,
    #[nominal(1, 2)] e: f64,
    #[unit(m)] #[unit(m)] f: f64,
    #[nominal()] g: f64,
}";
    assert_eq!(
        errors(fields),
        [
            "2:7 `coordinates`: the statement `coordinates` belongs on the struct, not on a field",
            "3:7 `units`: there is no statement `units`; did you mean `unit`?",
            "4:15 `+`: expected a unit such as `kg*m/s`: names with `*`, `/` and `powi(s, 2)`, or `1`",
            "5:13 `*`: expected a unit such as `kg*m/s`: names with `*`, `/` and `powi(s, 2)`, or `1`",
            "6:18 `2`: expected one expression, found another after the comma",
            "7:18 `unit`: `unit` is given twice; make it one statement",
            "8:7 `nominal`: `nominal` is empty",
        ]
    );
}

#[test]
fn attributes_of_others_are_passed_over() {
    let source = "
        /// text
        #[derive(Clone)]
        #[serde(rename_all = \"snake_case\")]
        #[cfg(feature = \"x\")]
        #[allow(dead_code)]
        #[builder(default)]
        #[path::to::coordinate(x)]
        #[non_exhaustive]
        #[state]
        #[display(\"x\")]
        struct Model { #[serde(skip)] #[validate] a: f64 }";
    assert_eq!(errors(source), [""; 0]);
}

/// Errors inside expressions leave the rest checkable; a name that could not be read does not.
#[test]
fn tells_whether_the_rest_is_as_meant() {
    let complete = |source: &str| {
        let (declarations, diagnostics) = read(source.parse().unwrap());
        assert!(!diagnostics.is_empty());
        declarations.is_some_and(|declarations| declarations.complete)
    };
    assert!(complete("#[forces(x^2, [1], )] struct Model { #[unit(2)] m: f64 }"));
    assert!(!complete("#[forces(x^2)] #[coordinates(3)] struct Model;"));
}

#[test]
fn errors_become_compile_errors() {
    let (_, diagnostics) = read("#[forces(x^2)] struct Model;".parse().unwrap());
    assert_eq!(
        diagnostics.into_tokens().to_string(),
        ":: core :: compile_error ! { \"`^` is not a power in Rust; write `powi(x, 2)`\" }"
    );
}

/// A thread of the size that tests have is enough for what the bound lets through; what it does not
/// let through is refused without recursion.
#[test]
fn nesting_is_bounded() {
    let forms = [
        ("(", ")"),
        ("x + -(", ")"),
        ("x*f(-1, 2, 3*-(a + ", ")/2)"),
        ("a.g(|x| return x + ", ")"),
        ("-", ""),
        ("sin(", ")"),
        ("x + (", ")"),
        ("a = ", ""),
        ("|a| ", ""),
        ("return ", ""),
        ("&", ""),
        ("", ".f()"),
        ("", "(x)"),
        ("if a { ", "}"),
        ("if a < b { ", "} else { 0 }"),
        ("if a < b { 0 } else ", ""),
        ("if ", " < a { 1 } else { 2 }"),
        ("x as a<b<", ""),
        ("if x as a<", ""),
        ("a::<", ""),
        ("|a: a<", ""),
        ("<", ""),
    ];
    for (open, close) in forms {
        for depth in [8, 12, 16, 24, 32, 40, 44, 48, 20_000] {
            let expression = format!("{}x{}", open.repeat(depth), close.repeat(depth));
            let errors = of_expression(&expression);
            let refused = errors.iter().any(|error| error.contains("nested more than 48 deep"));
            assert!(refused || depth < 60, "{open} {depth}: {errors:?}");
            assert!(!refused || depth > 8, "{open} {depth}: {errors:?}");
        }
    }
}
