#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(first: dot(x) - y*dot(z) == 0)]
#[constraint(second: dot(y) + dot(z) == 0)]
#[constraint(third: 2*dot(x) + x*dot(y) + (x - 2*y)*dot(z) == 0)]
pub struct Dependent {
    pub m: f64,
    pub g: f64,
}
