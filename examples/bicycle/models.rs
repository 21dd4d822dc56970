//! Whipple's bicycle.

use holonomy::ConstrainedSystem;

/// A bicycle with a rigid rider: two frames that share the steering axis, and two wheels that roll without slipping (Whipple 1899).
///
/// The parameters are those of the benchmark of Meijaard, Papadopoulos, Ruina and Schwab, in its axes: x ahead, y to the right, z
/// down, from the rear contact of the upright bicycle. `C` is the rear frame, `E` the front frame, and the steering axis, tilted back
/// by `lambda`, meets the road at `S`.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(
    /// The rear contact.
    x, y,
    /// Heading.
    yaw,
    /// To the right.
    lean,
    /// Of the rear frame.
    pitch,
    /// To the right.
    steer,
    /// Of the wheels against their frames.
    rear, front,
)]
#[frame(A = rotate(N, z, yaw), B = rotate(A, x, lean), C = rotate(B, y, pitch))]
#[frame(E = rotate(rotate(rotate(C, y, lambda), z, steer), y, -lambda))]
#[frame(R = rotate(C, y, rear), F = rotate(E, y, front))]
#[point(P = O + x*N.x + y*N.y)]
#[point(Hub = P - r_rear*B.z)]
#[point(S = Hub + (w + c)*C.x + r_rear*C.z)]
#[point(FrontHub = S - c*E.x - r_front*E.z)]
#[point(Q = FrontHub + r_front*unit(N.z - dot(N.z, E.y)*E.y))]
#[body(rear_wheel = { frame: R, center: Hub, mass: m_rear, inertia: diag(rear_xx, rear_yy, rear_xx) })]
#[body(rider = {
    frame: C, center: Hub + bx*C.x + (bz + r_rear)*C.z, mass: mb,
    inertia: matrix([bxx, 0, bxz], [_, byy, 0], [_, _, bzz])
})]
#[body(fork = {
    frame: E, center: S + (hx - w - c)*E.x + hz*E.z, mass: mh,
    inertia: matrix([hxx, 0, hxz], [_, hyy, 0], [_, _, hzz])
})]
#[body(front_wheel = { frame: F, center: FrontHub, mass: m_front, inertia: diag(front_xx, front_yy, front_xx) })]
#[gravity(g*N.z)]
#[constraint(contact: dot(Q, N.z) == 0)]
#[constraint(rear_roll: velocity(P, rear_wheel) == 0)]
#[constraint(front_roll: velocity(Q, front_wheel) == 0)]
#[independent(dot(lean), dot(steer), dot(rear))]
#[allow(missing_docs)]
pub struct Bicycle {
    #[nominal(1.02)]
    pub w: f64,
    #[nominal(0.08)]
    pub c: f64,
    #[nominal(0.3141592653589793)]
    pub lambda: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.3)]
    pub r_rear: f64,
    #[nominal(2.0)]
    pub m_rear: f64,
    #[nominal(0.0603)]
    pub rear_xx: f64,
    #[nominal(0.12)]
    pub rear_yy: f64,
    #[nominal(0.3)]
    pub bx: f64,
    #[nominal(-0.9)]
    pub bz: f64,
    #[nominal(85.0)]
    pub mb: f64,
    #[nominal(9.2)]
    pub bxx: f64,
    #[nominal(11.0)]
    pub byy: f64,
    #[nominal(2.8)]
    pub bzz: f64,
    #[nominal(2.4)]
    pub bxz: f64,
    #[nominal(0.9)]
    pub hx: f64,
    #[nominal(-0.7)]
    pub hz: f64,
    #[nominal(4.0)]
    pub mh: f64,
    #[nominal(0.05892)]
    pub hxx: f64,
    #[nominal(0.06)]
    pub hyy: f64,
    #[nominal(0.00708)]
    pub hzz: f64,
    #[nominal(-0.00756)]
    pub hxz: f64,
    #[nominal(0.35)]
    pub r_front: f64,
    #[nominal(3.0)]
    pub m_front: f64,
    #[nominal(0.1405)]
    pub front_xx: f64,
    #[nominal(0.28)]
    pub front_yy: f64,
}

impl Bicycle {
    /// The benchmark's parameters (Proc. R. Soc. A 463, 2007, table 1).
    pub const BENCHMARK: Bicycle = Bicycle {
        w: 1.02,
        c: 0.08,
        lambda: std::f64::consts::PI / 10.0,
        g: 9.81,
        r_rear: 0.3,
        m_rear: 2.0,
        rear_xx: 0.0603,
        rear_yy: 0.12,
        bx: 0.3,
        bz: -0.9,
        mb: 85.0,
        bxx: 9.2,
        byy: 11.0,
        bzz: 2.8,
        bxz: 2.4,
        hx: 0.9,
        hz: -0.7,
        mh: 4.0,
        hxx: 0.05892,
        hyy: 0.06,
        hzz: 0.00708,
        hxz: -0.00756,
        r_front: 0.35,
        m_front: 3.0,
        front_xx: 0.1405,
        front_yy: 0.28,
    };
}
