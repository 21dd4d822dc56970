//! A slider-crank with a rod that is longer than the crank.

use holonomy::ConstrainedSystem;

/// The piston slides along x without a constraint, since its place is x; what its guide holds is asked for by a release. The rod's angle
/// is that below the x axis, as in a textbook.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(alpha, beta, x)]
#[inputs(tau)]
#[frame(A = rotate(N, z, alpha), B = rotate(N, -z, beta))]
#[point(P = O + r*A.x, S = O + x*N.x)]
#[body(
    crank = { frame: A, center: O + r/2*A.x, mass: m1, inertia: rod(m1, r, x) },
    rod = { frame: B, center: P + l/2*B.x, mass: m2, inertia: rod(m2, l, x) },
)]
#[particle(piston = { at: S, mass: m3 })]
#[gravity(-g*N.y)]
#[torque(drive = { on: A, value: tau*N.z })]
#[constraint(closure: P + l*B.x == S)]
#[release(guide = { point: S, along: N.y })]
#[output(
    /// What the guide holds.
    guide = reaction(guide),
    /// The angular momentum of all parts about the crank's bearing.
    momentum = dot(angular_momentum(crank, O) + angular_momentum(rod, O) + angular_momentum(piston, O), N.z),
    acceleration = ddot(x),
)]
#[independent(dot(alpha))]
#[start(alpha = 0.5, beta = 0.16, x = 1.15)]
pub struct SliderCrank {
    /// Length of the crank.
    #[unit(m)]
    #[nominal(0.3)]
    pub r: f64,
    /// Length of the rod.
    #[unit(m)]
    #[nominal(0.9)]
    pub l: f64,
    /// Mass of the crank.
    #[unit(kg)]
    #[nominal(1)]
    pub m1: f64,
    /// Mass of the rod.
    #[unit(kg)]
    #[nominal(1)]
    pub m2: f64,
    /// Mass of the piston.
    #[unit(kg)]
    #[nominal(2)]
    pub m3: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}
