#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(nothing: ddot(x) + dot(y) == ddot(x))]
pub struct Nothing {
    pub m: f64,
}
