#[coordinates(x, y)]
#[speeds(v1, v2)]
#[kinematics(v1 = dot(x), v2 = dot(dot(y)))]
#[inertia(diag(m, m))]
#[forces(-m*ddot(x), dot(v1))]
#[constraint(rail: ddot(v1) == 0)]
#[independent(dot(v1))]
pub struct Misplaced {
    pub m: f64,
}
