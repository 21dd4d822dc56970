#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == 2*c*c)]
#[velocities(of(u), dot(x) = c*cos(u), dot(y) = c*sin(u))]
pub struct Model {
    pub m: f64,
    pub c: f64,
}
