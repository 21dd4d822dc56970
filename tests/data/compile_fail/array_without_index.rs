#[coordinates(a[2])]
#[inertia(diag(m[i] for i in 0..2))]
#[forces(a, 0)]
pub struct Two {
    pub m: [f64; 2],
}
