//! A ball on a table that turns.

use holonomy::ConstrainedSystem;

/// A homogeneous ball that rolls on a table turning at the rate w: the contact point moves with the table, so that the rows have a
/// part that no velocity multiplies, η(x, t) of (5.1). x, y: the centre; ox, oy, oz: the angular velocity in fixed axes, with the
/// angles of the same names mere integrals of it, which nothing depends on.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, ax, ay, az)]
#[speeds(vx, vy, ox, oy, oz)]
#[kinematics(dot(x) = vx, dot(y) = vy, dot(ax) = ox, dot(ay) = oy, dot(az) = oz)]
#[define(j = 2*m*powi(r, 2)/5, rate = w*(1 + a*sin(b*t)))]
#[inertia(diag(m, m, j, j, j))]
#[forces(0, 0, 0, 0, 0)]
#[constraint(along_x: vx - r*oy == -rate*y)]
#[constraint(along_y: vy + r*ox == rate*x)]
#[independent(vx, vy, oz)]
pub struct Turntable {
    /// Mass.
    #[unit(kg)]
    pub m: f64,
    /// Radius of the ball.
    #[unit(m)]
    pub r: f64,
    /// Rate of the table.
    #[unit(1/s)]
    pub w: f64,
    /// How much the rate swings.
    #[unit(1)]
    pub a: f64,
    /// How fast it swings.
    #[unit(1/s)]
    pub b: f64,
}
