#[coordinates(x, y)]
#[speeds(v1, v2)]
#[kinematics(v1 = dot(x), v2 = dot(y))]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(rail: v2 == 0)]
#[independent(dot(v1))]
pub struct Misplaced {
    pub m: f64,
}
