#[coordinates(x, y)]
#[speeds(v1, v2)]
#[kinematics(v1 = dot(x)*dot(y), v2 = dot(y))]
#[inertia(diag(m, m))]
#[forces(0, 0)]
pub struct Product {
    pub m: f64,
}
