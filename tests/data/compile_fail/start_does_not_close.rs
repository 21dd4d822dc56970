#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(rod: powi(x, 2) + powi(y, 2) == l)]
#[start(x = 0.1, y = 0.3)]
pub struct Nowhere {
    pub m: f64,
    pub g: f64,
    #[nominal(-0.8)]
    pub l: f64,
}
