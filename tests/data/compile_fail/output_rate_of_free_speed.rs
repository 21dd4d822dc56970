#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == c*c)]
#[velocities(of(u), dot(x) = c*cos(u), dot(y) = c*sin(u))]
#[output(turn = dot(u))]
pub struct Turn {
    pub m: f64,
    pub g: f64,
    pub c: f64,
}
