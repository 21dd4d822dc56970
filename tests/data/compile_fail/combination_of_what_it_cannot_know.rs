#[coordinates(x, y, z)]
#[inputs(tau)]
#[inertia(diag(m, m, m))]
#[forces(tau, s, 0)]
#[constraint(tied: dot(x) == 2*dot(y))]
#[independent(r = dot(x) + tau, s = dot(z) + ddot(x))]
pub struct Model {
    pub m: f64,
}
