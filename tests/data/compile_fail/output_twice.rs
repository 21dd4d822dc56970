#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[output(height = y, speed = dot(x))]
#[output(height = l + y)]
pub struct Twice {
    pub m: f64,
    pub g: f64,
    pub l: f64,
}
