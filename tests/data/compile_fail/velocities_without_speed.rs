#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[velocities(dot(x) = c*t, dot(y) = c)]
pub struct Model {
    pub m: f64,
    pub c: f64,
}
