//! Independent speeds that are combinations of others, against the full equations (2.8), against differences, and against
//! what their names say.

use super::{At, checked, close, names};
use holonomy_engine::projection::Equations;
use holonomy_engine::symbolic::Expr;
use quote::quote;

/// u of the state's chart from its own v, read back: nothing is lost.
fn read_back(e: &Equations) {
    let at = At::new(e);
    let u: Vec<Expr> = e.state_speeds.iter().map(|s| e.graph.var(*s)).collect();
    let mut initial = at.initial(at.time(), &at.value(&e.initial_coordinates), &at.value(&e.velocities));
    let coordinates = at.numbers.iter().filter(|(s, _)| e.state_coordinates.contains(s));
    initial.numbers.extend(coordinates.copied());
    close("u", &initial.value(&e.chart_speeds[0]), &at.value(&u), 1e-12);
}

/// The values of texts such as "dot_x" among v, and of the state's speeds.
fn value(e: &Equations, name: &str) -> f64 {
    let at = At::new(e);
    let own = at.numbers.iter().find(|(s, _)| e.graph.name(*s) == name).map(|(_, value)| *value);
    let velocity = || e.speeds.iter().position(|s| e.graph.name(*s) == name).map(|i| at.value(&e.velocities)[i]);
    own.or_else(velocity).expect("a name of the model")
}

fn refused(tokens: proc_macro2::TokenStream) -> Vec<String> {
    match holonomy_engine::analyse(tokens) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.iter().map(|error| error.message.clone()).collect(),
    }
}

/// A moving position row, a rheonomic velocity row; one combination, one plain speed, one of another name.
#[test]
fn combinations_beside_plain_speeds() {
    let e = checked(quote! {
        #[coordinates(x, y, z, p, q)]
        #[speeds(v1, v2, v3, v4, v5)]
        #[kinematics(
            dot(x) = v1 + sin(t), dot(y) = v2*(1 + x*x), dot(z) = v3 - v1*y, dot(p) = 2*v4, dot(q) = v5 + t*v4
        )]
        #[inertia(matrix(
            [m + x*x, 0, b, 0, 0], [_, m, 0, 0, b*t], [_, _, 2*m, 0, 0], [_, _, _, m, b], [_, _, _, _, 3*m + t]
        ))]
        #[forces(-x, v1*v2, -m*g, v5*p, -v4)]
        #[constraint(ball: powi(x, 2) + y*y + z*z == powi(r*(1 + t), 2))]
        #[constraint(roll: v4 - x*v5 == sin(t))]
        #[independent(s = 3*v5 + v4*sin(x) + dot(z)/4, v2, along = v3)]
        struct Mixture { m: f64, b: f64, g: f64, r: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["s", "v2", "along"]);
    assert!(e.combined);
    read_back(&e);
    let [s, v1, v3, v4, v5] = ["s", "v1", "v3", "v4", "v5"].map(|name| value(&e, name));
    let [x, y] = ["x", "y"].map(|name| value(&e, name));
    close("s", &[s], &[3.0 * v5 + v4 * x.sin() + (v3 - v1 * y) / 4.0], 1e-12);
    close("along", &[value(&e, "along")], &[value(&e, "v3")], 1e-12);
    assert!(e.notes.iter().any(|note| note.contains("s = ")), "{:?}", e.notes);
}

/// Body-fixed speeds of the contact point: [C; L] has no pivot that vanishes, where C alone has one.
#[test]
fn a_blade_by_the_speed_along_it() {
    let sleigh = |choice: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(x, y, phi)]
            #[inertia(matrix([m, 0, -m*a*sin(phi)], [_, m, m*a*cos(phi)], [_, _, j + m*a*a]))]
            #[forces(m*a*cos(phi)*powi(dot(phi), 2), m*a*sin(phi)*powi(dot(phi), 2), 0)]
            #[constraint(blade: dot(y)*cos(phi) - dot(x)*sin(phi) == 0)]
            #choice
            struct Sleigh { m: f64, a: f64, j: f64 }
        }
    };
    let e = checked(sleigh(quote! { #[independent(u = dot(x)*cos(phi) + dot(y)*sin(phi), w = dot(phi))] }));
    read_back(&e);
    assert!(e.guards.is_empty(), "{:?}", e.guards);
    let accelerations: Vec<String> = e.accelerations.iter().map(|e_| e.graph.display(*e_)).collect();
    // The closed form of Chaplygin and Carathéodory: u' = a w^2, w' = -m a u w/(j + m a^2).
    assert_eq!(accelerations[0], "a*powi(w, 2)");
    let plain = checked(sleigh(quote! { #[independent(dot(x), dot(phi))] }));
    assert_eq!(plain.guards.len(), 1);
}

/// Rates and quasi-velocities of a configuration, coordinates that it gives, and rates of these.
#[test]
fn combinations_of_the_rates_of_a_configuration() {
    for (speeds, choice, expected) in [
        (quote! {}, quote! { s = dot(a) + cos(a)*dot(b) + z*t, dot(b) }, ["s", "dot_b"]),
        (quote! {}, quote! { s = dot(z)*x + dot(b), r = dot(a) - t }, ["s", "r"]),
        // What is no carrier is a combination under its own name.
        (quote! {}, quote! { dot(z), dot(b) }, ["dot_z", "dot_b"]),
        (
            quote! { , speeds(u, w), u = l*dot(a) + t, w = sin(a)*dot(b) },
            quote! { s = u + x*w, o = dot(b) },
            ["s", "o"],
        ),
        (quote! { , speeds(u, w), u = l*dot(a) + t, w = sin(a)*dot(b) }, quote! { w, dot(z) }, ["w", "dot_z"]),
    ] {
        let e = checked(quote! {
            #[coordinates(x, y, z)]
            #[inertia(diag(m, m*(2 + sin(t)), m))]
            #[forces(-k*x*dot(y), -k*y, -m*g)]
            #[constraint(sphere: x*x + y*y + z*z == powi(l + t, 2))]
            #[configuration(of(a, b), x = (l + t)*sin(a)*cos(b + t), y = (l + t)*sin(a)*sin(b + t), z = (l + t)*cos(a) #speeds)]
            #[independent(#choice)]
            struct Particle { m: f64, g: f64, k: f64, l: f64 }
        });
        assert_eq!(names(&e, &e.state_speeds), expected);
        read_back(&e);
    }
}

/// Nonlinear and acceleration rows on top of combinations.
#[test]
fn rows_of_higher_kinds_in_combinations() {
    let e = checked(quote! {
        #[coordinates(x, y, z, p, q)]
        #[speeds(v1, v2, v3, v4, v5)]
        #[kinematics(
            dot(x) = v1 + sin(t), dot(y) = v2*(1 + x*x), dot(z) = v3 - v1*y, dot(p) = 2*v4, dot(q) = v5 + t*v4
        )]
        #[inertia(matrix(
            [m + x*x, 0, b, 0, 0], [_, m, 0, 0, b*t], [_, _, 2*m, 0, 0], [_, _, _, m, b], [_, _, _, _, 3*m + t]
        ))]
        #[forces(-x, v1*v2, -m*g, v5*p, -v4)]
        #[constraint(ball: powi(x, 2) + y*y + z*z == powi(r*(1 + t), 2))]
        #[constraint(roll: v4 - x*v5 == sin(t))]
        #[constraint(speed: v2*v2 + v5*v5*(2 + sin(x*t)) == c*c + v1*p)]
        #[constraint(push: dot(v5) + v1*ddot(z) == powi(v2, 2)*t)]
        #[independent(a1 = v1 + v2*cos(q), a2 = v2 - v4*t + x, a3 = v5 + v3)]
        struct Mixture { m: f64, b: f64, g: f64, r: f64, c: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["a1", "a2", "a3"]);
    assert_eq!(e.reduced_speeds.len(), 1);
    read_back(&e);
}

/// Several charts, of which one names a combination of another.
#[test]
fn charts_of_combinations() {
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m))]
        #[forces(0, 0, -m*g)]
        #[constraint(sphere: x*x + y*y + z*z == l*l)]
        #[independent(turn = (x*dot(y) - y*dot(x))/l, lift = dot(z))]
        #[independent(tilt = (y*dot(z) - z*dot(y))/l, roll = (z*dot(x) - x*dot(z))/l)]
        #[independent(turn, dot(x))]
        struct Particle { m: f64, g: f64, l: f64 }
    });
    let of = |chart: usize| names(&e, &e.charts[chart - 1].speeds);
    assert_eq!(names(&e, &e.state_speeds), ["turn", "lift"]);
    assert_eq!((of(1), of(2)), (vec!["tilt".into(), "roll".into()], vec!["turn".into(), "dot_x".into()]));
    assert_eq!(e.chart_speeds.len(), 3);
    read_back(&e);
}

#[test]
fn lists_that_are_not_independent_say_how() {
    let model = |choice: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(x, y, z)]
            #[inertia(diag(m, m, m))]
            #[forces(0, 0, -m*g)]
            #[constraint(first: dot(x) + y*dot(y) == sin(t))]
            #choice
            struct Particle { m: f64, g: f64 }
        }
    };
    let messages = refused(model(quote! { #[independent(a = dot(z) + 2*dot(x), b = dot(z) - 2*y*dot(y))] }));
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(
        messages[0].starts_with("these speeds are not independent of each other and of the constraints: ")
            && messages[0].contains("the speeds enter `b` as they enter -2*`first` + `a`"),
        "{messages:?}"
    );
    let messages = refused(model(quote! { #[independent(a = dot(x) + y*dot(y), dot(z))] }));
    assert!(messages[0].contains("the speeds enter `a` as they enter `first`"), "{messages:?}");
    let messages = refused(model(quote! { #[independent(a = dot(z), dot(z))] }));
    assert_eq!(messages, ["`dot(z)` stands in the list twice"]);
    let messages = refused(model(quote! { #[independent(a = dot(z))] }));
    assert!(messages[0].starts_with("1 independent speed is named, but the system has 2"), "{messages:?}");
}

/// Rows of D that have the names of speeds are these speeds, also where a row's own part moves all of them.
#[test]
fn rows_of_a_complement_are_what_their_names_say() {
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m))]
        #[forces(0, 0, -m*g)]
        #[constraint(first: x*dot(x) + y*dot(y) + cos(z)*dot(z) == sin(t))]
        #[complement(dot_y = [-y/x, 1, 0], dot_z = [-cos(z)/x, 0, 1])]
        struct Particle { m: f64, g: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["dot_y", "dot_z"]);
    let at = At::new(&e);
    let u: Vec<Expr> = e.state_speeds.iter().map(|s| e.graph.var(*s)).collect();
    close("u", &at.value(&u), &at.value(&e.velocities)[1..], 1e-12);
    read_back(&e);
}
