#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(height, -m*g)]
#[constraint(floor: y == height)]
#[define(half = height/2)]
#[output(height = x)]
pub struct OutOfPlace {
    pub m: f64,
    pub g: f64,
}
