#[coordinates(a, b)]
#[inertia(diag(m, -2))]
#[forces(0, 0)]
pub struct Negative {
    pub m: f64,
}
