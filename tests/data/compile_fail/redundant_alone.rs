#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(redundant)]
#[constraint(rail: y == 0, redundant, redundant)]
pub struct Alone {
    pub m: f64,
}
