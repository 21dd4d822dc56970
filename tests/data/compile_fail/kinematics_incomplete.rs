#[coordinates(x, y)]
#[speeds(v1, v2)]
#[kinematics(v1 = dot(x))]
#[inertia(diag(m, m))]
#[forces(0, 0)]
pub struct Incomplete {
    pub m: f64,
}
