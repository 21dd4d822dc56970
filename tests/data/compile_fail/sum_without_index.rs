#[coordinates(a[2])]
#[inertia(diag(1, 1))]
#[forces(0, sum(0..2, |j| ))]
pub struct Two {
    pub k: f64,
}
