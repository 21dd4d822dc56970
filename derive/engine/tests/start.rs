//! What the start that a model names shows: closed first, then judged; and what the guards are called.

use holonomy_engine::projection::Equations;
use quote::quote;

fn analysed(tokens: proc_macro2::TokenStream) -> Result<Equations, Vec<String>> {
    match holonomy_engine::analyse(tokens) {
        Ok(analysis) => Ok(analysis.equations),
        Err(errors) => Err(errors.iter().map(|error| error.message.clone()).collect()),
    }
}

#[track_caller]
fn refusal(tokens: proc_macro2::TokenStream) -> String {
    match analysed(tokens) {
        Ok(_) => panic!("accepted"),
        Err(messages) => messages.join("; "),
    }
}

/// The pivot sin(b - a) is 0.01 as the start is written, and zero where it closes.
#[test]
fn pivots_that_vanish_on_the_manifold_only() {
    let model = |start: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(a, b, c, d)]
            #[inertia(diag(1, 1, 1, 1))]
            #[forces(0, 0, 0, 0)]
            #[constraint(together: b == a)]
            #[constraint(slide: sin(b - a)*dot(c) + dot(d) == 0)]
            #[independent(dot(a), dot(d))]
            #start
            struct Folded {}
        }
    };
    let message = refusal(model(quote! { #[start(a = 0.3, b = 0.31)] }));
    assert!(message.contains("do not determine `dot_c` at the start, where the pivot"), "{message}");
    assert!(message.contains("#[independent("), "{message}");
    // Without a start nothing tells.
    assert!(analysed(model(quote! {})).is_ok());
}

#[test]
fn rows_that_depend_on_each_other_at_the_start() {
    let message = refusal(quote! {
        #[coordinates(a, b, c, d)]
        #[inertia(diag(1, 1, 1, 1))]
        #[forces(0, 0, 0, 0)]
        #[constraint(together: b == a + k)]
        #[constraint(first: dot(c) + a*dot(d) == 0)]
        #[constraint(second: 2*dot(c) + 2*(b - k)*dot(d) + dot(b) - dot(a) == 0)]
        #[start(a = 0.3, b = 0.6)]
        struct Folded { #[nominal(0.25)] k: f64 }
    });
    assert!(
        message
            .starts_with("constraint `second` depends on the others wherever these hold: at the start its rates are"),
        "{message}"
    );
    assert!(message.contains("`together` + 2*`first`, and so beside it"), "{message}");
}

#[test]
fn starts_that_do_not_close_say_what_is_left() {
    let message = refusal(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(1, 1))]
        #[forces(0, 0)]
        #[constraint(rod: x*x + y*y + l*l == 0)]
        #[start(x = 0.1, y = 0.2)]
        struct Nowhere { #[nominal(2)] l: f64 }
    });
    assert!(message.starts_with("the start does not close: "), "{message}");
    assert!(message.contains("`rod` by 4.00e0"), "{message}");
    // Newton's method goes a long way, and through a configuration.
    let far = analysed(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(1, 1))]
        #[forces(0, 0)]
        #[configuration(of(a, s), x = s*cos(a), y = s*sin(a))]
        #[constraint(rod: x*x + y*y == l*l)]
        #[start(a = 0.5, s = 40)]
        struct Far { #[nominal(2)] l: f64 }
    });
    assert!(far.is_ok(), "{:?}", far.err());
}

#[test]
fn charts_and_guards_know_their_figures_at_the_start() {
    let e = analysed(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[constraint(rod: x*x + y*y == l*l)]
        #[start(x = 0.49, y = -0.63)]
        #[independent(dot(x))]
        #[independent(dot(y))]
        #[independent(turn = (x*dot(y) - y*dot(x))/l)]
        struct Pendulum { m: f64, g: f64, #[nominal(0.8)] l: f64 }
    })
    .expect("the model is good");
    // On the circle of radius 0.8 along (0.49, -0.63): the cosines of the angles between the rod and the axes.
    let length = 0.49_f64.hypot(0.63);
    let expected = [0.63 / length, 0.49 / length, 1.0];
    for (found, expected) in e.relative_pivots.iter().zip(expected) {
        assert!((found.expect("all is known") - expected).abs() < 6e-3, "{:?}", e.relative_pivots);
    }
    let y = e.guards.iter().find(|guard| guard.name == "y").expect("the pivot of the rod");
    assert!((y.start.expect("y has a value") + 0.8 * 0.63 / length).abs() < 6e-3);
    assert!(
        e.notes.iter().any(|note| note.contains("the relative pivot of the independent speeds is 0.78")),
        "{:?}",
        e.notes
    );
    assert!(e.notes.iter().any(|note| note.contains("the relative pivot of chart 2 is 1:")), "{:?}", e.notes);
}

/// A guard whose text is too long for a name has one all the same.
#[test]
fn long_guards_have_names() {
    let e = analysed(quote! {
        #[coordinates(a, b, c, d)]
        #[inertia(diag(1, 1, 1, 1))]
        #[forces(0, 0, 0, 0)]
        #[constraint(first: sin(a + 2*b)*dot(a) + cos(b*c)*dot(b) + a*exp(c)*dot(c) + dot(d)*sin(d) == 0)]
        #[constraint(second: cos(a + 3*c)*dot(a) + exp(b*a)*dot(b) + b*sin(c*d)*dot(c) + dot(d)*cos(d) == 0)]
        #[constraint(third: sin(c - 2*a)*dot(a) + cos(b*c + d)*dot(b) + c*exp(a)*dot(c) + dot(d)*a == 0)]
        #[independent(dot(d))]
        struct Tangle {}
    })
    .expect("the model is good");
    let names: Vec<&str> = e.guards.iter().map(|guard| guard.name.as_str()).collect();
    assert!(names.contains(&"determinant of first, second, third"), "{names:?}");
    assert!(names.iter().all(|name| !name.contains('…') && name.chars().count() <= 160), "{names:?}");
}

/// Lengths in millimetres or kilometres make no difference: what is left is compared with the terms that it is left of.
#[test]
fn the_start_closes_in_any_unit() {
    let pendulum = |l: f64, factor: f64| {
        let (x, l) = (0.6 * l, proc_macro2::Literal::f64_unsuffixed(l));
        let (x, factor) = (proc_macro2::Literal::f64_unsuffixed(x), proc_macro2::Literal::f64_unsuffixed(factor));
        analysed(quote! {
            #[coordinates(x, y)]
            #[inertia(diag(1, 1))]
            #[forces(0, 0)]
            #[constraint(rod: #factor*(x*x + y*y - l*l) == 0)]
            #[start(x = #x, y = #x)]
            struct Pendulum { #[nominal(#l)] l: f64 }
        })
    };
    for (l, factor) in [(1.0, 1.0), (3e4, 1.0), (3e4, 1e3), (2e-5, 1.0), (1.0, 1e-9), (1.0, 1e9)] {
        assert!(pendulum(l, factor).is_ok(), "{l} {factor}: {:?}", pendulum(l, factor).err());
    }
    // A row without a slope does not keep the others from closing.
    let flat = analysed(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(1, 1, 1))]
        #[forces(0, 0, 0)]
        #[constraint(flat: x*x*x + y*y - y == 0)]
        #[constraint(height: z == 2)]
        #[start(x = 0, y = 0.5, z = 0.5)]
        struct Flat {}
    });
    assert!(
        flat.is_err_and(|messages| messages
            .iter()
            .all(|text| text.contains("`flat` by") && !text.contains("`height`")))
    );
}

/// The same pivot vanishes among large terms and among small ones.
#[test]
fn pivots_vanish_in_any_unit() {
    let slide = |factor: f64| {
        let factor = proc_macro2::Literal::f64_unsuffixed(factor);
        quote! {
            #[coordinates(a, b)]
            #[inertia(diag(1, 1))]
            #[forces(0, 0)]
            #[constraint(slide: #factor*(sin(a) - c)*dot(a) + #factor*dot(b) == 0)]
            #[independent(dot(b))]
            #[start(a = PI/6)]
            struct Slide { #[nominal(0.5)] c: f64 }
        }
    };
    for factor in [1.0, 1e7, 1e-7] {
        let message = refusal(slide(factor));
        assert!(message.contains("#[independent(dot(a))]"), "{message}");
    }
}

/// The line to paste comes from an elimination: after the first two rows the third leaves `dot_d` alone.
#[test]
fn the_independent_speeds_that_are_proposed_are_independent() {
    let message = refusal(quote! {
        #[coordinates(a, b, c, d, e)]
        #[inertia(diag(1, 1, 1, 1, 1))]
        #[forces(0, 0, 0, 0, 0)]
        #[constraint(first: 4*dot(a) + dot(b) + dot(c) + a*dot(e) == 0)]
        #[constraint(second: 4*dot(a) + 3*dot(b) + dot(c) + a*dot(e) == 0)]
        #[constraint(third: 8*dot(a) + 3*dot(b) + 2*dot(c) + dot(d)/10 + 2*a*dot(e) == 0)]
        #[independent(dot(c), dot(a))]
        #[start(a = 0)]
        struct Tangle {}
    });
    assert!(message.contains("#[independent(dot(c), dot(e))]"), "{message}");
}

/// Twice a speed is as good a speed; a chart that is no chart at the start says so.
#[test]
fn relative_pivots_do_not_depend_on_the_length_of_speeds() {
    let e = analysed(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m))]
        #[forces(0, 0, -m*g)]
        #[constraint(level: 3*x*dot(x) + 4*dot(y) == 0)]
        #[start(x = 1, y = 0, z = 0)]
        #[independent(dot(x), dot(z))]
        #[independent(fast = 10*dot(x), up = dot(z)/7)]
        #[independent(across = 3*dot(x) + 4*x*dot(y), dot(z))]
        struct Plane { m: f64, g: f64 }
    })
    .expect("the model is good");
    let found: Vec<f64> = e.relative_pivots.iter().map(|pivot| pivot.expect("all is known")).collect();
    assert_eq!(found, [0.8, 0.8, 0.0]);
}

/// A coupler on parallel bars does not turn wherever these are closed, and only there. Rounding is all that the pivots of its rate
/// show at the start and at configurations beside it. What is offered instead is accepted.
#[test]
fn pivots_that_vanish_wherever_the_loops_are_closed() {
    let bars = |start: f64, line: &str| {
        let [a, b, c] = [0.0, 0.01, -0.01].map(|beside| proc_macro2::Literal::f64_unsuffixed(start + beside));
        let line: proc_macro2::TokenStream = line.parse().expect("attributes");
        analysed(quote! {
            #[coordinates(a, b, c, d)]
            #[frame(A = rotate(N, z, a), B = rotate(N, z, b), C = rotate(N, z, c), D = rotate(N, z, d))]
            #[point(P = O + l*A.x, Q = O + 0.79*N.x - 0.47*N.y + l*B.x, R = O + 0.94*N.x - 0.38*N.y + l*C.x)]
            #[body(coupler = { frame: D, center: P + 0.4*D.x, mass: 1, inertia: planar(0.46) })]
            #[constraint(second: Q == P + 0.79*D.x - 0.47*D.y)]
            #[constraint(third: R == P + 0.94*D.x - 0.38*D.y, redundant)]
            #[start(a = #a, b = #b, c = #c, d = 0.02)]
            #line
            struct Bars { #[nominal(0.88)] l: f64 }
        })
    };
    for start in [0.75, 0.31, -0.4, 1.1, 0.93] {
        let messages =
            bars(start, "#[independent(dot(d))]").err().unwrap_or_else(|| panic!("{start}: accepted")).join("; ");
        assert!(messages.contains("do not determine"), "{start}: {messages}");
        let line = messages.split('`').rev().nth(1).expect("a line between quotes");
        let pivot = bars(start, line).expect("the line that was offered").relative_pivots[0];
        assert!(pivot.expect("all is known") > 0.5, "{start}: {line}");
    }
}

/// Bennett's linkage with one link more, closed by a ball, from angles of two digits: the rows of the hinge depend on each other wherever
/// it is closed, and changes of least norm go astray beside that. The link turns about the line through its ends.
#[test]
fn overconstrained_loops_close_from_rough_starts() {
    let equations = analysed(quote! {
        #[coordinates(a, b, c, d, e, f)]
        #[frame(A = rotate(N, z, a), B = rotate(rotate(A, x, beta), z, b), C = rotate(rotate(B, x, alpha), z, c))]
        #[frame(Last = rotate(C, x, beta), Ground = rotate(N, x, -alpha))]
        #[frame(Link = rotate(rotate(rotate(C, x, d), y, e), z, f))]
        #[define(long = short*sin(beta)/sin(alpha))]
        #[point(P = O + long*A.x, Q = P + short*B.x, R = Q + long*C.x, Foot = Q + 0.91*C.x - 0.26*C.y + 0.39*C.z)]
        #[point(Ball = Foot + 0.82*Link.x + 0.27*Link.y + 0.3*Link.z)]
        #[point(Socket = O + 0.238876607050834*A.x + 1.454417936109692*A.y - 1.129057297347411*A.z)]
        #[body(
            first = { frame: A, center: O + long/2*A.x, mass: 1, inertia: sphere(1, 0.5) },
            second = { frame: B, center: P + short/2*B.x, mass: 1, inertia: sphere(1, 0.5) },
            third = { frame: C, center: Q + long/2*C.x, mass: 1, inertia: sphere(1, 0.5) },
            fourth = { frame: Link, center: Foot + 0.4*Link.x, mass: 1, inertia: sphere(1, 0.5) },
        )]
        #[constraint(hinge: revolute(R, O - short*N.x, Last.z, Ground.z), redundant)]
        #[constraint(ball: spherical(Ball, Socket))]
        #[independent(dot(f))]
        #[start(a = 1.32, b = 2.36, c = -1.32, d = -0.46, e = 1.05, f = -0.40)]
        struct Bennett { #[nominal(0.9)] short: f64, #[nominal(1.19)] alpha: f64, #[nominal(0.41)] beta: f64 }
    });
    assert_eq!(equations.expect("it closes").state_speeds.len(), 1);
}
