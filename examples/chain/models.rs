//! A chain that hangs.

use holonomy::ConstrainedSystem;

/// Twenty equal weights on a thread, each link by its angle from the vertical. No constraint is written: what the thread has to hold is
/// asked for by a release, and costs no speed more.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 20)]
#[coordinates(a[n])]
#[frame(L[i] = rotate(N, z, a[i]) for i in 0..n)]
#[point(P[0] = O - l*L[0].y, P[i] = P[i - 1] - l*L[i].y for i in 1..n)]
#[particle(bob[i] = { at: P[i], mass: m } for i in 0..n)]
#[gravity(-g*N.y)]
#[release(hook = { point: P[0], along: L[0].y })]
#[output(tension = reaction(hook), x[i] = dot(P[i], N.x) for i in 0..n, y[i] = dot(P[i], N.y) for i in 0..n)]
pub struct Chain {
    /// Mass of a weight.
    #[unit(kg)]
    #[nominal(0.1)]
    pub m: f64,
    /// Length of a link.
    #[unit(m)]
    #[nominal(0.05)]
    pub l: f64,
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
}
