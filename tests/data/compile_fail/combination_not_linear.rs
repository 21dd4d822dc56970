#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: dot(x) == 2*dot(y))]
#[independent(s = dot(x)*dot(z) + y, dot(z))]
pub struct Model {
    pub m: f64,
}
