#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(rail: y == x)]
#[constraint(other: 2*y == 2*x + 1, redundant)]
pub struct Rails {
    pub m: f64,
}
