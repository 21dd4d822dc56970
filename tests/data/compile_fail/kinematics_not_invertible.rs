#[coordinates(x, y)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x)*cos(x) + dot(y)*sin(x),
    v2 = dot(x)*powi(cos(x), 2) + dot(y)*sin(x)*cos(x),
)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
pub struct Singular {
    pub m: f64,
}
