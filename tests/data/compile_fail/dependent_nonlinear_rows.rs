#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == c)]
#[constraint(again: 3*powi(dot(x), 2) + 3*powi(dot(y), 2) == 3*c)]
#[constraint(second: dot(x)*ddot(x) + dot(y)*ddot(y) == 0)]
pub struct Again {
    pub m: f64,
    pub c: f64,
}
