#[coordinates(x)]
#[kinetic_energy(m/2*powi(dot(x), 2), m)]
pub struct Driven {
    pub m: f64,
}
