#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(sphere: powi(x, 2) + powi(y, 2) + powi(z, 2) == 1)]
#[independent(dot(x), dot(y))]
#[independent(dot(y), dot(z))]
#[independent(dot(y), dot(x))]
#[independent(dot(z), dot(y))]
pub struct Model {
    pub m: f64,
}
