#[coordinates(x, y, z)]
#[speeds(u, v, w)]
#[kinematics(u = dot(x), v = dot(y) + dot(x), w = 2*dot(z))]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: u == 2*v)]
#[complement(dot_y = [2, 1, 0], dot_z = [0, 0, 1])]
pub struct Model {
    pub m: f64,
}
