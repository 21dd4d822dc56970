#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[define(friction = mu*reaction(floor))]
#[forces(-friction, -m*g + reaction(floor))]
#[constraint(floor: y == 0)]
pub struct OutOfPlace {
    pub m: f64,
    pub g: f64,
    pub mu: f64,
}
