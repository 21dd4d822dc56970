#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(slide: dot(x) + dot(y) == 0)]
#[output(height = y, ratio = x/(dot(x) + dot(y)))]
pub struct Divides {
    pub m: f64,
    pub g: f64,
}
