#[coordinates(a[2])]
#[inertia(diag(1, 1))]
#[forces(k*a[i] for i in 0..k)]
pub struct Two {
    pub k: f64,
}
