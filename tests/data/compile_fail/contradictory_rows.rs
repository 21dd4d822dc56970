#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(slow: dot(x) + dot(y) == 0)]
#[constraint(fast: dot(x) + dot(y) == c)]
pub struct Contradiction {
    pub m: f64,
    pub c: f64,
}
