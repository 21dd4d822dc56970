/// Another choice divides by other parameters; numbers that are no rationals need no guard.
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(tilted: a*dot(x) + b*dot(y) == 0)]
#[constraint(turned: sin(1)*dot(z) + cos(2)*dot(x) == 0)]
#[independent(dot(x))]
#[independent(dot(y))]
pub struct Charts {
    pub m: f64,
    pub g: f64,
    pub a: f64,
    pub b: f64,
}
