#[coordinates(x)]
#[inertia(diag(m))]
#[forces(-k*x^3)]
pub struct Spring {
    pub m: f64,
    pub k: f64,
}
