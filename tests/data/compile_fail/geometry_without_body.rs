#[coordinates(x)]
#[inertia(diag(m))]
#[forces(0)]
#[gravity(-g*N.y)]
#[force(push = { at: O, value: N.x })]
pub struct Nothing {
    pub m: f64,
    pub g: f64,
}
