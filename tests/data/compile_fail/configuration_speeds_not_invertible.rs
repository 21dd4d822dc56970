#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[configuration(y = x*x, speeds(u), u = x - t)]
pub struct Model {
    pub m: f64,
    pub l: f64,
}
