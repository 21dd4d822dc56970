//! Bodies that turn freely, by quaternions.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// The heavy top by its mass centre and its attitude; the mass centre lies anywhere in the body's axes.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, e0, e1, e2, e3)]
#[frame(T = quaternion(N, e0, e1, e2, e3))]
#[point(C = O + x*N.x + y*N.y + z*N.z)]
#[point(Pivot = C - c1*T.x - c2*T.y - c3*T.z)]
#[body(top = { frame: T, center: C, mass: m, inertia: diag(j1, j2, j3) })]
#[gravity(-g*N.z)]
#[constraint(pivot: Pivot == O)]
#[independent(omega_T_x, omega_T_y, omega_T_z)]
pub struct PivotedBall {
    #[nominal(15)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.25)]
    pub j1: f64,
    #[nominal(0.45)]
    pub j2: f64,
    #[nominal(0.3)]
    pub j3: f64,
    #[nominal(0.1)]
    pub c1: f64,
    #[nominal(1)]
    pub c2: f64,
    #[nominal(0.2)]
    pub c3: f64,
}

/// The same top on a joint that is no constraint; what holds it is asked for.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(e0, e1, e2, e3)]
#[frame(T = quaternion(N, e0, e1, e2, e3))]
#[point(Pivot = O, C = Pivot + c1*T.x + c2*T.y + c3*T.z)]
#[body(top = { frame: T, center: C, mass: m, inertia: diag(j1, j2, j3) })]
#[gravity(-g*N.z)]
#[release(px = { point: Pivot, along: N.x }, py = { point: Pivot, along: N.y }, pz = { point: Pivot, along: N.z })]
#[output(ax = dot(acceleration(C), N.x), ay = dot(acceleration(C), N.y), az = dot(acceleration(C), N.z))]
#[output(fx = reaction(px), fy = reaction(py), fz = reaction(pz))]
#[output(vertical = j1*omega_T_x*dot(T.x, N.z) + j2*omega_T_y*dot(T.y, N.z) + j3*omega_T_z*dot(T.z, N.z)
    + m*dot(cross(C, velocity(C)), N.z))]
pub struct BallTop {
    #[nominal(15)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.25)]
    pub j1: f64,
    #[nominal(0.45)]
    pub j2: f64,
    #[nominal(0.3)]
    pub j3: f64,
    #[nominal(0.1)]
    pub c1: f64,
    #[nominal(1)]
    pub c2: f64,
    #[nominal(0.2)]
    pub c3: f64,
}

/// A free body, nothing acting on it.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(rock = { frame: B, center: O + x*N.x + y*N.y + z*N.z, mass: m, inertia: matrix([j1, k, 0], [_, j2, 0], [_, _, j3]) })]
#[define(hx = j1*omega_B_x + k*omega_B_y, hy = k*omega_B_x + j2*omega_B_y, h = hx*B.x + hy*B.y + j3*omega_B_z*B.z)]
#[output(lx = dot(h, N.x), ly = dot(h, N.y), lz = dot(h, N.z))]
pub struct Rock {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.3)]
    pub j1: f64,
    #[nominal(0.4)]
    pub j2: f64,
    #[nominal(0.5)]
    pub j3: f64,
    #[nominal(0.05)]
    pub k: f64,
}

/// The same rock in speeds of the model's own: two of them lie in the plane of x and y, turned once and for all.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, e0, e1, e2, e3)]
#[speeds(u1, u2, u3, vx, vy, vz)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[define(w = angular_velocity(B))]
#[kinematics(
    u1 = dot(w, 3/5*B.x + 4/5*B.y), u2 = dot(w, 3/5*B.y - 4/5*B.x), u3 = dot(w, B.z),
    vx = dot(velocity(G), B.x), vy = dot(velocity(G), B.y), vz = dot(velocity(G), B.z),
)]
#[point(G = O + x*N.x + y*N.y + z*N.z)]
#[body(rock = { frame: B, center: G, mass: m, inertia: matrix([j1, k, 0], [_, j2, 0], [_, _, j3]) })]
pub struct KanesRock {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.3)]
    pub j1: f64,
    #[nominal(0.4)]
    pub j2: f64,
    #[nominal(0.5)]
    pub j3: f64,
    #[nominal(0.05)]
    pub k: f64,
}

/// Rods that hang on each other by ball joints.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 3)]
#[coordinates(a[n], b[n], c[n], d[n])]
#[frame(L[0] = quaternion(N, a[0], b[0], c[0], d[0]))]
#[frame(L[i] = quaternion(N, a[i], b[i], c[i], d[i]) for i in 1..n)]
#[point(P[0] = O)]
#[point(P[i] = P[i - 1] + l*L[i - 1].x for i in 1..n)]
#[body(rod[i] = { frame: L[i], center: P[i] + l/2*L[i].x, mass: m, inertia: cylinder(m, r, l, x) } for i in 0..n)]
#[gravity(-g*N.z)]
#[output(vertical = sum(0..n, |i|
    m*dot(cross(P[i] + l/2*L[i].x, velocity(P[i] + l/2*L[i].x)), N.z)
        + m*r*r/2*dot(angular_velocity(L[i]), L[i].x)*dot(L[i].x, N.z)
        + m*(3*r*r + l*l)/12*(dot(angular_velocity(L[i]), L[i].y)*dot(L[i].y, N.z)
            + dot(angular_velocity(L[i]), L[i].z)*dot(L[i].z, N.z))
))]
pub struct HangingRods {
    #[nominal(0.8)]
    pub m: f64,
    #[nominal(0.5)]
    pub l: f64,
    #[nominal(0.1)]
    pub r: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// A ball that rolls on an inclined plane.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[point(G = O + x*N.x + y*N.y + z*N.z, P = G - r*N.z)]
#[body(ball = { frame: B, center: G, mass: m, inertia: sphere(m, r) })]
#[gravity(g*sin(slope)*N.x - g*cos(slope)*N.z)]
#[constraint(contact: dot(P, N.z) == 0)]
#[constraint(roll: velocity(P, ball) == 0)]
#[independent(dot(x), dot(y), omega_B_z)]
pub struct RollingBall {
    #[nominal(1.2)]
    pub m: f64,
    #[nominal(0.3)]
    pub r: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.2)]
    pub slope: f64,
}

/// A top in a frame that precesses at a given rate; the rotor turns about its own axis, which does not turn about itself.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(e0, e1, e2, e3, psi)]
#[frame(L = quaternion(rotate(N, z, rate*t), e0, e1, e2, e3), T = rotate(L, z, psi))]
#[body(top = { frame: T, center: O + l*L.z, mass: m, inertia: diag(j, j, j) })]
#[constraint(level: omega_L_z == 0)]
#[gravity(-g*N.z)]
pub struct Precession {
    #[nominal(0.7)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.0005)]
    pub j: f64,
    #[nominal(0.075)]
    pub l: f64,
    #[nominal(10)]
    pub rate: f64,
}
