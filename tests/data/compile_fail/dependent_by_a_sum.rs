#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(first: dot(x) + y*dot(y) == 0)]
#[constraint(second: (x + 1)*dot(x) + (x*y + y)*dot(y) == 0)]
pub struct Twice {
    pub m: f64,
}
