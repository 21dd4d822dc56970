#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[velocities(dot(x) = c*dot(y), dot(y) = c*t)]
pub struct Model {
    pub m: f64,
    pub c: f64,
}
