#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[velocities(of(u, w), dot(x) = c*cos(u + w), dot(y) = c*sin(u + w))]
pub struct Model {
    pub m: f64,
    pub c: f64,
}
