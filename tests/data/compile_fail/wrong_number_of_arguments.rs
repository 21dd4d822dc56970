#[coordinates(x)]
#[inertia(diag(m))]
#[forces(-atan2(x))]
pub struct Spring {
    pub m: f64,
}
