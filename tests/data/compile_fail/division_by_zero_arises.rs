#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(1/(x - y), 1)]
#[configuration(y = x)]
pub struct Divided {
    pub m: f64,
}
