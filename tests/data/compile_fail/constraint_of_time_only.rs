#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(clock: t == 2)]
pub struct Clock {
    pub m: f64,
}
