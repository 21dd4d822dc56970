#[coordinates(x)]
#[inputs(f)]
#[kinetic_energy(f*powi(dot(x), 2))]
pub struct Driven {
    pub m: f64,
}
