#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(cylinder: powi(x, 2) + powi(y, 2) == 1)]
#[independent(dot(x), dot(z))]
#[independent(dot(x), dot(y))]
pub struct Model {
    pub m: f64,
}
