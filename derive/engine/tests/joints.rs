//! Joints in short against what they stand for: the same expressions at every point.

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

/// Values where every symbol has a number that follows from its name and from the number of the draw.
fn values(e: &Equations, roots: &[Expr], draw: usize) -> Vec<f64> {
    let number = |s: Symbol| {
        let name = e.graph.name(s).bytes().fold(7_u64, |sum, byte| sum.wrapping_mul(31).wrapping_add(byte.into()));
        0.7 + 0.6 * (name as f64 * 0.37 + draw as f64).sin()
    };
    let pi = e.graph.pi_symbol();
    e.graph.evaluate(roots, &|s| if s == pi { std::f64::consts::PI } else { number(s) })
}

/// Both say the same: names, M, h*, C, c0*, residuals.
#[track_caller]
fn same(short: TokenStream, long: TokenStream) {
    let (a, b) = (derived(short), derived(long));
    let names = |e: &Equations| -> Vec<String> { e.speeds.iter().map(|s| e.graph.name(*s).to_owned()).collect() };
    assert_eq!(names(&a), names(&b));
    assert_eq!((a.row_names(), &a.position_names), (b.row_names(), &b.position_names));
    let all = |e: &Equations, draw: usize| {
        let mut roots = e.inertia.entries().to_vec();
        roots.extend(e.forces.iter().chain(e.constraint_matrix.entries()).chain(&e.constraint_bias));
        roots.extend(e.position_residual.iter().chain(&e.velocity_residual));
        values(e, &roots, draw)
    };
    for draw in 0..5 {
        let (a, b) = (all(&a, draw), all(&b, draw));
        assert_eq!(a.len(), b.len());
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            assert!((a - b).abs() < 1e-13 * (1.0 + b.abs()), "number {i}: {a} {b}");
        }
    }
}

/// A free body on a link, bound by what is given.
fn bound(constraint: TokenStream) -> TokenStream {
    quote! {
        #[coordinates(a, x, y, z, e0, e1, e2, e3)]
        #[frame(A = rotate(N, unit(N.x + 2*N.z), a), B = quaternion(N, e0, e1, e2, e3))]
        #[point(G = O + x*N.x + y*N.y + z*N.z, P = O + l*A.x + r*A.y, Q = G - l*B.z)]
        #[body(link = { frame: A, center: P, mass: m, inertia: diag(i1, i2, i3) })]
        #[body(free = { frame: B, center: G, mass: m, inertia: diag(i2, i3, i1) })]
        #[gravity(-g*N.z)]
        #constraint
        struct Bound { l: f64, r: f64, m: f64, i1: f64, i2: f64, i3: f64, g: f64 }
    }
}

#[test]
fn frames_and_points() {
    let tree = |frames: TokenStream, point: TokenStream| {
        quote! {
            #[coordinates(a, b, c, s, e0, e1, e2, e3)]
            #frames
            #[point(#point)]
            #[body(first = { frame: A, center: O + l*A.x, mass: m, inertia: diag(i1, i2, i3) })]
            #[body(second = { frame: B, center: P, mass: m, inertia: diag(i2, i3, i1) })]
            #[body(third = { frame: C, center: P + l*C.y, mass: m, inertia: diag(i3, i1, i2) })]
            #[body(fourth = { frame: D, center: P + r*D.z, mass: m, inertia: diag(i1, i3, i2) })]
            #[gravity(-g*N.z)]
            struct Arm { l: f64, r: f64, m: f64, i1: f64, i2: f64, i3: f64, g: f64 }
        }
    };
    same(
        tree(
            quote! {
                #[frame(A = revolute(N, unit(N.y + N.z), a), B = universal(weld(A), x, b, -z, c + t))]
                #[frame(C = spherical(revolute(A, x, l), e0, e1, e2, e3), D = weld(rotate(C, z, r)))]
            },
            quote!(P = prismatic(O + l * A.x, 3 / 5 * A.y - 4 / 5 * A.z, s * s + r)),
        ),
        tree(
            quote! {
                #[frame(A = rotate(N, unit(N.y + N.z), a), B = rotate(rotate(A, x, b), -z, c + t))]
                #[frame(C = quaternion(rotate(A, x, l), e0, e1, e2, e3), D = rotate(C, z, r))]
            },
            quote!(P = O + l * A.x + (s * s + r) * (3 / 5 * A.y - 4 / 5 * A.z)),
        ),
    );
}

#[test]
fn points_together() {
    same(bound(quote!(#[constraint(pin: spherical(P, Q))])), bound(quote!(#[constraint(pin: P == Q)])));
    same(
        bound(quote!(#[constraint(pin: spherical(P, Q), expressed = B)])),
        bound(quote!(#[constraint(pin: P == Q, expressed = B)])),
    );
}

#[test]
fn axes_together() {
    let long = |x: TokenStream, y: TokenStream| {
        bound(quote!(#[constraint(hinge: P == Q)] #[constraint(hinge_axes_x: #x == 0, hinge_axes_y: #y == 0)]))
    };
    same(
        bound(quote!(#[constraint(hinge: revolute(P, Q, A.z, B.z))])),
        long(quote!(dot(A.x, B.z)), quote!(dot(A.y, B.z))),
    );
    // The frame's axes are those beside whichever is an axis of one.
    same(
        bound(quote!(#[constraint(hinge: revolute(P, Q, unit(A.x + A.y), B.z))])),
        long(quote!(dot(unit(A.x + A.y), B.x)), quote!(dot(unit(A.x + A.y), B.y))),
    );
    same(
        bound(quote!(#[constraint(cardan: universal(P, Q, A.x, unit(B.y + B.z)))])),
        bound(quote!(#[constraint(cardan: P == Q)] #[constraint(cardan_axes: dot(A.x, unit(B.y + B.z)) == 0)])),
    );
}

#[test]
fn all_axes_together() {
    same(
        bound(quote!(#[constraint(seam: weld(P, Q, A, free))])),
        bound(quote! {
            #[constraint(seam: P == Q)]
            #[constraint(seam_axes_xy: dot(A.x, B.y) == 0, seam_axes_yz: dot(A.y, B.z) == 0)]
            #[constraint(seam_axes_zx: dot(A.z, B.x) == 0)]
        }),
    );
    same(
        bound(quote!(#[constraint(rail: prismatic(P, Q, A.y, B))])),
        bound(quote! {
            #[constraint(rail_x: dot(P - Q, A.x) == 0, rail_z: dot(P - Q, A.z) == 0)]
            #[constraint(rail_axes_xy: dot(A.x, B.y) == 0, rail_axes_yz: dot(A.y, B.z) == 0)]
            #[constraint(rail_axes_zx: dot(A.z, B.x) == 0)]
        }),
    );
}

#[test]
fn rolling_in_short() {
    same(
        bound(quote!(#[constraint(roll: rolling(G - r*N.z, free))])),
        bound(quote!(#[constraint(roll: velocity(G - r*N.z, free) == 0)])),
    );
    same(
        bound(quote!(#[constraint(roll: rolling(G - r*A.z, free, link), expressed = A)])),
        bound(quote!(#[constraint(roll: velocity(G - r*A.z, free) == velocity(G - r*A.z, link), expressed = A)])),
    );
}

/// Rows that vanish identically are no rows, and reactions are told by the rows' names.
#[test]
fn rows_that_vanish_are_left_out() {
    let e = derived(quote! {
        #[coordinates(a, b, c)]
        #[frame(A = revolute(N, z, a), B = revolute(A, z, b), C = revolute(N, z, c))]
        #[point(P = O + A.x + l*B.x, Q = O + 2*N.x + C.y)]
        #[body(one = { frame: A, center: O, mass: m, inertia: planar(i) })]
        #[body(two = { frame: B, center: O + A.x, mass: m, inertia: planar(i) })]
        #[body(three = { frame: C, center: Q, mass: m, inertia: planar(i) })]
        #[constraint(hinge: revolute(P, Q, B.z, C.z))]
        #[output(pull = reaction(hinge_x))]
        struct Loop { l: f64, m: f64, i: f64 }
    });
    assert_eq!(e.row_names(), ["hinge_x", "hinge_y"]);
    let e = derived(bound(quote!(
        #[constraint(hinge: revolute(P, Q, A.z, B.z))]
        #[output(moment = reaction(hinge_axes_x))]
    )));
    assert_eq!(e.outputs.names, ["moment"]);
}

/// Joints in families, and rows that may depend on others.
#[test]
fn joints_in_families() {
    let e = derived(quote! {
        #[size(n = 2)]
        #[coordinates(x[n], y[n], z[n], e[n], f[n], g[n], h[n])]
        #[frame(B[i] = spherical(N, e[i], f[i], g[i], h[i]) for i in 0..n)]
        #[point(P[i] = O + x[i]*N.x + y[i]*N.y + z[i]*N.z for i in 0..n)]
        #[body(link[i] = { frame: B[i], center: P[i], mass: m, inertia: diag(1, 2, 2) } for i in 0..n)]
        #[constraint(base: weld(P[0], O, B[0], N))]
        #[constraint(hinge[i]: revolute(P[i - 1] + l*B[i - 1].x, P[i], B[i - 1].z, B[i].z) for i in 1..n)]
        #[constraint(again: spherical(P[0], O), redundant)]
        struct Chain { l: f64, m: f64 }
    });
    assert_eq!(e.state_speeds.len(), 1);
    let hinge = ["hinge_1_x", "hinge_1_y", "hinge_1_z", "hinge_1_axes_x", "hinge_1_axes_y"];
    assert!(hinge.iter().all(|name| e.row_names().contains(&(*name).to_owned())), "{:?}", e.row_names());
    assert!(
        e.rows.iter().filter(|row| row.redundant).map(|row| row.name.as_str()).eq(["again_x", "again_y", "again_z"])
    );
}
