/// A row that repeats another by a quotient of coordinates.
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, -m*g, 0)]
#[constraint(first: x*dot(x) + y*dot(y) == 0)]
#[constraint(second: x*z/(a*y)*dot(x) + z/a*dot(y) == 0, redundant)]
pub struct Shares {
    pub m: f64,
    pub g: f64,
    pub a: f64,
}
