//! Mechanisms whose branches meet, and the motions on one branch by themselves, without constraints.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// A four-bar of rods of which opposite ones are equally long: parallelograms and antiparallelograms meet where it is flat.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3)]
#[frame(A = rotate(N, z, q1), B = rotate(N, z, q2), C = rotate(N, z, q3))]
#[point(P = O + l*A.x, G = O + d*N.x, S = G + l*C.x)]
#[body(
    crank = { frame: A, center: O + l/2*A.x, mass: m1, inertia: rod(m1, l, x) },
    coupler = { frame: B, center: P + d/2*B.x, mass: m2, inertia: rod(m2, d, x) },
    rocker = { frame: C, center: G + l/2*C.x, mass: m1, inertia: rod(m1, l, x) },
)]
#[gravity(-g*N.y)]
#[inputs(tau)]
#[torque(drive = { on: A, value: tau*N.z })]
#[constraint(closure: P + d*B.x == S)]
#[independent(dot(q1))]
#[start(q1 = 0.7, q2 = 0, q3 = 0.7)]
pub struct Parallelogram {
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(1.3)]
    pub d: f64,
    #[nominal(0.7)]
    pub m1: f64,
    #[nominal(1.1)]
    pub m2: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// As a parallelogram both rods turn alike, and the coupler does not turn: a pendulum of inertia 2/3 m1 l² + m2 l².
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q)]
#[inertia(diag((2*m1/3 + m2)*powi(l, 2)))]
#[inputs(tau)]
#[forces(tau - g*(m1 + m2)*l*cos(q))]
pub struct AsPendulum {
    pub l: f64,
    pub m1: f64,
    pub m2: f64,
    pub g: f64,
}

/// A slider-crank of equal lengths whose crank turns on a cart, which a spring holds to a place: two degrees of freedom.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(c, alpha, beta, x)]
#[frame(A = rotate(N, z, alpha), B = rotate(N, -z, beta))]
#[point(C = O + c*N.x, P = C + l*A.x, S = C + x*N.x)]
#[body(
    crank = { frame: A, center: C + l/2*A.x, mass: m1, inertia: rod(m1, l, x) },
    rod = { frame: B, center: P + l/2*B.x, mass: m2, inertia: rod(m2, l, x) },
)]
#[particle(cart = { at: C, mass: m0 }, slider = { at: S, mass: m3 })]
#[gravity(-g*N.y)]
#[spring(hold = { from: O, to: C, stiffness: k, length: l0 })]
#[constraint(closure: P + l*B.x == S)]
#[independent(dot(c), dot(alpha))]
#[start(c = 2, alpha = 0.5, beta = 0.5, x = 1.4)]
pub struct CrankOnCart {
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(3)]
    pub m0: f64,
    #[nominal(1)]
    pub m1: f64,
    #[nominal(1.2)]
    pub m2: f64,
    #[nominal(2)]
    pub m3: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(40)]
    pub k: f64,
    #[nominal(2)]
    pub l0: f64,
}

/// The same on the branch β = α.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(c, alpha)]
#[frame(A = rotate(N, z, alpha), B = rotate(N, -z, alpha))]
#[point(C = O + c*N.x, P = C + l*A.x, S = P + l*B.x)]
#[body(
    crank = { frame: A, center: C + l/2*A.x, mass: m1, inertia: rod(m1, l, x) },
    rod = { frame: B, center: P + l/2*B.x, mass: m2, inertia: rod(m2, l, x) },
)]
#[particle(cart = { at: C, mass: m0 }, slider = { at: S, mass: m3 })]
#[gravity(-g*N.y)]
#[spring(hold = { from: O, to: C, stiffness: k, length: l0 })]
pub struct CrankOnCartAlone {
    pub l: f64,
    pub m0: f64,
    pub m1: f64,
    pub m2: f64,
    pub m3: f64,
    pub g: f64,
    pub k: f64,
    pub l0: f64,
}

/// A bead on two wires; with `gap` they do not meet.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(wires: x*x - y*y == gap)]
#[independent(dot(x))]
#[independent(dot(y))]
#[start(x = -1, y = -1)]
pub struct Wires {
    #[nominal(1)]
    pub m: f64,
    #[nominal(0)]
    pub gap: f64,
}

/// A bead on a wire with a cusp.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(cusp: y*y - x*x*x == 0)]
#[independent(dot(x))]
#[start(x = 1, y = 1)]
pub struct Cusp {
    #[nominal(1)]
    pub m: f64,
}

/// A kite: two rods of length a from O, one of them fixed, and two of length b that meet in (x, y), masses at the joints. Where the
/// crank lies on the fixed rod the other two may turn together instead.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q, x, y)]
#[inertia(diag(mp*a*a, m, m))]
#[forces(-mp*g*a*cos(q), 0, -m*g)]
#[potential_energy(mp*g*a*sin(q) + m*g*y)]
#[constraint(coupler: (powi(x - a*cos(q), 2) + powi(y - a*sin(q), 2) - b*b)/2 == 0)]
#[constraint(rocker: (powi(x - a, 2) + y*y - b*b)/2 == 0)]
#[independent(dot(q))]
#[start(q = 1, x = 2.3, y = 1.2)]
pub struct Kite {
    #[nominal(1)]
    pub a: f64,
    #[nominal(1.7)]
    pub b: f64,
    #[nominal(2)]
    pub mp: f64,
    #[nominal(0.7)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// The same by its symmetry: the joint is on the line that halves the angle of the crank.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q)]
#[define(s = a*cos(q/2) + sqrt(b*b - powi(a*sin(q/2), 2)))]
#[point(P = O + a*cos(q)*N.x + a*sin(q)*N.y, S = O + s*cos(q/2)*N.x + s*sin(q/2)*N.y)]
#[particle(crank = { at: P, mass: mp }, joint = { at: S, mass: m })]
#[gravity(-g*N.y)]
pub struct KiteAlone {
    #[nominal(1)]
    pub a: f64,
    #[nominal(1.7)]
    pub b: f64,
    #[nominal(2)]
    pub mp: f64,
    #[nominal(0.7)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
}
