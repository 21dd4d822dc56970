#[coordinates(x, y)]
#[kinetic_energy(m/2*powi(dot(x), 2) + m*powi(dot(x), 2)*dot(y))]
pub struct Cubic {
    pub m: f64,
}
