#[coordinates(a)]
#[frame(A = rotate(N, z, a))]
#[particle(bob = { at: O + l*A.x, mass: m })]
#[holonomy(elimination = leaves)]
pub struct Pendulum {
    pub m: f64,
    pub l: f64,
}
