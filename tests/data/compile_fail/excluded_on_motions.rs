#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(rail: y == 0)]
#[constraint(product: dot(x)*dot(y) == x)]
pub struct Railed {
    pub m: f64,
}
