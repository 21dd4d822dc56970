#[coordinates(x)]
#[inertia(diag(m))]
#[define(a = 2*b, b = a + x)]
#[forces(-a)]
pub struct Circle {
    pub m: f64,
}
