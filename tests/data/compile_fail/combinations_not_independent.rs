#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: cos(z)*dot(x) == 2*dot(y))]
#[independent(s = dot(z) + 4*dot(y), r = dot(z) + 2*cos(z)*dot(x))]
pub struct Model {
    pub m: f64,
}
