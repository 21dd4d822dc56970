#[coordinates(x, y)]
#[speeds(u)]
#[inertia(diag(m, m, m))]
#[forces(0)]
pub struct Lengths {
    pub m: f64,
}
