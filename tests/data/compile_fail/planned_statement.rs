#[coordinates(x)]
#[inertia(diag(m))]
#[forces(0)]
#[gravity(-g*N.y)]
pub struct Early {
    pub m: f64,
    pub g: f64,
}
