#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[output(pull = l*reaction(rope), push = reaction(rod, x), sum = reaction(rod + x))]
pub struct NoConstraint {
    pub m: f64,
    pub g: f64,
    pub l: f64,
}
