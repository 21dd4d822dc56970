#[coordinates(a[2])]
#[inertia(diag(m[i] for i in 0..2))]
#[forces(0, 0)]
pub struct Many<const N: usize> {
    pub m: [f64; N],
}
