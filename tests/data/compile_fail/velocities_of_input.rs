#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[inputs(f)]
#[velocities(of(u), dot(x) = f, dot(y) = u)]
pub struct Model {
    pub m: f64,
    pub c: f64,
}
