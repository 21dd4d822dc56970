#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(norm: powi(ddot(x), 2) + powi(ddot(y), 2) == powi(a, 2))]
pub struct ConstantAcceleration {
    pub m: f64,
    pub g: f64,
    pub a: f64,
}
