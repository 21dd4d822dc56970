#[coordinates(x, y, z)]
#[speeds(u, v, w)]
#[kinematics(u = dot(x), v = dot(y) + dot(x), w = 2*dot(z))]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: u == 2*v)]
#[independent(u = v + w, dot_z = w)]
#[independent(s = w, s = v)]
pub struct Model {
    pub m: f64,
}
