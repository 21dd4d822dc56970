#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, -m*g)]
#[constraint(rod: powi(x, 2) + powi(y, 2) == powi(l, 2))]
#[start(x = 0.8, y = 0)]
#[independent(dot(x))]
pub struct Hanging {
    pub m: f64,
    pub g: f64,
    #[nominal(0.8)]
    pub l: f64,
}
