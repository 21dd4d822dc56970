/// A row that repeats another by a quotient of coordinates.
#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(first: x*dot(x) + y*dot(y) == 0)]
#[constraint(second: x/y*dot(x) + dot(y) == 0, redundant)]
pub struct Shares {
    pub m: f64,
    pub g: f64,
}
