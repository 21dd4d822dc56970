#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(push: ddot(x) + ddot(y) == cos(t))]
pub struct Pushed {
    pub m: f64,
    pub g: f64,
}
