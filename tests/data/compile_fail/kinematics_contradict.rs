#[coordinates(x, y)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x) + y*dot(y),
    v2 = dot(y),
    dot(x) = v1 + y*v2,
    dot(y) = v2,
)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
pub struct Both {
    pub m: f64,
}
