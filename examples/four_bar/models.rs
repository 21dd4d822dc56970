//! A four-bar of uniform rods, by bodies and one vector equation.

use holonomy::ConstrainedSystem;

/// Crank, coupler and rocker by their angles from the line between the fixed pivots; the state's speed is that of the crank, which is a
/// choice for all of the way where the crank is the shortest of the rods.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, coupler, rocker)]
#[inputs(tau)]
#[frame(A = rotate(N, z, crank), B = rotate(N, z, coupler), C = rotate(N, z, rocker))]
#[point(P = O + a*A.x, Q = P + b*B.x, S = O + d*N.x + c*C.x)]
#[body(
    crank_bar = { frame: A, center: O + a/2*A.x, mass: m1, inertia: rod(m1, a, x) },
    coupler_bar = { frame: B, center: P + b/2*B.x, mass: m2, inertia: rod(m2, b, x) },
    rocker_bar = { frame: C, center: O + d*N.x + c/2*C.x, mass: m3, inertia: rod(m3, c, x) },
)]
#[gravity(-g*N.y)]
#[torque(drive = { on: A, value: tau*N.z })]
#[constraint(closure: Q == S)]
#[independent(dot(crank))]
#[start(crank = 0.1, coupler = 0.6, rocker = 1.9)]
pub struct FourBar {
    /// Length of the crank.
    #[unit(m)]
    #[nominal(0.5)]
    pub a: f64,
    /// Length of the coupler.
    #[unit(m)]
    #[nominal(1.8)]
    pub b: f64,
    /// Length of the rocker.
    #[unit(m)]
    #[nominal(1.2)]
    pub c: f64,
    /// Distance of the fixed pivots.
    #[unit(m)]
    #[nominal(2)]
    pub d: f64,
    /// Mass of the crank.
    #[unit(kg)]
    #[nominal(0.5)]
    pub m1: f64,
    /// Mass of the coupler.
    #[unit(kg)]
    #[nominal(1.8)]
    pub m2: f64,
    /// Mass of the rocker.
    #[unit(kg)]
    #[nominal(1.2)]
    pub m3: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}

/// One without a drive that carries a load on the pin of coupler and rocker, by the speed of the rocker, which stands still twice a turn,
/// or of the coupler, which does so elsewhere.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, coupler, rocker)]
#[frame(A = rotate(N, z, crank), B = rotate(N, z, coupler), C = rotate(N, z, rocker))]
#[point(P = O + a*A.x, Q = P + b*B.x, S = O + d*N.x + c*C.x)]
#[body(
    crank_bar = { frame: A, center: O + a/2*A.x, mass: m1, inertia: rod(m1, a, x) },
    coupler_bar = { frame: B, center: P + b/2*B.x, mass: m2, inertia: rod(m2, b, x) },
    rocker_bar = { frame: C, center: O + d*N.x + c/2*C.x, mass: m3, inertia: rod(m3, c, x) },
)]
#[particle(weight = { at: Q, mass: load })]
#[gravity(-g*N.y)]
#[constraint(closure: Q == S)]
#[independent(dot(rocker))]
#[independent(dot(coupler))]
#[start(crank = 0.1, coupler = 0.6, rocker = 1.9)]
pub struct ByRocker {
    /// Length of the crank.
    #[unit(m)]
    #[nominal(0.5)]
    pub a: f64,
    /// Length of the coupler.
    #[unit(m)]
    #[nominal(1.8)]
    pub b: f64,
    /// Length of the rocker.
    #[unit(m)]
    #[nominal(1.2)]
    pub c: f64,
    /// Distance of the fixed pivots.
    #[unit(m)]
    #[nominal(2)]
    pub d: f64,
    /// Mass of the crank.
    #[unit(kg)]
    #[nominal(0.5)]
    pub m1: f64,
    /// Mass of the coupler.
    #[unit(kg)]
    #[nominal(1.8)]
    pub m2: f64,
    /// Mass of the rocker.
    #[unit(kg)]
    #[nominal(1.2)]
    pub m3: f64,
    /// The load.
    #[unit(kg)]
    #[nominal(2)]
    pub load: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}
