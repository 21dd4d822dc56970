#[size(n = 2)]
#[coordinates(a[n])]
#[inertia(diag(m[i] for i in 0..n))]
#[forces(-a[i + 1] for i in 0..n)]
pub struct Two {
    pub m: [f64; 2],
}
