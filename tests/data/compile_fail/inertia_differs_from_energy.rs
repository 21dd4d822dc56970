#[coordinates(x, y)]
#[kinetic_energy(m/2*(powi(dot(x), 2) + powi(dot(x) + dot(y), 2)))]
#[inertia(matrix([2*m, 0], [_, m]))]
pub struct Chain {
    pub m: f64,
}
