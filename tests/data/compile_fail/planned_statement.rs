#[coordinates(x)]
#[inertia(diag(m))]
#[forces(0)]
#[release(pull = { point: O, along: N.y })]
pub struct Early {
    pub m: f64,
}
