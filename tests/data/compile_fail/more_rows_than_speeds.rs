#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(one: dot(x) == y)]
#[constraint(two: dot(y) == x)]
#[constraint(three: dot(x) + 2*dot(y) == 0)]
pub struct Overbound {
    pub m: f64,
}
