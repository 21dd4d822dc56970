#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: dot(x) == 2*dot(y))]
#[independent(dot(x), dot(y))]
pub struct Tied {
    pub m: f64,
}
