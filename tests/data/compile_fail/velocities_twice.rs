#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[velocities(of(u), dot(x) = c*cos(u), dot(x) = c*sin(u))]
pub struct Model {
    pub m: f64,
    pub c: f64,
}
