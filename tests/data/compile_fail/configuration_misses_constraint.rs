#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
#[constraint(rod: powi(x, 2) + powi(y, 2) == 4*powi(l, 2))]
pub struct Pendulum {
    pub m: f64,
    pub g: f64,
    pub l: f64,
}
