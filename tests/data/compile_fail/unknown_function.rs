#[coordinates(x)]
#[inertia(diag(m))]
#[forces(-sinh(x))]
pub struct Spring {
    pub m: f64,
}
