#[coordinates(x)]
#[forces(0)]
pub struct Massless {
    pub m: f64,
}
