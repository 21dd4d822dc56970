#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(along: dot(x) == 0)]
#[constraint(across: dot(y) == 0)]
#[constraint(both: x + y*y == 1)]
#[output(pull = reaction(along) + reaction(both))]
pub struct Shared {
    pub m: f64,
    pub g: f64,
}
