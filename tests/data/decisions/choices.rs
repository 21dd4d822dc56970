//! Models that leave the choice of independent speeds open, where more than the pivots decides.

/// Three masses on one rope, of which the first drags a chain from the ground: every pivot is one, and the mass that runs is best
/// not the dependent one.
#[derive(ConstrainedSystem)]
#[coordinates(x, y, z)]
#[inertia(diag(m + sigma*x, m, m))]
#[forces(-(m + sigma*x)*g - sigma*powi(dot(x), 2)/2, -m*g, -m*g)]
#[constraint(rope: x + y + z == l)]
pub struct RopeAndChain {
    pub m: f64,
    pub sigma: f64,
    pub l: f64,
    pub g: f64,
}

/// The same where the other speeds are multiplied by what may vanish.
#[derive(ConstrainedSystem)]
#[coordinates(x, y, z)]
#[inertia(diag(m + sigma*x, m, m))]
#[forces(-(m + sigma*x)*g - sigma*powi(dot(x), 2)/2, -m*g, -m*g)]
#[constraint(rope: x + powi(y, 2)/l + powi(z, 2)/l == l)]
pub struct RopeOverCams {
    pub m: f64,
    pub sigma: f64,
    pub l: f64,
    pub g: f64,
}

/// A point on a sphere: a little is not worth a chart that breaks down elsewhere.
#[derive(ConstrainedSystem)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(sphere: powi(x, 2) + powi(y, 2) + powi(z, 2) == l*l)]
pub struct PointOnSphere {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}
