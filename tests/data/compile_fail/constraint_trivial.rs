#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(always: powi(sin(x), 2) + powi(cos(x), 2) == 1)]
pub struct Trivial {
    pub m: f64,
}
