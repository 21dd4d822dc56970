#[coordinates(x)]
#[inertia(diag(m))]
#[forces(-sine(x))]
pub struct Spring {
    pub m: f64,
}
