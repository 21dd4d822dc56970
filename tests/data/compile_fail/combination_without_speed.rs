#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: dot(x) == 2*dot(y))]
#[independent(dot(z), s = dot(x) - dot(x) + sin(y))]
pub struct Model {
    pub m: f64,
}
