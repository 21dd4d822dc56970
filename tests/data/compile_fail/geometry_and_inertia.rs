#[coordinates(x)]
#[particle(bead = { at: O + x*N.x, mass: m })]
#[inertia(diag(m))]
pub struct Twice {
    pub m: f64,
}
