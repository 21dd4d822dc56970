#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*grav)]
pub struct Falling {
    pub m: f64,
    pub g: f64,
}
