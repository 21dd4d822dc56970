#[size(n = 2.5)]
#[coordinates(a)]
#[inertia(diag(1))]
#[forces(k*a)]
pub struct One {
    pub k: f64,
}
