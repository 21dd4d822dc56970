#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == c*t)]
#[constraint(brake: dot(x)*ddot(x) + dot(y)*ddot(y) == -c)]
pub struct Braked {
    pub m: f64,
    pub g: f64,
    pub c: f64,
}
