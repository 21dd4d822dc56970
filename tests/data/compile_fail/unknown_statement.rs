#[coordinates(x)]
#[inertai(diag(m))]
#[forces(0)]
pub struct Misspelt {
    pub m: f64,
}
