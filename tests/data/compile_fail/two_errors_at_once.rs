#[coordinates(x, y)]
#[inertia(diag(m, mass))]
#[forces(0, -m*g^2)]
#[constraint(rod: powi(x, 2) + powi(yy, 2) == 1)]
pub struct TwoErrors {
    pub m: f64,
    pub g: f64,
}
