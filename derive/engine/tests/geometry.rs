//! Models by geometry against twins whose kinetic energy is written out by hand: the same M, h*, T and V.

use holonomy_engine::projection::Equations;
use holonomy_engine::symbolic::{Expr, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

fn derived(tokens: TokenStream) -> Equations {
    match holonomy_engine::analyse(tokens) {
        Ok(analysis) => analysis.equations,
        Err(errors) => panic!("{:?}", errors.iter().map(|error| &error.message).collect::<Vec<_>>()),
    }
}

fn refused(tokens: TokenStream) -> Vec<String> {
    match holonomy_engine::analyse(tokens) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.iter().map(|error| error.message.clone()).collect(),
    }
}

/// Values where every symbol has a number that follows from its name.
fn values(e: &Equations, roots: &[Expr]) -> Vec<f64> {
    let number = |s: Symbol| {
        let name = e.graph.name(s).bytes().fold(7_u64, |sum, byte| sum.wrapping_mul(31).wrapping_add(byte.into()));
        0.7 + 0.6 * (name as f64 * 0.37).sin()
    };
    let pi = e.graph.pi_symbol();
    e.graph.evaluate(roots, &|s| if s == pi { std::f64::consts::PI } else { number(s) })
}

#[track_caller]
fn twins(geometry: TokenStream, energy: TokenStream) {
    let (a, b) = (derived(geometry), derived(energy));
    let all = |e: &Equations| {
        let mut roots = e.inertia.entries().to_vec();
        roots.extend(&e.forces);
        roots.push(e.kinetic_energy);
        roots.extend(e.potential_energy);
        roots.extend(e.accelerations.iter().chain(&e.multipliers));
        values(e, &roots)
    };
    let (a, b) = (all(&a), all(&b));
    assert_eq!(a.len(), b.len());
    let scale = b.iter().fold(1.0, |scale: f64, e| scale.max(e.abs()));
    for (i, (a, b)) in a.iter().zip(&b).enumerate() {
        assert!((a - b).abs() < 1e-12 * scale, "number {i}: {a} {b}");
    }
}

/// Absolute angles: the second rod's frame hangs on no other one, its point on the first's.
#[test]
fn two_rods_in_absolute_angles() {
    twins(
        quote! {
            #[coordinates(a, b)]
            #[frame(A = rotate(N, z, a), B = rotate(N, z, b))]
            #[body(lower = { frame: B, center: P + l2/2*B.x, mass: m2, inertia: rod(m2, l2, x) })]
            #[body(upper = { frame: A, center: O + l1/2*A.x, mass: m1, inertia: rod(m1, l1, x) })]
            #[point(P = O + l1*A.x)]
            #[gravity(-g*N.y)]
            struct Rods { l1: f64, l2: f64, m1: f64, m2: f64, g: f64 }
        },
        quote! {
            #[coordinates(a, b)]
            #[kinetic_energy(
                m1*powi(l1*dot(a), 2)/6 + m2*powi(l1*dot(a), 2)/2 + m2*powi(l2*dot(b), 2)/6
                    + m2*l1*l2*dot(a)*dot(b)*cos(a - b)/2
            )]
            #[potential_energy(m1*g*l1/2*sin(a) + m2*g*(l1*sin(a) + l2/2*sin(b)))]
            struct Rods { l1: f64, l2: f64, m1: f64, m2: f64, g: f64 }
        },
    );
}

/// A top in Euler's angles, its inertia about the pivot.
#[test]
fn a_top_about_its_pivot() {
    twins(
        quote! {
            #[coordinates(phi, theta, psi)]
            #[frame(B = rotate(rotate(rotate(N, z, phi), x, theta), z, psi))]
            #[body(top = { frame: B, center: O + l*B.z, mass: m, inertia: diag(i1, i2, i3), about: O })]
            #[gravity(-g*N.z)]
            struct Top { m: f64, l: f64, i1: f64, i2: f64, i3: f64, g: f64 }
        },
        quote! {
            #[coordinates(phi, theta, psi)]
            #[define(w1 = dot(phi)*sin(theta)*sin(psi) + dot(theta)*cos(psi))]
            #[define(w2 = dot(phi)*sin(theta)*cos(psi) - dot(theta)*sin(psi))]
            #[define(w3 = dot(phi)*cos(theta) + dot(psi))]
            #[kinetic_energy((i1*w1*w1 + i2*w2*w2 + i3*w3*w3)/2)]
            #[potential_energy(m*g*l*cos(theta))]
            struct Top { m: f64, l: f64, i1: f64, i2: f64, i3: f64, g: f64 }
        },
    );
}

/// The symmetric top: the axes of a body that looks the same all round need not turn with it.
#[test]
fn a_symmetric_top() {
    twins(
        quote! {
            #[coordinates(phi, theta, psi)]
            #[frame(B = rotate(rotate(rotate(N, z, phi), x, theta), z, psi))]
            #[frame(L = rotate(rotate(N, z, phi), x, theta))]
            #[body(top = { frame: B, center: O + l*L.z, mass: m, inertia: cylinder(m, r, h, z) })]
            #[gravity(-g*N.z)]
            struct Top { m: f64, l: f64, r: f64, h: f64, g: f64 }
        },
        quote! {
            #[coordinates(phi, theta, psi)]
            #[define(j = m*(3*r*r + h*h)/12 + m*l*l)]
            #[kinetic_energy(
                j*(powi(dot(phi)*sin(theta), 2) + powi(dot(theta), 2))/2
                    + m*r*r/4*powi(dot(phi)*cos(theta) + dot(psi), 2)
            )]
            #[potential_energy(m*g*l*cos(theta))]
            struct Top { m: f64, l: f64, r: f64, h: f64, g: f64 }
        },
    );
}

/// Euler's equations, with angular velocities as speeds; the products of inertia are entries of the tensor.
#[test]
fn a_free_body_with_kanes_speeds() {
    twins(
        quote! {
            #[coordinates(phi, theta, psi)]
            #[speeds(u1, u2, u3)]
            #[frame(B = rotate(rotate(rotate(N, z, phi), x, theta), y, psi))]
            #[body(rock = { frame: B, center: O, mass: m, inertia: matrix([i1, k, 0], [_, i2, 0], [_, _, i3]) })]
            #[kinematics(
                u1 = dot(angular_velocity(rock), B.x), u2 = dot(angular_velocity(B), B.y),
                u3 = dot(angular_velocity(B), B.z),
            )]
            #[torque(jet = { on: rock, value: p*B.x + q*N.z })]
            struct Rock { m: f64, i1: f64, i2: f64, i3: f64, k: f64, p: f64, q: f64 }
        },
        quote! {
            #[coordinates(phi, theta, psi)]
            #[speeds(u1, u2, u3)]
            #[kinematics(
                u1 = dot(theta)*cos(psi) - dot(phi)*cos(theta)*sin(psi), u2 = dot(psi) + dot(phi)*sin(theta),
                u3 = dot(theta)*sin(psi) + dot(phi)*cos(theta)*cos(psi),
            )]
            #[inertia(matrix([i1, k, 0], [_, i2, 0], [_, _, i3]))]
            #[forces(
                p - q*cos(theta)*sin(psi) - u2*i3*u3 + u3*(k*u1 + i2*u2),
                q*sin(theta) - u3*(i1*u1 + k*u2) + u1*i3*u3,
                q*cos(theta)*cos(psi) - u1*(k*u1 + i2*u2) + u2*(i1*u1 + k*u2),
            )]
            struct Rock { m: f64, i1: f64, i2: f64, i3: f64, k: f64, p: f64, q: f64 }
        },
    );
}

/// A bead on an arm that is turned by a motor and in time; spring, damper, armature, forces with counterparts.
#[test]
fn a_bead_on_a_turntable() {
    twins(
        quote! {
            #[coordinates(a, s)]
            #[inputs(tau)]
            #[frame(A = rotate(N, z, a + w*t))]
            #[point(P = O + s*A.x + h*A.y)]
            #[particle(bead = { at: P, mass: m })]
            #[spring(bungee = { from: Q, to: P, stiffness: k, length: l })]
            #[point(Q = O + d*N.x)]
            #[damper(rail = { of: s*s, coefficient: c })]
            #[armature(motor = { of: 7*a, inertia: j })]
            #[force(push = { at: P, value: f*A.y, from: Q })]
            #[torque(drive = { on: A, value: tau*N.z })]
            #[generalized_force(s = -b*dot(s))]
            struct Bead { m: f64, w: f64, h: f64, k: f64, l: f64, d: f64, c: f64, j: f64, f: f64, b: f64 }
        },
        quote! {
            #[coordinates(a, s)]
            #[inputs(tau)]
            #[define(turn = dot(a) + w)]
            #[define(x = s*cos(a + w*t) - h*sin(a + w*t) - d, y = s*sin(a + w*t) + h*cos(a + w*t))]
            #[kinetic_energy(m*(powi(dot(s) - h*turn, 2) + powi(s*turn, 2))/2 + 49*j*powi(dot(a), 2)/2)]
            #[potential_energy(k*powi(sqrt(x*x + y*y) - l, 2)/2)]
            #[forces(tau + f*s, -b*dot(s) - 4*c*s*s*dot(s))]
            struct Bead { m: f64, w: f64, h: f64, k: f64, l: f64, d: f64, c: f64, j: f64, f: f64, b: f64 }
        },
    );
}

/// A point that hangs on two frames, and a body in the axes of a third: no frame lies on the way of another.
#[test]
fn a_body_between_frames() {
    twins(
        quote! {
            #[coordinates(a, b, c)]
            #[frame(A = rotate(N, z, a), B = rotate(N, z, b), C = rotate(A, z, c))]
            #[body(plate = { frame: C, center: O + l*A.x + r*B.x + e*C.y, mass: m, inertia: planar(i) })]
            #[force(pull = { at: O + l*A.x + r*B.x, value: f*N.y, on: plate })]
            struct Between { l: f64, r: f64, e: f64, m: f64, i: f64, f: f64 }
        },
        quote! {
            #[coordinates(a, b, c)]
            #[define(vx = -l*sin(a)*dot(a) - r*sin(b)*dot(b) - e*cos(a + c)*(dot(a) + dot(c)))]
            #[define(vy = l*cos(a)*dot(a) + r*cos(b)*dot(b) - e*sin(a + c)*(dot(a) + dot(c)))]
            #[kinetic_energy(m*(vx*vx + vy*vy)/2 + i*powi(dot(a) + dot(c), 2)/2)]
            #[forces(f*l*cos(a), f*r*cos(b), 0)]
            struct Between { l: f64, r: f64, e: f64, m: f64, i: f64, f: f64 }
        },
    );
}

/// A rolling ball on a turning table: rows of a vector equation, and their reactions.
#[test]
fn a_ball_rolls_on_a_turning_table() {
    twins(
        quote! {
            #[coordinates(x, y, p, q, s)]
            #[frame(B = rotate(rotate(rotate(N, z, p), x, q), y, s))]
            #[frame(T = rotate(N, z, w*t))]
            #[point(G = O + x*N.x + y*N.y + r*N.z)]
            #[body(ball = { frame: B, center: G, mass: m, inertia: sphere(m, r) })]
            #[constraint(roll: velocity(G - r*N.z, ball) == velocity(O + x*N.x + y*N.y, table))]
            #[body(table = { frame: T, center: O, mass: 1, inertia: diag(0, 0, 0) })]
            struct Ball { r: f64, m: f64, w: f64 }
        },
        quote! {
            #[coordinates(x, y, p, q, s)]
            #[define(w1 = dot(q)*cos(p) - dot(s)*cos(q)*sin(p), w2 = dot(q)*sin(p) + dot(s)*cos(q)*cos(p))]
            #[define(w3 = dot(p) + dot(s)*sin(q))]
            #[kinetic_energy(m*(powi(dot(x), 2) + powi(dot(y), 2))/2 + m*r*r*(w1*w1 + w2*w2 + w3*w3)/5)]
            #[constraint(roll_x: dot(x) - r*w2 + w*y == 0)]
            #[constraint(roll_y: dot(y) + r*w1 - w*x == 0)]
            struct Ball { r: f64, m: f64, w: f64 }
        },
    );
}

/// Components in other axes, names of rows, accelerations of points and bodies.
#[test]
fn vector_equations_have_rows() {
    let e = derived(quote! {
        #[coordinates(a, b)]
        #[frame(A = rotate(N, z, a), B = rotate(A, unit(A.x + A.z), b))]
        #[point(P = O + l*B.x)]
        #[particle(tip = { at: P, mass: m })]
        #[body(bar = { frame: A, center: O, mass: m, inertia: cuboid(m, l, l, 2*l) })]
        #[constraint(held: dot(acceleration(P), B.y) + dot(angular_acceleration(A), A.z)*l == 0)]
        #[output(pull = reaction(held), far = norm(P + N.z), height = dot(P, N.z))]
        struct Held { l: f64, m: f64 }
    });
    assert_eq!(e.row_names(), ["held"]);
    let e = derived(quote! {
        #[coordinates(a, b, c)]
        #[frame(A = rotate(N, z, a), B = rotate(N, z, b), C = rotate(N, z, c))]
        #[particle(one = { at: O + A.x, mass: m }, two = { at: O + A.x + l*B.x, mass: m }, three = { at: S, mass: m })]
        #[point(S = O + 2*N.x + C.y)]
        #[constraint(closure: O + A.x + l*B.x == S, expressed = C)]
        struct Loop { l: f64, m: f64 }
    });
    assert_eq!(e.row_names(), ["closure_x", "closure_y"]);
    assert_eq!(e.position_names, ["closure_x", "closure_y"]);
}

/// What holds joints that are no constraints, against twins in which it is one.
#[test]
fn releases_tell_what_joints_hold() {
    let of = |tokens: TokenStream, values_of: &[&str]| {
        let e = derived(tokens);
        let at: Vec<Expr> = values_of
            .iter()
            .map(|name| match e.outputs.names.iter().position(|output| output == name) {
                Some(i) => e.outputs.values[i],
                None => e.multipliers[e.multiplier_names.iter().position(|m| m == name).expect("a name")],
            })
            .collect();
        values(&e, &at)
    };
    // Two pendulums and a wheel on a rail: the pull along and across the first rod, the moment in the second one's hinge.
    let tree = of(
        quote! {
            #[coordinates(a, b)]
            #[frame(A = rotate(N, z, a), B = rotate(N, z, b))]
            #[point(P = O + l*A.x)]
            #[release(pull = { point: P, along: A.x }, across = { point: P, along: A.y })]
            #[release(hinge = { frame: B, about: N.z })]
            #[body(arm = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) })]
            #[body(bob = { frame: B, center: P + r*B.y, mass: 2*m, inertia: planar(i) })]
            #[spring(coil = { from: O + l*N.x, to: P + l*B.x, stiffness: k })]
            #[gravity(-g*N.y)]
            #[constraint(tie: dot(velocity(P + l*B.x), N.x) == sin(t))]
            #[output(x = reaction(pull), y = reaction(across), moment = reaction(hinge))]
            struct Tree { l: f64, m: f64, r: f64, i: f64, k: f64, g: f64 }
        },
        &["x", "y", "moment", "tie"],
    );
    let loosened = of(
        quote! {
            #[coordinates(a, b, x, y)]
            #[frame(A = rotate(N, z, a), B = rotate(N, z, b))]
            #[point(P = O + l*A.x + x*A.x + y*A.y)]
            #[body(arm = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) })]
            #[body(bob = { frame: B, center: P + r*B.y, mass: 2*m, inertia: planar(i) })]
            #[spring(coil = { from: O + l*N.x, to: P + l*B.x, stiffness: k })]
            #[gravity(-g*N.y)]
            #[constraint(tie: dot(velocity(P + l*B.x), N.x) == sin(t))]
            #[configuration(x = 0, y = 0)]
            #[constraint(pull: x == 0, across: y == 0)]
            struct Loosened { l: f64, m: f64, r: f64, i: f64, k: f64, g: f64 }
        },
        &["pull", "across", "tie"],
    );
    let same = |a: f64, b: f64| assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}");
    same(tree[0], loosened[0]);
    same(tree[1], loosened[1]);
    same(tree[3], loosened[2]);
    // The hinge turns freely.
    same(tree[2], 0.0);
}

/// A frame by a quaternion that is let go: the reaction torques that hold a wheel's plane, against a twin by angles.
#[test]
fn what_holds_a_frame_by_a_quaternion() {
    let told = |frame: TokenStream, coordinates: TokenStream, state: &[(&str, f64)]| {
        let e = derived(quote! {
            #[coordinates(#coordinates)]
            #[frame(#frame)]
            #[frame(W = rotate(B, y, s))]
            #[release(gimbal = { frame: W, about: 3/5*B.x + 4/5*B.z }, post = { frame: B, about: N.z })]
            #[body(wheel = { frame: W, center: O + l*B.x, mass: m, inertia: diag(i1, i2, i3) })]
            #[gravity(-g*N.z)]
            #[constraint(held: dot(angular_velocity(B), B.x) == 1)]
            #[output(moment = reaction(gimbal), turning = reaction(post), pull = reaction(held))]
            struct Wheel { m: f64, l: f64, i1: f64, i2: f64, i3: f64, g: f64 }
        });
        let number = |s: Symbol| {
            let of = |name: &str| state.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
            of(e.graph.name(s)).unwrap_or_else(|| panic!("{}", e.graph.name(s)))
        };
        e.graph.evaluate(&e.outputs.values, &number)
    };
    let parameters = [("m", 1.3), ("l", 0.4), ("i1", 0.3), ("i2", 0.5), ("i3", 0.4), ("g", 9.81)];
    let (a, b, c, s): (f64, f64, f64, f64) = (0.7, -0.4, 1.1, 0.3);
    let [da, db, dc, ds] = [1.0, -0.6, 0.8, 2.0];
    // z, then x, then y.
    let half = |angle: f64| (angle / 2.0).sin_cos();
    let ((sa, ca), (sb, cb), (sc, cc)) = (half(a), half(b), half(c));
    let (p, q) = ([ca * cb, ca * sb, sa * sb, sa * cb], [cc, 0.0, sc, 0.0]);
    let e =
        [p[0] * q[0] - p[2] * q[2], p[1] * q[0] - p[3] * q[2], p[2] * q[0] + p[0] * q[2], p[3] * q[0] + p[1] * q[2]];
    // ω in the axes of the last rotation.
    let (wx, wy) = (db * c.cos() - da * b.cos() * c.sin(), dc + da * b.sin());
    let wz = db * c.sin() + da * b.cos() * c.cos();
    // The row holds ω_x = 1: the rates of the angles are changed so that it does.
    let da = da + (wx - 1.0) / (b.cos() * c.sin());
    let (wy, wz) = (wy - (wx - 1.0) * -b.sin() / (b.cos() * c.sin()), wz + (wx - 1.0) / c.tan());
    let angles = [("a", a), ("b", b), ("c", c), ("s", s), ("dot_a", da), ("dot_b", db), ("dot_c", dc), ("dot_s", ds)];
    let numbers = [
        ("e0", e[0]),
        ("e1", e[1]),
        ("e2", e[2]),
        ("e3", e[3]),
        ("s", s),
        ("omega_B_x", 1.0),
        ("omega_B_y", wy),
        ("omega_B_z", wz),
        ("dot_s", ds),
    ];
    let by_angles = told(
        quote!(B = rotate(rotate(rotate(N, z, a), x, b), y, c)),
        quote!(a, b, c, s),
        &[&angles[..], &parameters].concat(),
    );
    let by_numbers = told(
        quote!(B = quaternion(N, e0, e1, e2, e3)),
        quote!(e0, e1, e2, e3, s),
        &[&numbers[..], &parameters].concat(),
    );
    for (found, expected) in by_numbers.iter().zip(&by_angles) {
        assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{by_numbers:?} {by_angles:?}");
    }
}

/// A pivot far from the centre, held by rows: on the sphere of unit quaternions M_d is a number, and nothing is divided by that moves;
/// the row that holds the norm stays, though identity is decided where it vanishes.
#[test]
fn unit_quaternions_are_simplified_on_their_sphere() {
    let e = derived(quote! {
        #[coordinates(x, y, z, e0, e1, e2, e3)]
        #[frame(B = quaternion(N, e0, e1, e2, e3))]
        #[point(C = O + x*N.x + y*N.y + z*N.z)]
        #[body(top = { frame: B, center: C, mass: m, inertia: diag(i1, i2, i3) })]
        #[constraint(pivot: C == a*B.x + b*B.y + c*B.z)]
        #[independent(omega_B_x, omega_B_y, omega_B_z)]
        struct Top { m: f64, a: f64, b: f64, c: f64, i1: f64, i2: f64, i3: f64 }
    });
    assert_eq!(e.position_names, ["pivot_x", "pivot_y", "pivot_z", "norm_B"]);
    assert_eq!(
        e.graph.display(e.position_residual[3]),
        "powi(e0, 2)/2 + powi(e1, 2)/2 + powi(e2, 2)/2 + powi(e3, 2)/2 - 1/2"
    );
    let moving: Vec<Symbol> = e.state_coordinates.iter().chain(&e.state_speeds).copied().collect();
    assert!(e.mass_matrix.entries().iter().all(|entry| !e.graph.contains(*entry, &moving)));
    assert!(e.guards.is_empty());
}

/// Each mistake once, in words.
#[test]
fn mistakes_are_told() {
    let text = refused(quote! {
        #[coordinates(a, b)]
        #[frame(A = rotate(B, z, a), B = rotate(A, x, b))]
        #[frame(C = rotate(N, N.x + N.y, a), D = rotate(M, z, a), E = turn(N, z, a), F = rotate(C, A2.x, a))]
        #[frame(G = rotate(N, z, a))]
        #[point(P = O + 3, Q = G.x*G.y, R = O + G.w, S = O/G.x)]
        #[body(bar = { frame: O, center: O, mass: a, inertia: ring(m, l) })]
        #[body(rod = { frame: G, center: O + G.x, mass: m, inertia: rod(m, l, w), length: 3 })]
        #[force(pull = { at: O + G.x, value: 2 })]
        #[torque(turn = { on: pull, value: G.z })]
        #[spring(coil = { of: a, from: O, stiffness: 1 })]
        #[generalized_force(m = 1)]
        #[constraint(c: G.x == 1)]
        #[constraint(d: a == G.x)]
        #[constraint(e: a - b == 0, expressed = G)]
        #[constraint(f: norm(a) == sin(G.x))]
        struct Wrong { m: f64, l: f64 }
    });
    let expected = [
        "needed for its own value: `A` → `B` → `A`",
        "the axis is not a unit vector: its square is `2`",
        "there is no frame `M`",
        "expected `rotate(base, axis, angle)`",
        "there is no frame `A2`",
        "a vector and a scalar cannot be added",
        "two vectors cannot be multiplied so",
        "there is no component `.w`",
        "nothing can be divided by a vector",
        "`O` is the origin; expected a frame",
        "`a` is a coordinate, but the masses",
        "or one of `rod(m, l, x)`",
        "expected an axis of the body's frame",
        "`body` takes `frame`, `center`, `mass`, `inertia`, `about`, not `length`",
        "expected a vector such as",
        "`pull` is a force; expected a body or a frame",
        "`coil` takes either `of` or `from` and `to`",
        "`m` is a field; a generalised force",
        "only 0 stands for a vector",
        "the left side is a scalar and the right side a vector",
        "`e` is one equation of scalars",
        "`norm` takes vectors",
        "`sin` takes scalars",
    ];
    for part in expected {
        assert!(text.iter().any(|message| message.contains(part)), "{part} is not in {text:#?}");
    }
    assert_eq!(text.len(), expected.len(), "{text:#?}");
}
