//! Speeds of every origin: quasi-velocities of a configuration (4.3) and v = g(u, x, t) given (5.8), (5.9), each against
//! the full equations (2.8) and against differences.

use super::{At, checked, close};
use holonomy_engine::projection::Equations;
use quote::quote;

fn names(e: &Equations) -> Vec<&str> {
    e.state_speeds.iter().map(|s| e.graph.name(*s)).collect()
}

/// A particle on a sphere of changing radius, in a frame that turns: the speeds in either direction, then q̇ itself.
#[test]
fn quasi_velocities_of_a_configuration() {
    let particle = |speeds: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(x, y, z)]
            #[inertia(diag(m, m*(2 + sin(t)), m))]
            #[forces(-k*x*dot(y), -k*y, -m*g)]
            #[constraint(sphere: x*x + y*y + z*z == powi(l + t, 2))]
            #[configuration(of(a, b), x = (l + t)*sin(a)*cos(b + t), y = (l + t)*sin(a)*sin(b + t), z = (l + t)*cos(a), #speeds)]
            struct Particle { m: f64, g: f64, k: f64, l: f64 }
        }
    };
    let plain = checked(particle(quote! {}));
    assert_eq!(names(&plain), ["dot_a", "dot_b"]);
    for speeds in [
        quote! { speeds(u, w), u = l*dot(a) + t*dot(b) + a, w = sin(a)*dot(b) - t },
        quote! { dot(b) = (w + t)/sin(a), dot(a) = (u - t*(w + t)/sin(a) - a)/l, speeds(u, w) },
        quote! { speeds(u, w), u = l*dot(a) + t*dot(b) + a, w = sin(a)*dot(b) - t, dot(b) = (w + t)/sin(a), dot(a) = (u - t*(w + t)/sin(a) - a)/l },
        // The rates of given coordinates are at hand too.
        quote! { speeds(u, w), u = dot(z) + x, w = sin(a)*dot(b) - t },
    ] {
        let quasi = checked(particle(speeds));
        assert_eq!(names(&quasi), ["u", "w"]);
        assert!(quasi.guards.iter().any(|guard| guard.name == "sin(a)"), "{:?}", quasi.guards);
        // One motion, whatever the speeds: the same q and q̇ give the same v̇ and λ.
        let at = At::new(&quasi);
        let mut other = At::new(&plain);
        for (symbol, value) in &mut other.numbers {
            let name = plain.graph.name(*symbol);
            let rates = at.value(&quasi.coordinate_rates);
            *value = match name {
                "dot_a" => rates[0],
                "dot_b" => rates[1],
                _ => at.numbers.iter().find(|(s, _)| quasi.graph.name(*s) == name).expect("the symbol").1,
            };
        }
        close("v'", &at.value(&quasi.velocity_rates), &other.value(&plain.velocity_rates), 1e-9);
        close("lambda", &at.value(&quasi.multipliers), &other.value(&plain.multipliers), 1e-9);
    }
}

/// Later stages work on the quasi-velocities: rows that bind them, independent speeds among them, D in them.
#[test]
fn stages_behind_quasi_velocities() {
    let sleigh = |choice: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(x, y, phi, s)]
            #[inertia(diag(m, m, j, m))]
            #[forces(-k*dot(x), k*s, 0, m*g)]
            #[configuration(s = x*phi + t, speeds(u, w, o), u = dot(x)*cos(phi) + dot(y)*sin(phi),
                w = dot(y)*cos(phi) - dot(x)*sin(phi), o = dot(phi) + t)]
            #[constraint(blade: dot(y)*cos(phi) - dot(x)*sin(phi) == a*(dot(phi) + sin(t)))]
            #choice
            struct Sleigh { m: f64, g: f64, j: f64, k: f64, a: f64 }
        }
    };
    assert_eq!(names(&checked(sleigh(quote! {}))), ["u", "o"]);
    assert_eq!(names(&checked(sleigh(quote! { #[independent(o, u)] }))), ["o", "u"]);
    let named = checked(sleigh(quote! { #[complement(forward = [1, 0, 0], turn = [0, a, 1])] }));
    assert_eq!(names(&named), ["forward", "turn"]);
}

/// |v| = c with the direction as the speed (P6): u̇ = -(g/c) cos u, λ = (m g/c) sin u.
#[test]
fn a_constant_speed_by_its_direction() {
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[constraint(speed: (powi(dot(x), 2) + powi(dot(y), 2) - powi(c, 2))/2 == 0)]
        #[velocities(of(u), dot(x) = c*cos(u), dot(y) = c*sin(u))]
        struct Steady { m: f64, g: f64, c: f64 }
    });
    assert_eq!(names(&e), ["u"]);
    let at = At::new(&e);
    let number = |name: &str| at.numbers.iter().find(|(s, _)| e.graph.name(*s) == name).expect("the symbol").1;
    let [m, g, c, u] = ["m", "g", "c", "u"].map(number);
    close("u'", &at.value(&e.accelerations), &[-g / c * u.cos()], 1e-14);
    close("lambda", &at.value(&e.multipliers), &[m * g / c * u.sin()], 1e-13);
}

/// Everything depends on time and place; speeds that are not given stay independent.
#[test]
fn given_velocities_of_every_kind() {
    // A branch of a cone of velocities, moving.
    let cone = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m*(2 + cos(t*x))))]
        #[forces(0, -k*x*dot(z), -m*g)]
        #[constraint(cone: powi(dot(x), 2) + powi(dot(y) - sin(t)*x, 2) == powi(a + z*z + t, 2)*powi(dot(z), 2))]
        #[velocities(dot(z) = sqrt(powi(dot(x), 2) + powi(dot(y) - sin(t)*x, 2))/(a + z*z + t))]
        struct Cone { m: f64, g: f64, k: f64, a: f64 }
    });
    assert_eq!(names(&cone), ["dot_x", "dot_y"]);
    // Named speeds, a position row, a linear and a nonlinear one at once.
    let mixed = checked(quote! {
        #[coordinates(x, y, z, w)]
        #[speeds(v1, v2, v3, v4)]
        #[kinematics(dot(x) = v1 + t*y, dot(y) = v2*cos(t) + x, dot(z) = v3 + x*v1, dot(w) = v4)]
        #[inertia(matrix([m, 0, a, 0], [_, 2*m, 0, 0], [_, _, 3*m, 0], [_, _, _, m]))]
        #[forces(k*v2, -k*v1*v3, m*g, v4)]
        #[constraint(height: z == x*x/2 + sin(t))]
        #[constraint(along: v2 - y*v1 - t == 0)]
        #[constraint(power: v4 == v1*v1 + t*x)]
        #[velocities(v3 = x*(v1 + t*y) + cos(t) - x*v1, v2 = y*v1 + t, v4 = powi(v1, 2) + t*x)]
        struct Mixed { m: f64, g: f64, k: f64, a: f64 }
    });
    assert_eq!(names(&mixed), ["v1"]);
    // On the rates of a configuration and on its quasi-velocities.
    for (speeds, given) in [
        (quote! {}, quote! { dot(b) = c/(l*sin(a))*cos(u), dot(a) = c/l*sin(u) }),
        (quote! { , speeds(p, q), p = l*dot(a), q = l*sin(a)*dot(b) }, quote! { q = c*cos(u), p = c*sin(u) }),
    ] {
        let sphere = checked(quote! {
            #[coordinates(x, y, z)]
            #[inertia(diag(m, m, m))]
            #[forces(0, k*x, -m*g)]
            #[configuration(of(a, b), x = l*sin(a)*cos(b), y = l*sin(a)*sin(b), z = l*cos(a) #speeds)]
            #[constraint(sphere: (x*x + y*y + z*z)/2 == powi(l, 2)/2)]
            #[constraint(speed: (powi(dot(x), 2) + powi(dot(y), 2) + powi(dot(z), 2))/2 == powi(c, 2)/2)]
            #[velocities(of(u), #given)]
            struct Sphere { m: f64, g: f64, k: f64, l: f64, c: f64 }
        });
        assert_eq!(names(&sphere), ["u"]);
    }
    // A row for accelerations behind it binds u̇ alone.
    let bound = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m))]
        #[forces(0, k*x, -m*g)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == powi(c + t, 2))]
        #[constraint(turn: ddot(z) + x*ddot(y) == sin(t))]
        #[velocities(of(u), dot(x) = (c + t)*cos(u), dot(y) = (c + t)*sin(u))]
        struct Turn { m: f64, g: f64, k: f64, c: f64 }
    });
    assert_eq!(names(&bound), ["dot_z", "u"]);
    assert_eq!(bound.reduced_speeds.len(), 1);
}

/// M is singular, the mass matrix of the motions that the rows leave is not: a massless coordinate, by C alone and with T.
#[test]
fn massless_coordinates() {
    for dynamics in [
        quote! { #[inertia(diag(m, 0, m))] #[forces(-k*x, f, -k*z*dot(y))] },
        quote! { #[kinetic_energy(m/2*(powi(dot(x), 2) + powi(dot(z), 2)))] #[forces(-k*x, f, -k*z*dot(y))] },
    ] {
        let e = checked(quote! {
            #[coordinates(x, y, z)]
            #dynamics
            #[constraint(link: y == x*x + sin(t))]
            #[constraint(slide: dot(z) == x*dot(x) + t)]
            struct Massless { m: f64, k: f64, f: f64 }
        });
        assert_eq!(e.accelerations.len(), 1);
    }
    // Regular only because the massless direction is bound together with others.
    checked(quote! {
        #[coordinates(x, y)]
        #[inertia(matrix([m, m*x], [_, m*x*x]))]
        #[forces(-k*x, -k*y)]
        #[constraint(rod: x*x + y*y == powi(l, 2))]
        #[independent(dot(x))]
        struct Rod { m: f64, k: f64, l: f64 }
    });
}
