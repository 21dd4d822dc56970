#[coordinates(t, x)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
pub struct Reserved {
    pub m: f64,
}
