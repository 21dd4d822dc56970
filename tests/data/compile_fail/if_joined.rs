#[coordinates(x)]
#[inertia(diag(m))]
#[forces(if x < 0 || x > 1 { 1 } else { x })]
pub struct Stops {
    pub m: f64,
}
