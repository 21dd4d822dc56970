#[coordinates(x)]
#[inertia(diag(m))]
#[forces(asin(3/2)*x)]
pub struct Beyond {
    pub m: f64,
}
