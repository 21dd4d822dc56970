#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(floor: y == 0)]
#[output(pull = 2*floor, floor)]
pub struct AsName {
    pub m: f64,
    pub g: f64,
}
