//! The car axis of the test set for initial value problems (Schneider 1994).

use holonomy::ConstrainedSystem;

/// Two masses on springs, joined by a massless axle. The left spring stands at the origin, the right one on (xb, yb), which the
/// road moves up and down, so that both rows depend on time. The force on the springs is counted in units of their stiffness.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(xl, yl, xr, yr)]
#[define(
    k = m*powi(eps, 2)/2,
    yb = r*sin(w*t),
    xb = sqrt(powi(l, 2) - powi(yb, 2)),
    left = sqrt(powi(xl, 2) + powi(yl, 2)),
    right = sqrt(powi(xr - xb, 2) + powi(yr - yb, 2)),
)]
#[inertia(diag(k, k, k, k))]
#[forces(
    (l0 - left)*xl/left,
    (l0 - left)*yl/left - k*g,
    (l0 - right)*(xr - xb)/right,
    (l0 - right)*(yr - yb)/right - k*g,
)]
#[constraint(foot: xb*xl + yb*yl == 0)]
#[constraint(axle: powi(xl - xr, 2) + powi(yl - yr, 2) - powi(l, 2) == 0)]
#[independent(dot(yl), dot(yr))]
#[start(xl = 0, yl = 0.5, xr = 1, yr = 0.5)]
pub struct CarAxle {
    /// The scale of the masses.
    #[nominal(0.01)]
    pub eps: f64,
    /// Twice the mass at either end, over eps².
    #[nominal(10)]
    pub m: f64,
    /// Length of the axle.
    #[nominal(1)]
    pub l: f64,
    /// Length of a spring at rest.
    #[nominal(0.5)]
    pub l0: f64,
    /// Height of the road.
    #[nominal(0.1)]
    pub r: f64,
    /// Rate of the road.
    #[nominal(10)]
    pub w: f64,
    /// Gravity.
    #[nominal(1)]
    pub g: f64,
}
