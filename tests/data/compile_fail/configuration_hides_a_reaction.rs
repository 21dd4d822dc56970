#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[configuration(y = sin(x), z = cos(x))]
#[constraint(wall: y == sin(x))]
pub struct Wire {
    pub m: f64,
    pub g: f64,
}
