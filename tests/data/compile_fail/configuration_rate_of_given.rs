#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[configuration(of(a), x = l*sin(a), y = l*cos(a), speeds(u), dot(x) = u)]
pub struct Model {
    pub m: f64,
    pub l: f64,
}
