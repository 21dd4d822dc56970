#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(tied: dot(x) == 2*dot(y))]
#[complement(dot_x = [2, 1, 1], dot_z = [0, 0, 1])]
pub struct Model {
    pub m: f64,
}
