#[coordinates(x)]
#[inertia(diag(m))]
#[forces(if x == 0 { 1 } else { x })]
pub struct Contact {
    pub m: f64,
}
