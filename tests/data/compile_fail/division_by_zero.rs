#[coordinates(x)]
#[inertia(diag(m))]
#[forces(1/(x - x))]
pub struct Pole {
    pub m: f64,
}
