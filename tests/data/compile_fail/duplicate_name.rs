#[coordinates(x, m)]
#[inertia(diag(m, 1))]
#[forces(0, 0)]
#[define(x = 2*m)]
pub struct Twice {
    pub m: f64,
}
