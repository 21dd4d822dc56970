#[coordinates(x)]
#[kinetic_energy(m*dot(x) + m*x)]
pub struct Massless {
    pub m: f64,
}
